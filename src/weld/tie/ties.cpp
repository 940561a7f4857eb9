// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/parallel.hpp"
#include "weld/tie/assembly.hpp"
#include "weld/tie/beam_choice.hpp"
#include "weld/tie/beam_clusters.hpp"
#include "weld/tie/disc.hpp"
#include "weld/tie/reference.hpp"
#include "weld/tie/surroundings.hpp"
#include "weld/tie/tie_findings.hpp"
#include "weld/tie/touching.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

/// Parametric distance from an edge within which a node counts as lying on it.
constexpr double edge_margin = 1e-4;
/// A node lies in the plane of a sheet beside it if that plane is closer than this share of the distance it is moved.
constexpr double in_plane_share = 0.5;
/// A weld shorter than this share of the distance of two touching mid-surfaces is crushed.
constexpr double crushed_share = 0.05;
/// An edge of a brick whose ends come closer than this share of its length, projected, would be crushed.
constexpr double crushed_edge_share = 0.5;
/// Sheets that are closer than touching by more than this share penetrate each other.
constexpr double penetration_share = 0.01;
/// Cosine of the largest angle between a weld and the normal of a sheet that it may be meant for: 60 degrees.
constexpr double across_share = 0.5;
/// A weld below this share of its diameter has no direction that projection could turn over.
constexpr double no_length_share = 1e-6;

/// What is known of a tracked node.
struct Record {
  Index node = none;
  bool found = false;             ///< a segment; `closest` is the chosen one
  bool tied = false;              ///< found, and not released with its weld
  bool only_sheet_taken = false;  ///< its candidates lie on the sheet that holds the weld's other end
  Candidate closest;              ///< `contact` none: there is no segment at all
  Candidate elsewhere;            ///< where only that sheet is in reach: the closest segment of another part
  Index tie = none;               ///< in Ties::ties
  double plane_of_other_sheet = infinity;
  std::vector<Candidate> within_tolerance;  ///< in the contact that is being worked on
};

/// One end of a weld: the mean of its face's nodes.
struct End {
  bool attached = false;   ///< at least one node
  bool moved = false;      ///< projected onto a segment
  Index sheet = none;      ///< part
  double thickness = 0.0;  ///< of the sheet [length]
  Vec3d normal;            ///< of the segment, zero where there is none
  Vec3d before, after;     ///< in the deck, and where it is tied [length]
  Vec3d on_sheet;          ///< projected onto the sheet, moved there or not [length]
  Vec3d sheet_in_deck;     ///< that point of the sheet where the deck has it [length]
};

/// How deep the two sheets of a weld lie in each other, by their thicknesses [length].
struct Overlap {
  double in_deck = 0.0, left = 0.0;  ///< and once sliding contacts have moved them; 0: not worth a word
};

/// The nodes that a contact tracks, ascending, each once. `everything` means the nodes of all welds. Nodes that a weld
/// shares with a sheet come in only where they are named otherwise than as a weld's.
std::vector<Index> nodes_on_side_a(const model::Model& model, const model::Contact& contact,
                                   const Surroundings& around) {
  std::vector<char> chosen(model.nodes.size(), 0);
  std::vector<char> parts(model.parts.size(), 0), welds(model.parts.size(), 0);
  for (Index p = 0; p < static_cast<Index>(model.parts.size()); ++p) welds[p] = of_weld_material(model, p);
  for (Index p : contact.a.parts) parts[p] = 1;
  const auto choose = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const bool weld = welds[elements.part[e]] != 0;
      if (!parts[elements.part[e]] && !(contact.a.everything && weld)) continue;
      for (Index n : elements.nodes(e))
        if (!weld || around.shell[n] == none) chosen[n] = 1;
    }
  };
  choose(model.shells);
  choose(model.solids);
  choose(model.beams);
  for (Index n : contact.a.nodes) chosen[n] = 1;
  for (const model::Segment& segment : contact.a.segments)
    for (Index n : segment) chosen[n] = 1;
  std::vector<Index> nodes;
  for (Index n = 0; n < static_cast<Index>(chosen.size()); ++n) {
    const bool end_in_sheet = around.of_weld[n] && around.shell[n] != none;
    if (chosen[n] && !(end_in_sheet && contact.kind == model::Contact::Kind::spotweld)) nodes.push_back(n);
  }
  return nodes;
}

class Tying {
 public:
  Tying(const model::Model& model, std::vector<Vec3d> x, Findings& findings)
      : model_(model),
        x_(std::move(x)),
        findings_(findings),
        around_(model),
        record_of_(model.nodes.size(), none),
        only_part_(model.nodes.size(), none) {
    result_.x = x_;
    result_.welds = find_welds(model);
  }

  Ties run() {
    read_required_parts();
    for (Index c = 0; c < static_cast<Index>(model_.contacts.size()); ++c)
      if (model_.contacts[c].tie() && !model_.contacts[c].ties_what_touches()) work_through(c);
    const auto sheet = [this](Index node) { return sheet_at(node); };
    result_.welds = join_clusters(model_, std::move(result_.welds), sheet, findings_);
    faces_ = faces_between_welds(model_, result_.welds);
    rejection_.resize(result_.welds.size(), 0);
    for (std::size_t w = 0; w < result_.welds.size(); ++w) classify_weld(w);
    release_nodes_of_lost_welds();
    make_ties();
    for (std::size_t w = 0; w < result_.welds.size(); ++w) describe_weld(w);
    tie_touching(model_, around_, x_, result_.ties, findings_);
    return std::move(result_);
  }

 private:
  void read_required_parts();
  void work_through(Index contact);
  std::vector<Tracked> tracked_nodes(Index contact);
  void collect_candidates(Index contact, const std::vector<Tracked>& tracked, std::vector<NearbySegments> offers);
  void choose_beam_segments(const Weld& weld);
  PlaceOnPart held_at(Index node) const;
  static const Candidate* best(const Record& record, Index part_to_avoid);
  static void choose_segment(Record& record, const Candidate* candidate);
  void free_inner_nodes();
  bool free_farther_node(Index a, Index b);
  void report_loose_nodes(Index contact, const std::vector<Tracked>& tracked);
  void classify_weld(std::size_t w);
  int distorted(const End& a, const End& b, double diameter) const;
  void release_nodes_of_lost_welds();
  void make_ties();
  void choose_constraint_or_spring(Tie& tie, const model::Contact& contact) const;
  void describe_weld(std::size_t w);
  Projection projection(std::size_t w, Index node, const Overlap& overlap) const;
  Projection rigid_projection(Index node) const;
  std::array<Index, 2> sheets_of(const std::vector<Projection>& ends) const;
  int position_case(const Record& r) const;
  std::string reason(const Record& r, const Projection& p, const Overlap& overlap) const;
  double sheet_moved(const Record& r) const;
  std::string of_penetration(const Record& r, const Overlap& overlap) const;

  Record* record(Index node) { return record_of_[node] == none ? nullptr : &records_[record_of_[node]]; }
  /// Whether a tie of this contact moves nodes onto the segments.
  bool projects(Index contact) const {
    return !model_.control.keep_tied_gap && model_.contacts[contact].offset == model::Contact::Offset::projected;
  }
  const Record* record(Index node) const { return record_of_[node] == none ? nullptr : &records_[record_of_[node]]; }
  /// A node that needs no tie: a node of a sheet, or of a rigid body.
  bool belongs_to_sheet(Index node) const { return around_.shell[node] != none || around_.rigid_body[node] != none; }
  bool attached(Index node) const {
    const Record* r = record(node);
    return belongs_to_sheet(node) || (r && r->tied);
  }
  /// Whether a node of a weld's end faces lies inside a nugget of more bricks than a weld may have: on a face that
  /// bricks of two welds share and that lies on no sheet.
  bool inside(const Weld& weld, Index node) const {
    if (!record(node)) return false;  // no contact tracks it, nor holds its neighbours
    for (const std::vector<Facet>& facets : weld.facets)
      for (const Facet& f : facets)
        if (std::find(f.begin(), f.end(), node) != f.end() && faces_.contains(sorted(f)) &&
            std::none_of(f.begin(), f.end(), [this](Index n) { return attached(n); }))
          return true;
    return false;
  }
  bool across(const Weld& weld, const Candidate& sheet) const;
  Index sheet_at(Index node) const;
  Vec3d foot(Index node) const;
  Vec3d foot_in_deck(Index node) const;
  Vec3d projected(Index node) const;
  End end(const Weld& weld, int side) const;
  Overlap overlap(const Weld& weld) const;

  const model::Model& model_;
  const std::vector<Vec3d> x_;  ///< by node, before projection
  Findings& findings_;
  Surroundings around_;
  std::vector<Index> record_of_;  // of each node, in records_
  std::vector<Record> records_;
  std::vector<Index> only_part_;  // of each node, by *ELEMENT_BEAM_PID
  std::vector<int> rejection_;    // of each weld: 0, or the projection case 7 or 8
  std::set<Facet> faces_;         // that bricks of two welds share
  Ties result_;
};

/// Gathers the parts that *ELEMENT_BEAM_PID asks for.
void Tying::read_required_parts() {
  for (const Weld& weld : result_.welds)
    for (std::size_t end = 0; end < 2; ++end) {
      const Index wanted = weld.tied_parts[end];
      if (wanted == none) continue;
      for (Index node : nodes_as_numbered(model_, weld, end)) {
        Index& part = only_part_[node];
        if (part != none && part != wanted)
          findings_.warning(weld.place, "*ELEMENT_BEAM_PID",
                            fmt::format("weld {} wants node {} tied to part {}, but a weld before it wants part {}: "
                                        "the first one wins",
                                        weld.id, model_.nodes.id[node], model_.parts[wanted].id, model_.parts[part].id),
                            "give the two welds nodes of their own");
        if (part == none) part = wanted;
      }
    }
}

void Tying::work_through(Index contact) {
  const Reference reference(model_, x_, contact);
  report_what_is_not_built(model_, model_.contacts[contact], reference.segments(), findings_);
  std::vector<Tracked> tracked = tracked_nodes(contact);
  if (model_.contacts[contact].thickness_a == 0.0) aim_clusters(model_, reference, result_.welds, x_, tracked);
  if (reference.empty() || tracked.empty()) {
    report_empty_side(model_.contacts[contact], reference.empty(), findings_);
    return;
  }
  std::vector<NearbySegments> offers(tracked.size());
  parallel_for(tracked.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) offers[i] = reference.search(tracked[i]);
  });
  collect_candidates(contact, tracked, std::move(offers));

  for (const Weld& weld : result_.welds)
    if (weld.kind == Weld::Kind::beam || weld.kind == Weld::Kind::connector) choose_beam_segments(weld);
  for (const Tracked& t : tracked)
    if (Record& r = *record(t.node); !r.tied && !r.only_sheet_taken) choose_segment(r, best(r, none));
  free_inner_nodes();
  for (const Tracked& t : tracked) {
    Record& r = *record(t.node);
    if (r.only_sheet_taken) r.elsewhere = reference.closest_elsewhere(t, r.within_tolerance.front().segment.part);
    r.within_tolerance.clear();
  }
  report_loose_nodes(contact, tracked);
}

/// The nodes on side a that are free to be tied, ascending.
std::vector<Tracked> Tying::tracked_nodes(Index contact) {
  const model::Contact& c = model_.contacts[contact];
  std::vector<Index> rigid;
  std::vector<Tracked> tracked;
  for (Index node : nodes_on_side_a(model_, c, around_)) {
    // Springs hold bodies too. The end of a weld on a body is held already.
    const bool by_springs = c.penalty_fallback || (c.tie_by_springs() && c.kind != model::Contact::Kind::spotweld);
    if (around_.rigid_body[node] != none && !by_springs) {
      rigid.push_back(node);
      continue;
    }
    const double thickness = c.thickness_a > 0.0 ? c.thickness_a : around_.thickness[node] * c.thickness_scale_a;
    tracked.push_back({.node = node, .thickness = thickness, .only_part = only_part_[node]});
  }
  report_rigid_tracked_nodes(model_, c, around_, rigid, findings_);
  return tracked;
}

/// Writes into the records what the search in this contact has found.
void Tying::collect_candidates(Index contact, const std::vector<Tracked>& tracked, std::vector<NearbySegments> offers) {
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    const Index node = tracked[i].node;
    if (record_of_[node] == none) {
      record_of_[node] = static_cast<Index>(records_.size());
      records_.emplace_back().node = node;
    }
    Record& r = *record(node);
    NearbySegments& nearby = offers[i];
    if (r.tied) {
      if (!nearby.within_tolerance.empty()) report_second_tie(model_, node, r.closest.contact, contact, findings_);
      continue;
    }
    r.only_sheet_taken = false;
    const bool nearer = r.closest.contact == none || nearby.closest.foot.distance < r.closest.foot.distance;
    if (nearby.closest.contact != none && nearer) r.closest = nearby.closest;
    r.plane_of_other_sheet = nearby.plane_of_other_sheet;
    r.within_tolerance = std::move(nearby.within_tolerance);
  }
}

/// Ties the two ends to two sheets.
void Tying::choose_beam_segments(const Weld& weld) {
  const std::array<Record*, 2> r{record(weld.ends[0].node), record(weld.ends[1].node)};
  const auto is_open = [](const Record* record) {
    return record && !record->tied && !record->within_tolerance.empty();
  };
  const std::array<bool, 2> open{is_open(r[0]), is_open(r[1])};
  const Vec3d axis = x_[weld.ends[1].node] - x_[weld.ends[0].node];
  if (open[0] != open[1]) {
    const int end = open[0] ? 0 : 1;
    const Vec3d to_it = end == 1 ? axis : -1.0 * axis;
    choose_segment(*r[end], best_beside(r[end]->within_tolerance, held_at(weld.ends[1 - end].node), to_it, x_));
  }
  if (!open[0] || !open[1]) return;
  const auto choice = choose_two_sheets({&r[0]->within_tolerance, &r[1]->within_tolerance}, axis, x_);
  for (int end = 0; end < 2; ++end) choose_segment(*r[end], choice[end]);
}

/// Where a sheet or a body holds a node.
PlaceOnPart Tying::held_at(Index node) const {
  if (const Record* r = record(node); r && r->tied) return place_of(r->closest, x_);
  const Index shell = around_.shell[node];
  if (shell == none) return {sheet_at(node), x_[node], {}};
  const std::array<Index, 4>& n = model_.shells.node[shell];
  return {sheet_at(node), x_[node], normal({x_[n[0]], x_[n[1]], x_[n[2]], x_[n[3]]})};
}

/// The best that a node is offered elsewhere than on one part; null if there is nothing.
const Candidate* Tying::best(const Record& record, Index part_to_avoid) {
  const auto elsewhere = [&](const Candidate& c) { return part_to_avoid == none || c.segment.part != part_to_avoid; };
  const auto found = std::find_if(record.within_tolerance.begin(), record.within_tolerance.end(), elsewhere);
  return found == record.within_tolerance.end() ? nullptr : &*found;
}

/// Ties a node to the candidate; null: it stays free.
void Tying::choose_segment(Record& record, const Candidate* candidate) {
  if (candidate) {
    record.found = record.tied = true;
    record.closest = *candidate;
  } else {
    record.only_sheet_taken = !record.within_tolerance.empty();
  }
}

/// Nodes between the layers of a nugget of bricks may be in reach of a sheet and belong to none: of an edge that
/// projection onto one sheet would crush only the nearer end is tied to that sheet. What its other end loses, its
/// neighbours may gain, so this goes on until nothing changes.
void Tying::free_inner_nodes() {
  bool changed = true;
  while (changed) {
    changed = false;
    for (const Weld& weld : result_.welds) {
      if (!weld.of_bricks()) continue;
      for (Index e : weld.elements)
        for (const auto& [from, to] : opposite_faces(model_.solids.node[e]))
          for (std::size_t i = 0; i < 4; ++i) changed = free_farther_node(from[i], to[i]) || changed;
    }
  }
}

/// Takes a sheet away from the farther node of an edge that is crushed onto it; it gets its next best. Nodes that an
/// earlier contact has tied stay.
bool Tying::free_farther_node(Index a, Index b) {
  Record *near = record(a), *far = record(b);
  if (!near || !far || !near->tied || !far->tied) return false;
  if (near->closest.foot.gap > far->closest.foot.gap) std::swap(near, far);
  const Candidate &kept = near->closest, &lost = far->closest;
  const std::vector<Vec3d>& x = model_.nodes.x;
  if (far->within_tolerance.empty() || kept.segment.part != lost.segment.part || kept.foot.gap == lost.foot.gap ||
      norm(lost.foot.point - kept.foot.point) >= crushed_edge_share * norm(x[far->node] - x[near->node]))
    return false;
  const Candidate* other = best(*far, lost.segment.part);
  if (other) {
    const Index part = lost.segment.part;
    far->closest = *other;
    std::erase_if(far->within_tolerance, [part](const Candidate& c) { return c.segment.part == part; });
  } else {
    far->found = far->tied = false;
    far->only_sheet_taken = true;
  }
  return true;
}

/// One summary of the tracked nodes that belong to no weld and found nothing.
void Tying::report_loose_nodes(Index contact, const std::vector<Tracked>& tracked) {
  std::vector<Index> loose;
  for (const Tracked& t : tracked)
    if (!around_.of_weld[t.node] && !record(t.node)->tied) loose.push_back(t.node);
  if (loose.empty()) return;
  const Candidate& closest = record(loose.front())->closest;
  report_untied_nodes(model_, model_.contacts[contact], loose, closest.foot.distance, closest.tolerance, findings_);
}

Index Tying::sheet_at(Index node) const {
  const Record* r = record(node);
  if (r && r->tied) return r->closest.segment.part;
  if (around_.shell[node] != none) return model_.shells.part[around_.shell[node]];
  if (around_.rigid_body[node] == none) return none;
  const std::vector<Index>& parts = model_.rigid_bodies[around_.rigid_body[node]].parts;
  return parts.empty() ? none : parts.front();
}

/// The place of a tied node on its segment, of any other its own.
Vec3d Tying::foot(Index node) const {
  const Record* r = record(node);
  return r && r->tied ? r->closest.foot.point : x_[node];
}

/// The same point of the segment where the deck has it.
Vec3d Tying::foot_in_deck(Index node) const {
  const Record* r = record(node);
  if (!r || !r->tied) return model_.nodes.x[node];
  Vec3d point;
  for (std::size_t i = 0; i < 4; ++i) point += r->closest.foot.weight[i] * model_.nodes.x[r->closest.segment.node[i]];
  return point;
}

Vec3d Tying::projected(Index node) const {
  const Record* r = record(node);
  return r && r->tied && projects(r->closest.contact) ? r->closest.foot.point : x_[node];
}

End Tying::end(const Weld& weld, int side) const {
  End end;
  int count = 0;
  for (Index node : weld.face[side]) {
    ++count;
    end.before += model_.nodes.x[node];
    end.after += projected(node);
    end.on_sheet += foot(node);
    end.sheet_in_deck += foot_in_deck(node);
    if (end.attached || !attached(node)) continue;
    end.attached = true;
    end.sheet = sheet_at(node);
    if (const Record* r = record(node); r && r->tied) {
      end.moved = projects(r->closest.contact);
      const ReferenceSegment& s = r->closest.segment;
      end.thickness = s.thickness;
      end.normal = normal({x_[s.node[0]], x_[s.node[1]], x_[s.node[2]], x_[s.node[3]]});
    } else if (around_.shell[node] != none) {
      end.thickness = model_.shells.thickness[around_.shell[node]];
    }
  }
  if (count > 0) {
    end.before = (1.0 / count) * end.before;
    end.after = (1.0 / count) * end.after;
    end.on_sheet = (1.0 / count) * end.on_sheet;
    end.sheet_in_deck = (1.0 / count) * end.sheet_in_deck;
  }
  return end;
}

/// 7 or 8 if projection would turn the weld over or crush it, else 0.
int Tying::distorted(const End& a, const End& b, double diameter) const {
  const Vec3d before = b.before - a.before, after = b.after - a.after;
  const double touching = 0.5 * (a.thickness + b.thickness);
  const bool turned_over = norm(before) > no_length_share * diameter && dot(before, after) <= 0.0;
  const bool crushed = norm(after) < crushed_share * touching;
  if (!turned_over && !crushed) return 0;
  return dot(a.normal, before) < 0.0 && dot(b.normal, before) > 0.0 ? 8 : 7;
}

/// Whether weld `w` is refused, tied, to be deleted.
void Tying::classify_weld(std::size_t w) {
  Weld& weld = result_.welds[w];
  if (weld.of_bricks())
    find_end_faces(
        model_, weld, [this](Index node) { return sheet_at(node); }, faces_);
  const WeldSize size = measure(weld, model_.nodes.x);
  weld.length = weld.length_before = size.length;
  weld.diameter = size.diameter;
  if (weld.kind == Weld::Kind::rigid) {
    weld.tied = true;
    return;
  }
  const End a = end(weld, 0), b = end(weld, 1);
  if (a.moved || b.moved) rejection_[w] = distorted(a, b, weld.diameter);
  const auto is_inside = [&](const Projection& p) { return inside(weld, p.node); };
  const auto is_attached = [&](const Projection& p) { return attached(p.node) || is_inside(p); };
  const auto is_tracked = [&](const Projection& p) { return record(p.node) != nullptr; };
  weld.tied = rejection_[w] == 0 && std::all_of(weld.ends.begin(), weld.ends.end(), is_attached);
  weld.held_by_bricks = std::any_of(weld.ends.begin(), weld.ends.end(), is_inside);
  // SPOTSTP is about nodes that a contact tracks in vain.
  const bool in_vain = !weld.tied && std::any_of(weld.ends.begin(), weld.ends.end(), is_tracked);
  weld.deleted = in_vain && model_.control.untied_weld == 2;
}

/// A refused or deleted weld lets its nodes go, unless another weld holds them.
void Tying::release_nodes_of_lost_welds() {
  std::vector<char> kept(records_.size(), 0);
  for (std::size_t r = 0; r < records_.size(); ++r) kept[r] = !around_.of_weld[records_[r].node];
  for (std::size_t w = 0; w < result_.welds.size(); ++w) {
    if (rejection_[w] != 0 || result_.welds[w].deleted) continue;
    for (const Projection& p : result_.welds[w].ends)
      if (record_of_[p.node] != none) kept[record_of_[p.node]] = 1;
  }
  for (std::size_t r = 0; r < records_.size(); ++r)
    if (!kept[r]) records_[r].tied = false;
}

void Tying::make_ties() {
  for (Index node = 0; node < static_cast<Index>(model_.nodes.size()); ++node) {
    Record* r = record(node);
    if (!r || !r->tied) continue;
    const Candidate& c = r->closest;
    const model::Contact& contact = model_.contacts[c.contact];
    Tie tie;
    tie.node = node;
    tie.contact = c.contact;
    tie.shell = c.segment.shell;
    tie.part = c.segment.part;
    tie.segment = c.segment.node;
    tie.xi = c.foot.xi;
    tie.eta = c.foot.eta;
    tie.weight = c.foot.weight;
    tie.point = c.foot.point;
    constexpr double round_off = 1e-10;  // of the tolerance
    tie.gap = c.foot.gap > round_off * c.tolerance ? c.foot.gap : 0.0;
    tie.moved = projects(c.contact) ? tie.gap : 0.0;
    if (projects(c.contact)) result_.x[node] = tie.point;
    choose_constraint_or_spring(tie, contact);
    r->tie = static_cast<Index>(result_.ties.size());
    result_.ties.push_back(tie);
  }
  const auto interpolated = [](const Weld& weld) { return weld.interpolated; };
  if (by_area(model_.control.weld_tie) || std::ranges::any_of(result_.welds, interpolated))
    hang_on_discs(model_, result_.welds, result_.x, result_.ties, findings_);
  check_segments(model_, around_, result_.x, result_.ties, findings_);
}

/// What the tie hands over, and by what means.
void Tying::choose_constraint_or_spring(Tie& tie, const model::Contact& contact) const {
  using Offset = model::Contact::Offset;
  const bool on_shell = tie.shell != none && !model_.has_membranes(tie.part);
  const bool with_couples = contact.kind == model::Contact::Kind::tied_shell_edge_to_solid;
  tie.rotations = around_.rotates[tie.node] && contact.ties_rotations() && (on_shell || with_couples);
  tie.twist = contact.torsion && tie.rotations && on_shell;
  tie.couples = !on_shell && (with_couples || contact.offset != Offset::projected || model_.control.keep_tied_gap);
  tie.spring = contact.tie_by_springs() || around_.rigid_body[tie.node] != none;
  tie.lever = contact.offset != Offset::penalty;
}

/// Of sheets in the right order.
Overlap Tying::overlap(const Weld& weld) const {
  const End a = end(weld, 0), b = end(weld, 1);
  if (!a.attached || !b.attached || a.sheet == b.sheet || a.thickness == 0.0 || b.thickness == 0.0) return {};
  const Vec3d n = norm(a.normal) > 0.0 ? a.normal : b.normal;
  if (norm(n) == 0.0) return {};
  const double touching = 0.5 * (a.thickness + b.thickness);
  const auto depth = [&](const Vec3d& apart) {
    const double overlap = touching - std::abs(dot(apart, n));
    return overlap > penetration_share * touching ? overlap : 0.0;
  };
  return {depth(b.sheet_in_deck - a.sheet_in_deck), depth(b.on_sheet - a.on_sheet)};
}

void Tying::describe_weld(std::size_t w) {
  Weld& weld = result_.welds[w];
  const Overlap of_sheets = rejection_[w] == 0 ? overlap(weld) : Overlap{};
  for (Projection& p : weld.ends)
    p = weld.kind == Weld::Kind::rigid ? rigid_projection(p.node) : projection(w, p.node, of_sheets);
  if (weld.kind == Weld::Kind::rigid) {
    weld.sheets = sheets_of(weld.ends);
    return;
  }
  for (int side = 0; side < 2; ++side) weld.sheets[side] = end(weld, side).sheet;
  const WeldSize size = measure(weld, result_.x);
  weld.length = size.length;
  weld.diameter = size.diameter;
}

Projection Tying::rigid_projection(Index node) const {
  Projection p;
  p.node = node;
  p.tied = true;
  const Index shell = around_.shell[node];
  p.reason = shell == none ? "on no shell; held by the rigid weld"
                           : fmt::format("a node of shell {}; held by the rigid weld", model_.shells.id[shell]);
  return p;
}

/// The first two different parts whose shells the nodes belong to.
std::array<Index, 2> Tying::sheets_of(const std::vector<Projection>& ends) const {
  std::array<Index, 2> sheets{none, none};
  for (const Projection& p : ends) {
    const Index sheet = around_.shell[p.node] == none ? none : model_.shells.part[around_.shell[p.node]];
    if (sheet == none || sheet == sheets[0]) continue;
    if (sheets[0] == none)
      sheets[0] = sheet;
    else if (sheets[1] == none)
      sheets[1] = sheet;
  }
  return sheets;
}

Projection Tying::projection(std::size_t w, Index node, const Overlap& overlap) const {
  Projection p;
  p.node = node;
  const Record* r = record(node);
  if (inside(result_.welds[w], node)) {
    p.tied = rejection_[w] == 0;
    p.reason = "inside the nugget, on no sheet; held by the bricks on both sides";
    return p;
  }
  if (!r || (!r->found && belongs_to_sheet(node))) {
    p.tied = belongs_to_sheet(node);
    p.closest_shell = around_.shell[node];
    p.reason = around_.rigid_body[node] != none
                   ? fmt::format("belongs to rigid body {}", model_.rigid_bodies[around_.rigid_body[node]].id)
               : around_.shell[node] != none
                   ? fmt::format("is a node of shell {}", model_.shells.id[around_.shell[node]])
                   : "no contact tracks it";
    return p;
  }
  p.closest_shell = r->closest.segment.shell;
  p.only_sheet_taken = !r->found && r->only_sheet_taken;
  const Candidate& sheet = p.only_sheet_taken ? r->elsewhere : r->closest;
  p.distance = sheet.contact == none ? infinity : r->found ? sheet.foot.gap : sheet.foot.distance;
  p.tolerance = sheet.tolerance;
  p.faces_sheet = sheet.contact != none && sheet.foot.over && across(result_.welds[w], sheet);
  p.tied = r->tied && rejection_[w] == 0;
  if (p.tied) p.tie = result_.ties[r->tie];
  const bool penetrated = overlap.in_deck > 0.0 || overlap.left > 0.0 || sheet_moved(*r) > 0.0;
  p.projection_case = rejection_[w] != 0 ? rejection_[w] : !r->found ? 5 : penetrated ? 4 : position_case(*r);
  p.reason = reason(*r, p, overlap);
  return p;
}

/// 6, 3, 2 or 1, by where on its segment a node lies.
int Tying::position_case(const Record& r) const {
  const Foot& foot = r.closest.foot;
  if (!foot.over || r.plane_of_other_sheet < in_plane_share * foot.gap) return 6;
  bool on_first = false, on_second = false;
  if (r.closest.segment.triangle()) {
    const double third = 1.0 - foot.xi - foot.eta;
    on_second = std::max({foot.xi, foot.eta, third}) >= 1.0 - edge_margin;
    on_first = std::min({foot.xi, foot.eta, third}) <= edge_margin;
    return on_second ? 3 : on_first ? 2 : 1;
  }
  on_first = std::abs(foot.xi) >= 1.0 - edge_margin;
  on_second = std::abs(foot.eta) >= 1.0 - edge_margin;
  return on_first && on_second ? 3 : on_first || on_second ? 2 : 1;
}

/// Whether a sheet lies across a weld, as sheets do that it joins, and not along it as a web beside it does.
bool Tying::across(const Weld& weld, const Candidate& sheet) const {
  const Vec3d axis = face_centre(weld, 1, x_) - face_centre(weld, 0, x_);
  const std::array<Index, 4>& n = sheet.segment.node;
  return std::abs(dot(normal({x_[n[0]], x_[n[1]], x_[n[2]], x_[n[3]]}), axis)) >= across_share * norm(axis);
}

/// How far contact moved the sheet of a tied node there; 0: by nothing worth a word.
double Tying::sheet_moved(const Record& r) const {
  const double moved = norm(foot(r.node) - foot_in_deck(r.node));
  return moved > penetration_share * r.closest.segment.thickness ? moved : 0.0;
}

/// What is reported of a weld over sheets that penetrate each other.
std::string Tying::of_penetration(const Record& r, const Overlap& overlap) const {
  const double moved = sheet_moved(r);
  if (moved == 0.0 && overlap.left >= overlap.in_deck)
    return fmt::format("the sheets penetrate each other by {:.4g}", overlap.left);
  std::string text;
  if (overlap.in_deck > 0.0) text = fmt::format("the sheets penetrated each other by {:.4g}; ", overlap.in_deck);
  text += moved > 0.0 ? fmt::format("contact moved this one by {:.4g}", moved) : "contact moved the other one";
  return overlap.left > 0.0 ? text + fmt::format(", and {:.4g} is left", overlap.left) : text;
}

std::string Tying::reason(const Record& r, const Projection& p, const Overlap& overlap) const {
  const Foot& foot = r.closest.foot;
  const std::string segment = name_segment(model_, r.closest.segment.shell, r.closest.segment.part);
  const std::string distance = fmt::format("{:.4g}", foot.gap);
  std::string text;
  switch (p.projection_case) {
    case 1: text = "over " + segment; break;
    case 2: text = "on an edge of " + segment; break;
    case 3: text = "on a corner of " + segment; break;
    case 4: text = fmt::format("{}; over {}, {} away", of_penetration(r, overlap), segment, distance); break;
    case 5:
      if (r.closest.contact == none) return "there is no segment that it may be tied to";
      if (r.only_sheet_taken) {
        text = "the only sheet in reach, with " + segment + ", holds the weld's other end";
        if (r.elsewhere.contact == none) return text;
        return fmt::format("{}; the closest other, {}, is {:.4g} away, tolerance {:.4g}", text,
                           name_segment(model_, r.elsewhere.segment.shell, r.elsewhere.segment.part), p.distance,
                           p.tolerance);
      }
      return fmt::format("no segment in reach: the closest, {}, is {:.4g} away, tolerance {:.4g}", segment, p.distance,
                         p.tolerance);
    case 6: text = "over no segment of its own sheet; the closest is " + segment + ", " + distance + " away"; break;
    default: return "projection onto " + segment + ", " + distance + " away, would turn the weld over or crush it";
  }
  return p.tied ? text : text + "; released with the weld";
}

}  // namespace

Ties tie(const model::Model& model, std::vector<Vec3d> x, Findings& findings) {
  Ties ties = Tying(model, std::move(x), findings).run();
  report_welds(model, ties, findings);
  return ties;
}

Ties tie(const model::Model& model, Findings& findings) {
  return tie(model, model.nodes.x, findings);
}

}  // namespace nugget::weld
