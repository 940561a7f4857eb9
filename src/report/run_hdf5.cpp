// SPDX-License-Identifier: Apache-2.0
#include "report/run_hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "model/units.hpp"
#include "output/column_units.hpp"
#include "output/history_reader.hpp"
#include "output/result_file.hpp"
#include "report/hdf5_file.hpp"
#include "report/quantity.hpp"

namespace nugget::report {
namespace {

using output::Channel;
using output::HistoryRecord;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A name of HDF5 has no strokes: they part groups.
std::string link_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name.empty() ? "-" : name;
}

std::string symbol_of(const RunData& run, const Dimension& dimension) {
  const std::string unit = unit_of(run.summary, dimension);
  return unit.empty() ? unit : unit.substr(1);
}

/// Each entity of a history once, in the order in which they come.
std::vector<const Channel*> one_of_each_entity(const HistoryRecord& record) {
  std::vector<const Channel*> each;
  std::set<std::string> seen;
  for (const Channel& channel : record.channels)
    if (!channel.entity.empty() && seen.insert(channel.entity).second) each.push_back(&channel);
  return each;
}

/// A history file as a group: its times, its entities, and each quantity over times, or over times and entities.
class HistoryGroup {
 public:
  HistoryGroup(Hdf5File& file, const HistoryRecord& record, const RunData& run)
      : file_(file), record_(record), run_(run), path_('/' + record.file), entities_(one_of_each_entity(record)) {
    for (std::size_t i = 0; i < entities_.size(); ++i) column_[entities_[i]->entity] = i;
  }

  void write() {
    file_.group(path_);
    file_.numbers(path_ + "/time", record_.times);
    file_.attribute(path_ + "/time", "unit", symbol_of(run_, dimension::time));
    write_entities();
    std::map<std::string, std::vector<const Channel*>> of;
    for (const Channel& channel : record_.channels) of[channel.quantity].push_back(&channel);
    for (const auto& [quantity, channels] : of) {
      const std::string path = path_ + '/' + link_name(quantity == "time" ? "time_" : quantity);
      if (channels.size() == 1 && channels.front()->entity.empty())
        file_.numbers(path, channels.front()->values);
      else
        write_table(path, channels);
      file_.attribute(path, "unit", symbol_of(run_, channels.front()->dimension));
    }
  }

 private:
  void write_entities() {
    if (entities_.empty()) return;
    std::vector<std::string> names, titles;
    for (const Channel* channel : entities_) {
      names.push_back(channel->entity);
      titles.push_back(channel->title);
    }
    file_.texts(path_ + "/entity", names);
    if (std::any_of(titles.begin(), titles.end(), [](const std::string& t) { return !t.empty(); }))
      file_.texts(path_ + "/title", titles);
  }
  void write_table(const std::string& path, const std::vector<const Channel*>& channels) {
    std::vector<double> values(record_.times.size() * entities_.size(), no_number);
    for (const Channel* channel : channels) {
      const auto found = column_.find(channel->entity);
      if (found == column_.end()) continue;
      for (std::size_t i = 0; i < record_.times.size(); ++i)
        values[i * entities_.size() + found->second] = channel->values[i];
    }
    file_.table(path, values, record_.times.size(), entities_.size());
  }

  Hdf5File& file_;
  const HistoryRecord& record_;
  const RunData& run_;
  std::string path_;
  std::vector<const Channel*> entities_;
  std::map<std::string, std::size_t> column_;
};

/// A table of ours as a group with a dataset for each column: whole numbers and numbers as such, else texts.
void write_columns(Hdf5File& file, const std::string& group, const std::string& csv, const std::vector<WeldRow>& rows,
                   const RunData& run) {
  file.group(group);
  const auto units = model::units_named(run.summary.value("units", ""));
  for (const auto& [column, first] : rows.front()) {
    std::vector<std::string> cells;
    for (const WeldRow& row : rows) cells.push_back(row.contains(column) ? row.at(column) : std::string());
    std::vector<double> numbers;
    std::vector<std::int32_t> whole;
    const auto quantity = output::column_quantity(csv, column);
    bool all_numbers = true;
    for (const std::string& cell : cells) {
      char* end = nullptr;
      numbers.push_back(cell.empty() ? no_number : std::strtod(cell.c_str(), &end));
      all_numbers = all_numbers && (cell.empty() || *end == '\0');
      const bool is_whole = !cell.empty() && cell.find_first_not_of("-0123456789") == cell.npos;
      if (is_whole && whole.size() + 1 == numbers.size()) whole.push_back(std::atoi(cell.c_str()));
    }
    const std::string path = group + '/' + link_name(column);
    if (!quantity && whole.size() == cells.size())
      file.whole_numbers(path, whole);
    else if (all_numbers && (quantity || std::any_of(numbers.begin(), numbers.end(), [](double v) { return v == v; })))
      file.numbers(path, numbers);
    else
      file.texts(path, cells);
    if (quantity) {
      file.attribute(path, "quantity", std::string(quantity->quantity));
      file.attribute(path, "unit", output::unit_of_column(*quantity, units));
    }
  }
}

void write_modes(Hdf5File& file, const RunData& run) {
  std::vector<double> frequency;
  for (const auto& mode : run.summary["modes"]) frequency.push_back(mode.value("frequency_hz", 0.0));
  file.group("/modes");
  file.numbers("/modes/frequency", frequency);
  file.attribute("/modes/frequency", "unit", frequency_unit(run.summary).substr(1));
}

/// A group for each response, with its frequencies.
void write_responses(Hdf5File& file, const std::string& group, const std::vector<ResponseCurve>& curves,
                     const RunData& run) {
  file.group(group);
  for (const ResponseCurve& curve : curves) {
    const std::string path = group + '/' + link_name(curve.name + ' ' + curve.quantity);
    file.group(path);
    const std::tuple<const char*, const std::vector<double>&, std::string> columns[] = {
        {"frequency", curve.frequency, frequency_unit(run.summary).substr(1)},
        {"amplitude", curve.amplitude, symbol_of(run, output::dimension_of_response(curve.quantity))},
        {"phase", curve.phase, "degree"}};
    for (const auto& [name, values, unit] : columns) {
      if (values.empty()) continue;
      file.numbers(path + '/' + name, values);
      if (!unit.empty()) file.attribute(path + '/' + name, "unit", unit);
    }
  }
}

}  // namespace

std::vector<std::string> write_hdf5(const std::filesystem::path& directory, const std::filesystem::path& path,
                                    const RunData& run) {
  Hdf5File file;
  std::vector<std::string> groups;
  for (const HistoryRecord& record : output::read_histories(directory)) {
    HistoryGroup(file, record, run).write();
    groups.push_back(record.file);
  }
  if (!run.welds.empty()) {
    write_columns(file, "/welds", "welds.csv", run.welds, run);
    groups.emplace_back("welds");
  }
  if (run.summary.contains("modes") && !run.summary["modes"].empty()) {
    write_modes(file, run);
    groups.emplace_back("modes");
  }
  const std::pair<const char*, const std::vector<ResponseCurve>&> responses[] = {
      {"frf", run.frf}, {"ssd", run.ssd}, {"erp", run.power}};
  for (const auto& [name, curves] : responses) {
    if (curves.empty()) continue;
    write_responses(file, std::string("/") + name, curves, run);
    groups.emplace_back(name);
  }
  if (groups.empty())
    throw std::runtime_error(
        fmt::format("{} has no histories, no welds and no responses: *DATABASE_GLSTAT, _SWFORC, ... ask for histories",
                    directory.string()));
  for (const char* key : {"title", "deck", "units", "termination", "version", "date"})
    file.attribute("/", key, run.summary.value(key, ""));
  output::write_whole_file(path, file.bytes());
  return groups;
}

}  // namespace nugget::report
