// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/disc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "base/parallel.hpp"
#include "weld/tie/tie_findings.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

using Integrals = std::array<double, 4>;

constexpr double whole_turn = 2.0 * std::numbers::pi;

/// In the plane z = 0.
double cross_z(const Vec3d& a, const Vec3d& b) {
  return a.x * b.y - a.y * b.x;
}

/// Gauss' points on [0, 1] and their weights.
struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 3> three_points{
    {{0.1127016653792583, 0.2777777777777778}, {0.5, 0.4444444444444444}, {0.8872983346207417, 0.2777777777777778}}};
constexpr std::array<GaussPoint, 8> eight_points{{{0.0198550717512319, 0.0506142681451881},
                                                  {0.1016667612931866, 0.1111905172266872},
                                                  {0.2372337950418355, 0.1568533229389436},
                                                  {0.4082826787521751, 0.1813418916891810},
                                                  {0.5917173212478249, 0.1813418916891810},
                                                  {0.7627662049581645, 0.1568533229389436},
                                                  {0.8983332387068134, 0.1111905172266872},
                                                  {0.9801449282487681, 0.0506142681451881}}};

/// A flat convex segment, counter-clockwise, and the integrals of its shape functions over what a closed line runs
/// around. With (u, v) its parametric coordinates and P_k the antiderivative of N_k det J along u, the integral of N_k
/// over an area is that of P_k dv around it.
class FlatSegment {
 public:
  FlatSegment(const Corners& corner, bool triangle) : corner_(corner), triangle_(triangle) {
    if (triangle) {
      along_u_ = corner[1] - corner[0];
      along_v_ = corner[2] - corner[0];
    } else {
      along_u_ = 0.25 * (corner[1] + corner[2] - corner[0] - corner[3]);
      along_v_ = 0.25 * (corner[2] + corner[3] - corner[0] - corner[1]);
      twisted_ = 0.25 * (corner[0] + corner[2] - corner[1] - corner[3]);
    }
  }

  int corners() const { return triangle_ ? 3 : 4; }
  const Vec3d& corner(int k) const { return corner_[k % corners()]; }
  bool convex() const {
    for (int k = 0; k < corners(); ++k) {
      const Vec3d side = corner(k + 1) - corner(k), next = corner(k + 2) - corner(k + 1);
      if (cross_z(side, next) <= 1e-9 * norm(side) * norm(next)) return false;
    }
    return true;
  }
  bool holds(const Vec3d& x) const {
    for (int k = 0; k < corners(); ++k)
      if (cross_z(corner(k + 1) - corner(k), x - corner(k)) < 0.0) return false;
    return true;
  }

  /// Adds the line integral along side k between two shares of it.
  void add_side(int k, double from, double to, Integrals& sum) const {
    const Place a = place_of_corner(k), b = place_of_corner(k + 1);
    for (const GaussPoint& g : three_points) {
      const double s = from + g.place * (to - from);
      add({a.u + s * (b.u - a.u), a.v + s * (b.v - a.v)}, g.weight * (to - from) * (b.v - a.v), sum);
    }
  }
  /// Adds that along the arc about the origin from one angle to another; halved until halves agree with the whole: a
  /// corner of nearly 180 degrees bends the lines of the map.
  void add_arc(double radius, double from, double to, Integrals& sum, int halvings = 30) const {
    constexpr double longest = 0.125 * whole_turn, round_off = 1e-14;  // of the radius squared
    const double middle = 0.5 * (from + to);
    if (to - from <= longest) {
      Integrals whole{}, halves{};
      add_piece(radius, from, to, whole);
      add_piece(radius, from, middle, halves);
      add_piece(radius, middle, to, halves);
      double apart = 0.0;
      for (std::size_t k = 0; k < 4; ++k) apart = std::max(apart, std::abs(halves[k] - whole[k]));
      if (apart <= round_off * radius * radius || halvings == 0) {
        for (std::size_t k = 0; k < 4; ++k) sum[k] += halves[k];
        return;
      }
    }
    add_arc(radius, from, middle, sum, halvings - 1);
    add_arc(radius, middle, to, sum, halvings - 1);
  }

 private:
  struct Place {
    double u, v;
  };
  Place place_of_corner(int k) const {
    constexpr std::array<Place, 4> of_quad{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    constexpr std::array<Place, 3> of_triangle{{{0, 0}, {1, 0}, {0, 1}}};
    return triangle_ ? of_triangle[k % 3] : of_quad[k % 4];
  }
  /// Of a point in the segment. With h from the middle, the one of the two v with (h - v x_v) x (x_u + v twist) = 0
  /// at which the map does not turn over.
  Place place_of(const Vec3d& x) const {
    if (triangle_) {
      const Vec3d h = x - corner_[0];
      const double j = cross_z(along_u_, along_v_);
      return {cross_z(h, along_v_) / j, cross_z(along_u_, h) / j};
    }
    const Vec3d h = x - 0.25 * (corner_[0] + corner_[1] + corner_[2] + corner_[3]);
    const double a = cross_z(twisted_, along_v_), b = cross_z(along_u_, along_v_) + cross_z(h, twisted_),
                 c = cross_z(h, along_u_), root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
    const double v = b >= 0.0 ? -2.0 * c / (b + root) : (root - b) / (2.0 * a);
    const Vec3d x_u = along_u_ + v * twisted_;
    return {dot(h - v * along_v_, x_u) / dot(x_u, x_u), v};
  }
  void add_piece(double radius, double from, double to, Integrals& sum) const {
    for (const GaussPoint& g : eight_points) {
      const double angle = from + g.place * (to - from);
      const Vec3d x{radius * std::cos(angle), radius * std::sin(angle), 0.0}, dx{-x.y, x.x, 0.0};
      const Place p = place_of(x);
      const Vec3d x_u = along_u_ + p.v * twisted_, x_v = along_v_ + p.u * twisted_;
      add(p, g.weight * (to - from) * cross_z(x_u, dx) / cross_z(x_u, x_v), sum);
    }
  }
  void add(const Place& p, double dv, Integrals& sum) const {
    const double u = p.u, v = p.v;
    const double j0 = cross_z(along_u_, along_v_);
    if (triangle_) {
      sum[0] += j0 * dv * (u - 0.5 * u * u - u * v);
      sum[1] += j0 * dv * 0.5 * u * u;
      sum[2] += j0 * dv * u * v;
      return;
    }
    const double ju = cross_z(along_u_, twisted_), jv = cross_z(twisted_, along_v_);
    for (int k = 0; k < 4; ++k) {
      const Place c = place_of_corner(k);
      const double here = j0 + jv * v;
      const double primitive = here * u + 0.5 * (here * c.u + ju) * u * u + ju * c.u * u * u * u / 3.0;
      sum[k] += 0.25 * (1.0 + v * c.v) * dv * primitive;
    }
  }

  Corners corner_;
  bool triangle_;
  Vec3d along_u_, along_v_, twisted_;
};

/// The part of a side in the disc about the origin, in shares of the side; nothing where it only touches.
std::optional<std::array<double, 2>> share_in_disc(const Vec3d& from, const Vec3d& to, double radius) {
  const Vec3d side = to - from;
  const double a = dot(side, side), b = dot(from, side), c = dot(from, from) - radius * radius;
  const double root = b * b - a * c;
  if (!(root > 0.0)) return std::nullopt;
  const double first = std::max(0.0, (-b - std::sqrt(root)) / a), last = std::min(1.0, (-b + std::sqrt(root)) / a);
  if (!(last > first)) return std::nullopt;
  return std::array{first, last};
}

/// The angles at which the parts of the sides in the disc begin and end on its circle, ascending.
std::vector<double> add_sides(const FlatSegment& segment, double radius, Integrals& sum) {
  constexpr double on_circle = 1e-9;  // of the radius: corners may lie on it
  std::vector<double> angles;
  for (int k = 0; k < segment.corners(); ++k) {
    const Vec3d &from = segment.corner(k), &to = segment.corner(k + 1);
    const auto part = share_in_disc(from, to, radius);
    if (!part) continue;
    segment.add_side(k, (*part)[0], (*part)[1], sum);
    for (const double s : *part) {
      const Vec3d x = from + s * (to - from);
      if (std::abs(norm(x) - radius) < on_circle * radius) angles.push_back(std::atan2(x.y, x.x));
    }
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

Integrals integrals(const FlatSegment& segment, double radius) {
  Integrals sum{};
  std::vector<double> angles = add_sides(segment, radius, sum);
  if (angles.empty()) {  // the circle lies in the segment, around it or beside it
    if (segment.holds({}) && sum == Integrals{}) segment.add_arc(radius, 0.0, whole_turn, sum);
    return sum;
  }
  angles.push_back(angles.front() + whole_turn);
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    const double middle = 0.5 * (angles[i] + angles[i + 1]);
    if (segment.holds({radius * std::cos(middle), radius * std::sin(middle), 0.0}))
      segment.add_arc(radius, angles[i], angles[i + 1], sum);
  }
  return sum;
}

/// A plane with the origin in a place of a sheet.
struct Plane {
  Vec3d origin, e1, e2, normal;

  Plane(const Vec3d& at, const Vec3d& unit_normal) : origin(at), normal(unit_normal) {
    const Vec3d axis = std::abs(normal.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    e1 = unit(cross(axis, normal));
    e2 = cross(normal, e1);
  }
  Vec3d operator()(const Vec3d& x) const { return {dot(x - origin, e1), dot(x - origin, e2), 0.0}; }
};

/// Goes over the shells under a disc.
class Covering {
 public:
  Covering(const model::Model& model, const std::vector<Vec3d>& x, const SheetMesh& mesh, const PlaceOnSheet& place)
      : model_(model), x_(x), mesh_(mesh), start_(place.shell), plane_(place.point, normal_of(place.shell)) {}

  /// The pieces of a disc; empty and `why_not` where a shell is not convex.
  std::vector<Disc::Piece> pieces(double radius, std::string& why_not) const;
  /// The mean of the areas of the shells, by how much of each the pieces cover [length^2].
  double mean_area(const std::vector<Disc::Piece>& pieces) const;

 private:
  Corners corners(Index shell) const {
    const std::array<Index, 4>& n = model_.shells.node[shell];
    return {x_[n[0]], x_[n[1]], x_[n[2]], x_[n[3]]};
  }
  Vec3d normal_of(Index shell) const { return normal(corners(shell)); }
  /// The one shell in which the sheet goes on over a side, or none.
  Index next_over(Index shell, int side) const;

  const model::Model& model_;
  const std::vector<Vec3d>& x_;
  const SheetMesh& mesh_;
  Index start_;
  Plane plane_;
};

Index Covering::next_over(Index shell, int side) const {
  static const double flat = std::cos(30.0 * std::numbers::pi / 180.0);
  Index next = none;
  for (const Index other : mesh_.across_side(shell, side)) {
    if (std::abs(dot(normal_of(other), plane_.normal)) < flat) continue;
    if (next != none) return none;
    next = other;
  }
  return next;
}

std::vector<Disc::Piece> Covering::pieces(double radius, std::string& why_not) const {
  std::vector<Disc::Piece> found;
  std::vector<Index> open{start_};
  std::set<Index> seen{start_};
  while (!open.empty()) {
    const Index shell = open.back();
    open.pop_back();
    const bool triangle = model_.shells.triangle(static_cast<std::size_t>(shell));
    Corners flat = corners(shell);
    for (Vec3d& corner : flat) corner = plane_(corner);
    const std::optional<Integrals> weight = integrals_over_disc(flat, triangle, radius);
    if (!weight) {
      why_not = fmt::format("{} is not convex", name_segment(model_, shell, none));
      return {};
    }
    const Disc::Piece piece{shell, *weight};
    if (piece.sum() > 0.0) found.push_back(piece);
    for (int side = 0; side < 4; ++side) {
      const Vec3d &from = flat[side], &to = flat[(side + 1) % 4];
      if (norm(to - from) == 0.0 || !share_in_disc(from, to, radius)) continue;
      const Index next = next_over(shell, side);
      if (next != none && seen.insert(next).second) open.push_back(next);
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.shell < b.shell; });
  return found;
}

double Covering::mean_area(const std::vector<Disc::Piece>& pieces) const {
  double sum = 0.0, covered = 0.0;
  for (const Disc::Piece& piece : pieces) {
    const Corners k = corners(piece.shell);
    sum += piece.sum() * 0.5 * norm(cross(k[2] - k[0], k[3] - k[1]));
    covered += piece.sum();
  }
  return covered > 0.0 ? sum / covered : 0.0;
}

/// One end of a weld and the ties of its nodes.
struct HangingEnd {
  const Weld* weld = nullptr;
  std::vector<std::size_t> ties;
  Disc disc;
  std::string why_not;
};

Vec3d middle_of(const HangingEnd& end, const std::vector<Tie>& ties) {
  Vec3d middle;
  for (const std::size_t t : end.ties) middle += (1.0 / static_cast<double>(end.ties.size())) * ties[t].point;
  return middle;
}

/// The place on a sheet that is closest to a point, from a shell near it on.
PlaceOnSheet closest_place(const model::Model& model, const std::vector<Vec3d>& x, const SheetMesh& mesh, Index shell,
                           const Vec3d& point) {
  const auto foot_on = [&](Index e) {
    const auto& n = model.shells.node[e];
    return project({x[n[0]], x[n[1]], x[n[2]], x[n[3]]}, n[3] == n[2], point);
  };
  Foot foot = foot_on(shell);
  for (bool closer = true; closer;) {
    closer = false;
    const std::array<Index, 4> nodes = model.shells.node[shell];
    for (const Index node : nodes)
      for (const Index other : mesh.at(node)) {
        const Foot there = foot_on(other);
        if (!(there.distance < foot.distance)) continue;
        foot = there;
        shell = other;
        closer = true;
      }
  }
  return {shell, foot.point};
}

PlaceOnSheet place_of(const model::Model& model, const std::vector<Vec3d>& x, const SheetMesh& mesh,
                      const HangingEnd& end, const std::vector<Tie>& ties) {
  const Tie& first = ties[end.ties[0]];
  if (end.ties.size() == 1) return {first.shell, first.point};
  return closest_place(model, x, mesh, first.shell, middle_of(end, ties));
}

/// Why the ties of an end are no matter for a disc; empty: they are.
std::string obstacle(const HangingEnd& end, const std::vector<Tie>& ties) {
  if (!(end.weld->diameter > 0.0)) return "it has no diameter";
  for (const std::size_t t : end.ties) {
    if (ties[t].shell == none) return "it is tied to no shell";
    if (ties[t].part != ties[end.ties[0]].part) return "its end face lies on two parts";
  }
  return {};
}

bool is_a_nugget(const Weld& weld) {
  return weld.kind == Weld::Kind::beam || weld.of_bricks() || weld.interpolated;
}

/// All ends of the wanted welds with nodes that are tied; a node that two welds share goes with the first.
template <class Wanted>
std::vector<HangingEnd> hanging_ends(const std::vector<Weld>& welds, const std::vector<Tie>& ties,
                                     const Wanted& wanted) {
  std::vector<HangingEnd> ends;
  std::vector<char> taken(ties.size(), 0);
  for (const Weld& weld : welds) {
    if (!wanted(weld)) continue;
    for (const std::vector<Index>& face : weld.face) {
      HangingEnd end{&weld, {}, {}, {}};
      for (const Index node : face) {
        const auto tie =
            std::lower_bound(ties.begin(), ties.end(), node, [](const Tie& t, Index n) { return t.node < n; });
        const auto t = static_cast<std::size_t>(tie - ties.begin());
        if (tie == ties.end() || tie->node != node || std::exchange(taken[t], 1) != 0) continue;
        end.ties.push_back(t);
      }
      if (!end.ties.empty()) ends.push_back(std::move(end));
    }
  }
  return ends;
}

template <class Wanted>
std::vector<HangingEnd> find_discs(const model::Model& model, const std::vector<Weld>& welds,
                                   const std::vector<Vec3d>& x, const std::vector<Tie>& ties, const Wanted& wanted) {
  std::vector<HangingEnd> ends = hanging_ends(welds, ties, wanted);
  const SheetMesh mesh(model, x);
  parallel_for(ends.size(), 16, [&](std::size_t begin, std::size_t last) {
    for (std::size_t e = begin; e < last; ++e) {
      HangingEnd& end = ends[e];
      end.why_not = obstacle(end, ties);
      if (end.why_not.empty())
        end.disc = disc_on_sheet(model, x, mesh, place_of(model, x, mesh, end, ties), end.weld->diameter, end.why_not);
    }
  });
  return ends;
}

/// a_eff / a of an end by its segments, all its nodes taken together.
double hold_by_segments(const HangingEnd& end, const std::vector<Vec3d>& x, const std::vector<Tie>& ties) {
  const Vec3d middle = middle_of(end, ties);
  double sum = 0.0;
  for (const std::size_t t : end.ties)
    sum += std::pow(effective_radius(ties[t].segment, ties[t].weight, x, middle), 2.0);
  return std::sqrt(sum / static_cast<double>(end.ties.size())) / (0.5 * end.weld->diameter);
}

double hold_by_area(const HangingEnd& end, const std::vector<Vec3d>& x, const std::vector<Tie>& ties) {
  return effective_radius(end.disc.nodes, end.disc.weights, x, middle_of(end, ties)) / (0.5 * end.weld->diameter);
}

/// What the ends that are tied by discs come to, for one note and a warning of those on elements that are too large.
struct Account {
  std::size_t ends = 0, cut_off = 0;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;                // a_eff / a
  double least_before = std::numeric_limits<double>::infinity(), most_before = 0.0;  // by the segments
  std::vector<std::pair<double, const Weld*>> coarse;

  void add(const HangingEnd& end, double before, double now) {
    constexpr double whole = 0.999;
    ++ends;
    cut_off += end.disc.covered < whole;
    least = std::min(least, now), most = std::max(most, now);
    least_before = std::min(least_before, before), most_before = std::max(most_before, before);
    if (now > most_hold) coarse.emplace_back(now, end.weld);
  }
};

void report_account(const model::Model& model, Account account, Findings& findings) {
  if (account.ends == 0) return;
  findings.note(
      {model.deck, 0, 0}, by_area(model.control.weld_tie) ? "*NUGGET_WELD_TIE" : "*CONSTRAINED_INTERPOLATION_SPOTWELD",
      fmt::format("{} weld ends are tied to discs of their sheets, {} of them cut off by an edge, a fold or a "
                  "seam; their forces reach {:.2f} to {:.2f} nugget radii far, by the segments {:.2f} to {:.2f}",
                  account.ends, account.cut_off, account.least, account.most, account.least_before,
                  account.most_before));
  if (account.coarse.empty()) return;
  std::stable_sort(account.coarse.begin(), account.coarse.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  const auto& [hold, weld] = account.coarse.front();
  const bool joined = model.control.weld_tie == model::WeldTie::joint;
  findings.warning(
      weld->place, keyword_of(*weld),
      fmt::format("{} weld ends on elements too large for their nuggets, whose forces reach more than {} radii far, "
                  "worst {}: {:.2f}: {}",
                  account.coarse.size(), most_hold, name_weld(*weld), hold,
                  joined ? "beyond what joints were measured for; in peel and cross tension the sheet stays too stiff"
                         : "the sheet is held too stiffly there, most in peel"),
      "refine the sheet to elements no larger than the diameter; docs/manual/weld_place.md has the errors over this "
      "number");
}

}  // namespace

std::optional<std::array<double, 4>> integrals_over_disc(const Corners& corner, bool triangle, double radius) {
  const double sense = triangle ? cross_z(corner[1] - corner[0], corner[2] - corner[0])
                                : cross_z(corner[2] - corner[0], corner[3] - corner[1]);
  Corners turned = corner;
  if (sense < 0.0) std::swap(turned[1], turned[triangle ? 2 : 3]);
  if (triangle) turned[3] = turned[2];
  const FlatSegment segment(turned, triangle);
  if (!segment.convex()) return std::nullopt;
  Integrals sum = integrals(segment, radius);
  if (sense < 0.0) std::swap(sum[1], sum[triangle ? 2 : 3]);
  return sum;
}

Disc disc_on_sheet(const model::Model& model, const std::vector<Vec3d>& x, const SheetMesh& mesh,
                   const PlaceOnSheet& place, double diameter, std::string& why_not) {
  const Covering covering(model, x, mesh, place);
  Disc disc;
  disc.radius = 0.5 * diameter;
  disc.pieces = covering.pieces(disc.radius, why_not);
  const double least = least_disc_over_element * std::sqrt(covering.mean_area(disc.pieces));
  if (least > disc.radius) {
    disc.radius = least;
    disc.pieces = covering.pieces(disc.radius, why_not);
  }
  double area = 0.0;
  for (const Disc::Piece& piece : disc.pieces) area += piece.sum();
  disc.covered = area / (std::numbers::pi * disc.radius * disc.radius);
  constexpr double nothing_to_speak_of = 1e-3;
  if (!(disc.covered > nothing_to_speak_of)) {
    if (why_not.empty()) why_not = "its disc lies beside the sheet";
    return {};
  }
  std::map<Index, double> weights;
  for (Disc::Piece& piece : disc.pieces)
    for (std::size_t k = 0; k < 4; ++k) {
      piece.weight[k] /= area;
      if (piece.weight[k] != 0.0) weights[model.shells.node[piece.shell][k]] += piece.weight[k];
    }
  for (const auto& [node, weight] : weights) {
    disc.nodes.push_back(node);
    disc.weights.push_back(weight);
  }
  return disc;
}

std::vector<double> weights_without(const model::Model& model, const Disc& disc,
                                    const std::function<bool(Index shell)>& absent) {
  constexpr double least_share = 0.5;  // of what the disc covered
  double left = 0.0;
  for (const Disc::Piece& piece : disc.pieces)
    if (!absent(piece.shell)) left += piece.sum();
  if (left < least_share) return {};
  std::vector<double> weights(disc.nodes.size(), 0.0);
  for (const Disc::Piece& piece : disc.pieces) {
    if (absent(piece.shell)) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const Index node = model.shells.node[piece.shell][k];
      const auto place = std::lower_bound(disc.nodes.begin(), disc.nodes.end(), node);
      if (piece.weight[k] != 0.0)
        weights[static_cast<std::size_t>(place - disc.nodes.begin())] += piece.weight[k] / left;
    }
  }
  return weights;
}

double effective_radius(std::span<const Index> nodes, std::span<const double> weights, const std::vector<Vec3d>& x,
                        const Vec3d& point) {
  double sum = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) sum += weights[k] * dot(x[nodes[k]] - point, x[nodes[k]] - point);
  return std::sqrt(2.0 * sum);
}

void hang_on_discs(const model::Model& model, const std::vector<Weld>& welds, const std::vector<Vec3d>& x,
                   std::vector<Tie>& ties, Findings& findings) {
  std::map<std::string, std::vector<const Weld*>> left;
  Account account;
  const bool all = by_area(model.control.weld_tie);
  const auto wanted = [all](const Weld& weld) { return weld.interpolated || (all && is_a_nugget(weld)); };
  for (const HangingEnd& end : find_discs(model, welds, x, ties, wanted)) {
    if (end.disc.empty()) {
      left[end.why_not].push_back(end.weld);
      continue;
    }
    account.add(end, hold_by_segments(end, x, ties), hold_by_area(end, x, ties));
    for (const std::size_t t : end.ties) ties[t].disc = end.disc;
  }
  for (const auto& [why_not, ends] : left)
    findings.warning(ends.front()->place, keyword_of(*ends.front()),
                     fmt::format("{} weld end{} not hung on a disc, first of {}: {}", ends.size(),
                                 ends.size() == 1 ? " is" : "s are", name_weld(*ends.front()), why_not),
                     "tied by the shape functions of its segment instead");
  report_account(model, std::move(account), findings);
}

std::vector<WeldReach> reaches(const model::Model& model, const Ties& ties) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<WeldReach> all(ties.welds.size(), {nothing, nothing});
  for (const HangingEnd& end : find_discs(model, ties.welds, ties.x, ties.ties, is_a_nugget)) {
    if (end.disc.empty()) continue;
    WeldReach& hold = all[static_cast<std::size_t>(end.weld - ties.welds.data())];
    hold.by_segment = std::fmax(hold.by_segment, hold_by_segments(end, ties.x, ties.ties));
    hold.by_area = std::fmax(hold.by_area, hold_by_area(end, ties.x, ties.ties));
  }
  return all;
}

}  // namespace nugget::weld
