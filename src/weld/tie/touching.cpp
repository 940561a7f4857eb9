// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/touching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "model/bond.hpp"
#include "weld/tie/held_directions.hpp"
#include "weld/tie/reference.hpp"
#include "weld/tie/tie_findings.hpp"

namespace nugget::weld {
namespace {

/// CLOSE where it is 0, as a share of the root of the segment's area.
constexpr double default_close = 0.01;
/// A segment that a walk along its sheet reaches within so many times the distance that counts as a touch is the node's
/// own neighbourhood: the legs of a fold, a web and what it stands on.
constexpr double walk_share = 2.0;
/// Cosine of how far off the normal of a segment a node beside its border may stand: over the ridge between two
/// segments of a rounded sheet a node is over neither.
constexpr double over_ridge = 0.866;
/// Of two sizes of elements, or two distances, that differ by less than this share neither is larger.
constexpr double equal = 1e-6;

/// A segment that a node touches.
struct Touch {
  Index segment = none;
  Foot foot;
  double between = 0.0;  ///< from surface to surface [length]
};

/// What each node of the contact has around it, and the places that are near enough to be tied.
class Touching {
 public:
  Touching(const model::Model& model, Index contact, const Surroundings& around, const std::vector<Vec3d>& x,
           std::vector<Tie>& ties, Findings& findings);
  void run();

 private:
  void gather_segments(const Reference& reference);
  void link_nodes();
  std::vector<Touch> touches(Index node) const;
  std::set<Index> neighbourhood(Index node, double reach) const;
  double close_to(std::size_t segment) const;
  Corners corners(const ReferenceSegment& s) const;
  Foot snapped(Foot foot, bool triangle) const;
  void order_parts();
  void find_held();
  int rank_of(Index node) const;
  bool of_own_part(Index node, Index part) const {
    const std::vector<Index>& own = parts_at_[node];
    return std::find(own.begin(), own.end(), part) != own.end();
  }
  enum class Pass { down, up, within };
  void tie_all(Pass pass);
  const Touch* choice(Index node, Pass pass) const;
  bool follows_part_of(const Touch& touch, Index node) const;
  bool try_tie(Index node, const Touch& touch);
  Tie made(Index node, const Touch& touch) const;
  bool leads_to(const std::vector<Index>& from, Index node) const;
  std::string left_alone() const;
  void report() const;

  const model::Model& model_;
  const model::Contact& contact_;
  Index contact_index_;
  const Surroundings& around_;
  const std::vector<Vec3d>& x_;
  std::vector<Tie>& ties_;
  Findings& findings_;

  std::vector<ReferenceSegment> segments_;
  std::vector<double> size_;                  // of each segment: root of its area
  std::vector<Index> first_, at_node_;        // of each node its segments, one after the other
  std::vector<std::vector<Index>> parts_at_;  // of each node the parts of its segments, ascending
  std::vector<double> thickness_;             // of each node: mean of its segments'
  std::vector<Index> nodes_;                  // of segments, ascending
  BoxTree tree_;
  std::vector<std::vector<Touch>> touches_;  // of each of nodes_: the best of each part
  std::vector<int> rank_;                    // of each part, from 0; -1: it touches none
  HeldDirections supports_;
  std::vector<char> held_;                   // otherwise than by SPCs
  std::vector<std::vector<Index>> follows_;  // of each node what it follows by ties, interpolations, sides of shells
  std::vector<Index> tied_to_;               // of each node the part that this contact has tied it to
  std::vector<char> leads_within_;           // of each node whether others of its part follow it
};

Touching::Touching(const model::Model& model, Index contact, const Surroundings& around, const std::vector<Vec3d>& x,
                   std::vector<Tie>& ties, Findings& findings)
    : model_(model),
      contact_(model.contacts[contact]),
      contact_index_(contact),
      around_(around),
      x_(x),
      ties_(ties),
      findings_(findings),
      parts_at_(model.nodes.size()),
      thickness_(model.nodes.size(), 0.0),
      rank_(model.parts.size(), -1),
      supports_(model),
      held_(model.nodes.size(), 0),
      follows_(model.nodes.size()),
      tied_to_(model.nodes.size(), none),
      leads_within_(model.nodes.size(), 0) {
  gather_segments(Reference(model, x, contact));
  link_nodes();
  find_held();
}

/// Welds and adhesive between sheets take no part, as in sliding contacts.
void Touching::gather_segments(const Reference& reference) {
  for (const ReferenceSegment& s : reference.segments()) {
    const auto in_box = [&](Index n) { return contact_.a.holds(x_[n]); };
    const auto of_weld = [&](Index n) { return around_.of_weld[n] != 0; };
    if (!std::all_of(s.node.begin(), s.node.end(), in_box)) continue;
    if (s.shell == none && std::all_of(s.node.begin(), s.node.end(), of_weld)) continue;
    if (s.shell == none && s.part != none && model::bond_of(model_, model_.parts[s.part])) continue;
    segments_.push_back(s);
    const Corners k = corners(s);
    size_.push_back(std::sqrt(0.5 * norm(cross(k[2] - k[0], k[3] - k[1]))));
  }
}

void Touching::link_nodes() {
  first_.assign(model_.nodes.size() + 1, 0);
  const auto each_corner = [](const ReferenceSegment& s, auto&& visit) {
    for (std::size_t i = 0; i < (s.triangle() ? 3u : 4u); ++i) visit(s.node[i]);
  };
  for (const ReferenceSegment& s : segments_) each_corner(s, [&](Index n) { ++first_[n + 1]; });
  for (std::size_t n = 0; n < model_.nodes.size(); ++n) first_[n + 1] += first_[n];
  at_node_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (std::size_t s = 0; s < segments_.size(); ++s)
    each_corner(segments_[s], [&](Index n) {
      at_node_[next[n]++] = static_cast<Index>(s);
      parts_at_[n].push_back(segments_[s].part);
      thickness_[n] += segments_[s].thickness;
    });
  for (Index n = 0; n < static_cast<Index>(model_.nodes.size()); ++n) {
    const Index count = first_[n + 1] - first_[n];
    if (count == 0) continue;
    nodes_.push_back(n);
    thickness_[n] /= count;
    std::sort(parts_at_[n].begin(), parts_at_[n].end());
    parts_at_[n].erase(std::unique(parts_at_[n].begin(), parts_at_[n].end()), parts_at_[n].end());
  }
  std::vector<Box> boxes(segments_.size());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    Box box;
    for (const Vec3d& corner : corners(segments_[i])) box.add(corner);
    const double beyond_border = (parametric_extension - 1.0) * norm(box.high - box.low);
    boxes[i] = box.grown(0.5 * segments_[i].thickness + close_to(i) + beyond_border);
  }
  tree_ = BoxTree(boxes);
}

double Touching::close_to(std::size_t segment) const {
  return contact_.close > 0.0 ? contact_.close : default_close * size_[segment];
}

Corners Touching::corners(const ReferenceSegment& s) const {
  return {x_[s.node[0]], x_[s.node[1]], x_[s.node[2]], x_[s.node[3]]};
}

/// Without the round-off of weights that are none.
Foot Touching::snapped(Foot foot, bool triangle) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < (triangle ? 3u : 4u); ++i) {
    if (std::abs(foot.weight[i]) < no_weight) foot.weight[i] = 0.0;
    sum += foot.weight[i];
  }
  for (double& w : foot.weight) w /= sum;
  return foot;
}

/// The nodes that a walk along the segments gets to within `walk_share` times `reach`, and all of the node's segments.
std::set<Index> Touching::neighbourhood(Index node, double reach) const {
  std::set<Index> reached;
  using Place = std::pair<double, Index>;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> ahead;
  std::map<Index, double> distance{{node, 0.0}};
  ahead.push({0.0, node});
  while (!ahead.empty()) {
    const auto [walked, from] = ahead.top();
    ahead.pop();
    if (walked > distance[from]) continue;
    reached.insert(from);
    for (Index i = first_[from]; i < first_[from + 1]; ++i)
      for (const Index to : segments_[at_node_[i]].node) {
        const double further = walked + norm(x_[to] - x_[from]);
        if (from == node) reached.insert(to);
        if (further > walk_share * reach) continue;
        const auto known = distance.find(to);
        if (known != distance.end() && known->second <= further) continue;
        distance[to] = further;
        ahead.push({further, to});
      }
  }
  return reached;
}

/// The best touch of each part: the one with the shortest distance, of equal ones the first segment.
std::vector<Touch> Touching::touches(Index node) const {
  std::vector<Touch> found;
  const Vec3d& x = x_[node];
  double farthest_reach = 0.0;
  tree_.overlapping(Box{x, x}.grown(0.5 * thickness_[node]), [&](Index i) {
    const ReferenceSegment& s = segments_[i];
    if (s.has(node)) return;
    const Foot foot = project(corners(s), s.triangle(), x);
    const double touching = 0.5 * (thickness_[node] + s.thickness), reach = touching + close_to(at(i));
    if (!(foot.gap <= reach * (1.0 + equal))) return;
    if (!foot.over && !(std::abs(dot(normal(corners(s)), x - foot.point)) >= over_ridge * foot.gap && foot.gap > 0.0))
      return;
    const double between = foot.gap - touching;
    found.push_back({i, foot, std::abs(between) > equal * reach ? between : 0.0});
    farthest_reach = std::max(farthest_reach, reach);
  });
  if (found.empty()) return found;
  const std::set<Index> own = neighbourhood(node, farthest_reach);
  std::erase_if(found, [&](const Touch& t) {
    const model::Segment& corner = segments_[t.segment].node;
    return std::any_of(corner.begin(), corner.end(), [&](Index n) { return own.contains(n); });
  });
  std::sort(found.begin(), found.end(), [&](const Touch& a, const Touch& b) {
    return std::pair(segments_[a.segment].part, a.segment) < std::pair(segments_[b.segment].part, b.segment);
  });
  std::vector<Touch> best;
  for (const Touch& t : found) {
    const bool first = best.empty() || segments_[best.back().segment].part != segments_[t.segment].part;
    if (first)
      best.push_back(t);
    else if (t.foot.distance < best.back().foot.distance - equal * size_[t.segment])
      best.back() = t;
  }
  for (Touch& t : best) t.foot = snapped(t.foot, segments_[t.segment].triangle());
  return best;
}

/// Each part, but for the first of those that touch each other, after one that it touches; of those that could be next
/// the one with the largest segments.
void Touching::order_parts() {
  std::map<Index, std::set<Index>> touched;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (const Touch& t : touches_[i])
      for (const Index own : parts_at_[nodes_[i]])
        if (const Index other = segments_[t.segment].part; own != none && other != none && own != other) {
          touched[own].insert(other);
          touched[other].insert(own);
        }
  std::vector<double> area(model_.parts.size(), 0.0);
  std::vector<int> count(model_.parts.size(), 0);
  for (std::size_t s = 0; s < segments_.size(); ++s)
    if (const Index part = segments_[s].part; part != none) {
      area[part] += size_[s] * size_[s];
      ++count[part];
    }
  const auto coarsest = [&](const std::set<Index>& parts) {
    Index best = none;
    for (const Index p : parts)
      if (best == none || area[p] / count[p] > (1.0 + equal) * (area[best] / count[best])) best = p;
    return best;
  };
  std::set<Index> open, next;
  for (const auto& [part, others] : touched) open.insert(part);
  for (int rank = 0; !open.empty(); ++rank) {
    const Index part = coarsest(next.empty() ? open : next);
    rank_[part] = rank;
    open.erase(part);
    next.erase(part);
    for (const Index other : touched[part])
      if (open.contains(other)) next.insert(other);
  }
}

int Touching::rank_of(Index node) const {
  int rank = -1;
  for (const Index part : parts_at_[node])
    if (part != none && rank_[part] >= 0 && (rank < 0 || rank_[part] < rank)) rank = rank_[part];
  return rank;
}

/// What else moves nodes, and the nodes that these follow.
void Touching::find_held() {
  for (const model::PrescribedMotion& motion : model_.motions)
    if (motion.target == model::PrescribedMotion::Target::nodes)
      for (const Index n : motion.nodes) held_[n] = 1;
  using Excitation = model::FrequencyResponse::Excitation;
  const auto drive = [&](const Excitation& e) {
    if (e.kind == Excitation::Kind::enforced)
      for (const Index n : e.nodes) held_[n] = 1;
  };
  if (model_.frequency_response)
    for (const model::FrequencyResponse::Case& c : model_.frequency_response->cases) drive(c.excitation);
  if (model_.steady_state)
    for (const model::SteadyState::Case& c : model_.steady_state->cases)
      for (const model::SteadyState::Load& load : c.loads) drive(load.excitation);
  for (const model::RigidWeld& weld : model_.rigid_welds)
    for (const Index n : weld.nodes) held_[n] = 1;
  for (const model::LinearConstraint& equation : model_.linear_constraints)
    for (const model::LinearConstraint::Term& term : equation.terms) held_[term.node] = 1;
  for (const model::Interpolation& i : model_.interpolations) {
    held_[i.node] = 1;
    follows_[i.node] = i.independent;
  }
  for (const model::HangingNode& h : model_.hanging_nodes) {
    held_[h.node] = 1;
    follows_[h.node] = {h.ends[0], h.ends[1]};
  }
  for (const Tie& tie : ties_) {
    held_[tie.node] = 1;
    follows_[tie.node] = carriers(tie);
  }
}

/// Whether one of these nodes follows `node`, through whatever others.
bool Touching::leads_to(const std::vector<Index>& from, Index node) const {
  std::vector<Index> ahead = from;
  std::set<Index> seen(from.begin(), from.end());
  while (!ahead.empty()) {
    const Index n = ahead.back();
    ahead.pop_back();
    if (n == node) return true;
    for (const Index next : follows_[n])
      if (seen.insert(next).second) ahead.push_back(next);
  }
  return false;
}

Tie Touching::made(Index node, const Touch& touch) const {
  const ReferenceSegment& s = segments_[touch.segment];
  Tie tie;
  tie.node = node;
  tie.contact = contact_index_;
  tie.shell = s.shell;
  tie.part = s.part;
  tie.segment = s.node;
  tie.xi = touch.foot.xi;
  tie.eta = touch.foot.eta;
  tie.weight = touch.foot.weight;
  tie.point = touch.foot.point;
  tie.gap = touch.foot.gap;
  tie.own_part = parts_at_[node].front();
  tie.between = touch.between;
  const bool on_shell = s.shell != none && !model_.has_membranes(s.part);
  tie.couples = !on_shell;
  tie.arched = on_shell;
  tie.rotations = around_.rotates[node] != 0;
  const Index body = around_.rigid_body[s.node[0]];
  if (std::all_of(s.node.begin(), s.node.end(), [&](Index n) { return around_.rigid_body[n] == body; }))
    tie.rigid_body = body;
  return tie;
}

bool Touching::try_tie(Index node, const Touch& touch) {
  Tie tie = made(node, touch);
  if (supports_.any(node)) {
    tie.held_alike = tie.rigid_body == none && supports_.hold_alike(tie, x_);
    if (!tie.held_alike) return false;
  }
  const std::vector<Index> nodes = carriers(tie);
  if (leads_to(nodes, node)) return false;
  follows_[node] = nodes;
  tied_to_[node] = tie.part;
  ties_.push_back(tie);
  return true;
}

/// Whether the segment, or some of it, follows a part of the node's: the two are tied there already.
bool Touching::follows_part_of(const Touch& touch, Index node) const {
  const model::Segment& corner = segments_[touch.segment].node;
  return std::any_of(corner.begin(), corner.end(),
                     [&](Index n) { return tied_to_[n] != none && of_own_part(node, tied_to_[n]); });
}

/// What the node is to follow: the earliest part that comes before its own; in the second pass one that comes after, in
/// the third its own.
const Touch* Touching::choice(Index node, Pass pass) const {
  const std::size_t i = static_cast<std::size_t>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
  const int own = rank_of(node);
  const Touch* best = nullptr;
  for (const Touch& t : touches_[i]) {
    const Index part = segments_[t.segment].part;
    if (of_own_part(node, part) != (pass == Pass::within)) continue;
    if (pass == Pass::within || part == none) {
      best = &t;
      continue;
    }
    if ((rank_[part] < own) != (pass == Pass::down) || (pass == Pass::up && follows_part_of(t, node))) continue;
    if (best == nullptr || rank_[part] < rank_[segments_[best->segment].part]) best = &t;
  }
  if (best == nullptr || pass != Pass::within) return best;
  return leads_within_[node] != 0 || follows_part_of(*best, node) ? nullptr : best;
}

void Touching::tie_all(Pass pass) {
  for (const Index node : nodes_) {
    if (!follows_[node].empty() || held_[node]) continue;
    const Touch* touch = choice(node, pass);
    if (touch == nullptr || around_.rigid_body[node] != none) continue;
    if (!try_tie(node, *touch) || pass != Pass::within) continue;
    for (const Index n : follows_[node]) leads_within_[n] = 1;
  }
}

/// How many nodes that should follow are held otherwise, and by what.
std::string Touching::left_alone() const {
  int rigid = 0, supported = 0, otherwise = 0;
  for (const Index n : nodes_) {
    if (tied_to_[n] != none || choice(n, Pass::down) == nullptr) continue;
    if (around_.rigid_body[n] != none)
      ++rigid;
    else if (supports_.any(n))
      ++supported;
    else
      ++otherwise;
  }
  std::string text;
  const auto add = [&](int count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "; left alone: " : ", ", count, what);
  };
  add(rigid, "of rigid bodies");
  add(supported, "held by SPCs that the other part has not");
  add(otherwise, "that another constraint moves");
  return text;
}

void Touching::report() const {
  constexpr std::size_t most = 5;
  const std::string name = name_contact(contact_);
  const std::string close = contact_.close > 0.0 ? fmt::format("CLOSE {:.4g}", contact_.close)
                                                 : fmt::format("CLOSE {:g} of the segments' size", default_close);
  std::string text;
  std::size_t pairs = 0;
  int nodes = 0;
  for (const TouchingParts& pair : touching_parts(model_, ties_, x_)) {
    if (pair.contact != contact_index_) continue;
    nodes += pair.nodes;
    if (++pairs <= most) text += fmt::format("; {}", describe(model_, pair));
  }
  if (pairs > most) text += fmt::format("; {} more pairs of parts stand in the log", pairs - most);
  if (nodes == 0)
    return findings_.warning(
        contact_.place, name, fmt::format("no parts touch ({}): nothing is tied{}", close, left_alone()),
        "give CLOSE above the gap between the surfaces of the sheets, half a thickness off their nodes");
  findings_.note(contact_.place, name,
                 fmt::format("{} node{} tied where parts touch ({}){}{}", nodes, nodes == 1 ? "" : "s", close, text,
                             left_alone()));
}

void Touching::run() {
  if (segments_.empty()) {
    report_empty_side(contact_, true, findings_);
    return;
  }
  touches_.resize(nodes_.size());
  parallel_for(nodes_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) touches_[i] = touches(nodes_[i]);
  });
  order_parts();
  for (const Pass pass : {Pass::down, Pass::up, Pass::within}) tie_all(pass);
  std::sort(ties_.begin(), ties_.end(), [](const Tie& a, const Tie& b) { return a.node < b.node; });
  report();
}

std::string name_part(const model::Model& model, Index part) {
  return part == none ? "a segment" : fmt::format("part {}", model.parts[part].id);
}

}  // namespace

void tie_touching(const model::Model& model, const Surroundings& around, const std::vector<Vec3d>& x,
                  std::vector<Tie>& ties, Findings& findings) {
  for (Index c = 0; c < static_cast<Index>(model.contacts.size()); ++c)
    if (model.contacts[c].ties_what_touches()) Touching(model, c, around, x, ties, findings).run();
}

std::vector<TouchingParts> touching_parts(const model::Model& model, const std::vector<Tie>& ties,
                                          const std::vector<Vec3d>& x) {
  std::map<std::tuple<Index, Index, Index>, TouchingParts> pairs;
  for (const Tie& tie : ties) {
    if (!model.contacts[tie.contact].ties_what_touches()) continue;
    TouchingParts& pair = pairs[{tie.contact, tie.own_part, tie.part}];
    pair.contact = tie.contact;
    pair.part = tie.own_part;
    pair.on = tie.part;
    pair.box.add(x[tie.node]);
    pair.closest = pair.nodes == 0 ? tie.between : std::min(pair.closest, tie.between);
    pair.farthest = pair.nodes == 0 ? tie.between : std::max(pair.farthest, tie.between);
    ++pair.nodes;
  }
  std::vector<TouchingParts> list;
  for (const auto& [key, pair] : pairs) list.push_back(pair);
  return list;
}

std::string describe(const model::Model& model, const TouchingParts& pair) {
  const auto in_words = [](double between) -> std::string {
    if (between == 0.0) return "touching";
    return between < 0.0 ? fmt::format("{:.4g} in each other", -between) : fmt::format("{:.4g} apart", between);
  };
  const Vec3d &low = pair.box.low, &high = pair.box.high;
  const std::string distance = in_words(pair.closest) == in_words(pair.farthest)
                                   ? in_words(pair.closest)
                                   : fmt::format("{} to {}", in_words(pair.closest), in_words(pair.farthest));
  return fmt::format("{} on {}: {} nodes from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}), surfaces {}",
                     name_part(model, pair.part), pair.on == pair.part ? "itself" : name_part(model, pair.on),
                     pair.nodes, low.x, low.y, low.z, high.x, high.y, high.z, distance);
}

}  // namespace nugget::weld
