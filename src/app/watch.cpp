// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <optional>
#include <thread>

#include "app/commands.hpp"
#include "app/progress.hpp"
#include "app/run_status.hpp"
#include "output/history_reader.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;
using output::Channel;
using output::HistoryRecord;

constexpr std::size_t columns = 60;  // of a small plot

/// The course of values over their times, in blocks of eight heights: the largest in each column; where a column has no
/// time of its own, the last before it.
std::string small_plot(const std::vector<double>& times, const std::vector<double>& values, double end_time) {
  constexpr std::array<const char*, 8> blocks{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const double low = std::min(0.0, *std::min_element(values.begin(), values.end())),
               high = *std::max_element(values.begin(), values.end());
  std::string text;
  std::size_t drawn = 0;
  double height = 0.0;
  const auto draw_up_to = [&](std::size_t column) {
    for (; drawn < column; ++drawn) text += blocks[static_cast<std::size_t>(std::lround(7.0 * height))];
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = end_time > 0.0 ? times[i] / end_time : 1.0;
    const auto column = std::min(static_cast<std::size_t>(std::max(share, 0.0) * columns), columns - 1);
    const double now = high > low ? (values[i] - low) / (high - low) : 0.0;
    const bool same_column = i > 0 && column == drawn;
    draw_up_to(column);
    height = same_column ? std::max(height, now) : now;
  }
  draw_up_to(drawn + 1);
  return text + std::string(columns - drawn, ' ');
}

/// The largest of some channels at each time, which is the crush force of the hardest wall, or the weld nearest to
/// failure.
std::vector<double> largest_of(const HistoryRecord& record, std::string_view quantity) {
  std::vector<double> largest;
  for (const Channel& channel : record.channels) {
    if (channel.quantity != quantity) continue;
    if (largest.empty()) largest.assign(record.times.size(), 0.0);
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], channel.values[i]);
  }
  return largest;
}

/// A line for each of the courses that a crash engineer follows, as far as the deck asks for their files.
std::vector<std::string> small_plots(const fs::path& directory, double end_time) {
  struct Followed {
    std::string_view file, quantity, name;
  };
  constexpr std::array followed{
      Followed{"glstat", "kinetic_energy", "kinetic energy"}, Followed{"glstat", "internal_energy", "internal energy"},
      Followed{"glstat", "hourglass_energy", "hourglass energy"}, Followed{"rwforc", "normal_force", "wall force"},
      Followed{"swforc", "failure", "failure of welds"}};
  constexpr std::string_view files[] = {"glstat", "rwforc", "swforc"};
  std::vector<std::string> lines;
  const std::vector<HistoryRecord> records = output::read_histories(directory, files);
  for (const Followed& f : followed)
    for (const HistoryRecord& record : records) {
      if (record.file != f.file) continue;
      const std::vector<double> values = largest_of(record, f.quantity);
      if (values.empty()) continue;
      lines.push_back(fmt::format("{:<17} |{}| now {:.4g}, largest {:.4g}", f.name,
                                  small_plot(record.times, values, end_time), values.back(),
                                  *std::max_element(values.begin(), values.end())));
    }
  return lines;
}

std::vector<std::string> lines_of(const fs::path& directory, const RunStatus& status) {
  constexpr long quiet_seconds = 30;
  const std::string done =
      status.at.end_time > 0.0 ? fmt::format("{:.1f} % in ", 100.0 * share_done(status.at)) : std::string("after ");
  std::vector<std::string> lines{
      fmt::format("{}  {}  {}{}", status.deck, status.state, done, clock_time(status.at.seconds)),
      progress_line(status.at)};
  const long silent = static_cast<long>(std::time(nullptr)) - status.updated;
  if (status.state == "running" && silent > quiet_seconds)
    lines.push_back(
        fmt::format("no sign of life for {} s: the run was killed, or a cycle takes that long [nugget run --resume {}]",
                    silent, directory.string()));
  for (std::string& line : small_plots(directory, status.at.end_time)) lines.push_back(std::move(line));
  return lines;
}

/// Over the lines that stand there, on a terminal.
void print_lines(const std::vector<std::string>& lines, std::size_t& drawn, bool terminal) {
  if (terminal && drawn > 0) fmt::print("\x1b[{}A", drawn);
  for (const std::string& line : lines) fmt::print("{}{}\n", line, terminal ? "\x1b[K" : "");
  std::fflush(stdout);
  drawn = lines.size();
}

ExitCode code_of(const std::string& state) {
  if (state == "error") return ExitCode::error_termination;
  return state == "interrupted" ? ExitCode::interrupted : ExitCode::normal;
}

}  // namespace

ExitCode watch(const std::string& directory, bool once) {
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  std::size_t drawn = 0;
  for (;;) {
    const std::optional<RunStatus> status = read_status(directory);
    if (!status) {
      fmt::print(stderr,
                 "nugget: there is no status.out in {}, which an explicit run writes as it goes, and no summary.json\n",
                 directory);
      return ExitCode::wrong_command;
    }
    print_lines(lines_of(directory, *status), drawn, terminal);
    if (status->state != "running") return code_of(status->state);
    if (once) return ExitCode::normal;
    std::this_thread::sleep_for(std::chrono::seconds(terminal ? 1 : 10));
  }
}

}  // namespace nugget::app
