// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "deck/bulk.hpp"

namespace nugget::deck {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Field number8(std::string_view name, IdSpace space, std::string_view meaning, double fallback = 0.0) {
  const Range range = space == IdSpace::none ? any_value : at_least(0);
  return {name, Kind::integer, {}, fallback, range, meaning, space, 8, true};
}

/// A release of a beam's end: none is supported.
Field release(std::string_view name, std::string_view meaning) {
  return {name, Kind::integer, {}, 0.0, only(0.0), meaning, IdSpace::none, 8, true};
}

const std::array<std::string_view, 10> node_names{"n1", "n2", "n3", "n4", "n5", "n6", "n7", "n8", "n9", "n10"};

/// EID PID N1 ... and fields behind the nodes.
Card element_card(std::size_t nodes, std::vector<Field> behind = {}) {
  Card card{
      {number8("eid", IdSpace::element, "element id", required), number8("pid", IdSpace::part, "part id", required)}};
  for (std::size_t i = 0; i < nodes; ++i) card.fields.push_back(number8(node_names[i], IdSpace::node, "node id"));
  card.fields.insert(card.fields.end(), behind.begin(), behind.end());
  return card;
}

Card nodes_only_card(std::size_t nodes) {
  Card card;
  for (std::size_t i = 0; i < nodes; ++i) card.fields.push_back(number8(node_names[i], IdSpace::node, "node id"));
  return card;
}

Field real16(std::string_view name, Dimension d, std::string_view meaning, Range range = any_value) {
  Field f = wide(real(name, d, 0.0, range, meaning), 16);
  f.zero_is_default = false;
  return f;
}

/// The options behind the keyword's base name, each without its underscore.
std::vector<std::string_view> options_of(std::string_view keyword, std::string_view base) {
  std::vector<std::string_view> options;
  std::string_view rest = keyword.substr(base.size());
  while (!rest.empty()) {
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find('_'), rest.size());
    options.push_back(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  return options;
}

/// What the element readers share: the walk over lines, the two paths for a line of integers, and the appended row.
class ElementReader {
 public:
  ElementReader(const Deck& deck, const Block& block, ElementTable& out, Findings& findings, int nodes,
                std::size_t lines_per_row)
      : block_(block),
        out_(out),
        findings_(findings),
        lines_(block),
        careful_(deck, block, findings),
        element_offset_(block, IdSpace::element),
        part_offset_(block, IdSpace::part),
        node_offset_(block, IdSpace::node),
        width_(id_width(block.format)) {
    out_.nodes_per_element = nodes;
    const std::size_t rows = estimated_rows(block, lines_per_row);
    make_room(out.id, rows);
    make_room(out.part, rows);
    make_room(out.node, rows * static_cast<std::size_t>(nodes));
    make_room(out.line, rows);
    make_room(out.file, rows);
  }

 protected:
  /// The first line of an element: id, part and `count` nodes; of beams with `releases` too (four that must be 0, and
  /// their axes).
  bool read_element(std::string_view line, const Card& card, std::size_t count, bool releases = false) {
    row_ = {};
    PlainColumns cells(line);
    row_.id = cells.integer(width_);
    row_.part = cells.integer(width_);
    read_plain_nodes(cells, 0, count);
    bool nothing_released = true;
    if (releases) {
      for (int i = 0; i < 4; ++i) nothing_released = cells.integer(width_) == 0 && nothing_released;
      cells.integer(width_);
    }
    if (cells.good() && nothing_released && row_.id > 0 && row_.part > 0 && offsets_fit()) return true;
    if (trimmed(line).empty()) return false;
    const Row careful = careful_.read(card, line, lines_.number());
    row_ = {careful.integer("eid"), careful.integer("pid"), {}};
    for (std::size_t i = 0; i < count; ++i) row_.node[i] = careful.integer(node_names[i]);
    return row_.id != 0 && row_.part != 0;  // else a finding says so
  }

  /// A line of nodes only.
  void read_nodes_line(std::string_view line, const Card& card, std::size_t count) {
    PlainColumns cells(line);
    read_plain_nodes(cells, 0, count);
    if (cells.good() && apply_node_offsets()) return;
    const Row careful = careful_.read(card, line, lines_.number());
    for (std::size_t i = 0; i < count; ++i) row_.node[i] = careful.integer(node_names[i]);
  }

  /// The next line of the same element; a finding where the block ends first.
  bool next_of_element(std::string_view& line, std::string_view what) {
    if (lines_.next(line)) return true;
    findings_.error({block_.place.file, first_line_, 0}, block_.starred(),
                    fmt::format("the keyword ends before the {} of element {}", what, row_.id),
                    "add the line, or remove the element");
    return false;
  }

  void append() {
    out_.id.push_back(row_.id);
    out_.part.push_back(row_.part);
    out_.node.insert(out_.node.end(), row_.node.begin(), row_.node.begin() + out_.nodes_per_element);
    out_.line.push_back(first_line_);
  }

  /// One value of an option for the row appended last; rows of earlier blocks without the option get `absent`.
  template <class T>
  void append(std::vector<T>& column, const T& value, const T& absent) {
    column.resize(out_.id.size() - 1, absent);
    column.push_back(value);
  }

  /// Brings the columns that are not filled row by row to the table's length.
  void complete() {
    const std::size_t n = out_.id.size();
    out_.file.resize(n, static_cast<int>(block_.file));
    const auto fill = [n](auto& column, const auto& absent) {
      if (!column.empty()) column.resize(n, absent);
    };
    fill(out_.thickness, std::array<double, 4>{});
    fill(out_.angle, none);
    fill(out_.system, 0);
    fill(out_.offset, none);
    fill(out_.to_ten, char{0});
    fill(out_.tied_parts, std::array<int, 2>{});
    fill(out_.orientation, std::array<double, 3>{});
    fill(out_.section, std::array<double, 5>{});
  }

  /// False (and an error) where an option is none of `known`.
  bool options_are_known(const std::vector<std::string_view>& options, const std::vector<std::string_view>& known,
                         std::string_view remedy) {
    for (const std::string_view option : options) {
      if (std::find(known.begin(), known.end(), option) != known.end()) continue;
      findings_.error(block_.place, block_.starred(), fmt::format("the option _{} is not supported", option),
                      std::string(remedy));
      return false;
    }
    return true;
  }

  struct Element {
    int id = 0, part = 0;
    std::array<int, 10> node{};
  };

  const Block& block_;
  ElementTable& out_;
  Findings& findings_;
  BulkLines lines_;
  CarefulLines careful_;
  IdOffset element_offset_, part_offset_, node_offset_;
  std::size_t width_;
  Element row_;
  int first_line_ = 0;

 private:
  void read_plain_nodes(PlainColumns& cells, std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) row_.node[i] = cells.integer(width_);
  }

  bool offsets_fit() { return element_offset_.apply(row_.id) && part_offset_.apply(row_.part) && apply_node_offsets(); }

  bool apply_node_offsets() {
    bool fit = true;
    for (int& n : row_.node) fit = fit && n >= 0 && node_offset_.apply(n);
    return fit;
  }
};

// ---- shells

const Card& more_thickness_card() {
  using dimension::length;
  static const Card card{{real16("thic5", length, "thickness at node 5", at_least(0)),
                          real16("thic6", length, "thickness at node 6", at_least(0)),
                          real16("thic7", length, "thickness at node 7", at_least(0)),
                          real16("thic8", length, "thickness at node 8", at_least(0))}};
  return card;
}
const Card shell_system_card{{real16("thic1", dimension::length, "thickness at node 1", at_least(0)),
                              real16("thic2", dimension::length, "thickness at node 2", at_least(0)),
                              real16("thic3", dimension::length, "thickness at node 3", at_least(0)),
                              real16("thic4", dimension::length, "thickness at node 4", at_least(0)),
                              wide(id("mcid", IdSpace::define, 0, "coordinate system of the material"), 16)}};
const Card shell_offset_card{{real16("offset", dimension::length, "distance of the reference surface from the nodes")}};
const Card scalar_nodes_card{
    {number8("ns1", IdSpace::node, "scalar node"), number8("ns2", IdSpace::node, "scalar node"),
     number8("ns3", IdSpace::node, "scalar node"), number8("ns4", IdSpace::node, "scalar node"),
     number8("ns5", IdSpace::node, "scalar node"), number8("ns6", IdSpace::node, "scalar node"),
     number8("ns7", IdSpace::node, "scalar node"), number8("ns8", IdSpace::node, "scalar node")}};

class ShellReader : ElementReader {
 public:
  ShellReader(const Deck& deck, const Block& block, ElementTable& out, Findings& findings)
      : ElementReader(deck, block, out, findings, 8, 1 + options_of(block.keyword, "ELEMENT_SHELL").size()) {}

  void read() {
    const auto options = options_of(block_.keyword, "ELEMENT_SHELL");
    if (!options_are_known(options, {"THICKNESS", "BETA", "MCID", "OFFSET", "DOF"},
                           "use *ELEMENT_SHELL with THICKNESS, BETA, MCID, OFFSET or DOF")) {
      return;
    }
    const auto has = [&](std::string_view o) { return std::find(options.begin(), options.end(), o) != options.end(); };
    const bool mcid = has("MCID"), thick = has("THICKNESS") || has("BETA") || mcid, offset = has("OFFSET"),
               dof = has("DOF");
    std::string_view line;
    while (lines_.next(line)) {
      first_line_ = lines_.number();
      const bool kept = read_element(line, shell_card(), 8);
      if (!kept && trimmed(line).empty()) continue;
      if (kept) append();
      if (thick && !read_thickness(kept, mcid)) break;
      if (offset && !read_offset(kept)) break;
      if (dof && !read_scalar_nodes()) break;
    }
    complete();
  }

 private:
  bool read_thickness(bool kept, bool mcid) {
    std::string_view line;
    if (!next_of_element(line, "thickness card")) return false;
    std::array<double, 4> t{};
    double angle = none;
    int system = 0;
    const std::size_t wide_cell = real_width(block_.format);
    PlainColumns cells(line);
    for (double& v : t) v = cells.real(wide_cell);
    if (!mcid && !trimmed(columns(line, 4 * wide_cell, wide_cell)).empty()) angle = cells.real(wide_cell);
    const bool positive = t[0] >= 0.0 && t[1] >= 0.0 && t[2] >= 0.0 && t[3] >= 0.0;
    if (!cells.good() || !positive || block_.transform != nullptr) {
      const Row row = careful_.read(mcid ? shell_system_card : shell_thickness_card(), line, lines_.number());
      t = {row.real("thic1"), row.real("thic2"), row.real("thic3"), row.real("thic4")};
      if (mcid) {
        system = row.integer("mcid");
      } else {
        angle = row.blank("beta") ? none : row.real("beta");
      }
    }
    if (kept) {
      append(out_.thickness, t, {});
      if (mcid) {
        append(out_.system, system, 0);
      } else {
        append(out_.angle, angle, none);
      }
    }
    const bool more_nodes = std::any_of(row_.node.begin() + 4, row_.node.begin() + 8, [](int n) { return n != 0; });
    if (!more_nodes) return true;
    if (!next_of_element(line, "card THIC5 to THIC8")) return false;
    careful_.read(more_thickness_card(), line, lines_.number());
    return true;
  }

  bool read_offset(bool kept) {
    std::string_view line;
    if (!next_of_element(line, "offset card")) return false;
    const Row row = careful_.read(shell_offset_card, line, lines_.number());
    if (kept) append(out_.offset, row.real("offset"), none);
    return true;
  }

  bool read_scalar_nodes() {
    std::string_view line;
    if (!next_of_element(line, "scalar node card")) return false;
    careful_.read(scalar_nodes_card, line, lines_.number());
    return true;
  }
};

// ---- solids

/// `EID PID` alone, or with zeros behind: the first line of the two-line form.
bool is_short(std::string_view line, std::size_t width) {
  const auto names_no_node = [](std::string_view rest) {
    return rest.find_first_not_of(", \t\r0") == std::string_view::npos;
  };
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return names_no_node(columns(line, 2 * width, line.size()));
  const std::size_t second = line.find(',', comma + 1);
  return second == std::string_view::npos || names_no_node(line.substr(second));
}

const Card& solid_short_card() {
  static const Card card = element_card(0);
  return card;
}
const Card& solid_nodes_card() {
  static const Card card = nodes_only_card(10);
  return card;
}
const Card axes_card{
    {real16("a1", dimension::number, "material axes"), real16("a2", dimension::number, "material axes"),
     real16("a3", dimension::number, "material axes"), real16("a4", dimension::number, "material axes"),
     real16("a5", dimension::number, "material axes")}};

class SolidReader : ElementReader {
 public:
  SolidReader(const Deck& deck, const Block& block, ElementTable& out, Findings& findings)
      : ElementReader(deck, block, out, findings, 10, 1) {}

  void read() {
    const auto options = options_of(block_.keyword, "ELEMENT_SOLID");
    if (!options_are_known(options, {"ORTHO", "DOF", "TET4TOTET10"},
                           "use *ELEMENT_SOLID, alone or with ORTHO, DOF or TET4TOTET10"))
      return;
    const auto has = [&](std::string_view o) { return std::find(options.begin(), options.end(), o) != options.end(); };
    if (has("ORTHO")) {
      findings_.warning(block_.place, block_.starred(), "material axes of single elements are read but not used",
                        "no material here has axes: *ELEMENT_SOLID alone says the same");
    }
    std::string_view line;
    while (lines_.next(line)) {
      first_line_ = lines_.number();
      if (trimmed(line).empty()) continue;
      const bool two_lines = is_short(line, width_);
      const bool kept = two_lines ? read_element(line, solid_short_card(), 0) : read_element(line, solid_card(), 8);
      if (two_lines) {
        if (!next_of_element(line, "line of nodes")) break;
        read_nodes_line(line, solid_nodes_card(), 10);
      }
      if (kept) append();
      if (kept && has("TET4TOTET10")) append(out_.to_ten, char{1}, char{0});
      if (has("ORTHO") && !(skip_card(axes_card) && skip_card(axes_card))) break;
      if (has("DOF") && !skip_card(scalar_nodes_card)) break;
    }
    complete();
  }

 private:
  bool skip_card(const Card& card) {
    std::string_view line;
    if (!next_of_element(line, "option card")) return false;
    careful_.read(card, line, lines_.number());
    return true;
  }
};

// ---- beams

const Card beam_section_card{
    {real16("parm1", dimension::number, "section value"), real16("parm2", dimension::number, "section value"),
     real16("parm3", dimension::number, "section value"), real16("parm4", dimension::number, "section value"),
     real16("parm5", dimension::number, "section value")}};
const Card beam_parts_card{{number8("pid1", IdSpace::part, "part to which node 1 is tied"),
                            number8("pid2", IdSpace::part, "part to which node 2 is tied")}};
const Card beam_offset_card{{real("wx1", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                             real("wy1", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                             real("wz1", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                             real("wx2", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                             real("wy2", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                             real("wz2", dimension::length, 0.0, only(0.0), "offset of the beam axis")}};
const Card beam_orientation_card{{real("vx", dimension::number, 0.0, any_value, "orientation vector"),
                                  real("vy", dimension::number, 0.0, any_value, "orientation vector"),
                                  real("vz", dimension::number, 0.0, any_value, "orientation vector")}};

class BeamReader : ElementReader {
 public:
  BeamReader(const Deck& deck, const Block& block, ElementTable& out, Findings& findings)
      : ElementReader(deck, block, out, findings, 3, 1 + options_of(block.keyword, "ELEMENT_BEAM").size()) {}

  void read() {
    const auto options = options_of(block_.keyword, "ELEMENT_BEAM");
    if (!options_are_known(options, {"THICKNESS", "PID", "OFFSET", "ORIENTATION"},
                           "use *ELEMENT_BEAM with THICKNESS, PID, OFFSET or ORIENTATION")) {
      return;
    }
    const auto has = [&](std::string_view o) { return std::find(options.begin(), options.end(), o) != options.end(); };
    std::string_view line;
    while (lines_.next(line)) {
      first_line_ = lines_.number();
      if (trimmed(line).empty()) continue;
      kept_ = read_element(line, beam_card(), 3, true);
      if (kept_) append();
      if (has("THICKNESS") && !read_section()) break;
      if (has("PID") && !read_parts()) break;
      if (has("OFFSET") && !option_row(beam_offset_card, "offset card")) break;
      if (has("ORIENTATION") && !read_orientation()) break;
    }
    complete();
  }

 private:
  std::optional<Row> option_row(const Card& card, std::string_view what) {
    std::string_view line;
    if (!next_of_element(line, what)) return {};
    return careful_.read(card, line, lines_.number());
  }

  bool read_section() {
    const std::optional<Row> row = option_row(beam_section_card, "thickness card");
    if (!row) return false;
    if (kept_) {
      append(out_.section,
             {row->real("parm1"), row->real("parm2"), row->real("parm3"), row->real("parm4"), row->real("parm5")}, {});
    }
    return true;
  }

  bool read_parts() {
    const std::optional<Row> row = option_row(beam_parts_card, "card of parts");
    if (!row) return false;
    if (kept_) append(out_.tied_parts, {row->integer("pid1"), row->integer("pid2")}, {});
    return true;
  }

  bool read_orientation() {
    const std::optional<Row> row = option_row(beam_orientation_card, "orientation card");
    if (!row) return false;
    Vec3d v{row->real("vx"), row->real("vy"), row->real("vz")};
    if (block_.transform != nullptr) v = block_.transform->direction(v);
    if (kept_) append(out_.orientation, {v.x, v.y, v.z}, {});
    return true;
  }

  bool kept_ = false;
};

}  // namespace

const Card& shell_card() {
  static const Card card = element_card(8);
  return card;
}

const Card& shell_thickness_card() {
  using dimension::length;
  static const Card card{{real16("thic1", length, "thickness at node 1", at_least(0)),
                          real16("thic2", length, "thickness at node 2", at_least(0)),
                          real16("thic3", length, "thickness at node 3", at_least(0)),
                          real16("thic4", length, "thickness at node 4", at_least(0)),
                          real16("beta", dimension::number, "angle of the material axes in degrees")}};
  return card;
}

const Card& solid_card() {
  static const Card card = element_card(8);
  return card;
}

const Card& beam_card() {
  static const Card card = element_card(
      3, {release("rt1", "released translations at node 1"), release("rr1", "released rotations at node 1"),
          release("rt2", "released translations at node 2"), release("rr2", "released rotations at node 2"),
          number8("local", IdSpace::none, "axes of the releases")});
  return card;
}

void read_shells(const Deck& deck, const Block& block, ElementTable& out, Findings& findings) {
  ShellReader(deck, block, out, findings).read();
}

void read_solids(const Deck& deck, const Block& block, ElementTable& out, Findings& findings) {
  SolidReader(deck, block, out, findings).read();
}

void read_beams(const Deck& deck, const Block& block, ElementTable& out, Findings& findings) {
  BeamReader(deck, block, out, findings).read();
}

}  // namespace nugget::deck
