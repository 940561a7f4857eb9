// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/adapt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "base/bvh.hpp"
#include "base/index.hpp"
#include "weld/placement/held_nodes.hpp"
#include "weld/tie/segment.hpp"
#include "weld/tie/sheet_mesh.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

constexpr double centred = 0.1;      // a weld so far from the centre, at most, stands over it
constexpr double of_its_size = 0.1;  // an edge so far from the diameter, at most, is that

/// One way to lay a square under a weld and let the patch around it follow.
struct Way {
  double reach = 1.0;     ///< how far the square's centre comes from that of its element towards the weld [1]
  double side = 0.0;      ///< of the square: 0 the diameter, 1 as the element is, between: between
  double scale = 1.0;     ///< on that side
  int rings = 3;          ///< of shells that follow
  double stiffens = 1.0;  ///< power of 1/r by which their springs stiffen towards the weld
};
/// All that is tried, best first: under the weld before near it, its diameter before other sizes, few shells before
/// many.
std::vector<Way> all_ways() {
  constexpr std::array<std::array<double, 2>, 6> sizes{{{0, 1}, {0.25, 1}, {0.5, 1}, {0.75, 1}, {1, 1}, {1, 0.85}}};
  constexpr std::array<std::pair<int, double>, 4> gives{{{3, 1.0}, {4, 1.0}, {6, 1.0}, {4, 2.0}}};
  std::vector<Way> ways;
  for (const double reach : {1.0, 0.75, 0.5})
    for (const auto& [side, scale] : sizes)
      for (const auto& [rings, stiffens] : gives) ways.push_back({reach, side, scale, rings, stiffens});
  return ways;
}
/// How the element that is to be divided is moved and made larger first, best first: under the weld before beside it,
/// with room for good pieces before its own size; last of all it stays as it is.
std::vector<Way> ways_to_divide() {
  std::vector<Way> ways;
  for (const double reach : {1.0, 0.75, 0.5, 0.25, 0.0})
    for (const double side : {0.0, 0.25, 0.5, 0.75, 1.0})
      for (const int rings : {3, 4, 6}) ways.push_back({reach, side, 1.0, rings, 1.0});
  return ways;
}
constexpr double too_large = 1.4;           // diameters: an element that moving nodes does not bring down to one
constexpr double with_room = 2.4;           // diameters: the side of an element whose pieces are good ones
constexpr std::size_t most_candidates = 4;  // elements that are tried for one weld

Corners corners_of(const model::Shells& shells, Index shell, const std::vector<Vec3d>& x) {
  const std::array<Index, 4>& n = shells.node[shell];
  return {x[n[0]], x[n[1]], x[n[2]], x[n[3]]};
}

int corner_count(const model::Shells& shells, Index shell) {
  return shells.triangle(at(shell)) ? 3 : 4;
}

Vec3d centre_of(const Corners& c) {
  return 0.25 * (c[0] + c[1] + c[2] + c[3]);
}

double mean_side(const Corners& c) {
  return 0.25 * (norm(c[1] - c[0]) + norm(c[2] - c[1]) + norm(c[3] - c[2]) + norm(c[0] - c[3]));
}

/// The larger coordinate of a point over a shell: 0 over its centre, 1 over its border. Of a triangle by area
/// coordinates: 0 where all are a third.
double off_centre(const Corners& c, bool triangle, const Vec3d& point) {
  const Foot foot = project(c, triangle, point);
  if (triangle) return 1.0 - 3.0 * std::min({foot.weight[0], foot.weight[1], foot.weight[2]});
  return std::max(std::abs(foot.xi), std::abs(foot.eta));
}

double degrees_between(const Vec3d& a, const Vec3d& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
}

/// The worse of two in each respect.
ShellShape worst(const ShellShape& a, const ShellShape& b) {
  return {std::min(a.jacobian, b.jacobian), std::max(a.aspect, b.aspect), std::max(a.warp, b.warp),
          std::min(a.length, b.length)};
}

/// What a weld stands on with one end.
struct Seat {
  Vec3d point;
  Index shell = none;
};

/// New places of the nodes of a patch.
struct Trial {
  std::vector<Index> shells;  ///< of the patch
  std::map<Index, Vec3d> new_place;
  std::optional<DividedShell> divided;
  std::string wrong;  ///< which limit it breaks; empty: none
};

class Adapting {
 public:
  Adapting(const model::Model& model, const Ties& ties, const std::function<bool(Index)>& can_move,
           const AdaptLimits& limits, const WhyWhole& why_whole)
      : model_(model),
        shells_(model.shells),
        ties_(ties),
        limits_(limits),
        why_whole_(why_whole),
        mesh_(model, model.nodes.x),
        hold_(held_nodes(model, ties, mesh_, can_move)),
        surface_(boxes()),
        out_{model.nodes.x, {}, {}} {}

  Adapted run() {
    collect_ends();
    for (std::size_t i = 0; i < seats_.size(); ++i)
      if (is_good(i)) keep(i, "it stands over the centre of an element of its size");
    for (std::size_t i = 0; i < seats_.size(); ++i)
      if (out_.ends[i].left.empty()) adapt_end(i);
    for (std::size_t i = 0; i < seats_.size(); ++i) measure(i);
    return std::move(out_);
  }

 private:
  std::vector<Box> boxes() const {
    std::vector<Box> boxes(shells_.size());
    for (std::size_t e = 0; e < boxes.size(); ++e)
      for (const Index n : shells_.node[e]) boxes[e].add(model_.nodes.x[n]);
    return boxes;
  }

  // ---- the ends of welds

  void add_end(Index weld, Index part, const Seat& seat, std::string left) {
    AdaptedEnd end;
    end.weld = weld;
    end.part = part;
    end.shell = seat.shell;
    end.diameter = ties_.welds[weld].diameter;
    end.left = std::move(left);
    if (seat.shell != none) {
      const Corners c = corners_of(shells_, seat.shell, model_.nodes.x);
      end.off_before = off_centre(c, shells_.triangle(at(seat.shell)), seat.point);
      end.edge_before = mean_side(c);
    }
    out_.ends.push_back(std::move(end));
    seats_.push_back(seat);
  }

  void collect_ends() {
    for (Index w = 0; at(w) < ties_.welds.size(); ++w) {
      const Weld& weld = ties_.welds[w];
      if (weld.kind == Weld::Kind::rigid) {
        add_end(w, none, {}, "a rigid weld, whose nodes are those of its sheets");
      } else if (weld.of_bricks()) {
        for (int end = 0; end < 2; ++end) add_face(w, end);
      } else {
        for (const Projection& p : weld.ends)
          if (!std::exchange(seen_[p.node], true)) add_projection(w, p);
      }
    }
  }

  void add_projection(Index w, const Projection& p) {
    if (!p.tied || p.projection_case == 0) return add_end(w, none, {}, "it is not tied to a sheet");
    if (p.tie.shell == none) return add_end(w, none, {}, "it is tied to no shell");
    if (ties_.welds[w].diameter <= 0.0) return add_end(w, p.tie.part, {}, "it has no diameter");
    add_end(w, p.tie.part, {p.tie.point, p.tie.shell}, {});
  }

  /// The face of a brick weld: its centre counts.
  void add_face(Index w, int end) {
    const Weld& weld = ties_.welds[w];
    const Index part = weld.sheets[at(end)];
    if (!weld.tied || part == none) return add_end(w, none, {}, "it is not tied to a sheet");
    const Vec3d centre = face_centre(weld, end, ties_.x);
    const Index shell = closest(centre, part);
    if (shell == none) return add_end(w, part, {}, "its sheet has no shells");
    const Foot foot = project(corners_of(shells_, shell, model_.nodes.x), shells_.triangle(at(shell)), centre);
    add_end(w, part, {foot.point, shell}, {});
  }

  Index closest(const Vec3d& x, Index part) const {
    const auto distance = [&](int e) {
      if (shells_.part[e] != part) return Box::infinity;
      return project(corners_of(shells_, e, model_.nodes.x), shells_.triangle(at(e)), x).distance;
    };
    return surface_.nearest(x, Box::infinity, distance).item;
  }

  bool is_good(std::size_t i) const {
    const AdaptedEnd& end = out_.ends[i];
    return end.left.empty() && !shells_.triangle(at(end.shell)) && end.off_before <= centred &&
           std::abs(end.edge_before / end.diameter - 1.0) <= of_its_size;
  }

  /// The nodes of the element under a weld that is done stay.
  void keep(std::size_t i, std::string left) {
    AdaptedEnd& end = out_.ends[i];
    for (const Index n : shells_.node[end.shell])
      if (hold_[n] == Hold::nothing) hold_[n] = Hold::weld;
    end.left = std::move(left);
  }

  // ---- one end

  void adapt_end(std::size_t i) {
    const auto is_whole = [](const Way& way) { return way.reach == 1.0 && way.side == 0.0; };
    std::string why;
    if (move_at(i, why, is_whole)) return;
    if (limits_.divides && out_.ends[i].edge_before > too_large * out_.ends[i].diameter &&
        divide_at(i, out_.ends[i].whole))
      return;
    if (move_at(i, why, [&](const Way& way) { return !is_whole(way); })) return;
    out_.ends[i].left = why.empty() ? "there are only triangles around it" : why;
  }

  /// Lays an element under the weld by one of the ways that `is_tried`.
  template <class IsTried>
  bool move_at(std::size_t i, std::string& why, const IsTried& is_tried) {
    const std::vector<Index> shells = candidates(seats_[i]);
    for (const Way& way : ways_) {
      if (!is_tried(way)) continue;
      for (const Index shell : shells) {
        if (way.reach < 1.0 && shell != shells.front()) continue;
        Trial trial = attempt(i, shell, way);
        if (trial.wrong.empty()) return accept(i, shell, trial), true;
        if (why.empty()) why = std::move(trial.wrong);
      }
    }
    return false;
  }

  /// Divides an element around the foot, moved and made larger first where that helps.
  bool divide_at(std::size_t i, std::string& why) {
    const std::vector<Index> shells = candidates(seats_[i]);
    std::vector<Index> open;
    for (const Index shell : shells) {
      const Foot foot = project(corners_of(shells_, shell, out_.x), false, seats_[i].point);
      if (!foot.over) continue;  // a square under the weld would not lie within it
      std::string against = why_whole_ ? why_whole_(shell) : std::string();
      if (of_divided_.contains(shell)) against = "another weld has divided its element";
      if (against.empty()) open.push_back(shell);
      if (why.empty()) why = std::move(against);
    }
    for (const Way& way : ways_to_divide())
      for (const Index shell : open) {
        Trial trial = attempt_to_divide(i, shell, way);
        if (trial.wrong.empty()) {
          why.clear();
          return accept(i, shell, trial), true;
        }
        if (why.empty()) why = std::move(trial.wrong);
      }
    return false;
  }

  Trial attempt_to_divide(std::size_t i, Index shell, const Way& way) {
    Trial trial;
    const Corners now = corners_of(shells_, shell, out_.x);
    const Vec3d point = centre_of(now) + way.reach * (seats_[i].point - centre_of(now));
    const double size = mean_side(now), diameter = out_.ends[i].diameter, room = std::max(size, with_room * diameter);
    const bool stays = way.reach == 0.0 && way.side == 1.0;
    trial.shells = patch(shell, way.rings);
    const std::map<Index, Vec3d> outer =
        stays ? std::map<Index, Vec3d>{} : square_around(point, shell, room + way.side * (size - room));
    if (!outer.empty()) move_patch(point, shell, outer, way.stiffens, trial);
    exchange(trial);
    DividedShell divided{shell, {}};
    const std::array<Vec3d, 4> square = full_square(seats_[i].point, shell, diameter);
    for (std::size_t k = 0; k < 4; ++k) divided.square[k] = on_sheet(square[k], shells_.part[shell]);
    trial.wrong = broken_limit(trial.shells, &divided, diameter);
    if (trial.wrong.empty()) trial.wrong = broken_by_pieces(divided, diameter);
    exchange(trial);
    trial.divided = divided;
    return trial;
  }

  Corners piece(const DividedShell& divided, std::size_t k) const {
    const Corners outer = corners_of(shells_, divided.shell, out_.x);
    Corners c;
    for (std::size_t i = 0; i < 4; ++i)
      c[i] = pieces[k][i] < 4 ? outer[at(pieces[k][i])] : divided.square[at(pieces[k][i]) - 4];
    return c;
  }

  std::string broken_by_pieces(const DividedShell& divided, double diameter) const {
    const auto broken = [](std::string_view what, double value, double limit) {
      return fmt::format("a piece of its element would have {} {:.3g}, past {:.3g}", what, value, limit);
    };
    const double warp = std::max(limits_.warp, 1.25 * shape_of(shells_, divided.shell, model_.nodes.x).warp);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const ShellShape shape = shape_of(piece(divided, k), false);
      if (shape.jacobian < limits_.jacobian) return broken("a scaled Jacobian of", shape.jacobian, limits_.jacobian);
      if (shape.aspect > limits_.divided_aspect)
        return broken("an aspect ratio of", shape.aspect, limits_.divided_aspect);
      if (shape.warp > warp + 1e-9) return broken("a warp in degrees of", shape.warp, warp);
      if (shape.length < limits_.divided_length * diameter)
        return broken("a length of the time step of", shape.length, limits_.divided_length * diameter);
    }
    return {};
  }

  /// Quadrilaterals around the foot, the closest centre first.
  std::vector<Index> candidates(const Seat& seat) const {
    std::set<std::pair<double, Index>> found;
    const double size = mean_side(corners_of(shells_, seat.shell, model_.nodes.x));
    for (const Index n : shells_.node[seat.shell])
      for (const Index e : mesh_.at(n)) {
        if (shells_.triangle(at(e)) || shells_.part[e] != shells_.part[seat.shell]) continue;
        const double away = norm(centre_of(corners_of(shells_, e, out_.x)) - seat.point) / size;
        if (away <= 1.0) found.emplace(std::round(away * 1e6), e);
      }
    std::vector<Index> all;
    for (const auto& [away, e] : found)
      if (all.size() < most_candidates) all.push_back(e);
    return all;
  }

  Trial attempt(std::size_t i, Index shell, const Way& way) {
    Trial trial;
    const Corners now = corners_of(shells_, shell, out_.x);
    const Vec3d point = centre_of(now) + way.reach * (seats_[i].point - centre_of(now));
    const double size = mean_side(corners_of(shells_, shell, model_.nodes.x)), diameter = out_.ends[i].diameter,
                 side = way.scale * (diameter + way.side * (size - diameter));
    const std::map<Index, Vec3d> square = square_around(point, shell, side);
    if (square.empty()) {
      trial.wrong = "all nodes of its element keep their place: " + name_holds(shell);
      return trial;
    }
    trial.shells = patch(shell, way.rings);
    move_patch(point, shell, square, way.stiffens, trial);
    exchange(trial);
    trial.wrong = broken_limit(trial.shells);
    const double off = off_centre(corners_of(shells_, shell, out_.x), false, seats_[i].point);
    exchange(trial);
    if (trial.wrong.empty() && off > (way.reach < 1.0 ? out_.ends[i].off_before - centred : centred))
      trial.wrong = "no element can be centred under it";
    if (const std::string holds = name_holds(shell); !trial.wrong.empty() && !holds.empty())
      trial.wrong += "; nodes of its element keep their place: " + holds;
    return trial;
  }

  /// Puts the nodes to their new places, or back.
  void exchange(Trial& trial) {
    for (auto& [node, place] : trial.new_place) std::swap(out_.x[node], place);
  }

  std::string name_holds(Index shell) const {
    std::map<Hold, int> count;
    for (const Index n : shells_.node[shell]) ++count[hold_[n]];
    std::string text;
    for (const auto& [hold, n] : count)
      if (hold != Hold::nothing) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, to_string(hold));
    return text;
  }

  /// Corners of a square of `side` around `point`, in the plane of a shell and turned as the shell is.
  std::array<Vec3d, 4> full_square(const Vec3d& point, Index shell, double side) const {
    const Corners c = corners_of(shells_, shell, out_.x);
    const Vec3d n = normal(c), centre = centre_of(c);
    const Vec3d across = c[1] - c[0];
    const Vec3d e1 = unit(across - dot(across, n) * n), e2 = cross(n, e1);
    // The turn that brings the square closest to the corners (a Procrustes problem in the plane).
    double cosine = 0.0, sine = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::array<double, 2> q = unit_square(k);
      const Vec3d d = c[k] - centre;
      cosine += q[0] * dot(d, e1) + q[1] * dot(d, e2);
      sine += q[0] * dot(d, e2) - q[1] * dot(d, e1);
    }
    const double length = std::hypot(cosine, sine);
    const Vec3d u = (0.5 * side / length) * (cosine * e1 + sine * e2), v = cross(n, u);
    std::array<Vec3d, 4> square;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::array<double, 2> q = unit_square(k);
      square[k] = point + q[0] * u + q[1] * v;
    }
    return square;
  }

  /// Where the free corners of a shell go so that its centre is at `point`: to such a square; where corners are held
  /// the others make up for them.
  std::map<Index, Vec3d> square_around(const Vec3d& point, Index shell, double side) const {
    const Corners c = corners_of(shells_, shell, out_.x);
    const std::array<Vec3d, 4> places = full_square(point, shell, side);
    std::map<Index, Vec3d> square;
    Vec3d missing;
    for (std::size_t k = 0; k < 4; ++k) {
      const Index node = shells_.node[shell][k];
      if (hold_[node] == Hold::nothing)
        square[node] = places[k];
      else
        missing += places[k] - c[k];
    }
    for (auto& [node, place] : square) place += (1.0 / static_cast<double>(square.size())) * missing;
    return square;
  }

  static std::array<double, 2> unit_square(std::size_t k) {
    return {k == 1 || k == 2 ? 1.0 : -1.0, k >= 2 ? 1.0 : -1.0};
  }

  /// The shells of the same part within so many rings around a shell, ascending.
  std::vector<Index> patch(Index shell, int rings) const {
    std::set<Index> shells{shell};
    for (int r = 0; r < rings; ++r) {
      const std::set<Index> inner = shells;
      for (const Index e : inner)
        for (const Index n : shells_.node[e])
          for (const Index other : mesh_.at(n))
            if (shells_.part[other] == shells_.part[shell]) shells.insert(other);
    }
    return {shells.begin(), shells.end()};
  }

  bool inside(Index node, const std::vector<Index>& patch) const {
    return std::ranges::all_of(mesh_.at(node),
                               [&](Index e) { return std::binary_search(patch.begin(), patch.end(), e); });
  }

  /// The nodes of a patch, ascending, and the springs between them along the sides of its shells.
  struct Web {
    std::vector<Index> nodes;
    std::vector<std::vector<std::pair<std::size_t, double>>> springs;  ///< of each node: to which one, how stiff

    std::size_t place(Index node) const {
      return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
    }
  };

  Web web(const std::vector<Index>& patch, const Vec3d& point, double nearest, double stiffens) const {
    Web web;
    for (const Index e : patch) web.nodes.insert(web.nodes.end(), shells_.node[e].begin(), shells_.node[e].end());
    std::sort(web.nodes.begin(), web.nodes.end());
    web.nodes.erase(std::unique(web.nodes.begin(), web.nodes.end()), web.nodes.end());
    web.springs.resize(web.nodes.size());
    for (const Index e : patch)
      for (int k = 0; k < corner_count(shells_, e); ++k) {
        const Index n = shells_.node[e][k], m = shells_.node[e][(k + 1) % corner_count(shells_, e)];
        const std::size_t a = web.place(n), b = web.place(m);
        const double r = std::max(norm(0.5 * (out_.x[n] + out_.x[m]) - point), nearest);
        const double stiff = std::pow(nearest / r, stiffens);
        web.springs[a].emplace_back(b, stiff);  // a side between two shells comes twice, at the rim of the sheet once:
        web.springs[b].emplace_back(a, stiff);  // its nodes stay there, so that the factor 2 is everywhere the same
      }
    return web;
  }

  /// Displacements over the patch: given at the square, 0 at nodes that are held and at its rim, and between them such
  /// that springs along the sides of shells are in balance, stiffer towards the weld.
  void move_patch(const Vec3d& point, Index shell, const std::map<Index, Vec3d>& square, double stiffens,
                  Trial& trial) const {
    const double nearest = 0.5 * mean_side(corners_of(shells_, shell, model_.nodes.x));
    const Web web = this->web(trial.shells, point, nearest, stiffens);
    std::vector<Vec3d> u(web.nodes.size());
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const Index node = web.nodes[i];
      if (const auto given = square.find(node); given != square.end())
        u[i] = given->second - out_.x[node];
      else if (hold_[node] == Hold::nothing && inside(node, trial.shells))
        free.push_back(i);
    }
    balance(web, free, u, 1e-9 * nearest);
    for (std::size_t i = 0; i < u.size(); ++i)
      if (norm(u[i]) > 0.0)
        trial.new_place[web.nodes[i]] = on_surface(web.nodes[i], u[i], shells_.part[shell], nearest);
  }

  /// Successive over-relaxation, until nothing moves by more than `enough`.
  static void balance(const Web& web, const std::vector<std::size_t>& free, std::vector<Vec3d>& u, double enough) {
    constexpr double over = 1.6;
    for (double change = 2.0 * enough; change > enough;) {
      change = 0.0;
      for (const std::size_t i : free) {
        Vec3d sum;
        double weight = 0.0;
        for (const auto& [other, k] : web.springs[i]) {
          sum += k * (u[other] - u[i]);
          weight += k;
        }
        const Vec3d step = (over / weight) * sum;
        change = std::max(change, norm(step));
        u[i] += step;
      }
    }
  }

  /// Back onto the surface of the sheet as it is in the model; what does not leave it stays as it is.
  Vec3d on_surface(Index node, const Vec3d& displacement, Index part, double size) const {
    const Vec3d old = out_.x[node], x = old + displacement;
    const Index shell = closest(x, part);
    const Foot foot = project(corners_of(shells_, shell, model_.nodes.x), shells_.triangle(at(shell)), x);
    const Vec3d now = foot.distance <= 1e-9 * size ? x : foot.point;
    const auto or_old = [&](double a, double b) { return std::abs(b - a) <= 1e-9 * size ? a : b; };
    return {or_old(old.x, now.x), or_old(old.y, now.y), or_old(old.z, now.z)};
  }

  /// The closest point of the part's surface as the model has it.
  Vec3d on_sheet(const Vec3d& x, Index part) const {
    const Index shell = closest(x, part);
    const Foot foot = project(corners_of(shells_, shell, model_.nodes.x), shells_.triangle(at(shell)), x);
    return foot.distance <= 1e-9 * mean_side(corners_of(shells_, shell, model_.nodes.x)) ? x : foot.point;
  }

  /// `divided`: the shell that is no longer there, if one is to be; the others may then be as its pieces are.
  std::string broken_limit(const std::vector<Index>& patch, const DividedShell* divided = nullptr,
                           double diameter = 0.0) const {
    const auto broken = [](std::string_view what, double value, double limit) {
      return fmt::format("its patch would have a shell with {} {:.3g}, past {:.3g}", what, value, limit);
    };
    double before_length = Box::infinity, length = Box::infinity;
    for (const Index e : patch) {
      if ((divided != nullptr && e == divided->shell) || of_divided_.contains(e)) continue;
      const ShellShape before = shape_of(shells_, e, model_.nodes.x), now = shape_of(shells_, e, out_.x);
      const double jacobian = std::min(limits_.jacobian, before.jacobian),
                   aspect = std::max(divided != nullptr ? limits_.divided_aspect : limits_.aspect, before.aspect),
                   warp = std::max(limits_.warp, 1.25 * before.warp);
      if (now.jacobian < jacobian - 1e-9) return broken("a scaled Jacobian of", now.jacobian, jacobian);
      if (now.aspect > aspect + 1e-9) return broken("an aspect ratio of", now.aspect, aspect);
      if (now.warp > warp + 1e-9) return broken("a warp in degrees of", now.warp, warp);
      before_length = std::min(before_length, before.length);
      length = std::min(length, now.length);
    }
    double least = limits_.length * before_length;
    if (divided != nullptr) least = std::min(least, limits_.divided_length * diameter);
    if (length < least) return broken("a length of the time step of", length, least);
    return {};
  }

  void accept(std::size_t i, Index shell, const Trial& trial) {
    AdaptedEnd& end = out_.ends[i];
    end.shell = shell;
    patches_[i] = trial.shells;
    for (const auto& [node, place] : trial.new_place) {
      if (norm(place - out_.x[node]) == 0.0) continue;
      end.moved.push_back(node);
      out_.x[node] = place;
    }
    if (trial.divided) {
      of_divided_[shell] = out_.divided.size();
      out_.divided.push_back(*trial.divided);
      end.divided = true;
    }
    keep(i, {});
  }

  /// How it is in the end: a later weld may have moved nodes of this patch too.
  void measure(std::size_t i) {
    AdaptedEnd& end = out_.ends[i];
    if (seats_[i].shell == none) return;
    const Corners c =
        end.divided ? out_.divided[of_divided_.at(end.shell)].square : corners_of(shells_, end.shell, out_.x);
    end.off_after = off_centre(c, shells_.triangle(at(end.shell)), seats_[i].point);
    end.edge_after = mean_side(c);
    for (const Index n : end.moved) end.farthest = std::max(end.farthest, norm(out_.x[n] - model_.nodes.x[n]));
    const auto shells = patches_.find(i);
    if (shells == patches_.end()) return;
    end.before.length = end.after.length = Box::infinity;
    for (const Index e : shells->second) {
      end.before = worst(end.before, shape_of(shells_, e, model_.nodes.x));
      if (const auto found = of_divided_.find(e); found == of_divided_.end())
        end.after = worst(end.after, shape_of(shells_, e, out_.x));
      else
        for (std::size_t k = 0; k < pieces.size(); ++k)
          end.after = worst(end.after, shape_of(piece(out_.divided[found->second], k), false));
    }
  }

  const model::Model& model_;
  const model::Shells& shells_;
  const Ties& ties_;
  AdaptLimits limits_;
  WhyWhole why_whole_;
  SheetMesh mesh_;
  std::vector<Hold> hold_;
  BoxTree surface_;
  std::map<Index, std::size_t> of_divided_;  ///< of a divided shell its place in Adapted::divided
  std::map<Index, bool> seen_;
  std::vector<Way> ways_ = all_ways();
  std::vector<Seat> seats_;                            ///< of each end
  std::map<std::size_t, std::vector<Index>> patches_;  ///< of the ends whose nodes were moved
  Adapted out_;
};

}  // namespace

ShellShape shape_of(const model::Shells& shells, Index shell, const std::vector<Vec3d>& x) {
  return shape_of(corners_of(shells, shell, x), shells.triangle(at(shell)));
}

ShellShape shape_of(const Corners& c, bool is_triangle) {
  const int count = is_triangle ? 3 : 4;
  const Vec3d area = 0.5 * (count == 4 ? cross(c[2] - c[0], c[3] - c[1]) : cross(c[1] - c[0], c[2] - c[0]));
  const double size = norm(area);
  if (size == 0.0) return {0.0, Box::infinity, 180.0, 0.0};
  const Vec3d n = (1.0 / size) * area;
  double shortest = Box::infinity, longest = 0.0, jacobian = 1.0;
  for (int k = 0; k < count; ++k) {
    const Vec3d next = c[(k + 1) % count] - c[k], last = c[(k + count - 1) % count] - c[k];
    shortest = std::min(shortest, norm(next));
    longest = std::max(longest, norm(next));
    jacobian = std::min(jacobian, dot(cross(next, last), n) / (norm(next) * norm(last)));
  }
  if (count == 3) return {2.0 / std::sqrt(3.0) * jacobian, longest / shortest, 0.0, 2.0 * size / longest};
  const auto triangle = [&](std::size_t i, std::size_t j, std::size_t k) { return cross(c[j] - c[i], c[k] - c[i]); };
  const double warp = std::max(degrees_between(triangle(0, 1, 2), triangle(0, 2, 3)),
                               degrees_between(triangle(0, 1, 3), triangle(1, 2, 3)));
  return {jacobian, longest / shortest, warp, size / longest};
}

Adapted adapt(const model::Model& model, const Ties& ties, const std::function<bool(Index node)>& can_move,
              const AdaptLimits& limits, const WhyWhole& why_whole) {
  return Adapting(model, ties, can_move, limits, why_whole).run();
}

}  // namespace nugget::weld
