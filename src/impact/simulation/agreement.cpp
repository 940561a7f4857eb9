// SPDX-License-Identifier: Apache-2.0
// What the ranks of a run agree on (docs/decisions/0101). In one process each of these functions does what it says for
// the process alone.
#include <limits>

#include "base/index.hpp"
#include "impact/simulation/simulation.hpp"

namespace nugget::impact {
namespace {

/// What a rank brings to the agreement of a cycle.
struct Wishes {
  double step = std::numeric_limits<double>::infinity();
  int group = -1, element = -1;
  bool stop = false, restart_file = false, writes_restart_files = false, state = false;
};

/// Whether `a` controls the step rather than `b`: the choice of one process, which goes through all elements in order
/// and takes the first of the smallest steps, or the first that is not a number.
bool controls(const Wishes& a, const Wishes& b) {
  if (a.group < 0 || b.group < 0) return b.group < 0 && a.group >= 0;
  const bool a_is_none = a.step != a.step, b_is_none = b.step != b.step;
  if (a_is_none != b_is_none) return a_is_none;
  if (!a_is_none && a.step != b.step) return a.step < b.step;
  return a.group != b.group ? a.group < b.group : a.element < b.element;
}

/// What a balance of energies changes in a run.
struct Balance {
  Energy energy;
  bool diverged = false, unstable = false;
  double largest_input = 0.0, physical_mass = 0.0, added_mass = 0.0, next_mark = 0.0;
};

}  // namespace

void Simulation::share_out(Ranks& ranks) {
  std::vector<system::System::ElementLocation> read;
  components_.elements_read([&](system::System::ElementLocation location) { read.push_back(location); });
  ranks_ = &ranks;
  system_.told_below = components_.erosion.smallest_step(first_step_);
  system_.share_out(ranks, read);
}

void Simulation::agree(const Options& options) {
  Wishes own;
  own.stop = interrupted();
  own.writes_restart_files = options.write_checkpoint && !diverged_;
  if (own.writes_restart_files) {
    solve_seconds_ = elapsed();
    own.restart_file = checkpoints_.due(options.checkpoints, state_.cycle, state_.time, solve_seconds_);
  }
  own.state = state_asked_;
  controlling_ = system_.controlling();
  if (ranks_ != nullptr) {
    own.step = controlling_.step;
    own.group = controlling_.group;
    own.element = controlling_.element;
    Wishes all;
    for (const Wishes& w : gather(*ranks_, own)) {
      if (controls(w, all)) {
        all.step = w.step;
        all.group = w.group;
        all.element = w.element;
      }
      all.stop |= w.stop;
      all.restart_file |= w.restart_file;
      all.writes_restart_files |= w.writes_restart_files;
      all.state |= w.state;
    }
    if (all.stop && !own.stop) interrupt("a signal to another rank");
    if (all.state) next_mark_ = -std::numeric_limits<double>::infinity();
    own = all;
    controlling_ = {own.step, own.group, own.element};
  }
  stop_requested_ = own.stop;
  restart_file_due_ = own.restart_file || (own.stop && own.writes_restart_files);
  state_asked_ = false;
}

bool Simulation::results_due(Recorder& recorder) const {
  if (on_first_rank()) return recorder.due(state_);
  return state_.time + state_.dt > next_mark_ + 1e-9 * state_.dt;
}

void Simulation::pass_on_balance(const Recorder& recorder) {
  if (ranks_ == nullptr) return;
  Balance balance{energy_, diverged_, unstable_, largest_input_, masses_.physical, masses_.added, recorder.next_mark()};
  broadcast(*ranks_, balance);
  energy_ = balance.energy;
  diverged_ = balance.diverged;
  unstable_ = balance.unstable;
  largest_input_ = balance.largest_input;
  masses_.physical = balance.physical_mass;
  masses_.added = balance.added_mass;
  next_mark_ = balance.next_mark;
}

}  // namespace nugget::impact
