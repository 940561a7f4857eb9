// SPDX-License-Identifier: Apache-2.0
#include "app/restart.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "app/outcome.hpp"

namespace nugget::app {

namespace fs = std::filesystem;

std::optional<impact::Checkpoints> read_checkpoints(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || !(value > 0.0) || !std::isfinite(value)) return {};
  const std::string unit(end);
  impact::Checkpoints every;
  if (unit.empty()) {
    every.time = value;
  } else if (unit == "min") {
    every.minutes = value;
  } else if ((unit == "cycles" || unit == "cycle") && value == std::trunc(value) && value < 1e15) {
    every.cycles = static_cast<long>(value);
  } else {
    return {};
  }
  return every;
}

std::optional<double> clock_seconds(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || !(value > 0.0) || !std::isfinite(value)) return {};
  const std::string unit(end);
  if (unit == "s") return value;
  if (unit == "min") return 60.0 * value;
  if (unit == "h") return 3600.0 * value;
  return {};
}

bool says_checkpoints(const std::string& text) {
  return read_checkpoints(text).has_value();
}

output::RestartHead head_of(const RunArguments& arguments, std::uint64_t deck_checksum) {
  return {.version = NUGGET_VERSION,
          .deck = arguments.deck,
          .folder = fs::current_path().string(),
          .deck_checksum = deck_checksum,
          .date = today(),
          .skip_unsupported = arguments.skip_unsupported,
          .until = arguments.until,
          .max_cycles = arguments.max_cycles,
          .checkpoint = arguments.checkpoint,
          .weld_law = arguments.weld_law,
          .weld_tie = arguments.weld_tie,
          .units = arguments.units,
          .drop_weld = arguments.drop_weld,
          .load_case = arguments.load_case,
          .precision = arguments.precision.empty() ? "double" : arguments.precision,
          .subcycle = arguments.subcycle};
}

RunArguments resumed_arguments(const RunArguments& asked, const output::RestartHead& head) {
  RunArguments run = asked;
  run.directory = fs::absolute(asked.resume).string();
  run.skip_unsupported = head.skip_unsupported;
  run.weld_tie = head.weld_tie;
  run.drop_weld = head.drop_weld;
  if (run.units.empty()) run.units = head.units;
  run.load_case = head.load_case;
  if (!run.precision.empty() && run.precision != head.precision)
    throw ArchiveError("--precision " + run.precision + ": the run was begun with " + head.precision +
                       " precision, and only with that it can go on: leave the option out, or run the deck from its "
                       "start");
  run.precision = head.precision;
  if (run.subcycle && !head.subcycle)
    throw ArchiveError(
        "--subcycle: the run was begun without, and goes on so: leave the option out, or run the deck from its start");
  run.subcycle = head.subcycle;
  if (run.until == 0.0) run.until = head.until;
  if (run.max_cycles == 0) run.max_cycles = head.max_cycles;
  if (run.checkpoint.empty()) run.checkpoint = head.checkpoint;
  if (run.weld_law.empty()) run.weld_law = head.weld_law;
  if (!run.deck.empty()) return run;
  run.deck = head.deck;
  std::error_code error;
  fs::current_path(head.folder, error);
  if (error)
    throw ArchiveError("the folder " + head.folder + " from which the run was begun cannot be entered: " +
                       error.message() + "; name the deck: nugget run MODEL.k --resume DIR");
  return run;
}

void expect_same_deck(const std::string& deck, std::uint64_t checksum, const output::RestartHead& head) {
  if (checksum != head.deck_checksum)
    throw ArchiveError(deck +
                       ", a file that it includes, or the library of --weld-law, is not what it was when the restart "
                       "file was written: bring it "
                       "back, or run the deck from its start");
}

}  // namespace nugget::app
