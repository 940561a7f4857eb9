// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "deck/bulk.hpp"

namespace nugget::deck {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// An element as its first line (of two, for solids) gives it.
struct ElementRow {
  int id = 0, part = 0;
  std::array<int, 10> node{};
};
using ElementCard = CardOf<ElementRow>;

IntegerField number8(std::string_view name, IdSpace space, std::string_view meaning, double fallback = 0.0) {
  return within_range(wide(nugget::id(name, space, fallback, meaning), 8), at_least(0));
}

/// A release of a beam's end: none is supported.
Field release(std::string_view name, std::string_view meaning) {
  return within_range(wide(integer(name, 0, any_value, meaning), 8), only(0.0));
}

const std::array<std::string_view, 10> node_names{"n1", "n2", "n3", "n4", "n5", "n6", "n7", "n8", "n9", "n10"};
/// What the nodes of an element mean, one for each that its card has.
using NodeMeanings = std::vector<std::string_view>;
const NodeMeanings shell_nodes{"node 1",
                               "node 2",
                               "node 3",
                               "node 4; 0 or n3: a triangle",
                               "mid-side node: shells of eight nodes are not supported",
                               "mid-side node",
                               "mid-side node",
                               "mid-side node"};
const NodeMeanings solid_nodes{"node 1; n1 to n10 may also stand on a line of their own", "node 2", "node 3", "node 4",
                               "node 5; n5 to n8 repeat for wedges and tetrahedra",       "node 6", "node 7", "node 8"};
const NodeMeanings thick_shell_nodes{"node 1 of the bottom; a wedge repeats nodes: n4 = n3, n8 = n7",
                                     "node 2 of the bottom",
                                     "node 3 of the bottom",
                                     "node 4 of the bottom",
                                     "node of the top over n1",
                                     "node of the top over n2",
                                     "node of the top over n3",
                                     "node of the top over n4"};
const NodeMeanings beam_nodes{"node 1", "node 2", "orientation node"};

/// The first `needed` of them have to be given.
void add_nodes(ElementCard& card, const NodeMeanings& meanings, std::size_t needed) {
  for (std::size_t i = 0; i < meanings.size(); ++i)
    card.add({nugget::at(&ElementRow::node, i),
              number8(node_names[i], IdSpace::node, meanings[i], i < needed ? required : 0.0)});
}

/// EID PID N1 ...
ElementCard element_card(const NodeMeanings& nodes, std::size_t needed) {
  ElementCard card{{&ElementRow::id, number8("eid", IdSpace::element, "element id", required)},
                   {&ElementRow::part, number8("pid", IdSpace::part, "part id", required)}};
  add_nodes(card, nodes, needed);
  return card;
}

/// N1 to N10 on a line of their own.
ElementCard nodes_only_card() {
  ElementCard card;
  add_nodes(card, NodeMeanings(10, "node id"), 0);
  return card;
}

RealField real16(std::string_view name, Dimension d, std::string_view meaning, Range range = any_value) {
  RealField f = wide(real(name, d, 0.0, range, meaning), 16);
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
        width_(id_width(block.format)),
        mirrored_(block.transform != nullptr && block.transform->mirrors()),
        rows_before_(out.id.size()) {
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
  bool read_element(std::string_view line, const ElementCard& card, std::size_t count, bool releases = false) {
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
    if (!careful_.reads_every_line() && cells.good() && nothing_released && row_.id > 0 && row_.part > 0 &&
        offsets_fit())
      return true;
    if (trimmed(line).empty()) return false;
    row_ = *careful_.read(card, line, lines_.number());
    return row_.id != 0 && row_.part != 0;  // else a finding says so
  }

  /// A line of nodes only.
  void read_nodes_line(std::string_view line, const ElementCard& card, std::size_t count) {
    PlainColumns cells(line);
    read_plain_nodes(cells, 0, count);
    if (!careful_.reads_every_line() && cells.good() && apply_node_offsets()) return;
    row_.node = careful_.read(card, line, lines_.number())->node;
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

  /// Nodes of an element as its mirror image numbers them: ends of the first side change places, and so do those of
  /// the sides opposite, so that the axes that begin along node 1 to node 2 stay on the same line.
  void mirror_nodes(std::initializer_list<std::array<std::size_t, 2>> places) {
    for (const auto& [one, other] : places) std::swap(row_.node[one], row_.node[other]);
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
    fill(out_.thick, char{0});
    if (mirrored_ && n > rows_before_) {
      out_.mirrored.resize(rows_before_, char{0});
      out_.mirrored.resize(n, char{1});
    }
    fill(out_.mirrored, char{0});
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

  const Block& block_;
  ElementTable& out_;
  Findings& findings_;
  BulkLines lines_;
  CarefulLines careful_;
  IdOffset element_offset_, part_offset_, node_offset_;
  std::size_t width_;
  const bool mirrored_;            ///< the block stands in a file that is mirrored
  const std::size_t rows_before_;  ///< of the table, before this block
  ElementRow row_;
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

const ElementCard& shell_element_card() {
  static const ElementCard card = element_card(shell_nodes, 3);
  return card;
}

/// What the cards of the options of a shell give.
struct ShellOptionRow {
  std::array<double, 4> thickness{};
  double angle = 0.0;
  int system = 0;
  double offset = 0.0;
};
using ShellOptionCard = CardOf<ShellOptionRow>;

ShellOptionCard thickness_card() {
  const std::array<std::string_view, 4> names{"thic1", "thic2", "thic3", "thic4"},
      meanings{"thickness at node 1; 0: of the section", "thickness at node 2", "thickness at node 3",
               "thickness at node 4"};
  ShellOptionCard card;
  for (std::size_t i = 0; i < 4; ++i)
    card.add(
        {nugget::at(&ShellOptionRow::thickness, i), real16(names[i], dimension::length, meanings[i], at_least(0))});
  return card;
}
const ShellOptionCard& thickness_and_angle_card() {
  static const ShellOptionCard card = [] {
    ShellOptionCard c = thickness_card();
    c.add({&ShellOptionRow::angle,
           real16("beta", dimension::number, "angle of the material axes instead of the material's BETA [degrees]")});
    return c;
  }();
  return card;
}
const ShellOptionCard& thickness_and_system_card() {
  static const ShellOptionCard card = [] {
    ShellOptionCard c = thickness_card();
    c.add({&ShellOptionRow::system, wide(id("mcid", IdSpace::define, 0, "coordinate system of the material"), 16)});
    return c;
  }();
  return card;
}
const ShellOptionCard& offset_card() {
  static const ShellOptionCard card{
      {&ShellOptionRow::offset, real16("offset", dimension::length, "mid-surface from the nodes, along the normal")},
  };
  return card;
}

/// Cards of which nothing is kept; what stands on them is checked.
struct NothingKept {};
using CheckedCard = CardOf<NothingKept>;

const CheckedCard& more_thickness_card() {
  using dimension::length;
  static const CheckedCard card{real16("thic5", length, "thickness at node 5", at_least(0)),
                                real16("thic6", length, "thickness at node 6", at_least(0)),
                                real16("thic7", length, "thickness at node 7", at_least(0)),
                                real16("thic8", length, "thickness at node 8", at_least(0))};
  return card;
}
const CheckedCard scalar_nodes_card{
    number8("ns1", IdSpace::node, "scalar node"), number8("ns2", IdSpace::node, "scalar node"),
    number8("ns3", IdSpace::node, "scalar node"), number8("ns4", IdSpace::node, "scalar node"),
    number8("ns5", IdSpace::node, "scalar node"), number8("ns6", IdSpace::node, "scalar node"),
    number8("ns7", IdSpace::node, "scalar node"), number8("ns8", IdSpace::node, "scalar node")};

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
      const bool kept = read_element(line, shell_element_card(), 8);
      if (!kept && trimmed(line).empty()) continue;
      if (kept && mirrored_) mirror_shell();
      if (kept) append();
      if (thick && !read_thickness(kept, mcid)) break;
      if (offset && !read_offset(kept)) break;
      if (dof && !read_scalar_nodes()) break;
    }
    complete();
  }

 private:
  /// Node 4 of a triangle is 0 or node 3.
  void mirror_shell() {
    is_triangle_ = row_.node[3] == 0 || row_.node[3] == row_.node[2];
    mirror_nodes({{0, 1}});
    if (!is_triangle_) mirror_nodes({{2, 3}, {5, 7}});
  }

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
    if (careful_.reads_every_line() || !cells.good() || !positive || block_.transform != nullptr) {
      const auto row =
          careful_.read(mcid ? thickness_and_system_card() : thickness_and_angle_card(), line, lines_.number());
      t = row->thickness;
      system = row->system;
      angle = mcid || row[&ShellOptionRow::angle].blank ? none : row->angle;
    }
    if (mirrored_) {
      std::swap(t[0], t[1]);
      if (!is_triangle_) std::swap(t[2], t[3]);
      angle = -angle;  // about the normal, from node 1 to node 2: see mirror_nodes()
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
    const auto row = careful_.read(offset_card(), line, lines_.number());
    if (kept) append(out_.offset, row->offset, none);
    return true;
  }

  bool read_scalar_nodes() {
    std::string_view line;
    if (!next_of_element(line, "scalar node card")) return false;
    careful_.read(scalar_nodes_card, line, lines_.number());
    return true;
  }

  bool is_triangle_ = false;  ///< of the row read last, where it is mirrored
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

const ElementCard& solid_element_card() {
  static const ElementCard card = element_card(solid_nodes, 4);
  return card;
}
const ElementCard& thick_shell_element_card() {
  static const ElementCard card = element_card(thick_shell_nodes, 8);
  return card;
}
const ElementCard& solid_short_card() {
  static const ElementCard card = element_card({}, 0);
  return card;
}
const ElementCard& solid_nodes_card() {
  static const ElementCard card = nodes_only_card();
  return card;
}
const CheckedCard axes_card{
    real16("a1", dimension::number, "material axes"), real16("a2", dimension::number, "material axes"),
    real16("a3", dimension::number, "material axes"), real16("a4", dimension::number, "material axes"),
    real16("a5", dimension::number, "material axes")};

class SolidReader : ElementReader {
 public:
  SolidReader(const Deck& deck, const Block& block, ElementTable& out, Findings& findings)
      : ElementReader(deck, block, out, findings, 10, 1) {}

  void read_thick() {
    std::string_view line;
    while (lines_.next(line)) {
      first_line_ = lines_.number();
      if (!read_element(line, thick_shell_element_card(), 8)) continue;
      if (mirrored_) mirror_nodes({{0, 1}, {2, 3}, {4, 5}, {6, 7}});
      append();
      append(out_.thick, char{1}, char{0});
    }
    complete();
  }

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
      const bool kept =
          two_lines ? read_element(line, solid_short_card(), 0) : read_element(line, solid_element_card(), 8);
      if (two_lines) {
        if (!next_of_element(line, "line of nodes")) break;
        read_nodes_line(line, solid_nodes_card(), 10);
      }
      if (kept && mirrored_) mirror_solid();
      if (kept) append();
      if (kept && has("TET4TOTET10")) append(out_.to_ten, char{1}, char{0});
      if (has("ORTHO") && !(skip_card(axes_card) && skip_card(axes_card))) break;
      if (has("DOF") && !skip_card(scalar_nodes_card)) break;
    }
    complete();
  }

 private:
  /// Of a brick, wedge or pyramid both faces; a tetrahedron has its fourth node apart, one of ten its mid-edge nodes
  /// in the order 12, 23, 31, 14, 24, 34.
  void mirror_solid() {
    const auto& n = row_.node;
    const auto all_are = [&](int id) {
      return std::all_of(n.begin() + 4, n.begin() + 8, [=](int m) { return m == id; });
    };
    if (n[8] != 0 || n[9] != 0)
      mirror_nodes({{0, 1}, {5, 6}, {7, 8}});
    else if (all_are(n[3]) || all_are(0))
      mirror_nodes({{0, 1}});
    else
      mirror_nodes({{0, 1}, {2, 3}, {4, 5}, {6, 7}});
  }

  bool skip_card(const CheckedCard& card) {
    std::string_view line;
    if (!next_of_element(line, "option card")) return false;
    careful_.read(card, line, lines_.number());
    return true;
  }
};

// ---- beams

/// What the cards of the options of a beam give.
struct BeamOptionRow {
  std::array<double, 5> section{};
  std::array<int, 2> part{};
  Vec3d orientation;
};
using BeamOptionCard = CardOf<BeamOptionRow>;

const BeamOptionCard& section_card() {
  static const BeamOptionCard card = [] {
    const std::array<std::string_view, 5> names{"parm1", "parm2", "parm3", "parm4", "parm5"};
    BeamOptionCard c;
    for (std::size_t i = 0; i < 5; ++i)
      c.add({nugget::at(&BeamOptionRow::section, i), real16(names[i], dimension::number, "section value")});
    return c;
  }();
  return card;
}
const BeamOptionCard& parts_card() {
  static const BeamOptionCard card{
      {nugget::at(&BeamOptionRow::part, 0), number8("pid1", IdSpace::part, "part that end 1 is to be tied to")},
      {nugget::at(&BeamOptionRow::part, 1), number8("pid2", IdSpace::part, "part that end 2 is to be tied to")},
  };
  return card;
}
const BeamOptionCard beam_offset_card{real("wx1", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                                      real("wy1", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                                      real("wz1", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                                      real("wx2", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                                      real("wy2", dimension::length, 0.0, only(0.0), "offset of the beam axis"),
                                      real("wz2", dimension::length, 0.0, only(0.0), "offset of the beam axis")};
const BeamOptionCard& orientation_card() {
  const auto component = [](double Vec3d::*axis, std::string_view name, std::string_view meaning) {
    return FieldOf<BeamOptionRow>(within(&BeamOptionRow::orientation, axis),
                                  real(name, dimension::number, 0.0, any_value, meaning));
  };
  static const BeamOptionCard card{
      component(&Vec3d::x, "vx", "direction from node 1, instead of n3: x"),
      component(&Vec3d::y, "vy", "y"),
      component(&Vec3d::z, "vz", "z"),
  };
  return card;
}
const ElementCard& beam_element_card() {
  static const ElementCard card = [] {
    ElementCard c = element_card(beam_nodes, 2);
    for (const Field& behind :
         {release("rt1", "released translations at node 1"), release("rr1", "released rotations at node 1"),
          release("rt2", "released translations at node 2"), release("rr2", "released rotations at node 2")})
      c.add(behind);
    c.add(within_range(number8("local", IdSpace::none, "axes of the releases"), any_value));
    return c;
  }();
  return card;
}

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
      kept_ = read_element(line, beam_element_card(), 3, true);
      // With the ends exchanged all three axes of a section are images of their own: r turns, s = s and t = r x s.
      if (kept_ && mirrored_) mirror_nodes({{0, 1}});
      if (kept_) append();
      if (has("THICKNESS") && !read_section()) break;
      if (has("PID") && !read_parts()) break;
      if (has("OFFSET") && !option_row(beam_offset_card, "offset card")) break;
      if (has("ORIENTATION") && !read_orientation()) break;
    }
    complete();
  }

 private:
  std::optional<BeamOptionRow> option_row(const BeamOptionCard& card, std::string_view what) {
    std::string_view line;
    if (!next_of_element(line, what)) return {};
    return *careful_.read(card, line, lines_.number());
  }

  bool read_section() {
    const auto row = option_row(section_card(), "thickness card");
    if (!row) return false;
    if (kept_) append(out_.section, row->section, {});
    return true;
  }

  bool read_parts() {
    const auto row = option_row(parts_card(), "card of parts");
    if (!row) return false;
    std::array<int, 2> parts = row->part;
    if (mirrored_) std::swap(parts[0], parts[1]);
    if (kept_) append(out_.tied_parts, parts, {});
    return true;
  }

  bool read_orientation() {
    const auto row = option_row(orientation_card(), "orientation card");
    if (!row) return false;
    Vec3d v = row->orientation;
    if (block_.transform != nullptr) v = block_.transform->direction(v);
    if (kept_) append(out_.orientation, {v.x, v.y, v.z}, {});
    return true;
  }

  bool kept_ = false;
};

}  // namespace

const Card& shell_card() {
  return shell_element_card();
}
const Card& shell_thickness_card() {
  return thickness_and_angle_card();
}
const Card& shell_offset_card() {
  return offset_card();
}
const Card& solid_card() {
  return solid_element_card();
}
const Card& thick_shell_card() {
  return thick_shell_element_card();
}
const Card& beam_card() {
  return beam_element_card();
}
const Card& beam_parts_card() {
  return parts_card();
}
const Card& beam_orientation_card() {
  return orientation_card();
}

void read_shells(const Deck& deck, const Block& block, ElementTable& out, Findings& findings) {
  ShellReader(deck, block, out, findings).read();
}

void read_solids(const Deck& deck, const Block& block, ElementTable& out, Findings& findings) {
  SolidReader(deck, block, out, findings).read();
}

void read_thick_shells(const Deck& deck, const Block& block, ElementTable& out, Findings& findings) {
  SolidReader(deck, block, out, findings).read_thick();
}

void read_beams(const Deck& deck, const Block& block, ElementTable& out, Findings& findings) {
  BeamReader(deck, block, out, findings).read();
}

}  // namespace nugget::deck
