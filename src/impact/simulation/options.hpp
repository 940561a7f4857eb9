// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "base/ranks.hpp"

namespace nugget::impact {

/// When restart files are written, besides at an interruption: every so many cycles, minutes of the clock, or model
/// time. 0: not so.
struct Checkpoints {
  long cycles = 0;
  double minutes = 0.0, time = 0.0;
};

/// What somebody asks of a run that is under way; LS-DYNA's word for it.
struct SenseSwitches {
  bool stop = false;          ///< with a restart file
  bool report = false;        ///< a line of progress
  bool restart_file = false;  ///< and go on
  bool state = false;         ///< one of d3plot that is not due
};

/// What the command line says about a run.
struct Options {
  double until = 0.0;   ///< end time; 0: the deck's
  long max_cycles = 0;  ///< 0: the deck's
  Checkpoints checkpoints{};
  /// Writes a restart file, between two cycles; empty: there are none. Over several ranks all have it.
  std::function<void()> write_checkpoint{};
  /// Take from one what the partition goes by (Simulation::archive_costs), and then, in place of the start's, the
  /// state; empty: a run from its start.
  std::function<void()> restore_costs{}, restore{};
  Ranks* ranks = nullptr;  ///< that compute the run together; null: this process alone
  /// Called once, when nobody asks for places at the start (Ties::x) any more. Empty: nothing.
  std::function<void()> made{};
  std::function<SenseSwitches()> sense_switches{};  ///< asked a few times a second; empty: nobody asks for anything
};

enum class Termination { normal, error, interrupted };

/// How a run ended.
struct Outcome {
  Termination termination = Termination::normal;
  std::string message;  ///< the reason, where it is not the end time
  bool stops() const { return termination != Termination::normal || !message.empty(); }
};

/// What a progress display gets every so often.
struct Progress {
  double time = 0.0, end_time = 0.0, dt = 0.0;
  long cycle = 0;
  double energy_ratio = 1.0;
  int welds = 0, welds_failed = 0;
  double seconds = 0.0;               ///< since the start of the run
  double kinetic_energy_ratio = 0.0;  ///< in dynamic relaxation: kinetic energy over the largest so far; 0 in the run
};
using ProgressCallback = std::function<void(const Progress&)>;

}  // namespace nugget::impact
