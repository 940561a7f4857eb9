// SPDX-License-Identifier: Apache-2.0
#include "report/run_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "output/history_reader.hpp"

namespace nugget::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Null where the file is missing or is no JSON.
Json read_json(const fs::path& path) {
  std::ifstream file(path);
  return file ? Json::parse(file, nullptr, false) : Json(Json::value_t::discarded);
}

/// The cells of a comma-separated line; quoted ones may hold commas and doubled quotes (RFC 4180).
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      out.back() += line[i++];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      out.emplace_back();
    else if (c != '\r')
      out.back() += c;
  }
  return out;
}

std::vector<WeldRow> read_table(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) return {};
  const std::vector<std::string> names = cells(line);
  std::vector<WeldRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> values = cells(line);
    WeldRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) row[names[i]] = values[i];
  }
  return rows;
}

/// Lines of a response stand together, in ascending order of frequency.
std::vector<ResponseCurve> read_responses(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);  // node, direction, response, frequency, amplitude, phase, real, imaginary; case
  const auto number = [](const std::string& cell) {
    return cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(cell.c_str(), nullptr);
  };
  std::vector<ResponseCurve> curves;
  while (std::getline(file, line)) {
    const std::vector<std::string> cell = cells(line);
    if (cell.size() < 6) continue;
    std::string name = fmt::format("node {} {}", cell[0], cell[1]);
    if (cell.size() > 8) name = fmt::format("case {}, {}", cell[8], name);
    if (curves.empty() || curves.back().name != name || curves.back().quantity != cell[2])
      curves.push_back({name, cell[2], {}, {}, {}});
    curves.back().frequency.push_back(number(cell[3]));
    curves.back().amplitude.push_back(number(cell[4]));
    curves.back().phase.push_back(number(cell[5]));
  }
  return curves;
}

/// erp.csv.
std::vector<ResponseCurve> read_power(const fs::path& path) {
  std::vector<ResponseCurve> curves;
  for (const WeldRow& row : read_table(path)) {
    const auto number = [&](const char* column) {
      const std::string& cell = row.at(column);
      return cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(cell.c_str(), nullptr);
    };
    if (curves.empty() || curves.back().name != row.at("panel"))
      curves.push_back({row.at("panel"), "radiated power", {}, {}, {}});
    curves.back().frequency.push_back(number("frequency"));
    curves.back().amplitude.push_back(number("power"));
  }
  return curves;
}

/// The energies worth a curve: those that are not zero all the time.
void read_energies(const fs::path& directory, RunData& data) {
  constexpr std::string_view file = "glstat";
  const std::vector<output::HistoryRecord> found = output::read_histories(directory, {&file, 1});
  if (found.empty()) return;
  data.times = found[0].times;
  for (const char* name :
       {"kinetic energy", "internal energy", "hourglass energy", "sliding interface energy", "stonewall energy",
        "eroded kinetic energy", "eroded internal energy", "external work", "total energy"}) {
    std::string quantity = name;
    std::replace(quantity.begin(), quantity.end(), ' ', '_');
    const auto channel = std::find_if(found[0].channels.begin(), found[0].channels.end(),
                                      [&](const output::Channel& c) { return c.quantity == quantity; });
    if (channel == found[0].channels.end()) continue;
    if (std::any_of(channel->values.begin(), channel->values.end(), [](double value) { return value != 0.0; }))
      data.energies.emplace_back(name, channel->values);
  }
}

}  // namespace

RunData::RunData() = default;
RunData::RunData(const RunData&) = default;
RunData::RunData(RunData&&) noexcept = default;
RunData& RunData::operator=(const RunData& other) {
  return *this = RunData(other);
}
RunData& RunData::operator=(RunData&&) noexcept = default;
RunData::~RunData() = default;

RunData read_run(const fs::path& directory) {
  RunData data;
  data.summary = read_json(directory / "summary.json");
  if (!data.summary.is_object())
    throw std::runtime_error(
        fmt::format("{} holds no results of a run: there is no summary.json that can be read", directory.string()));
  data.findings = read_json(directory / "findings.json");
  if (!data.findings.is_array()) data.findings = Json::array();
  data.welds = read_table(directory / "welds.csv");
  read_energies(directory, data);
  data.shares = read_table(directory / "mode_energy.csv");
  data.frf = read_responses(directory / "frf.csv");
  data.ssd = read_responses(directory / "ssd.csv");
  data.power = read_power(directory / "erp.csv");
  return data;
}

}  // namespace nugget::report
