// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/child_runs.hpp"
#include "app/commands.hpp"
#include "app/prepared_deck.hpp"
#include "report/coupon_page.hpp"
#include "weld/coupon/coupon.hpp"

namespace nugget::app {

/// The current folder while it lives. Included files are looked for in the current folder first, as in LS-DYNA: coupons
/// are read and run where their decks stand, so that no file of the same name elsewhere takes the card's place.
class InFolder {
 public:
  explicit InFolder(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder);
  }
  ~InFolder() {
    std::error_code gone;
    std::filesystem::current_path(before_, gone);
  }
  InFolder(const InFolder&) = delete;
  InFolder& operator=(const InFolder&) = delete;

 private:
  std::filesystem::path before_;
};

/// Writes their decks into the current folder; each will run into a folder of its name. Throws output::WriteError.
std::vector<ChildRun> write_coupons(const weld::CouponCard& card, const std::vector<weld::CouponTest>& tests);

/// A coupon as it was read and tied; nothing where it is refused, which is reported.
std::optional<PreparedDeck> prepare_coupon(const ChildRun& run);

/// Runs them, as many at once as there are threads (0: all cores). Tells which did not end normally.
ExitCode run_coupons(std::vector<ChildRun>& runs, int threads);

/// Which loads of the weld stand beside a coupon's peak: the last ones before it failed, or, of a weld that fades until
/// nothing is left, those at the largest force of the grip.
enum class CouponLoads { at_failure, at_the_peak };

/// Grip and weld over a run of a coupon, from bndout, nodout, welds.csv and swforc in its folder. Throws
/// std::runtime_error where a file is missing or does not say it.
report::CouponResult read_coupon(const std::filesystem::path& folder, const weld::CouponTest& test,
                                 CouponLoads loads = CouponLoads::at_failure);

/// Force of the grip and what the weld bore at the same time: N+ (tension), shear, torsion, bending.
struct LoadPath {
  std::vector<double> force;
  std::vector<std::array<double, 4>> load;
};
/// From bndout and swforc, up to the failure of the weld. Throws as read_coupon.
LoadPath read_load_path(const std::filesystem::path& folder, const weld::CouponTest& test);

}  // namespace nugget::app
