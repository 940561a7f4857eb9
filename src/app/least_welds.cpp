// SPDX-License-Identifier: Apache-2.0
#include "app/least_welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "app/lessened_structure.hpp"
#include "base/index.hpp"
#include "output/result_file.hpp"

namespace nugget::app {
namespace {

struct Step {
  std::vector<std::size_t> welds;  ///< that go together, by their place in Ties::welds
  double frequency;                ///< first elastic one then [1/time]
};

/// A structure without some welds and its lowest modes.
struct Reduced {
  std::unique_ptr<LessenedStructure> structure;
  nvh::Modes modes;
};

class Search {
 public:
  Search(const nvh::Matrices& whole, const nvh::Modes& modes, double share, const nvh::ProgressCallback& progress)
      : whole_(whole), progress_(progress) {
    while (rigid_ < modes.eigenvalue.size() && !modes.elastic(rigid_)) ++rigid_;
    count_ = static_cast<int>(std::min(modes.eigenvalue.size(), rigid_ + 6));
    if (rigid_ < modes.eigenvalue.size()) whole_frequency_ = modes.frequency(rigid_);
    least_ = share * whole_frequency_;
    for (std::size_t w = 0; w < whole.system.ties.welds.size(); ++w)
      if (nvh::can_drop(whole.system, w)) left_.push_back(w);
  }

  double whole_frequency() const { return whole_frequency_; }
  double least() const { return least_; }
  const std::vector<Step>& steps() const { return steps_; }
  const std::vector<std::size_t>& left() const { return left_; }

  void run() {
    if (whole_frequency_ <= 0.0) return;
    Reduced now = *reduced({});
    for (std::size_t at_once = std::max<std::size_t>(1, left_.size() / 10); !left_.empty();) {
      progress_(fmt::format("least welds: {} of {} are out", gone_.size(), gone_.size() + left_.size()));
      sort_by_worth(now);
      at_once = std::min(at_once, left_.size());
      std::vector<std::size_t> without = gone_;
      without.insert(without.end(), left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(at_once));
      std::optional<Reduced> next = reduced(without);
      if (next && first_elastic(next->modes) >= least_) {
        steps_.push_back(
            {{left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(at_once)}, first_elastic(next->modes)});
        left_.erase(left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(at_once));
        gone_ = without;
        now = std::move(*next);
      } else if (at_once == 1) {
        return;
      } else {
        at_once /= 2;
      }
    }
  }

 private:
  /// 0 where there are more motions without stiffness than before.
  double first_elastic(const nvh::Modes& modes) const {
    return rigid_ < modes.eigenvalue.size() && modes.elastic(rigid_) ? modes.frequency(rigid_) : 0.0;
  }

  /// Nothing where it does not carry its preload.
  std::optional<Reduced> reduced(std::vector<std::size_t> without) const {
    std::sort(without.begin(), without.end());
    Reduced r;
    r.structure = LessenedStructure::make(whole_, without);
    if (r.structure == nullptr) return {};
    nvh::ModeRequest request;
    request.count = count_;
    r.modes = nvh::find_modes(r.structure->matrices(), request, progress_);
    return r;
  }

  /// The weld first without which the structure as it is keeps the highest first frequency.
  void sort_by_worth(const Reduced& now) {
    std::vector<nvh::WeldGroup> groups;
    for (const std::size_t w : left_) groups.push_back({w});
    const std::vector<nvh::WeldDrop> drops = nvh::drop_welds(now.structure->matrices(), now.modes, groups, progress_);
    std::vector<std::pair<double, std::size_t>> ranked;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      double lowest = drops[i].eigenvalue[rigid_];
      for (std::size_t k = rigid_; k < drops[i].eigenvalue.size(); ++k)
        lowest = std::min(lowest, drops[i].eigenvalue[k]);
      for (const double v : drops[i].new_modes) lowest = std::min(lowest, v);
      ranked.emplace_back(-lowest, left_[i]);
    }
    std::sort(ranked.begin(), ranked.end());
    for (std::size_t i = 0; i < left_.size(); ++i) left_[i] = ranked[i].second;
  }

  const nvh::Matrices& whole_;
  const nvh::ProgressCallback& progress_;
  std::size_t rigid_ = 0;  ///< motions without stiffness
  int count_ = 0;
  double whole_frequency_ = 0.0, least_ = 0.0;
  std::vector<std::size_t> left_, gone_;
  std::vector<Step> steps_;
};

}  // namespace

std::string find_least_welds(const std::filesystem::path& directory, const nvh::Matrices& matrices,
                             const nvh::Modes& modes, double share, const std::optional<model::Units>& units,
                             const nvh::ProgressCallback& progress) {
  Search search(matrices, modes, share, progress);
  search.run();
  const auto id = [&](std::size_t w) { return matrices.system.ties.welds[w].id; };
  std::string csv = "weld,goes,first_frequency\n";
  std::size_t out = 0;
  std::string list;
  for (const Step& step : search.steps())
    for (const std::size_t w : step.welds) {
      csv += fmt::format("{},yes,{:.9g}\n", id(w), step.frequency);
      list += fmt::format("{}{}", out++ == 0 ? "" : " ", id(w));
    }
  for (const std::size_t w : search.left()) csv += fmt::format("{},no,\n", id(w));
  output::write_whole_file(directory / "least_welds.csv", csv);
  const double last = search.steps().empty() ? search.whole_frequency() : search.steps().back().frequency;
  return fmt::format(
      "Least welds that keep the first frequency, {0:.6g}{7}, above {1:.6g}{7} (greedy; least_welds.csv)\n\n {2} of "
      "{3} can go, in "
      "this order: {4}\n first frequency without them {5:.6g}{7}, {6:.2f} % lower\n\n",
      search.whole_frequency(), search.least(), out, out + search.left().size(), out == 0 ? "none" : list, last,
      search.whole_frequency() > 0.0 ? 100.0 * (1.0 - last / search.whole_frequency()) : 0.0,
      model::unit_of_frequency(units));
}

}  // namespace nugget::app
