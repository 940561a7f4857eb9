// SPDX-License-Identifier: Apache-2.0
#include "app/run_status.hpp"

#include <fmt/format.h>

#include <cctype>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/progress.hpp"
#include "output/result_file.hpp"

namespace nugget::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* status_name = "status.out";
constexpr std::size_t width_of_names = 20;

std::string status_line(const char* name, const std::string& value) {
  return fmt::format(" {:<{}}{}\n", name, width_of_names, value);
}

long seconds_since_1970() {
  return static_cast<long>(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
}

std::string text_of(const RunStatus& status) {
  const impact::Progress& p = status.at;
  const std::optional<double> left = seconds_left(p);
  const std::string lines[] = {
      status_line("deck", status.deck),
      status_line("state", status.state),
      status_line("cycle", fmt::format("{}", p.cycle)),
      status_line("time", fmt::format("{:.6e}", p.time)),
      status_line("end time", fmt::format("{:.6e}", p.end_time)),
      status_line("time step", fmt::format("{:.4e}", p.dt)),
      status_line("percent completed", fmt::format("{:.1f}", 100.0 * share_done(p))),
      status_line("energy ratio", fmt::format("{:.5f}", p.energy_ratio)),
      status_line("welds", fmt::format("{}", p.welds)),
      status_line("failed welds", fmt::format("{}", p.welds_failed)),
      p.kinetic_energy_ratio > 0.0 ? status_line("relaxation", fmt::format("{:.4e}", p.kinetic_energy_ratio)) : "",
      status_line("elapsed seconds", fmt::format("{:.1f}", p.seconds)),
      left ? status_line("seconds left", fmt::format("{:.0f}", *left)) : "",
      status_line("updated", fmt::format("{}", status.updated))};
  return fmt::format("{}", fmt::join(lines, ""));
}

std::optional<RunStatus> status_of_ended_run(const fs::path& directory) {
  std::ifstream file(directory / "summary.json");
  if (!file) return std::nullopt;
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("termination") || !summary.contains("cycles")) return std::nullopt;
  RunStatus status;
  status.deck = summary.value("deck", "");
  status.state = summary.value("termination", "");
  status.at.cycle = summary.value("cycles", 0L);
  status.at.time = summary.value("time", 0.0);
  status.at.end_time = status.state == "normal" ? status.at.time : 0.0;
  status.at.dt = summary["time_step"].value("smallest", 0.0);
  status.at.energy_ratio = summary["energy"].value("ratio", 1.0);
  status.at.welds = summary.value("welds", 0);
  for (const auto& weld : summary["weld"]) status.at.welds_failed += weld.value("failed", false) ? 1 : 0;
  status.at.seconds = summary["seconds"].value("solve", 0.0);
  return status;
}

}  // namespace

StatusFile::StatusFile(fs::path directory, std::string deck)
    : directory_(std::move(directory)), deck_(std::move(deck)) {}

void StatusFile::update(const impact::Progress& progress) {
  constexpr double between = 1.0;  // seconds
  last_ = progress;
  if (progress.seconds < next_) return;
  next_ = progress.seconds + between;
  write("running");
}

void StatusFile::write(const std::string& state) const {
  try {
    output::write_whole_file(directory_ / status_name, text_of({deck_, state, last_, seconds_since_1970()}));
  } catch (const output::WriteError&) {
    return;
  }
}

std::optional<RunStatus> read_status(const fs::path& directory) {
  std::ifstream file(directory / status_name);
  if (!file) return status_of_ended_run(directory);
  std::map<std::string, std::string> of;
  for (std::string line; std::getline(file, line);) {
    if (line.size() <= width_of_names + 1) continue;
    const std::string name = line.substr(1, width_of_names);
    of[name.substr(0, name.find_last_not_of(' ') + 1)] = line.substr(width_of_names + 1);
  }
  const auto number = [&](const char* name) { return std::strtod(of[name].c_str(), nullptr); };
  RunStatus status;
  status.deck = of["deck"];
  status.state = of["state"];
  impact::Progress& p = status.at;
  p.cycle = static_cast<long>(number("cycle"));
  p.time = number("time");
  p.end_time = number("end time");
  p.dt = number("time step");
  p.energy_ratio = number("energy ratio");
  p.welds = static_cast<int>(number("welds"));
  p.welds_failed = static_cast<int>(number("failed welds"));
  p.kinetic_energy_ratio = number("relaxation");
  p.seconds = number("elapsed seconds");
  status.updated = static_cast<long>(number("updated"));
  return status;
}

void remove_status(const fs::path& directory) {
  std::error_code ignored;
  fs::remove(directory / status_name, ignored);
}

impact::SenseSwitches take_sense_switch(const fs::path& directory) {
  const fs::path path = directory / "d3kil";
  std::ifstream file(path);
  if (!file) return {};
  std::string word;
  file >> word;
  file.close();
  std::error_code ignored;
  fs::remove(path, ignored);
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word.empty() || word == "sw1" || word == "sw1.") return {.stop = true};
  if (word == "sw2" || word == "sw2.") return {.report = true};
  if (word == "sw3" || word == "sw3.") return {.restart_file = true};
  if (word == "sw4" || word == "sw4.") return {.state = true};
  fmt::print(stderr,
             "\nnugget: d3kil says '{}', expected sw1 (stop with a restart file), sw2 (time and cycle), sw3 (a "
             "restart file) or sw4 (a state of d3plot); the run goes on\n",
             word);
  return {};
}

}  // namespace nugget::app
