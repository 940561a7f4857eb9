// SPDX-License-Identifier: Apache-2.0
#include "contact/edge_contact.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/parallel.hpp"
#include "contact/couple.hpp"
#include "kernel/contact/touch_friction.hpp"

namespace nugget::contact {
namespace {

constexpr int edges_per_block = 64;
constexpr double parallel = 1e-5;           // sine below which edges have no common normal of their own
constexpr double beyond_normals = 0.1;      // angle by which a common normal may leave those of the faces
constexpr double flat = 0.05;               // sine of an inward angle between faces that still counts as none
constexpr double ridge = 0.3;               // angle from the middle of the normals beyond which faces form a ridge
constexpr double parallel_to_nodes = 0.05;  // sine below which edges leave all to their nodes
constexpr double straight = 0.85;           // cosine of the angle up to which an edge goes straight on into the next
constexpr double blunt = 0.05;              // half the angle between faces up to which their edge does not stand out
constexpr double sharp = 0.15;              // and from which on it does so fully
constexpr double near_end = 0.06;  // of an edge: nearer to an end than this it meets at the node, see closer(), share()

bool share_a_node(const Edge& a, const Edge& b) {
  return a.has(b.node[0]) || a.has(b.node[1]);
}

std::vector<int> all_nodes(const std::vector<Edge>& edges) {
  std::vector<int> nodes;
  for (const Edge& e : edges) nodes.insert(nodes.end(), e.node.begin(), e.node.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

Vec3d along(const Edge& e, std::span<const Row> x) {
  return vec(x[e.node[1]]) - vec(x[e.node[0]]);
}

Vec3d point_of(const Edge& e, double place, std::span<const Row> rows) {
  return (1.0 - place) * vec(rows[e.node[0]]) + place * vec(rows[e.node[1]]);
}

/// The outward normals at an edge of bricks: their middle, and how far from it either stands. None (zero) where there
/// are not two exposed faces, or these stand at an inward angle.
struct Outward {
  Vec3d middle;
  double half_angle = 0.0;

  Outward(const Edge& e, const Step& step) {
    const Segment* face[2] = {nullptr, nullptr};
    int bare_faces = 0;
    for (const Segment& s : e.faces)
      if (is_exposed(s, step.element_alive) && bare_faces++ < 2) face[bare_faces - 1] = &s;
    if (bare_faces != 2) return;
    Vec3d normal[2], centre[2];
    for (int f = 0; f < 2; ++f) {
      const kernel::Corners c = corners_of(*face[f], step.x);
      normal[f] = kernel::detail::unit_or_zero(cross(c[2] - c[0], c[3] - c[1]));
      const int corners = face[f]->corners();
      for (int i = 0; i < corners; ++i) centre[f] += (1.0 / corners) * c[i];
    }
    const Vec3d to_other = kernel::detail::unit_or_zero(centre[1] - point_of(e, 0.5, step.x));
    if (dot(normal[0], to_other) > flat) return;
    middle = kernel::detail::unit_or_zero(normal[0] + normal[1]);
    half_angle = angle_to(normal[0]);
  }
  double angle_to(const Vec3d& direction) const { return std::acos(std::clamp(dot(middle, direction), -1.0, 1.0)); }
  bool hold(const Vec3d& direction) const { return angle_to(direction) <= half_angle + beyond_normals; }
};

bool is_active(int element, std::span<const unsigned char> alive) {
  return element < 0 || alive.empty() || alive[element] != 0;
}

/// How many of the elements of an edge are active.
std::ptrdiff_t live_elements(const Edge& e, std::span<const unsigned char> alive) {
  return std::count_if(e.elements.begin(), e.elements.end(),
                       [&alive](int element) { return is_active(element, alive); });
}

/// Inverse of the mass that an edge has where it has least, at its lighter node; 0 if both are held.
double inverse_of_lightest(double mass_a, double mass_b) {
  const double lightest = std::min(mass_a > 0.0 ? mass_a : mass_b, mass_b > 0.0 ? mass_b : mass_a);
  return lightest > 0.0 ? 1.0 / lightest : 0.0;
}

/// Whether a place along an edge is one of its ends, but for round-off.
bool at_an_end(double place) {
  return place <= 1e-9 || place >= 1.0 - 1e-9;
}

bool near_an_end(double place) {
  return place <= near_end || place >= 1.0 - near_end;
}

/// The end of an edge to which a place along it is closer.
int end_at(const Edge& edge, double place) {
  return edge.node[place < 0.5 ? 0 : 1];
}

/// Whether of the edges `from_a` and `from_b`, which are closest at `feet`, those that are not `a` or `b` end there.
bool goes_on_at_ends(int from_a, int from_b, const kernel::EdgeFeet& feet, int a, int b) {
  const auto same = [a, b](int edge) { return edge == a || edge == b; };
  return (same(from_a) || at_an_end(feet.s)) && (same(from_b) || at_an_end(feet.t));
}

}  // namespace

std::vector<Edge> edges_of(const std::vector<Segment>& segments, std::span<const Row> x, bool bricks) {
  std::map<std::pair<int, int>, Edge> of_shells, of_bricks;
  for (const Segment& s : segments) {
    const bool brick = s.volume > 0.0;
    if (brick && !bricks) continue;
    for (int c = 0; c < s.corners(); ++c) {
      const int from = s.node[c], to = s.node[(c + 1) % s.corners()];
      Edge& edge = (brick ? of_bricks : of_shells)[std::minmax(from, to)];
      edge.node = {std::min(from, to), std::max(from, to)};
      edge.thickness += s.thickness;
      edge.stiffness += penalty_stiffness(s, x);
      edge.mass += s.mass;
      edge.scale = edge.elements.empty() ? s.scale : edge.scale + s.scale;
      edge.side = edge.elements.empty() ? s.side : edge.side | s.side;
      edge.kind = edge.elements.empty() ? s.kind : std::min(edge.kind, s.kind);
      edge.elements.push_back(s.element);
      edge.of_surface = true;
      if (!brick) {
        const int corners = s.corners();
        edge.beyond.push_back({s.node[(c + 2) % corners], s.node[(c + corners - 1) % corners]});
        continue;
      }
      const double a = area(s, x), depth = a > 0.0 ? pressing_depth * s.volume / a : 0.0;
      edge.depth = edge.faces.empty() ? depth : std::min(edge.depth, depth);
      edge.faces.push_back(s);
    }
  }
  of_shells.merge(of_bricks);  // where a shell lies on a brick its edge counts
  std::vector<Edge> edges;
  for (auto& [nodes, edge] : of_shells) {
    const auto segments_there = static_cast<double>(edge.elements.size());
    edge.thickness /= segments_there;
    edge.stiffness /= segments_there;
    edge.mass /= segments_there;
    edge.scale /= segments_there;
    edges.push_back(std::move(edge));
  }
  return edges;
}

EdgeContact::EdgeContact(EdgeContactSetup setup, std::span<const Row> x)
    : setup_(std::move(setup)), forces_(all_nodes(setup_.edges), setup_.law.friction.any()) {
  const std::vector<Edge>& edges = setup_.edges;
  first_at_.assign(forces_.nodes().empty() ? 1 : forces_.nodes().back() + 2, 0);
  double length = 0.0;
  for (const Edge& e : edges) {
    for (int n : e.node) {
      ++first_at_[n + 1];
      if (e.side == 2) forces_.set_side(n, 1);
    }
    length += norm(along(e, x));
  }
  for (std::size_t n = 1; n < first_at_.size(); ++n) first_at_[n] += first_at_[n - 1];
  edge_at_.resize(first_at_.back());
  std::vector<int> next(first_at_.begin(), first_at_.end() - 1);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (int n : edges[e].node) edge_at_[next[n]++] = static_cast<int>(e);

  margin_ = edges.empty() ? 0.0 : 0.25 * length / static_cast<double>(edges.size());
  const int count = static_cast<int>(edges.size());
  for (int begin = 0; begin < count; begin += edges_per_block)
    blocks_.push_back({begin, std::min(count, begin + edges_per_block), {}, {}});
}

void EdgeContact::apply(const Step& step, std::span<Row> force) {
  forces_.next_cycle();
  std::swap(touches_, touched_before_);
  touches_.clear();
  resultant_ = {};
  deepest_ = 0.0;
  if (!step.off && step.time >= setup_.birth && step.time < setup_.death) {
    approach_.update(step.x);
    if (!searched_ || approach_.since_start() > margin_) search(step.x, step.element_alive);
    parallel_for(blocks_.size(), 4, [this, &step](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) find_close(blocks_[b], step);
    });
    close_.clear();
    for (const Block& block : blocks_)
      for (const Candidate& candidate : block.close) close_.push_back(&candidate);
    parallel_for(close_.size(), 64, [this, &step](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) close_[i]->pair->touching = presses(*close_[i], step.x);
    });
    energies_.springs = 0.0;
    for (const Candidate* candidate : close_)
      if (candidate->pair->touching) press(*candidate, step);
    book_drops(step);
    forces_.add_to(force);
  }
  forces_.book_work(step.dt, step.v);
}

// ---- search

bool EdgeContact::takes_part(int edge, std::span<const unsigned char> alive) const {
  const Edge& e = setup_.edges[edge];
  if (!e.faces.empty())
    return std::count_if(e.faces.begin(), e.faces.end(), [&alive](const Segment& s) { return is_exposed(s, alive); }) ==
           2;
  const auto count = live_elements(e, alive);
  return count == 1 || (setup_.interior && count > 1);
}

bool EdgeContact::face_each_other(int a, int b) const {
  const unsigned e = setup_.edges[a].side, f = setup_.edges[b].side;
  return !setup_.two_sides || ((e & 1u) && (f & 2u)) || ((e & 2u) && (f & 1u));
}

/// Edges that meet, or belong to one element or part.
bool EdgeContact::belong_together(int a, int b) const {
  const Edge &e = setup_.edges[a], &f = setup_.edges[b];
  if (e.part >= 0 && e.part == f.part) return true;
  for (const int n : e.node)
    for (const int other : f.node)
      if (at_one_place(setup_.places, n, other)) return true;
  return share_a_node(e, f) || std::find_first_of(e.elements.begin(), e.elements.end(), f.elements.begin(),
                                                  f.elements.end()) != e.elements.end();
}

kernel::EdgeFeet EdgeContact::feet_of(int a, int b, std::span<const Row> x) const {
  const Edge &e = setup_.edges[a], &f = setup_.edges[b];
  return kernel::closest_points(vec(x[e.node[0]]), vec(x[e.node[1]]), vec(x[f.node[0]]), vec(x[f.node[1]]));
}

void EdgeContact::search(std::span<const Row> x, std::span<const unsigned char> alive) {
  active_.assign(setup_.edges.size(), 0);
  std::vector<int> listed, nodes;
  std::vector<Box> boxes;
  for (std::size_t e = 0; e < setup_.edges.size(); ++e) {
    const Edge& edge = setup_.edges[e];
    if (!finite(x[edge.node[0]]) || !finite(x[edge.node[1]]) || !takes_part(static_cast<int>(e), alive)) continue;
    active_[e] = 1;
    Box box;
    for (int n : edge.node) box.add(vec(x[n]));
    listed.push_back(static_cast<int>(e));
    boxes.push_back(box.grown(0.5 * edge.thickness + edge.depth));
    nodes.insert(nodes.end(), edge.node.begin(), edge.node.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  approach_.start(std::move(nodes), x);
  const BoxTree tree(boxes);
  parallel_for(blocks_.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) list_neighbours(blocks_[b], listed, tree, x);
  });
  searched_ = true;
  ++searches_;
}

void EdgeContact::list_neighbours(Block& block, const std::vector<int>& listed, const BoxTree& tree,
                                  std::span<const Row> x) const {
  const auto by_edges = [](const Pair& p, const Pair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; };
  const std::vector<Pair> old = std::move(block.pairs);
  block.pairs.clear();
  for (int a = block.begin; a < block.end; ++a) {
    if (!active_[a]) continue;
    const Edge& edge = setup_.edges[a];
    Box box;
    for (int n : edge.node) box.add(vec(x[n]));
    const std::size_t start = block.pairs.size();
    tree.overlapping(box.grown(0.5 * edge.thickness + edge.depth + margin_), [&](int item) {
      const int b = listed[item];
      if (b <= a || !face_each_other(a, b) || belong_together(a, b)) return;
      Pair pair;
      pair.a = a;
      pair.b = b;
      pair.feet = feet_of(a, b, x);
      if (pair.feet.distance > contact_distance(a, b) + depth(a, b) + margin_) return;
      // What the pair remembers goes on.
      const auto known = std::lower_bound(old.begin(), old.end(), pair, by_edges);
      block.pairs.push_back(known != old.end() && known->a == a && known->b == b ? *known : pair);
    });
    std::sort(block.pairs.begin() + static_cast<std::ptrdiff_t>(start), block.pairs.end(), by_edges);
  }
  block.close.reserve(block.pairs.size());
}

// ---- every cycle

void EdgeContact::find_close(Block& block, const Step& step) const {
  block.close.clear();
  for (Pair& pair : block.pairs) {
    if (pair.next_check_travel > approach_.travelled()) continue;
    const Pair before = pair;
    pair.touching = false;
    pair.feet = feet_of(pair.a, pair.b, step.x);
    const double gap = pair.feet.distance - contact_distance(pair.a, pair.b);
    pair.next_check_travel = approach_.travelled() + gap;
    if (of_bricks(pair)) {
      pair.direction = out_of_bricks(pair, step);
      // What is inside is close however far it is; asked again in the next cycle.
      if (norm(pair.direction) == 0.0) continue;
      pair.next_check_travel = approach_.travelled();
      block.close.push_back({&pair, before});
    } else if (gap < std::max(0.0, -before.offset)) {
      pair.next_check_travel = std::min(pair.next_check_travel, approach_.travelled());
      block.close.push_back({&pair, before});
    }
  }
}

/// The direction in which the first edge leaves the second, of a pair with an edge of bricks that overlaps; else zero.
Vec3d EdgeContact::out_of_bricks(const Pair& pair, const Step& step) const {
  const double deepest = depth(pair.a, pair.b), span = contact_distance(pair.a, pair.b);
  if (pair.feet.distance > span + deepest) return {};
  const Edge &e = setup_.edges[pair.a], &f = setup_.edges[pair.b];
  const Vec3d p = along(e, step.x), q = along(f, step.x), r = pair.feet.a - pair.feet.b;
  const Vec3d normal = cross(p, q);
  if (norm(normal) <= parallel * norm(p) * norm(q)) return {};
  Vec3d direction = (1.0 / norm(normal)) * normal;
  // Off the common normal the closest point is the end of a line: a node, which meets faces.
  if (norm(r - dot(r, direction) * direction) > 1e-6 * std::min(norm(p), norm(q))) return {};
  const Outward of_e(e, step), of_f(f, step);
  if ((!e.faces.empty() && norm(of_e.middle) == 0.0) || (!f.faces.empty() && norm(of_f.middle) == 0.0)) return {};
  if (dot(direction, of_f.middle - of_e.middle) < 0.0) direction = -direction;
  if ((!e.faces.empty() && !of_e.hold(-direction)) || (!f.faces.empty() && !of_f.hold(direction))) return {};
  return dot(r, direction) < span ? direction : Vec3d{};
}

/// The edge of a sheet that goes on over no other shell.
bool EdgeContact::is_free(int edge, std::span<const unsigned char> alive) const {
  const Edge& e = setup_.edges[edge];
  return e.of_surface && e.faces.empty() && live_elements(e, alive) == 1;
}

/// Widest sine of the angles between the free edges that meet where the pair does, as seen along the direction of the
/// pair (an edge that stands on its end crosses nothing); 0 where there are none of the one or the other.
double EdgeContact::sine_of_free(const Pair& pair, const Step& step) const {
  const auto each = [&](int edge, double place, const auto& visit) {
    if (is_free(edge, step.element_alive)) visit(edge);
    for (const int next : neighbours(edge, place))
      if (next != edge && is_free(next, step.element_alive)) visit(next);
  };
  double widest = 0.0;
  each(pair.a, pair.feet.s, [&](int a) {
    each(pair.b, pair.feet.t, [&](int b) {
      const Vec3d p = along(setup_.edges[a], step.x), q = along(setup_.edges[b], step.x);
      const double size = norm(p) * norm(q);
      if (size > 0.0) widest = std::max(widest, std::abs(dot(cross(p, q), pair.direction)) / size);
    });
  });
  return widest;
}

/// How much the edge of a surface stands out against what lies `toward` it: 1 that of a free edge, or where faces form
/// a ridge; 0 where they lie in one plane, or form a hollow.
double EdgeContact::sharpness(const Edge& edge, const Vec3d& toward, const Step& step) const {
  const auto of_angle = [](double half) { return std::clamp((half - blunt) / (sharp - blunt), 0.0, 1.0); };
  if (!edge.faces.empty()) return of_angle(Outward(edge, step).half_angle);
  Vec3d wing[2];
  int wings = 0;
  const Vec3d from = vec(step.x[edge.node[0]]), e = along(edge, step.x);
  for (std::size_t i = 0; i < edge.elements.size(); ++i) {
    if (!is_active(edge.elements[i], step.element_alive)) continue;
    if (wings == 2) return 1.0;
    const Vec3d to_middle = 0.5 * (vec(step.x[edge.beyond[i][0]]) + vec(step.x[edge.beyond[i][1]])) - from;
    wing[wings++] = kernel::detail::unit_or_zero(to_middle - (dot(to_middle, e) / dot(e, e)) * e);
  }
  if (wings < 2) return 1.0;
  const Vec3d fall = wing[0] + wing[1];  // as long as twice the sine of half the angle of the fold
  if (dot(fall, toward) >= 0.0) return 0.0;
  return of_angle(std::asin(std::min(1.0, 0.5 * norm(fall))));
}

/// The share of its stiffness with which the pair meets; the rest is left to nodes and segments.
double EdgeContact::share(const Pair& pair, const Step& step) const {
  const Edge &e = setup_.edges[pair.a], &f = setup_.edges[pair.b];
  if (!e.of_surface || !f.of_surface) return 1.0;
  const auto ramp = [](double value, double full) { return std::clamp(value / full, 0.0, 1.0); };
  const auto across = [&ramp](double sine) { return ramp(sine - parallel_to_nodes, side_by_side - parallel_to_nodes); };
  const double of_free = across(sine_of_free(pair, step));
  if (of_free >= 1.0) return 1.0;
  const auto is_ridge = [&step](const Edge& edge) {
    return !edge.faces.empty() && Outward(edge, step).half_angle > ridge;
  };
  if (is_ridge(e) && is_ridge(f)) return 1.0;
  const Vec3d p = along(e, step.x), q = along(f, step.x);
  const double size = norm(p) * norm(q), sine = size > 0.0 ? std::abs(dot(cross(p, q), pair.direction)) / size : 0.0;
  const auto from_end = [](double place) { return std::min(place, 1.0 - place); };
  const double at_a = ramp(from_end(pair.feet.s), near_end), at_b = ramp(from_end(pair.feet.t), near_end);
  const double stands_out = std::min(sharpness(e, -pair.direction, step), sharpness(f, pair.direction, step));
  return std::max(of_free, (1.0 - (1.0 - at_a) * (1.0 - at_b)) * across(sine) * stands_out);
}

/// The edges that go on where `place` is near an end of the edge (the edge itself is one of them).
std::span<const int> EdgeContact::neighbours(int edge, double place) const {
  if (!near_an_end(place)) return {};
  const int node = end_at(setup_.edges[edge], place);
  return std::span(edge_at_).subspan(first_at_[node], first_at_[node + 1] - first_at_[node]);
}

/// The pair of edges `a` and `b` if it is close enough to touch.
const EdgeContact::Pair* EdgeContact::close_pair(int a, int b) const {
  if (a > b) std::swap(a, b);
  const auto place = std::lower_bound(close_.begin(), close_.end(), std::pair{a, b},
                                      [](const Candidate* candidate, const std::pair<int, int>& key) {
                                        return std::pair{candidate->pair->a, candidate->pair->b} < key;
                                      });
  return place != close_.end() && (*place)->pair->a == a && (*place)->pair->b == b ? (*place)->pair : nullptr;
}

/// Whether the pair of edges `a` and `b` is closer than `than`; of pairs that are equally close, the first. Where
/// `than` meets near ends but not at them, only if the other does so too: lines that bend away from each other at a
/// node are closest a little before it and a little behind, and meet once.
bool EdgeContact::closer(int a, int b, const Candidate& than) const {
  const Pair& own = *than.pair;
  if (a > b) std::swap(a, b);
  const Pair* const found = close_pair(a, b);
  if (found == nullptr) return false;
  const Pair& other = *found;
  const auto meets_near = [&](int edge, double at) {
    if (edge == own.a || edge == own.b) return true;
    const int node = end_at(setup_.edges[edge], at);
    return near_an_end(at) &&
           (node == end_at(setup_.edges[own.a], own.feet.s) || node == end_at(setup_.edges[own.b], own.feet.t));
  };
  if (!goes_on_at_ends(own.a, own.b, own.feet, a, b) && !(meets_near(a, other.feet.s) && meets_near(b, other.feet.t)))
    return false;
  if (other.feet.distance != own.feet.distance) return other.feet.distance < own.feet.distance;
  return std::pair{a, b} < std::pair{own.a, own.b};
}

/// Edges of surfaces that lie side by side, one going straight on where the other ends, meet once: where lines that
/// cross at a small angle bend, they have several places where they are closest.
bool EdgeContact::another_stretch_is_closer(const Pair& pair, std::span<const Row> x) const {
  const auto straight_on = [&](int edge, std::array<int, 9>& line) {
    const Edge& e = setup_.edges[edge];
    std::size_t count = 0;
    line[count++] = edge;
    for (const int end : {0, 1}) {
      const Vec3d out = (end == 0 ? -1.0 : 1.0) * along(e, x);
      for (int i = first_at_[e.node[end]]; i < first_at_[e.node[end] + 1] && count < line.size(); ++i) {
        const int next = edge_at_[i];
        if (next == edge || !active_[next]) continue;
        const Edge& f = setup_.edges[next];
        const Vec3d on = (f.node[0] == e.node[end] ? 1.0 : -1.0) * along(f, x);
        if (dot(out, on) > straight * norm(out) * norm(on)) line[count++] = next;
      }
    }
    return count;
  };
  const Edge &e = setup_.edges[pair.a], &f = setup_.edges[pair.b];
  if (!e.of_surface || !f.of_surface || of_bricks(pair)) return false;
  std::array<int, 9> line_a{}, line_b{};
  const std::size_t of_a = straight_on(pair.a, line_a), of_b = straight_on(pair.b, line_b);
  for (std::size_t i = 0; i < of_a; ++i)
    for (std::size_t j = 0; j < of_b; ++j) {
      if (i == 0 && j == 0) continue;
      const Pair* const other = close_pair(line_a[i], line_b[j]);
      if (other == nullptr) continue;
      const double distance = other->feet.distance;
      if (distance < pair.feet.distance) return true;
      if (distance == pair.feet.distance && std::pair{other->a, other->b} < std::pair{pair.a, pair.b}) return true;
    }
  return false;
}

/// Whether the distance of the pair is a local minimum along the lines that the edges are part of.
bool EdgeContact::presses(const Candidate& candidate, std::span<const Row> x) const {
  const Pair& pair = *candidate.pair;
  if (another_stretch_is_closer(pair, x)) return false;
  const std::span<const int> beside_a = neighbours(pair.a, pair.feet.s), beside_b = neighbours(pair.b, pair.feet.t);
  const auto better = [&](int a, int b) {
    if (a == b || belong_together(a, b)) return goes_on_at_ends(pair.a, pair.b, pair.feet, a, b);
    return closer(a, b, candidate);
  };
  for (int a : beside_a) {
    if (a == pair.a || !active_[a]) continue;
    if (better(a, pair.b)) return false;
    for (int b : beside_b)
      if (b != pair.b && active_[b] && better(a, b)) return false;
  }
  return std::none_of(beside_b.begin(), beside_b.end(),
                      [&](int b) { return b != pair.b && active_[b] && better(pair.a, b); });
}

/// The pair that touched in the cycle before, this one or the one from which it slid here, with its edges in the order
/// of this one; not touching if there was none. What a pair had goes to one other pair, and to none while it goes on.
EdgeContact::Pair EdgeContact::predecessor(const Candidate& candidate) {
  if (candidate.before.touching) return candidate.before;
  const auto goes_on = [this](int a, int b) { return a == b || share_a_node(setup_.edges[a], setup_.edges[b]); };
  const int a = candidate.pair->a, b = candidate.pair->b;
  for (Pair& other : touched_before_) {
    if (!other.touching) continue;
    if (const Pair* const now = close_pair(other.a, other.b); now != nullptr && now->touching) continue;
    const bool same_order = goes_on(a, other.a) && goes_on(b, other.b);
    if (!same_order && !(goes_on(a, other.b) && goes_on(b, other.a))) continue;
    Pair turned = other;
    other.touching = false;
    if (same_order) return turned;
    std::swap(turned.a, turned.b);
    std::swap(turned.feet.a, turned.feet.b);
    std::swap(turned.feet.s, turned.feet.t);
    turned.direction = -other.direction;
    turned.friction = -other.friction;
    return turned;
  }
  return {};
}

/// In which the first edge is pressed away from the second; zero if the two meet in a point and have no normal.
Vec3d EdgeContact::direction(const Pair& pair, const Pair& before, const Vec3d& was_at, std::span<const Row> x) const {
  const Vec3d e = along(setup_.edges[pair.a], x), f = along(setup_.edges[pair.b], x);
  Vec3d normal = cross(e, f);
  if (at_an_end(pair.feet.s) || at_an_end(pair.feet.t) || norm(normal) <= parallel * norm(e) * norm(f))
    normal = pair.feet.a - pair.feet.b;
  const double length = norm(normal);
  if (!(length > 0.0)) return before.direction;
  const double side = dot(before.touching ? before.direction : was_at, normal) < 0.0 ? -1.0 : 1.0;
  return (side / length) * normal;
}

/// Friction on the first edge; see SurfaceContact. The slip is the way of the closest point over the second edge less
/// that over the first.
Vec3d EdgeContact::friction(const kernel::Friction& law, const Pair& pair, const Pair& before, double stiffness,
                            double normal_force, const Step& step) const {
  // Two crossing bars touch in a patch as wide as both.
  const double area = setup_.edges[pair.a].thickness * setup_.edges[pair.b].thickness;
  if (!before.touching) {
    const Vec3d velocity =
        point_of(setup_.edges[pair.a], pair.feet.s, step.v) - point_of(setup_.edges[pair.b], pair.feet.t, step.v);
    return kernel::touch_friction(law, {velocity, pair.direction, pair.depth, stiffness, normal_force, area});
  }
  const Vec3d over_a = pair.feet.a - point_of(setup_.edges[before.a], before.feet.s, step.x);
  const Vec3d over_b = pair.feet.b - point_of(setup_.edges[before.b], before.feet.t, step.x);
  const auto tangential = [&pair](const Vec3d& a) { return a - dot(a, pair.direction) * pair.direction; };
  const Vec3d slip = tangential(over_b - over_a);
  const double speed = step.dt > 0.0 ? norm(slip) / step.dt : 0.0;
  const double bound = law.bound(normal_force, speed, area);
  return kernel::sliding_spring(tangential(before.friction), stiffness, slip, bound);
}

double EdgeContact::penalty(const Edge& e, const Edge& f, const Step& step) const {
  if (setup_.law.stiffness != kernel::PenaltyStiffness::segment_masses)
    return setup_.stiffness_scale * std::min(e.stiffness, f.stiffness);
  return setup_.stiffness_scale * std::min(e.scale, f.scale) *
         kernel::segment_penalty(e.mass > 0.0 ? e.mass : f.mass, f.mass > 0.0 ? f.mass : e.mass,
                                 setup_.law.step(step.longest));
}

void EdgeContact::press(const Candidate& candidate, const Step& step) {
  Pair& pair = *candidate.pair;
  const Edge &e = setup_.edges[pair.a], &f = setup_.edges[pair.b];
  const double s = pair.feet.s, t = pair.feet.t;
  const Vec3d r = pair.feet.a - pair.feet.b;
  const Vec3d velocity = point_of(e, s, step.v) - point_of(f, t, step.v);
  const Pair before = predecessor(candidate);
  if (!of_bricks(pair)) pair.direction = direction(pair, before, r - step.dt * velocity, step.x);
  const double overlap = contact_distance(pair.a, pair.b) - dot(r, pair.direction);
  // What the motion of this step cannot have made was there before, or comes from an edge newly exposed or from a foot
  // or a direction that is another one.
  const double approach = -dot(velocity, pair.direction);
  const double explained = before.depth + step.dt * (before.touching ? norm(velocity) : std::max(0.0, approach));
  const double offset = std::max(before.offset, overlap - explained);
  pair.share = before.touching ? std::max(before.share, share(pair, step)) : share(pair, step);
  if (pair.share == 0.0) {
    pair.touching = false;
    return;
  }
  pair.touching = true;
  pair.offset = std::min(offset, overlap);
  pair.depth = overlap - pair.offset;
  pair.friction = {};
  pair.force = {};

  const std::array<double, 4> weight{1.0 - s, s, 1.0 - t, t};
  const std::array<double, 4> node_mass{step.mass[e.node[0]], step.mass[e.node[1]], step.mass[f.node[0]],
                                        step.mass[f.node[1]]};
  const double inverse_mass = kernel::inverse_pair_mass(0.0, weight, node_mass);
  const double greatest =
      inverse_of_lightest(node_mass[0], node_mass[1]) + inverse_of_lightest(node_mass[2], node_mass[3]);
  const double stiffness =
      pair.share * kernel::pair_stiffness(setup_.law, penalty(e, f, step), greatest, step.stable_dt);
  pair.memory = before.memory;
  if (const double depth = kernel::depth_of_same_energy(pair.memory, pair.depth, stiffness); depth != pair.depth) {
    pair.depth = depth;
    pair.offset = overlap - depth;
  }
  const double inverse_own_mass =
      kernel::inverse_pair_mass(0.0, {weight[0], weight[1], 0.0, 0.0}, {node_mass[0], node_mass[1], 0.0, 0.0});
  const double size = kernel::pair_force(setup_.law, pair.memory, stiffness, inverse_mass, inverse_own_mass, pair.depth,
                                         approach, step.dt);
  energies_.springs += pair.held();
  energies_.damping += 0.5 * (before.memory.damping() + pair.memory.damping()) * approach * step.dt;
  if (size > 0.0) {
    if (const kernel::Friction& law = setup_.law.friction.between(e.kind, f.kind); law.any())
      pair.friction = friction(law, pair, before, stiffness, size, step);
    pair.force = size * pair.direction + pair.friction;
    for (int end = 0; end < 2; ++end) {
      add(e.node[end], weight[end] * pair.force, weight[end] * pair.friction);
      add(f.node[end], -weight[2 + end] * pair.force, -weight[2 + end] * pair.friction);
    }
    if (setup_.law.balances_friction) balance(pair, step);
    if (setup_.two_sides) resultant_ += (e.side & 1u) ? pair.force : -pair.force;
    deepest_ = std::max(deepest_, pair.depth);
  }
  touches_.push_back(pair);
}

/// As SurfaceContact::book_drop(), of the pairs that touched in the cycle before and have no successor.
void EdgeContact::book_drops(const Step& step) {
  for (const Pair& pair : touched_before_) {
    if (!pair.touching || !(pair.held() > 0.0)) continue;
    if (!active_[pair.a] || !active_[pair.b]) {
      energies_.deleted += pair.held();
      continue;
    }
    if (const Pair* const now = close_pair(pair.a, pair.b); now != nullptr && now->touching) continue;
    const Edge &e = setup_.edges[pair.a], &f = setup_.edges[pair.b];
    const Vec3d velocity = point_of(e, pair.feet.s, step.v) - point_of(f, pair.feet.t, step.v);
    if (pair.depth > step.dt * norm(velocity)) energies_.drops.add(pair.held(), e.node[0], f.node[0], step.time);
  }
}

/// Friction acts on the axes of both bars, which lie beside each other. Of that couple each bar takes what friction
/// along itself makes, about an axis across it. Bars side by side have none for friction across them: that would be
/// torsion.
void EdgeContact::balance(const Pair& pair, const Step& step) {
  const Edge &e = setup_.edges[pair.a], &f = setup_.edges[pair.b];
  const Vec3d p = along(e, step.x), q = along(f, step.x), n = cross(p, q);
  const Vec3d lever = pair.feet.a - pair.feet.b;
  Vec3d along_p = pair.friction, along_q;  // shares of the friction
  if (norm(n) > parallel * norm(p) * norm(q)) {
    along_p = (dot(cross(pair.friction, q), n) / dot(n, n)) * p;
    along_q = pair.friction - along_p;
  }
  const std::array<Vec3d, 4> on_e = couple(e.node, -cross(lever, along_p), step.x),
                             on_f = couple(f.node, -cross(lever, along_q), step.x);
  for (std::size_t end = 0; end < 2; ++end) {
    add(e.node[end], on_e[end], on_e[end]);
    add(f.node[end], on_f[end], on_f[end]);
  }
}

void EdgeContact::add(int node, const Vec3d& force, const Vec3d& friction) {
  forces_.add(node, force, friction);
}

Vec3d EdgeContact::force_between(const TwoBodies& bodies) const {
  Vec3d sum;
  for (const Pair& pair : touches_)
    sum += bodies.sign(setup_.edges[pair.a].node, setup_.edges[pair.b].node) * pair.force;
  return sum;
}

void EdgeContact::Block::archive(Archive& a) {
  a(pairs);
  a.built(begin, end, close);
}

void EdgeContact::archive(Archive& a) {
  a.section("contact of edges");
  a(approach_, searched_, searches_, active_, blocks_, touches_, touched_before_, forces_, resultant_, deepest_,
    energies_);
  a.built(setup_, first_at_, edge_at_, margin_, close_);
}

}  // namespace nugget::contact
