// SPDX-License-Identifier: Apache-2.0
#include "output/ascii_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>

#include "output/abstat.hpp"
#include "output/dcfail.hpp"
#include "output/rwforc.hpp"
#include "output/sleout.hpp"

namespace nugget::output {
namespace {

constexpr std::array<std::string_view, 3> axis_names{"x", "y", "z"};

/// A number of a field of columns; nothing where there is none, or more than one.
std::optional<double> number_of_field(const std::string& line, std::size_t first, std::size_t width) {
  if (line.size() < first + width) return std::nullopt;
  const std::string field = line.substr(first, width);
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  const bool any = end != field.c_str();
  while (*end == ' ') ++end;
  return any && *end == '\0' ? std::optional(value) : std::nullopt;
}

/// The number behind the first `key` in a line.
std::optional<double> number_behind(const std::string& line, std::string_view key) {
  const std::size_t place = line.find(key);
  if (place == line.npos) return std::nullopt;
  const char* text = line.c_str() + place + key.size();
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  return end == text ? std::nullopt : std::optional(value);
}

bool starts_with(const std::string& line, std::string_view text) {
  return line.compare(0, text.size(), text) == 0;
}

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

/// ` kinetic energy.................   1.00000E+00`: name and value; an empty name for other lines.
std::pair<std::string, double> dotted(const std::string& line) {
  const std::size_t dots = line.find("..");
  if (!starts_with(line, " ") || dots == line.npos) return {};
  const std::size_t value = line.find_first_not_of(". ", dots);
  if (value == line.npos) return {};
  return {trimmed(line.substr(0, dots)), std::strtod(line.c_str() + value, nullptr)};
}

std::string underscored(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

void read_glstat(std::istream& in, HistorySamples& samples) {
  const std::pair<std::string_view, std::string_view> names[] = {
      {"total energy / initial energy", "energy_ratio"},
      {"energy ratio w/o eroded energy", "energy_ratio_wo_eroded"},
      {"percentage increase", "percent_increase"}};
  int wall = 0;
  for (std::string line; std::getline(in, line);) {
    auto [name, value] = dotted(line);
    if (name.empty() || name == "time per zone cycle.(nanosec)" || starts_with(name, "number of")) continue;
    if (name == "time") {
      samples.begin_state(value);
      wall = 0;
    } else if (name == "stonewall energy") {
      samples.put(fmt::format("wall {}", ++wall), "stonewall_energy", value);
    } else {
      for (const auto& [ours, binouts] : names)
        if (name == ours) name = binouts;
      samples.put("", underscored(name), value);
    }
  }
}

void read_matsum(std::istream& in, HistorySamples& samples) {
  std::string part;
  const std::pair<std::string_view, std::string_view> names[] = {{"inten=", "internal_energy"},
                                                                 {"kinen=", "kinetic_energy"},
                                                                 {"eroded_ie=", "eroded_internal_energy"},
                                                                 {"x-mom=", "x_momentum"},
                                                                 {"y-mom=", "y_momentum"},
                                                                 {"z-mom=", "z_momentum"},
                                                                 {"x-rbv=", "x_rbvelocity"},
                                                                 {"y-rbv=", "y_rbvelocity"},
                                                                 {"z-rbv=", "z_rbvelocity"},
                                                                 {"hgeng=", "hourglass_energy"},
                                                                 {"eroded_ke=", "eroded_kinetic_energy"},
                                                                 {"+mass=", "mass"}};
  for (std::string line; std::getline(in, line);) {
    if (const auto time = number_behind(line, " time =")) samples.begin_state(*time);
    if (const auto id = number_behind(line, "mat.#="))
      part = *id == 0.0 ? "masses of no part" : fmt::format("part {:.0f}", *id);
    for (const auto& [key, name] : names)
      if (const auto value = number_behind(line, key)) samples.put(part, name, *value);
  }
}

void read_nodout(std::istream& in, HistorySamples& samples) {
  const std::array<std::string_view, 4> translations{"displacement", "velocity", "acceleration", "coordinate"};
  bool rotations = false;
  for (std::string line; std::getline(in, line);) {
    if (const auto time = number_behind(line, "( at time")) {
      if (samples.empty() || *time != samples.time()) samples.begin_state(*time);
    }
    if (line.find("nodal point") != line.npos) rotations = line.find("x-rot") != line.npos;
    const auto node = number_of_field(line, 0, 9);
    if (!node || line.size() < 10 + 9 * 12) continue;
    const std::string entity = fmt::format("node {:.0f}", *node);
    for (std::size_t group = 0; group < (rotations ? 3U : 4U); ++group)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (const auto value = number_of_field(line, 10 + 12 * (3 * group + axis), 12))
          samples.put(entity, fmt::format("{}{}_{}", rotations ? "r" : "", axis_names[axis], translations[group]),
                      *value);
  }
}

/// Row of swforc: number, axial, shear, time, failure, label of 20 columns, id, then length, moment and torsion or
/// text.
void read_swforc(std::istream& in, HistorySamples& samples) {
  bool begins = false;
  for (std::string line; std::getline(in, line);) {
    if (line.find("constraint #") != line.npos) begins = true;
    const std::size_t digits = line.find_first_not_of(' ');
    const std::size_t at = digits == line.npos ? line.npos : std::max<std::size_t>(11, line.find(' ', digits));
    if (at == line.npos || line.size() < at + 80) continue;
    const auto axial = number_of_field(line, at, 13), shear = number_of_field(line, at + 13, 13),
               time = number_of_field(line, at + 26, 13);
    const auto id = number_of_field(line, at + 72, 8);
    if (!axial || !shear || !time || !id) continue;
    if (begins) samples.begin_state(*time);
    begins = false;
    const std::string entity = fmt::format("weld {:.0f}", *id);
    const std::string failure = trimmed(line.substr(at + 39, 13));
    samples.put(entity, "axial", *axial);
    samples.put(entity, "shear", *shear);
    samples.put(entity, "failure", failure == "failure" ? 1.0 : std::strtod(failure.c_str(), nullptr));
    if (const auto failed = number_behind(line, "failure time=")) samples.put(entity, "failure_time", *failed);
    const bool has_torsion = line.find("failure time=") == line.npos;
    const std::array<std::string_view, 3> names{"length", "resultant_moment", "torsion"};
    for (std::size_t i = 0; has_torsion && i < names.size(); ++i)
      if (const auto value = number_of_field(line, at + 80 + 13 * i, 13)) samples.put(entity, names[i], *value);
    if (const auto value = number_behind(line, "fres=")) samples.put(entity, "resultant_force", *value);
  }
}

void read_rcforc(std::istream& in, HistorySamples& samples) {
  for (std::string line; std::getline(in, line);) {
    const auto time = number_behind(line, " time");
    const bool master = starts_with(line, "  master"), slave = starts_with(line, "  slave ");
    const auto contact = number_of_field(line, 8, 11);
    if (!time || !contact || !(master || slave)) continue;
    const std::string entity = fmt::format("contact {:.0f} {}", *contact, master ? "reference side" : "tracked side");
    if (samples.empty() || *time != samples.time() || samples.has(entity, "x_force")) samples.begin_state(*time);
    for (const std::string_view axis : axis_names)
      if (const auto value = number_behind(line, fmt::format("  {} ", axis)))
        samples.put(entity, fmt::format("{}_force", axis), *value);
  }
}

void read_ncforc(std::istream& in, HistorySamples& samples) {
  constexpr std::array<std::string_view, 4> forces{"x_force", "y_force", "z_force", "pressure"};
  std::string side;
  std::set<std::string> of_state;
  for (std::string line; std::getline(in, line);) {
    if (const auto time = number_behind(line, " forces (t="), contact = number_behind(line, "for interface");
        time && contact) {
      side = fmt::format("contact {:.0f} {} side node", *contact,
                         line.find("master") != line.npos ? "reference" : "tracked");
      // A side that comes again begins another state, whatever the time is printed as.
      if (samples.empty() || *time != samples.time() || of_state.contains(side)) {
        samples.begin_state(*time);
        of_state.clear();
      }
      of_state.insert(side);
      continue;
    }
    const auto node = number_of_field(line, 0, 10);
    std::string place;
    if (side.empty() || !node || line.size() < 72 || !std::getline(in, place)) continue;
    const std::string entity = fmt::format("{} {:.0f}", side, *node);
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (const auto value = number_of_field(line, 16 + 14 * i, 14)) samples.put(entity, forces[i], *value);
    for (std::size_t i = 0; i < axis_names.size(); ++i)
      if (const auto value = number_of_field(place, 16 + 14 * i, 14)) samples.put(entity, axis_names[i], *value);
  }
}

/// Three numbers and a fourth, as secforc has them.
void put_four(HistorySamples& samples, const std::string& line, const std::string& entity, std::string_view vector,
              std::string_view last) {
  constexpr std::size_t first = 27;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const auto value = number_of_field(line, axis == 0 ? first : first + 3 + 12 * axis, axis == 0 ? 15 : 12))
      samples.put(entity, fmt::format("{}_{}", axis_names[axis], vector), *value);
  if (const auto value = number_of_field(line, first + 3 + 36, 12)) samples.put(entity, last, *value);
}

void read_secforc(std::istream& in, HistorySamples& samples) {
  for (std::string line; std::getline(in, line);) {
    const auto id = number_of_field(line, 0, 12), time = number_of_field(line, 12, 15);
    if (!id || !time || line.size() < 78) continue;
    std::string moments, centroid;
    if (!std::getline(in, moments) || !std::getline(in, centroid)) return;
    const std::string entity = fmt::format("section {:.0f}", *id);
    if (samples.empty() || *time != samples.time() || samples.has(entity, "x_force")) samples.begin_state(*time);
    put_four(samples, line, entity, "force", "total_force");
    put_four(samples, moments, entity, "moment", "total_moment");
    put_four(samples, centroid, entity, "centroid", "area");
  }
}

void read_spcforc(std::istream& in, HistorySamples& samples) {
  for (std::string line; std::getline(in, line);) {
    if (const auto time = number_behind(line, "output at time =")) samples.begin_state(*time);
    const auto put = [&](const std::string& entity, std::string_view suffix, std::size_t first) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (const auto value = number_of_field(line, first + 14 * axis, 14))
          samples.put(entity, fmt::format("{}_{}", axis_names[axis], suffix), *value);
    };
    const std::size_t equals = line.rfind('=', line.find("  setid"));
    if (const auto node = number_behind(line, " node="); node && equals != line.npos)
      put(fmt::format("node {:.0f}", *node), line.find("moments") != line.npos ? "moment" : "force", equals + 1);
    if (const std::size_t place = line.find("force resultants   ="); place != line.npos)
      put("", "resultant", place + 20);
  }
}

void read_rbdout(std::istream& in, HistorySamples& samples) {
  std::string body;
  const std::pair<std::string_view, std::string_view> rows[] = {
      {"coordinates", ""}, {"displacements", "d"}, {"velocities", "v"}, {"accelerations", "a"}};
  bool global = false;
  for (std::string line; std::getline(in, line);) {
    if (const auto time = number_behind(line, "time="); time && line.find("m o t i o n") != line.npos)
      samples.begin_state(*time);
    if (const auto id = number_behind(line, " rigid body"))
      body = fmt::format("{} {:.0f}", starts_with(line, " nodal") ? "nodal rigid body" : "rigid body", *id);
    if (line.find("   global  ") == 0) global = true;
    if (line.find("local coordinate direction") != line.npos) global = false;
    const std::size_t colon = line.find(":  ");
    if (!global || colon == line.npos) continue;
    for (const auto& [row, letter] : rows) {
      if (trimmed(line.substr(0, colon)) != row) continue;
      for (std::size_t i = 0; i < 6; ++i)
        if (const auto value = number_of_field(line, colon + 3 + 12 * i, 12))
          samples.put(body, fmt::format("global_{}{}{}", i < 3 ? "" : "r", letter, axis_names[i % 3]), *value);
    }
  }
}

/// deforc and jntforc: `name....  value` of one entity after the other; `heads` are the lines that begin one.
void read_dotted(std::istream& in, HistorySamples& samples,
                 std::span<const std::pair<std::string_view, std::string_view>> heads) {
  std::string entity;
  for (std::string line; std::getline(in, line);) {
    std::string name;
    double value = 0.0;
    std::tie(name, value) = dotted(line);
    if (name.empty()) continue;
    if (name == "time") {
      samples.begin_state(value);
      continue;
    }
    const auto head = std::find_if(heads.begin(), heads.end(), [&](const auto& h) { return h.first == name; });
    if (head != heads.end()) {
      entity = fmt::format("{} {:.0f}", head->second, value);
      continue;
    }
    std::replace(name.begin(), name.end(), '-', '_');
    samples.put(entity, name == "change in length" || name == "relative rotation" ? "displacement" : underscored(name),
                value);
  }
}

void read_deforc(std::istream& in, HistorySamples& samples) {
  constexpr std::pair<std::string_view, std::string_view> heads[] = {{"spring/damper number", "spring"}};
  read_dotted(in, samples, heads);
}

void read_jntforc(std::istream& in, HistorySamples& samples) {
  constexpr std::pair<std::string_view, std::string_view> heads[] = {{"joint ID", "joint"},
                                                                     {"joint stiffness id number", "joint stiffness"}};
  read_dotted(in, samples, heads);
}

/// A field of a row's template: `{name:15.4E}`.
struct RowField {
  std::string name;
  std::size_t width = 0;
};
std::vector<RowField> fields_of(std::string_view row) {
  std::vector<RowField> fields;
  for (std::size_t open = row.find('{'); open != row.npos; open = row.find('{', open + 1)) {
    const std::size_t colon = row.find(':', open);
    fields.push_back({std::string(row.substr(open + 1, colon - open - 1)),
                      static_cast<std::size_t>(std::strtoul(row.data() + colon + 1, nullptr, 10))});
  }
  return fields;
}

/// The words that stand before the time in the head of a state; empty where each row has it.
std::string_view words_before_time(std::string_view head) {
  const std::size_t place = head.find("{time");
  if (place == head.npos) return {};
  const std::size_t line = head.rfind('\n', place);
  return head.substr(line == head.npos ? 0 : line + 1, place - (line == head.npos ? 0 : line + 1));
}

/// A regular file, by the template that it is written with.
void read_lines(std::istream& in, HistorySamples& samples, const Lines& lines, std::string_view kind) {
  const std::vector<RowField> fields = fields_of(lines.row);
  const std::string_view before_time = words_before_time(lines.head);
  for (std::string line; std::getline(in, line);) {
    if (!before_time.empty())
      if (const auto time = number_behind(line, before_time)) samples.begin_state(*time);
    std::vector<double> values;
    std::size_t first = 0;
    for (const RowField& field : fields) {
      const auto value = number_of_field(line, first, field.width);
      if (!value) break;
      values.push_back(*value);
      first += field.width;
    }
    if (values.size() != fields.size()) continue;
    std::string entity;
    std::optional<double> time;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].name == "id") entity = fmt::format("{} {:.0f}", kind, values[i]);
      if (fields[i].name == "time") time = values[i];
    }
    if (time && (samples.empty() || *time != samples.time() || samples.has(entity, fields.back().name)))
      samples.begin_state(*time);
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].name != "id" && fields[i].name != "time") samples.put(entity, fields[i].name, values[i]);
  }
}

struct AsciiReader {
  std::string_view file;
  void (*read)(std::istream&, HistorySamples&);
};
constexpr AsciiReader readers[] = {
    {"abstat", [](std::istream& in, HistorySamples& s) { read_lines(in, s, abstat().lines, "airbag"); }},
    {"dcfail", [](std::istream& in, HistorySamples& s) { read_lines(in, s, dcfail().lines, "weld"); }},
    {"deforc", read_deforc},
    {"glstat", read_glstat},
    {"jntforc", read_jntforc},
    {"matsum", read_matsum},
    {"ncforc", read_ncforc},
    {"nodout", read_nodout},
    {"rbdout", read_rbdout},
    {"rcforc", read_rcforc},
    {"rwforc", [](std::istream& in, HistorySamples& s) { read_lines(in, s, rwforc().lines, "wall"); }},
    {"secforc", read_secforc},
    {"sleout", [](std::istream& in, HistorySamples& s) { read_lines(in, s, sleout().lines, "contact"); }},
    {"spcforc", read_spcforc},
    {"swforc", read_swforc},
};

const AsciiReader* reader_of(std::string_view name) {
  const auto found =
      std::find_if(std::begin(readers), std::end(readers), [&](const AsciiReader& r) { return r.file == name; });
  return found == std::end(readers) ? nullptr : found;
}

/// The file up to its last line end: a line that is being written is none.
std::string whole_lines(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  text.resize(text.rfind('\n') == text.npos ? 0 : text.rfind('\n') + 1);
  return text;
}

/// Titles of the legend, by id: `        1     barrier`.
std::map<std::string, std::string> read_legend(const std::string& text) {
  std::map<std::string, std::string> titles;
  const std::size_t begin = text.find("{BEGIN LEGEND}"), end = text.find("{END LEGEND}");
  if (begin == text.npos || end == text.npos) return titles;
  std::istringstream in(text.substr(begin, end - begin));
  for (std::string line; std::getline(in, line);)
    if (const auto id = number_of_field(line, 0, 9)) titles[fmt::format("{:.0f}", *id)] = trimmed(line.substr(9));
  return titles;
}

}  // namespace

bool can_read_ascii_history(std::string_view name) {
  return reader_of(name) != nullptr;
}

HistoryRecord read_ascii_history(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  HistorySamples samples(name);
  const AsciiReader* reader = reader_of(name);
  const std::string text = reader ? whole_lines(path) : std::string();
  std::istringstream in(text);
  if (reader) reader->read(in, samples);
  HistoryRecord record = samples.take();
  const std::map<std::string, std::string> titles = read_legend(text);
  for (Channel& channel : record.channels)
    for (const auto& [id, title] : titles)
      if ((' ' + channel.entity + ' ').find(' ' + id + ' ') != std::string::npos) channel.title = title;
  return record;
}

}  // namespace nugget::output
