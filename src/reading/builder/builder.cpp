// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/builder.hpp"
#include "base/index.hpp"
#include "model/lumped_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nugget::reading {

namespace {

std::string text_of(const Place& place) {
  return place.line > 0 ? fmt::format("{}:{}", place.file, place.line) : place.file;
}

/// The id that stands in a field, whatever its sign says.
int id_of(const deck::Entry& field) {
  return std::abs(field.integer());
}

template <class Member>
const Set<Member>* find_set(Builder& b, const Ids& ids, const std::vector<Set<Member>>& sets, std::string_view what,
                            const deck::Entry& field) {
  const Index i = b.find(ids, what, field);
  return i == none ? nullptr : &sets[i];
}

}  // namespace

bool Ids::add(int id, Index index, const Place& place, std::string_view keyword, std::string_view what,
              Findings& findings) {
  const auto [at, is_new] = entries_.try_emplace(id, Entry{index, place});
  if (is_new) return true;
  if (id == 0) return false;  // ids that could not be read, which was said there
  findings.error(place, std::string(keyword),
                 fmt::format("{} {} is defined twice; first at {}", what, id, text_of(at->second.place)),
                 "give one of them another id");
  return false;
}

void Ids::assign(const std::vector<int>& ascending) {
  ascending_ = ascending;
  by_id_.clear();
  if (ascending_.empty()) return;
  const auto span = static_cast<std::size_t>(static_cast<long>(ascending_.back()) - ascending_.front() + 1);
  // A table costs four bytes an id of the range; with large gaps the binary search is the better bargain.
  if (span > 8 * ascending_.size() + 1024) return;
  by_id_.assign(span, none);
  for (std::size_t i = 0; i < ascending_.size(); ++i)
    by_id_[ascending_[i] - ascending_.front()] = static_cast<Index>(i);
}

Index Ids::find(int id) const {
  if (!given_.empty())
    if (const auto other = given_.find(id); other != given_.end()) return other->second;
  if (!by_id_.empty()) {
    const long at = static_cast<long>(id) - ascending_.front();
    return at < 0 || at >= static_cast<long>(by_id_.size()) ? none : by_id_[at];
  }
  if (!ascending_.empty()) {
    const auto at = std::lower_bound(ascending_.begin(), ascending_.end(), id);
    return at == ascending_.end() || *at != id ? none : static_cast<Index>(at - ascending_.begin());
  }
  const auto at = entries_.find(id);
  return at == entries_.end() ? none : at->second.index;
}

const std::string* Ids::left_out(int id) const {
  const auto at = ignored_.find(id);
  return at == ignored_.end() ? nullptr : &at->second;
}

unsigned bits_of_code(int code) {
  static constexpr std::array<unsigned, 8> bits{0b000, 0b001, 0b010, 0b100, 0b011, 0b110, 0b101, 0b111};
  return code < 0 || code > 7 ? 0 : bits[code];
}

const std::vector<double>& Builder::nodal_mass() {
  if (nodal_mass_.empty()) nodal_mass_ = nodal_masses(model);
  return nodal_mass_;
}

void Builder::run(Phase phase) {
  // By index: a closure may leave another one for its own phase.
  auto& work = work_[static_cast<std::size_t>(phase)];
  for (std::size_t i = 0; i < work.size(); ++i) {
    const auto task = std::move(work[i]);
    task(*this);
  }
  work.clear();
}

Index Builder::find(const Ids& ids, std::string_view what, const deck::Entry& field) {
  const int id = id_of(field);
  if (id == 0) return none;
  const Index found = ids.find(id);
  if (found == none) report_missing(ids, what, field);
  return found;
}

void Builder::report_missing(const Ids& ids, std::string_view what, const deck::Entry& field) {
  const int id = id_of(field);
  const std::string* const refused = ids.left_out(id);
  if (refused == nullptr)
    // What was defined by an id that could not be read, which was said there, is entered as 0.
    field.report(findings, Severity::error, fmt::format("{} {} is not defined", what, id),
                 ids.find(0) == none ? "" : fmt::format("correct the id of the {} that could not be read", what));
  else if (skip_unsupported)
    field.report(findings, Severity::error,
                 fmt::format("{} {} is left out, as {} is not supported", what, id, *refused),
                 "define it by a supported keyword, or remove what needs it");
}

CurveTable Builder::table_with_curves(Index table) const {
  if (table == none) return {};
  const Table& t = model.tables[table];
  if (t.curve.size() != t.value.size()) return {};
  CurveTable result{t.id, t.value, {}};
  for (const Index c : t.curve) result.curve.push_back(model.curves[c]);
  return result;
}

void Builder::mark_ignored(const deck::Block& block) {
  struct Family {
    std::string_view beginning;
    IdSpace space;
    std::vector<Ids*> ids;
  };
  const Family families[] = {
      {"MAT_", IdSpace::material, {&materials}},
      {"SECTION_",
       IdSpace::other,
       {&shell_sections, &solid_sections, &beam_sections, &discrete_sections, &belt_sections}},
      {"SET_NODE", IdSpace::set, {&node_sets}},
      {"SET_PART_TREE", IdSpace::set, {&branches}},
      {"SET_PART", IdSpace::set, {&part_sets}},
      {"SET_SEGMENT", IdSpace::set, {&segment_sets}},
      {"SET_SHELL", IdSpace::set, {&shell_sets}},
      {"SET_SOLID", IdSpace::set, {&solid_sets}},
      {"SET_BEAM", IdSpace::set, {&beam_sets}},
      {"DEFINE_CURVE", IdSpace::define, {&curves}},
      {"DEFINE_TABLE", IdSpace::define, {&curves}},
      {"DEFINE_COORDINATE", IdSpace::define, {&systems}},
  };
  for (const Family& family : families) {
    if (!block.keyword.starts_with(family.beginning)) continue;
    deck::Cursor cursor(deck, block, findings);
    if (block.keyword.ends_with("_TITLE") && cursor.more()) cursor.skip();
    if (!cursor.more()) return;
    const long offset = block.transform ? block.transform->id_offset[static_cast<std::size_t>(family.space)] : 0;
    const double id = cursor.peek_number(0) + static_cast<double>(offset);
    if (!(std::abs(id) < std::numeric_limits<int>::max())) return;
    for (Ids* ids : family.ids) ids->mark_ignored(static_cast<int>(id), block.starred());
    return;
  }
}

Index Builder::node(const deck::Entry& field) {
  const Index found = find(nodes, "node", field);
  if (found != none) model.named_nodes.push_back(found);
  return found;
}
Index Builder::part(const deck::Entry& field) {
  return find(parts, "part", field);
}
Index Builder::curve(const deck::Entry& field) {
  return find(curves, "curve", field);
}
Index Builder::shell(const deck::Entry& field) {
  const Index found = find(shells, "shell", field);
  if (found != none) model.named_shells.push_back(found);
  return found;
}
Index Builder::solid(const deck::Entry& field) {
  return find(solids, "solid", field);
}
Index Builder::beam(const deck::Entry& field) {
  return find(beams, "beam", field);
}
Index Builder::system(const deck::Entry& field) {
  const Index found = turning_or_fixed_system(field);
  if (found == none || !model.systems[found].turning) return found;
  refuse(*this, field,
         fmt::format("coordinate system {} turns with its nodes (FLAG 1); fixed axes are built here", id_of(field)),
         "define one with FLAG 0");
  return none;
}
Index Builder::system_of_directions(const deck::Entry& field) {
  const Index found = system(field);
  if (const auto curved = curved_systems.find(std::abs(field.integer()));
      found != none && curved != curved_systems.end())
    refuse(*this, field,
           fmt::format("coordinate system {} is {}: directions that differ from node to node are not built",
                       curved->first, curved->second == 1 ? "cylindrical" : "spherical"),
           "write TYPE 0, and a Cartesian system for each direction");
  return found;
}

Index Builder::turning_or_fixed_system(const deck::Entry& field) {
  return find(systems, "coordinate system", field);
}

const Vec3d* Builder::vector(const deck::Entry& field) {
  const Index i = find(vectors, "vector", field);
  return i == none ? nullptr : &vector_list[i];
}
const Vec3d* Builder::vector_tail(const deck::Entry& field) {
  const Index i = find(vectors, "vector", field);
  return i == none ? nullptr : &vector_tails[i];
}
const Box* Builder::box(const deck::Entry& field) {
  const Index i = find(boxes, "box", field);
  return i == none ? nullptr : &box_list[i];
}

const Set<Index>* Builder::node_set(const deck::Entry& field) {
  return find_set(*this, node_sets, model.sets.nodes, "node set", field);
}
const Set<Index>* Builder::part_set(const deck::Entry& field) {
  return find_set(*this, part_sets, model.sets.parts, "part set", field);
}
const Set<Index>* Builder::shell_set(const deck::Entry& field) {
  return find_set(*this, shell_sets, model.sets.shells, "shell set", field);
}
const Set<Index>* Builder::solid_set(const deck::Entry& field) {
  return find_set(*this, solid_sets, model.sets.solids, "solid set", field);
}
const Set<Index>* Builder::beam_set(const deck::Entry& field) {
  return find_set(*this, beam_sets, model.sets.beams, "beam set", field);
}
const Set<Index>* Builder::branch(const deck::Entry& field) {
  return find_set(*this, branches, model.sets.branches, "branch of parts", field);
}
const Set<Segment>* Builder::segment_set(const deck::Entry& field) {
  return find_set(*this, segment_sets, model.sets.segments, "segment set", field);
}

bool at_end(const deck::Cursor& cursor) {
  return !cursor.more();
}

void expect_end(Builder& builder, const deck::Cursor& cursor) {
  if (at_end(cursor)) return;
  builder.findings.error(cursor.place(), cursor.block().starred(), "more data lines than this keyword has cards",
                         "remove them, or give the next definition its own keyword line");
}

std::string read_title(deck::Cursor& cursor, const Options& options) {
  return options.contains("TITLE") ? cursor.read_text() : std::string{};
}

void refuse(Builder& builder, const deck::Entry& field, std::string_view text, std::string_view remedy) {
  field.report(builder.findings, Severity::error, text, remedy);
}

void refuse_nonzero(Builder& builder, const deck::Entry& field, std::string_view text, std::string_view remedy) {
  if (!field.blank && field.value != 0.0) refuse(builder, field, text, remedy);
}

void Tally::finish() {
  if (count_ <= limit_) return;
  findings_.add({severity_, last_, keyword_, {}, {}, fmt::format("and {} more of this kind", count_ - limit_), {}});
}

}  // namespace nugget::reading
