// SPDX-License-Identifier: Apache-2.0
#include "report/tidy_table.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/append.hpp"
#include "output/history_reader.hpp"
#include "output/result_file.hpp"
#include "report/quantity.hpp"

namespace nugget::report {
namespace {

/// A cell of a comma-separated line (RFC 4180).
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::size_t write_tidy_table(const std::filesystem::path& directory, const std::filesystem::path& file,
                             const nlohmann::json& summary) {
  const std::vector<output::HistoryRecord> records = output::read_histories(directory);
  if (records.empty())
    throw std::runtime_error(
        fmt::format("{} has no histories: *DATABASE_GLSTAT, _SWFORC, ... ask for them", directory.string()));
  std::string text = "file,entity,title,quantity,unit,time,value\n";
  std::size_t rows = 0;
  for (const output::HistoryRecord& record : records)
    for (const output::Channel& channel : record.channels) {
      const std::string unit = unit_of(summary, channel.dimension);
      const std::string head =
          fmt::format("{},{},{},{},{}", record.file, csv_cell(channel.entity), csv_cell(channel.title),
                      csv_cell(channel.quantity), csv_cell(unit.empty() ? unit : unit.substr(1)));
      for (std::size_t i = 0; i < record.times.size(); ++i, ++rows)
        append(text, "{},{},{}\n", head, record.times[i], channel.values[i]);
    }
  output::write_whole_file(file, text);
  return rows;
}

}  // namespace nugget::report
