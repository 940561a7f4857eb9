// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "app/command.hpp"
#include "app/coupon_card.hpp"
#include "app/coupon_runs.hpp"
#include "report/coupon_page.hpp"
#include "weld/coupon/coupon.hpp"
#include "weld/failure/force_at_failure.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

/// The surface by the failure function, or the law, of the weld of a coupon that was read and tied.
double surface(const PreparedDeck& deck, double angle) {
  const weld::Weld& weld = deck.ties.welds.front();
  if (weld.interpolated)
    return std::visit([&](const auto& joint) { return weld::failure::force_at_failure(joint, angle); },
                      deck.model.interpolation_spotwelds.front().law);
  return weld::failure::force_at_failure(deck.model, weld::law_of(deck.model, weld),
                                         weld::failure::geometry_of(deck.model, weld), angle);
}

bool is_chosen(const CouponArguments& arguments, const weld::CouponTest& test) {
  return arguments.only.empty() ||
         std::find(arguments.only.begin(), arguments.only.end(), test.name()) != arguments.only.end();
}

ExitCode test_card(const CouponArguments& arguments, const fs::path& directory) {
  TakenCard taken = take_card(arguments, directory);
  std::vector<weld::CouponTest> tests;
  for (const weld::CouponTest& test : weld::coupon_tests())
    if (is_chosen(arguments, test)) tests.push_back(test);
  const InFolder here(directory);
  std::vector<ChildRun> runs = write_coupons(taken.card, tests);
  const std::optional<PreparedDeck> prepared = prepare_coupon(runs.front());
  if (!prepared) return ExitCode::refused;
  for (const std::string& note : taken.notes) fmt::print("{}\n", note);
  if (arguments.only_decks) {
    fmt::print("{} decks in {}; nothing was run (--decks)\n", runs.size(), directory.string());
    return ExitCode::normal;
  }
  if (const ExitCode code = run_coupons(runs, arguments.threads); code != ExitCode::normal) return code;

  report::CouponStudy study{arguments.card, std::move(taken.notes), taken.card.units, {}, {}, {}};
  for (int angle = 0; angle <= 90; ++angle) {
    study.angle.push_back(angle);
    study.surface.push_back(surface(*prepared, angle));
  }
  const CouponLoads loads = taken.card.weld_nodes != 0 ? CouponLoads::at_the_peak : CouponLoads::at_failure;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    report::CouponResult r = read_coupon(runs[i].folder, tests[i], loads);
    r.surface = surface(*prepared, r.angle);
    r.surface_at_load = surface(*prepared, r.load_angle());
    study.results.push_back(std::move(r));
  }
  report::write_coupon_study(".", study);
  fmt::print("\n{}\n{}\n", report::coupon_table(study), (directory / "coupon.html").string());
  return ExitCode::normal;
}

}  // namespace

const std::vector<std::string>& coupon_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const weld::CouponTest& test : weld::coupon_tests()) all.push_back(test.name());
    return all;
  }();
  return names;
}

ExitCode coupon(const CouponArguments& arguments) {
  if (arguments.thickness.size() > 2) {
    fmt::print(stderr, "nugget: --thickness: {} numbers, expected that of both sheets, or T1,T2\n",
               arguments.thickness.size());
    return ExitCode::wrong_command;
  }
  return study_card(arguments.directory, [&](const fs::path& directory) { return test_card(arguments, directory); });
}

}  // namespace nugget::app
