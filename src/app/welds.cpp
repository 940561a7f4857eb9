// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <stdexcept>

#include "app/commands.hpp"
#include "app/weld_ranking.hpp"
#include "report/quantity.hpp"
#include "report/run_data.hpp"

namespace nugget::app {
namespace {

ExitCode wrong_ranking(const std::string& text) {
  fmt::print(stderr, "nugget: {}\n", text);
  return ExitCode::wrong_command;
}

WeldOrder order_of(const std::string& word) {
  return word == "margin" ? WeldOrder::margin : word == "failure" ? WeldOrder::failure : WeldOrder::energy;
}

ExitCode rank_modes(const WeldsArguments& arguments, const report::RunData& run) {
  if (arguments.sort != "energy")
    return wrong_ranking(
        fmt::format("--sort {}: {} holds natural modes, whose welds have no failure values; expected energy, "
                    "the share of strain energy",
                    arguments.sort, arguments.directory));
  const std::vector<WeldShare> welds = rank_shares(run);
  fmt::print("{}", arguments.csv ? share_csv(welds) : share_table(welds, static_cast<std::size_t>(arguments.lines)));
  return ExitCode::normal;
}

}  // namespace

ExitCode welds(const WeldsArguments& arguments) {
  report::RunData run;
  try {
    run = report::read_run(arguments.directory);
  } catch (const std::runtime_error& error) {
    return wrong_ranking(error.what());
  }
  if (run.summary.contains("modes") && !run.summary["modes"].empty()) return rank_modes(arguments, run);
  if (run.welds.empty())
    return wrong_ranking(fmt::format("the run in {} has no welds: nothing to rank", arguments.directory));
  const WeldOrder order = order_of(arguments.sort);
  const std::vector<RankedWeld> welds = rank_welds(run, order);
  if (arguments.csv) {
    fmt::print("{}", ranking_csv(welds));
    return ExitCode::normal;
  }
  fmt::print("{} ({} termination): {}", arguments.directory, run.summary.value("termination", ""),
             ranking_table(welds, order, static_cast<std::size_t>(arguments.lines), report::units_of_run(run.summary)));
  if (!run.welds.front().contains("most_energy_passed"))
    fmt::print(" welds.csv has no energy through the welds: it was written by an older version; run the deck again\n");
  return ExitCode::normal;
}

}  // namespace nugget::app
