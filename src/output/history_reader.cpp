// SPDX-License-Identifier: Apache-2.0
#include "output/history_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

#include "output/abstat.hpp"
#include "output/ascii_reader.hpp"
#include "output/binout_reader.hpp"
#include "output/dcfail.hpp"
#include "output/deforc.hpp"
#include "output/glstat.hpp"
#include "output/history_samples.hpp"
#include "output/jntforc.hpp"
#include "output/matsum.hpp"
#include "output/ncforc.hpp"
#include "output/nodout.hpp"
#include "output/rbdout.hpp"
#include "output/rcforc.hpp"
#include "output/rwforc.hpp"
#include "output/secforc.hpp"
#include "output/sleout.hpp"
#include "output/spcforc.hpp"
#include "output/swforc.hpp"

namespace nugget::output {
namespace {

/// A branch of binout, what its rows are, and what its titles are of where these are others.
struct ReadBranch {
  std::string path, kind, titled = {};
};

struct ReadFile {
  std::string_view name;
  std::vector<ReadBranch> branches;
  std::vector<ColumnMeaning> (*meanings)();
};

const std::vector<ReadFile>& read_files() {
  static const std::vector<ReadFile> files{
      {"abstat", {{"abstat", "airbag"}}, [] { return meanings(abstat()); }},
      {"dcfail", {{"dcfail", "weld"}}, [] { return meanings(dcfail()); }},
      {"deforc", {{"deforc", "spring"}}, [] { return meanings(deforc()); }},
      {"glstat", {{"glstat", ""}}, [] { return meanings(glstat()); }},
      {"jntforc",
       {{"jntforc/joints", "joint"}, {"jntforc/type0", "joint stiffness"}, {"jntforc/type1", "joint stiffness"}},
       [] { return meanings(jntforc()); }},
      {"matsum", {{"matsum", "part"}}, [] { return meanings(matsum()); }},
      {"ncforc", {}, [] { return meanings(ncforc({{}})); }},
      {"nodout", {{"nodout", "node"}}, [] { return meanings(nodout()); }},
      {"rbdout", {{"rbdout", "rigid body"}}, [] { return meanings(rbdout()); }},
      {"rcforc", {{"rcforc", "contact"}}, [] { return meanings(rcforc()); }},
      {"rwforc",
       {{"rwforc/forces", "wall"}, {"rwforc/transducer", "transducer"}},
       [] { return meanings(rwforc_with_areas({0})); }},
      {"secforc", {{"secforc", "section"}}, [] { return meanings(secforc()); }},
      {"sleout", {{"sleout", "contact"}}, [] { return meanings(sleout()); }},
      {"spcforc", {{"spcforc", "node"}}, [] { return meanings(spcforc()); }},
      {"swforc", {{"swforc", "weld"}}, [] { return meanings(swforc()); }},
  };
  return files;
}

constexpr std::string_view area_of_wall = " area";  // ends the kind of what rwforc has of a wall's areas

/// Those of rwforc: a wall with areas has a branch by its place, `wall001` the first.
std::vector<ReadBranch> branches_of_walls(const BinoutReader& binout, const ReadFile& file) {
  std::vector<ReadBranch> branches = file.branches;
  const std::vector<double> walls = binout.numbers("/rwforc/forces/metadata/ids");
  for (const std::string& name : binout.branches("rwforc")) {
    if (!name.starts_with("wall")) continue;
    const auto place = static_cast<std::size_t>(std::atoi(name.c_str() + 4));
    if (place >= 1 && place <= walls.size())
      branches.push_back({"rwforc/" + name, fmt::format("wall {:.0f}{}", walls[place - 1], area_of_wall)});
  }
  return branches;
}

/// The branches of a file; those of ncforc are the sides of contacts, by their ids, the tracked side first.
std::vector<ReadBranch> branches_of(const BinoutReader& binout, const ReadFile& file) {
  if (file.name == "rwforc") return branches_of_walls(binout, file);
  if (file.name != "ncforc") return file.branches;
  std::vector<std::tuple<int, bool, std::string>> sides;
  for (const std::string& name : binout.branches("ncforc")) {
    const bool reference = name.starts_with("master_");
    if (reference || name.starts_with("slave_"))
      sides.emplace_back(std::atoi(name.c_str() + name.find('_') + 1), reference, name);
  }
  std::ranges::sort(sides);
  std::vector<ReadBranch> branches;
  branches.reserve(sides.size());
  for (const auto& [contact, reference, name] : sides)
    branches.push_back({"ncforc/" + name,
                        fmt::format("contact {} {} side node", contact, reference ? "reference" : "tracked"),
                        "contact"});
  return branches;
}

/// Names of the rows of a branch; of one value more than rows (sums) nothing is known.
std::vector<std::string> entities(const BinoutReader& binout, const ReadBranch& branch) {
  const std::string metadata = "/" + branch.path + "/metadata";
  const std::vector<double> ids = binout.numbers(metadata + "/ids"), sides = binout.numbers(metadata + "/side"),
                            nodal = binout.numbers(metadata + "/num_nodal");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    std::string name = fmt::format("{} {:.0f}", branch.kind, ids[i]);
    if (i < sides.size()) name += sides[i] == 0.0 ? " tracked side" : " reference side";
    if (!nodal.empty() && static_cast<double>(i) >= static_cast<double>(ids.size()) - nodal[0])
      name.insert(0, "nodal ");
    names.push_back(name);
  }
  return names;
}

/// The rows that a variable is of: supports have lists of their own, walls in glstat none, sums of areas one for all.
std::vector<std::string> entities_of(const BinoutReader& binout, const ReadBranch& branch, const std::string& variable,
                                     const std::vector<std::string>& rows, std::size_t count) {
  const std::string metadata = "/" + branch.path + "/metadata";
  if (branch.path == "spcforc" && variable.find("resultant") == variable.npos && variable != "time") {
    std::vector<std::string> nodes;
    for (const double id : binout.numbers(metadata + (variable.ends_with("_moment") ? "/moment_ids" : "/force_ids")))
      nodes.push_back(fmt::format("node {:.0f}", id));
    return nodes;
  }
  if (variable == "stonewall_energy") {
    std::vector<std::string> walls;
    for (std::size_t i = 0; i < count; ++i) walls.push_back(fmt::format("wall {}", i + 1));
    return walls;
  }
  if (branch.kind.ends_with(area_of_wall) && variable.starts_with("total_")) return {branch.kind + 's'};
  if (rows.size() == count) return rows;
  return count == 1 ? std::vector<std::string>{""} : std::vector<std::string>{};
}

/// What counts and names, and no history.
bool is_history(std::string_view variable) {
  constexpr std::array<std::string_view, 6> not_one{"time", "cycle", "ts_eltype", "ts_element", "ts_part", "nzc"};
  return std::find(not_one.begin(), not_one.end(), variable) == not_one.end() && variable.find("number_of") != 0;
}

/// A branch as its states are read.
struct BranchInReading {
  const ReadBranch* branch;
  std::vector<std::string> rows;
  /// By variable, of the state before: places in the samples of its values.
  std::map<std::string_view, std::vector<std::size_t>> places;
};

/// One state of a branch; its numbers are those of the branches beside it.
void read_state(const BinoutReader& binout, BranchInReading& reading, const std::string& state,
                HistorySamples& samples) {
  const std::string directory = fmt::format("/{}/{}", reading.branch->path, state);
  const std::vector<double> time = binout.numbers(directory + "/time");
  if (time.empty()) return;
  if (samples.empty() || time[0] != samples.time()) samples.begin_state(time[0]);
  for (const BinoutReader::Variable& variable : binout.variables(directory)) {
    if (!is_history(variable.name)) continue;
    const std::vector<double> values = binout.numbers(variable);
    std::vector<std::size_t>& places = reading.places[variable.name];
    if (places.size() != values.size()) {
      places.clear();
      for (const std::string& of :
           entities_of(binout, *reading.branch, std::string(variable.name), reading.rows, values.size()))
        if (places.size() < values.size()) places.push_back(samples.place(of, variable.name));
    }
    for (std::size_t i = 0; i < std::min(places.size(), values.size()); ++i) samples.put(places[i], values[i]);
  }
}

void add_titles(const BinoutReader& binout, const std::vector<ReadBranch>& branches, HistoryRecord& record) {
  constexpr std::size_t width = 70;
  for (const ReadBranch& branch : branches) {
    const std::string metadata = "/" + branch.path + "/metadata", text = binout.text(metadata + "/legend");
    const std::vector<double> ids = binout.numbers(metadata + "/legend_ids");
    for (std::size_t i = 0; i < ids.size() && (i + 1) * width <= text.size(); ++i) {
      std::string title = text.substr(i * width, width);
      title.erase(title.find_last_not_of(' ') + 1);
      const std::string name = fmt::format("{} {:.0f}", branch.titled.empty() ? branch.kind : branch.titled, ids[i]);
      for (Channel& channel : record.channels)
        if (channel.entity == name || channel.entity.find(name + ' ') == 0) channel.title = title;
    }
  }
}

HistoryRecord read_one(const std::filesystem::path& directory, const BinoutReader& binout, const ReadFile& file) {
  HistorySamples samples{std::string(file.name)};
  const std::vector<ReadBranch> all = branches_of(binout, file);
  std::set<std::pair<std::size_t, std::string>> states;  // d01000000 follows d999999
  for (const ReadBranch& branch : all)
    for (const std::string& state : binout.states(branch.path)) states.emplace(state.size(), state);
  std::vector<BranchInReading> branches;
  branches.reserve(all.size());
  for (const ReadBranch& branch : all) branches.push_back({&branch, entities(binout, branch), {}});
  for (const auto& [length, state] : states)
    for (BranchInReading& branch : branches) read_state(binout, branch, state, samples);
  HistoryRecord record = samples.take();
  if (record.times.empty())
    record = read_ascii_history(directory / file.name);
  else
    add_titles(binout, all, record);
  for (const ColumnMeaning& meaning : file.meanings())
    for (Channel& channel : record.channels)
      if (channel.quantity == meaning.name) channel.dimension = meaning.dimension;
  return record;
}

}  // namespace

std::span<const std::string_view> readable_histories() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const ReadFile& file : read_files()) all.push_back(file.name);
    return all;
  }();
  return names;
}

std::vector<HistoryRecord> read_histories(const std::filesystem::path& directory,
                                          std::span<const std::string_view> files) {
  const BinoutReader binout(directory);
  std::vector<HistoryRecord> records;
  for (const ReadFile& file : read_files()) {
    if (std::find(files.begin(), files.end(), file.name) == files.end()) continue;
    HistoryRecord record = read_one(directory, binout, file);
    if (!record.times.empty()) records.push_back(std::move(record));
  }
  return records;
}

}  // namespace nugget::output
