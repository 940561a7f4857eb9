// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "base/index.hpp"
#include "kernel/element/quadratic_tetrahedron.hpp"
#include "model/segments.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {

namespace {

Place place_of(const Builder& b, int file, int line) {
  return {b.deck.files[file], line, 0};
}

template <class Table>
bool is_thick(const Table& table, std::size_t row) {
  if constexpr (requires { table.thick; }) return !table.thick.empty() && table.thick[row] != 0;
  return false;
}

/// Rows of a table in ascending order of id, each id once; a second one is a finding.
template <class Table>
std::vector<std::size_t> rows_by_id(Builder& b, const Table& table, std::string_view what, std::string keyword) {
  std::vector<std::size_t> rows(table.id.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  const auto by_id = [&](std::size_t i, std::size_t j) { return table.id[i] < table.id[j]; };
  if (!std::is_sorted(rows.begin(), rows.end(), by_id)) std::stable_sort(rows.begin(), rows.end(), by_id);

  Tally twice(b.findings, Severity::error, std::move(keyword));
  const auto is_second = [&](std::size_t first, std::size_t second) {
    if (table.id[first] != table.id[second]) return false;
    const bool unlike = is_thick(table, first) != is_thick(table, second);
    twice.add(
        place_of(b, table.file[second], table.line[second]),
        [&] {
          const Place p = place_of(b, table.file[first], table.line[first]);
          return fmt::format("{} {} is defined twice{}; first at {}:{}", what, table.id[second],
                             unlike ? ", of bricks and of thick shells, which share their ids here" : "", p.file,
                             p.line);
        },
        "give one of them another id");
    return true;
  };
  rows.erase(std::unique(rows.begin(), rows.end(), is_second), rows.end());
  return rows;
}

void make_nodes(Builder& b) {
  const auto& table = b.node_table;
  auto rows = rows_by_id(b, table, "node", "*NODE");
  if (b.coarsening != nullptr)
    std::erase_if(rows,
                  [&](std::size_t r) { return std::ranges::binary_search(b.coarsening->removed_nodes, table.id[r]); });
  Nodes& nodes = b.model.nodes;
  nodes.id.reserve(rows.size());
  nodes.x.reserve(rows.size());
  for (const std::size_t r : rows) {
    if (table.tc[r] != 0 || table.rc[r] != 0)
      b.model.spcs.push_back({.node = static_cast<Index>(nodes.size()),
                              .fixed = bits_of_code(table.tc[r]) | bits_of_code(table.rc[r]) << 3});
    nodes.id.push_back(table.id[r]);
    nodes.x.push_back(table.x[r]);
  }
  b.nodes.assign(nodes.id);
}

bool is_mirrored(const deck::ElementTable& table, std::size_t row) {
  return !table.mirrored.empty() && table.mirrored[row] != 0;
}

/// What the three kinds of elements have in common while they are made: looking up parts and nodes, and saying so where
/// that fails.
class Elements {
 public:
  Elements(Builder& b, const deck::ElementTable& table, ElementKind kind, std::string_view what, std::string keyword)
      : b_(b),
        table_(table),
        kind_(kind),
        what_(what),
        keyword_(keyword),
        unknown_(b.findings, Severity::error, keyword),
        mixed_(b.findings, Severity::error, keyword),
        shape_(b.findings, Severity::error, keyword) {}

  Elements(const Elements&) = delete;
  Elements& operator=(const Elements&) = delete;
  ~Elements() {
    for (const auto& [id, missing] : missing_parts_)
      b_.findings.error(place(missing.row), keyword_,
                        fmt::format("part {} is not defined; {} of its elements, from {} {} on, have no section and no "
                                    "material",
                                    id, missing.count, what_, table_.id[missing.row]),
                        "define it by *PART");
  }

  /// Index of the row's part, or none and a finding. A part that is not defined is a finding, and gets a stand-in of
  /// this id: what is known of its elements is kept for the audit of a refused deck.
  Index part(std::size_t row) {
    const int id = table_.part[row];
    if (id != last_id_) {
      last_id_ = id;
      last_ = b_.parts.find(id);
      if (last_ == none) last_ = stand_in(id, row);
      const auto missing = missing_parts_.find(id);
      missing_ = missing == missing_parts_.end() ? nullptr : &missing->second;
    }
    if (missing_ != nullptr) ++missing_->count;
    Part& p = b_.model.parts[last_];
    if (p.kind == ElementKind::nothing) p.kind = kind_;
    if (p.kind == kind_) return last_;
    mixed_.add(
        place(row), [&] { return fmt::format("part {} already has elements of another kind", id); },
        "give them a part of their own");
    return none;
  }

  /// The first `N` nodes of the row; false and findings where one is unknown. Node 0 becomes none.
  template <std::size_t N>
  bool nodes(std::size_t row, std::array<Index, N>& out) {
    bool complete = true;
    for (std::size_t i = 0; i < N; ++i) {
      const int id = node_id(row, i);
      out[i] = id == 0 ? none : b_.nodes.find(id);
      if (id == 0 || out[i] != none) continue;
      complete = false;
      unknown_.add(
          place(row), [&] { return fmt::format("{} {}: node {} is not defined", what_, table_.id[row], id); },
          "define it by *NODE, or correct its number");
    }
    return complete;
  }

  int node_id(std::size_t row, std::size_t i) const {
    const auto per = at(table_.nodes_per_element);
    return i < per ? table_.node[row * per + i] : 0;
  }

  /// True where a node beyond the first `count` is given: an element of higher order.
  bool has_more_nodes_than(std::size_t count, std::size_t row) const {
    for (auto i = count; i < at(table_.nodes_per_element); ++i)
      if (node_id(row, i) != 0) return true;
    return false;
  }

  bool refuse(std::size_t row, std::string_view text, std::string remedy) {
    shape_.add(
        place(row), [&] { return fmt::format("{} {}: {}", what_, table_.id[row], text); }, std::move(remedy));
    return false;
  }

  Place place(std::size_t row) const { return place_of(b_, table_.file[row], table_.line[row]); }

 private:
  struct MissingPart {
    std::size_t row = 0;  ///< of its first element
    int count = 0;
  };

  Index stand_in(int id, std::size_t row) {
    missing_parts_[id].row = row;
    Part part;
    part.id = id;
    part.place = place(row);
    const auto index = static_cast<Index>(b_.model.parts.size());
    b_.model.parts.push_back(std::move(part));
    b_.parts.add(id, index, place(row), keyword_, "part", b_.findings);
    return index;
  }

  Builder& b_;
  const deck::ElementTable& table_;
  ElementKind kind_;
  std::string_view what_;
  std::string keyword_;
  std::map<int, MissingPart> missing_parts_;
  Tally unknown_, mixed_, shape_;
  int last_id_ = std::numeric_limits<int>::min();
  Index last_ = none;
  MissingPart* missing_ = nullptr;  ///< of `last_id_`; null where the part is defined
};

/// Shells that are merged while the mesh is made.
class MergedShells {
 public:
  explicit MergedShells(const Builder& b) : b_(b) {
    if (b.coarsening == nullptr) return;
    for (const Coarsening::Merged& m : b.coarsening->merged) {
      corners_[m.shells[0]] = &m.nodes;
      for (std::size_t k = 1; k < 4; ++k) gone_.insert(m.shells[k]);
    }
  }
  bool gone(int id) const { return gone_.contains(id); }
  /// The corners of a shell that stands for four; false for another one.
  bool nodes(int id, std::array<Index, 4>& out) const {
    const auto found = corners_.find(id);
    if (found == corners_.end()) return false;
    for (std::size_t k = 0; k < 4; ++k) out[k] = b_.nodes.find((*found->second)[k]);
    return true;
  }

 private:
  const Builder& b_;
  std::unordered_map<int, const std::array<int, 4>*> corners_;
  std::unordered_set<int> gone_;
};

/// Rows of the table that became elements, in order.
std::vector<std::size_t> make_shells(Builder& b) {
  const auto& table = b.shell_table;
  const auto rows = rows_by_id(b, table, "shell", "*ELEMENT_SHELL");
  Shells& shells = b.model.shells;
  shells.place = Places(b.deck.files);
  shells.id.reserve(rows.size());
  shells.part.reserve(rows.size());
  shells.node.reserve(rows.size());
  shells.place.reserve(rows.size());
  Elements elements(b, table, ElementKind::shell, "shell", "*ELEMENT_SHELL");
  std::vector<std::size_t> made;
  made.reserve(rows.size());
  const MergedShells merged(b);
  for (const std::size_t r : rows) {
    if (merged.gone(table.id[r])) continue;
    const Index part = elements.part(r);
    std::array<Index, 4> n;
    if (!merged.nodes(table.id[r], n) && !elements.nodes(r, n)) continue;
    if (part == none) continue;
    if (elements.has_more_nodes_than(4, r)) {
      elements.refuse(r, "shells of eight nodes are not supported", "mesh with four-node shells");
      continue;
    }
    if (n[0] == none || n[1] == none || n[2] == none || !bring_triangle_into_form(n)) {
      elements.refuse(
          r,
          fmt::format("its corners are nodes {} {} {} {}, expected three or four different ones in sequence",
                      elements.node_id(r, 0), elements.node_id(r, 1), elements.node_id(r, 2), elements.node_id(r, 3)),
          "remove it or correct its nodes");
      continue;
    }
    shells.id.push_back(table.id[r]);
    shells.part.push_back(part);
    shells.node.push_back(n);
    shells.place.push_back(table.file[r], table.line[r]);
    if (!table.mirrored.empty()) b.mirrored_shells.push_back(table.mirrored[r]);
    made.push_back(r);
  }
  b.shells.assign(shells.id);
  return made;
}

/// Fills up a tetrahedron that gives four nodes only.
bool complete_solid(std::array<Index, 8>& n) {
  if (std::count(n.begin() + 4, n.end(), none) == 4) std::fill(n.begin() + 4, n.end(), n[3]);
  return std::count(n.begin(), n.end(), none) == 0;
}

bool all_different(std::array<Index, 10> n) {
  std::sort(n.begin(), n.end());
  return n.front() != none && std::adjacent_find(n.begin(), n.end()) == n.end();
}

/// *ELEMENT_SOLID_TET4TOTET10: tetrahedra of four nodes, rows `to_ten` of the table, get new nodes amid their edges,
/// with ids after the largest; on edges of ten-node tetrahedra of the deck theirs.
void add_midside_nodes(Builder& b, Elements& elements, const std::vector<std::size_t>& to_ten) {
  Solids& solids = b.model.solids;
  Nodes& nodes = b.model.nodes;
  std::map<std::pair<Index, Index>, Index> amid;
  const auto edge = [](const std::array<Index, 10>& n, std::size_t i) -> std::pair<Index, Index> {
    const auto& ends = kernel::quadratic_tetrahedron_edge[i];
    return std::minmax(n[ends[0]], n[ends[1]]);
  };
  for (const std::array<Index, 10>& n : solids.ten_nodes)
    for (std::size_t i = 0; i < 6; ++i) amid.emplace(edge(n, i), n[4 + i]);
  const std::size_t given = nodes.size();
  solids.ten_row.resize(solids.size(), none);
  for (const std::size_t r : to_ten) {
    const auto e = at(b.solids.find(b.solid_table.id[r]));
    const std::vector<Index> corners = solids.corners(e);
    if (corners.size() != 4) {
      elements.refuse(r, fmt::format("has {} different nodes, expected the four of a tetrahedron", corners.size()),
                      "take it out of *ELEMENT_SOLID_TET4TOTET10");
      continue;
    }
    std::array<Index, 10> ten;
    std::copy(corners.begin(), corners.end(), ten.begin());
    for (std::size_t i = 0; i < 6; ++i) {
      const auto [it, is_new] = amid.try_emplace(edge(ten, i), static_cast<Index>(nodes.size()));
      ten[4 + i] = it->second;
      if (!is_new) continue;
      const auto [from, to] = it->first;
      nodes.id.push_back(nodes.id.back() + 1);
      nodes.x.push_back(0.5 * (nodes.x[from] + nodes.x[at(to)]));
    }
    solids.node[e] = {ten[0], ten[1], ten[2], ten[3], ten[3], ten[3], ten[3], ten[3]};
    solids.ten_row[e] = static_cast<Index>(solids.ten_nodes.size());
    solids.ten_nodes.push_back(ten);
  }
  b.nodes.assign(nodes.id);
  if (nodes.size() > given)
    b.findings.warning(elements.place(to_ten.front()), "*ELEMENT_SOLID_TET4TOTET10",
                       fmt::format("{} nodes are made amid edges, {} to {}; sets that list nodes do not have them",
                                   nodes.size() - given, nodes.id[given], nodes.id.back()),
                       "choose nodes of supports and loads by part or box, or press on segments");
}

void make_solids(Builder& b) {
  const auto& table = b.solid_table;
  const auto rows = rows_by_id(b, table, "solid", "*ELEMENT_SOLID");
  Solids& solids = b.model.solids;
  solids.place = Places(b.deck.files);
  solids.id.reserve(rows.size());
  solids.part.reserve(rows.size());
  solids.node.reserve(rows.size());
  solids.place.reserve(rows.size());
  Elements elements(b, table, ElementKind::solid, "solid", "*ELEMENT_SOLID");
  std::vector<std::size_t> to_ten;
  for (const std::size_t r : rows) {
    const Index part = elements.part(r);
    std::array<Index, 10> ten;
    if (!elements.nodes(r, ten) || part == none) continue;
    const bool quadratic = elements.has_more_nodes_than(8, r);
    if (quadratic && !all_different(ten)) {
      elements.refuse(r, "expected ten different nodes of a quadratic tetrahedron", "complete its nodes");
      continue;
    }
    std::array<Index, 8> n;
    std::copy_n(ten.begin(), 8, n.begin());
    if (quadratic) std::fill(n.begin() + 4, n.end(), n[3]);
    const bool thick = is_thick(table, r);
    if (thick && std::count(n.begin(), n.end(), none) != 0) {
      elements.refuse(r, "expected eight nodes of a thick shell (1 2 3 3 5 6 7 7 of a wedge)", "complete its nodes");
      continue;
    }
    if (!complete_solid(n)) {
      elements.refuse(r, "expected eight nodes (repeated ones for wedges and tetrahedra)", "complete its nodes");
      continue;
    }
    solids.id.push_back(table.id[r]);
    solids.part.push_back(part);
    solids.node.push_back(n);
    solids.place.push_back(table.file[r], table.line[r]);
    if (!table.mirrored.empty()) b.mirrored_solids.push_back(table.mirrored[r]);
    if (!table.thick.empty()) b.thick_solids.push_back(thick);
    if (!quadratic) {
      if (!table.to_ten.empty() && table.to_ten[r] != 0) to_ten.push_back(r);
      continue;
    }
    solids.ten_row.resize(solids.size(), none);
    solids.ten_row.back() = static_cast<Index>(solids.ten_nodes.size());
    solids.ten_nodes.push_back(ten);
  }
  b.solids.assign(solids.id);
  if (!to_ten.empty()) add_midside_nodes(b, elements, to_ten);
}

/// The parts that a weld beam's ends are to be tied to (_PID).
std::array<Index, 2> tied_parts(Builder& b, Elements& elements, std::size_t row) {
  std::array<Index, 2> parts{none, none};
  if (b.beam_table.tied_parts.empty()) return parts;
  for (std::size_t end = 0; end < 2; ++end) {
    const int id = b.beam_table.tied_parts[row][end];
    if (id == 0) continue;
    parts[end] = b.parts.find(id);
    if (parts[end] == none)
      elements.refuse(row, fmt::format("part {} of end {} is not defined", id, end + 1), "correct PID1, PID2");
  }
  return parts;
}

std::vector<std::size_t> make_beams(Builder& b) {
  const auto& table = b.beam_table;
  const auto rows = rows_by_id(b, table, "beam", "*ELEMENT_BEAM");
  Beams& beams = b.model.beams;
  beams.place = Places(b.deck.files);
  Elements elements(b, table, ElementKind::beam, "beam", "*ELEMENT_BEAM");
  std::vector<std::size_t> made;
  for (const std::size_t r : rows) {
    const Index part = elements.part(r);
    std::array<Index, 3> n;
    if (!elements.nodes(r, n) || part == none) continue;
    if (n[0] == none || n[1] == none || n[0] == n[1]) {
      elements.refuse(r, "needs two different nodes", "remove it or correct its nodes");
      continue;
    }
    beams.id.push_back(table.id[r]);
    beams.part.push_back(part);
    beams.node.push_back({n[0], n[1]});
    beams.orientation.push_back(n[2]);
    const auto v = table.orientation.empty() ? std::array<double, 3>{} : table.orientation[r];
    beams.direction.push_back(n[2] == none ? Vec3d{v[0], v[1], v[2]} : Vec3d{});
    beams.tied_parts.push_back(tied_parts(b, elements, r));
    beams.place.push_back(table.file[r], table.line[r]);
    made.push_back(r);
  }
  b.beams.assign(beams.id);
  return made;
}

/// `rows`: of the table, by beam.
void refuse_mirrored_discrete_beams(Builder& b, const std::vector<std::size_t>& rows) {
  Tally refused(b.findings, Severity::error, "*ELEMENT_BEAM");
  for (std::size_t e = 0; e < rows.size(); ++e) {
    const Index section = b.model.parts[b.model.beams.part[e]].section;
    if (!is_mirrored(b.beam_table, rows[e]) || section == none || b.model.beam_sections[section].elform != 6) continue;
    refused.add(
        b.model.beams.place[e],
        [&] {
          return fmt::format(
              "beam {} is a discrete one (ELFORM 6), which is not built in a file that *INCLUDE_TRANSFORM mirrors",
              b.model.beams.id[e]);
        },
        "write it in a file that is not mirrored");
  }
}

/// Mean of the nodal thicknesses; where one is not given, that of the section stands in.
double mean_thickness(const std::array<double, 4>& nodal, double section, int corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < at(corners); ++i) sum += nodal[i] > 0.0 ? nodal[i] : section;
  return sum / corners;
}

/// False where a row says nothing about its option's value (0 or not a number).
bool given(double value) {
  return value == value && value != 0.0;
}

void set_thickness(Builder& b, const std::vector<std::size_t>& rows) {
  Tally offsets(b.findings, Severity::error, "*ELEMENT_SHELL_OFFSET");
  const auto& table = b.shell_table;
  Shells& shells = b.model.shells;
  shells.thickness.resize(shells.size());
  if (!table.angle.empty())
    for (std::size_t e = 0; e < shells.size(); ++e)
      shells.angle.push_back(table.angle[rows[e]] * (std::numbers::pi / 180.0));
  for (std::size_t e = 0; e < shells.size(); ++e) {
    const Part& part = b.model.parts[shells.part[e]];
    if (part.section == none) continue;
    const SectionShell& section = b.model.shell_sections[part.section];
    shells.thickness[e] = table.thickness.empty()
                              ? section.thickness
                              : mean_thickness(table.thickness[rows[e]], section.thickness, shells.triangle(e) ? 3 : 4);
    const bool own_offset = !table.offset.empty() && given(table.offset[rows[e]]);
    const double offset = -0.5 * section.nloc * shells.thickness[e];
    if (offset != 0.0) {
      shells.offsets.resize(shells.size());
      shells.offsets[e] = offset;
    }
    if (!own_offset || table.offset[rows[e]] == offset) continue;
    offsets.add(
        shells.place[e],
        [&] { return fmt::format("shell {}: offsets of single shells are not supported", shells.id[e]); },
        "give the shells a section with NLOC, or move their nodes to the mid-surface");
  }
}

/// A value of *ELEMENT_BEAM_THICKNESS by its name in the section, and what the section has there.
struct SectionValue {
  std::string_view name;
  double value = 0.0;
};

/// PARM1 to PARM5 by formulation; nameless where a formulation has no use for one.
std::array<SectionValue, 5> values_of(const SectionBeam& s, const Model& m) {
  switch (s.elform) {
    case 2:
      return {
          {{"A", s.area}, {"ISS", s.moment_s}, {"ITT", s.moment_t}, {"J", s.torsion_constant}, {"SA", s.shear_area}}};
    case 3: return {{{"A", s.area}}};
    case 6: return {{{"VOL", s.volume}, {"INER", s.inertia}, {"CID", s.system == none ? 0.0 : m.systems[s.system].id}}};
    default: return {{{"TS1", s.outer[0]}, {"TS2", s.outer[1]}, {"TT1", s.inner[0]}, {"TT2", s.inner[1]}}};
  }
}

/// Cross-sections of single beams (_THICKNESS) that differ from their section's cannot be obeyed.
void check_single_sections(Builder& b, const std::vector<std::size_t>& rows) {
  const auto& table = b.beam_table;
  if (table.section.empty()) return;
  Tally differing(b.findings, Severity::error, "*ELEMENT_BEAM_THICKNESS");
  const auto differs = [](double value, double own) { return std::abs(value - own) > 1e-6 * std::abs(own); };
  for (std::size_t e = 0; e < rows.size(); ++e) {
    const Part& part = b.model.parts[b.model.beams.part[e]];
    if (part.section == none) continue;
    const SectionBeam& s = b.model.beam_sections[part.section];
    const std::array<SectionValue, 5> own = values_of(s, b.model);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const double value = table.section[rows[e]][i];
      if (own[i].name.empty() || !given(value) || !differs(value, own[i].value)) continue;
      differing.add(
          b.model.beams.place[e],
          [&] {
            return fmt::format(
                "beam {}: parm{} = {:g} differs from {} = {:g} of section {}; cross-sections of single beams are not "
                "supported",
                b.model.beams.id[e], i + 1, value, own[i].name, own[i].value, s.id);
          },
          s.elform == 9 ? "give the welds of each diameter a part and a section of their own"
                        : "give the beams of each cross-section a part and a section of their own");
      break;
    }
  }
}

std::string_view name_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::shell: return "shell";
    case ElementKind::solid: return "solid";
    case ElementKind::beam: return "beam";
    case ElementKind::discrete: return "discrete";
    case ElementKind::nothing: break;
  }
  return "no";
}

/// The section that a part's elements need: same id, of their kind.
void link_section(Builder& b, Part& part, const deck::RowOf<PartCard>& row) {
  // Belts are no elements of the mesh: a part of theirs has none, and its section says nothing.
  const int id = row->secid;
  if (part.kind == ElementKind::nothing && b.belt_sections.find(id) != none) return;
  const std::array<std::pair<ElementKind, const Ids*>, 4> kinds{{{ElementKind::shell, &b.shell_sections},
                                                                 {ElementKind::solid, &b.solid_sections},
                                                                 {ElementKind::beam, &b.beam_sections},
                                                                 {ElementKind::discrete, &b.discrete_sections}}};
  if (id == 0) return;
  bool exists = false;
  for (const auto& [kind, ids] : kinds) {
    const Index found = ids->find(id);
    exists = exists || found != none;
    if (kind == part.kind) part.section = found;
  }
  if (part.section != none || (part.kind == ElementKind::nothing && exists)) return;
  exists = exists || b.belt_sections.find(id) != none;
  if (part.kind == ElementKind::nothing || !exists)
    return b.report_missing(b.shell_sections, "section", row[&PartCard::secid]);
  refuse(b, row[&PartCard::secid],
         fmt::format("section {} is of another kind; the part has {} elements", id, name_of(part.kind)),
         "give the part the *SECTION_... of its elements");
}

/// A part with elements needs both.
void require_section_and_material(const Part& part, const deck::RowOf<PartCard>& row, Tally& incomplete) {
  if (part.kind == ElementKind::nothing) return;
  const auto lacks = [&](int PartCard::*id) { return (*row).*id == 0 && !row[id].refused; };
  const bool no_section = lacks(&PartCard::secid), no_material = lacks(&PartCard::mid);
  if (!no_section && !no_material) return;
  const char* const what = no_section && no_material ? "section and no material" : no_section ? "section" : "material";
  incomplete.add(
      row[no_section ? &PartCard::secid : &PartCard::mid].place,
      [&] { return fmt::format("part {} has elements, but no {}", part.id, what); }, "give their ids in SECID and MID");
}

}  // namespace

namespace {

/// A tetrahedron N1 N2 N3 N4 N4 N4 N4 N4 in a formulation of bricks: as N1 N2 N3 N3 N4 N4 N4 N4 the collapsed brick has
/// the volume of the tetrahedron; as it is written, with a bottom of all four nodes, it would have half of it.
void fold_tetrahedra(Model& m) {
  if (m.control.sort_solids) return;
  for (std::size_t e = 0; e < m.solids.size(); ++e) {
    auto& n = m.solids.node[e];
    if (n[3] != n[4] || m.solids.quadratic(e) || m.solids.corners(e).size() != 4) continue;
    const Part& part = m.parts[m.solids.part[e]];
    if (part.kind != ElementKind::solid || part.section == none) continue;
    const int elform = m.solid_sections[part.section].elform;
    if (elform < 10 && elform != 4) n[3] = n[2];
  }
}

}  // namespace

void make_mesh(Builder& b) {
  make_nodes(b);
  const auto shell_rows = make_shells(b);
  make_solids(b);
  const auto beam_rows = make_beams(b);
  make_discretes(b);
  Tally incomplete(b.findings, Severity::error, "*PART");
  for (const auto& [index, row] : b.part_rows) {
    Part& part = b.model.parts[index];
    link_section(b, part, row);
    part.material = b.find(b.materials, "material", row[&PartCard::mid]);
    require_section_and_material(part, row, incomplete);
    part.hourglass = b.find(b.hourglass, "hourglass control", row[&PartCard::hgid]);
  }
  for (const auto& [index, section, id, hourglass] : b.composite_parts) {
    Part& part = b.model.parts[index];
    if (part.kind == ElementKind::shell) part.section = section;
    if (part.kind != ElementKind::shell && part.kind != ElementKind::nothing)
      refuse(b, id, fmt::format("*PART_COMPOSITE is of shells; the part has {} elements", name_of(part.kind)),
             "use *PART with their *SECTION_...");
    part.hourglass = b.find(b.hourglass, "hourglass control", hourglass);
  }
  fold_tetrahedra(b.model);
  turn_parts_inside_out(b);
  if (b.coarsening != nullptr)
    for (const Coarsening::Hanging& h : b.coarsening->hanging)
      b.model.hanging_nodes.push_back(
          {b.nodes.find(h.node), {b.nodes.find(h.ends[0]), b.nodes.find(h.ends[1])}, b.model.coarsen.place});
  set_thickness(b, shell_rows);
  b.defer(Phase::bodies, [beam_rows](Builder& late) {
    refuse_mirrored_discrete_beams(late, beam_rows);
    check_single_sections(late, beam_rows);
  });
}

}  // namespace nugget::reading
