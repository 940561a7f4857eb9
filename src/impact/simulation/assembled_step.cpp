// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/assembled_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "model/bond.hpp"

namespace nugget::impact {
namespace {

/// One-point and fully integrated bricks and wedges, whose step is that of a plane wave. Adhesive has a bound of its
/// own.
bool steps_like_a_plane_wave(const system::System& system, const system::ElementGroup& group) {
  return group.kind == model::ElementKind::solid && (group.nodes_per_element == 8 || group.nodes_per_element == 6) &&
         !model::bond_of(system.model, system.model.parts[group.part]);
}

template <class Visit>
void each_node(const system::ElementGroup& group, std::size_t e, const Visit& visit) {
  const system::ElementNodes node = group.nodes(e);
  for (int a = 0; a < group.nodes_per_element; ++a)
    if (node[a] >= 0) visit(node[a]);
}

/// Which shells can vibrate faster than the formula of their step knows. Inside a sheet and at its edges none does;
/// alone or beside a single neighbour one that swells and shrinks does, and thick ones do with nodes off the
/// mid-surface or as triangles. The formula of ISDO 2 goes by the shortest side of slanted ones, too.
class DoubtfulShells {
 public:
  DoubtfulShells(const system::System& system, std::span<const Row> x)
      : model_(system.model), x_(x), angle_(system.all_nodes(), 0.0) {
    for (const auto& group : system.groups) {
      if (group->kind != model::ElementKind::shell) continue;
      for (std::size_t e = 0; e < group->size(); ++e) {
        const Shape s = shape(*group, e);
        for (int a = 0; a < s.corners; ++a) angle_[s.node[a]] += s.angle[a];
      }
    }
  }

  bool free(const system::ElementGroup& group, std::size_t e) const {
    const Shape s = shape(group, e);
    bool all = true;
    for (int a = 0; a < s.corners; ++a) all = all && angle_[s.node[a]] < hardly_surrounded;
    return all;
  }
  bool slanted_or_thick(const system::ElementGroup& group, std::size_t e) const {
    const Shape s = shape(group, e);
    const double longest = *std::max_element(s.side.begin(), s.side.begin() + s.corners),
                 shortest = *std::min_element(s.side.begin(), s.side.begin() + s.corners);
    if (model_.control.length_basis == 2 && shortest * longest > 1.001 * (s.corners == 3 ? 2.0 : 1.0) * s.area)
      return true;
    const bool off = model_.shells.offset(group.element[e]) != 0.0;
    return (off || s.corners == 3) && model_.shells.thickness[group.element[e]] > thick * std::sqrt(s.area);
  }

 private:
  struct Shape {
    int corners;
    system::ElementNodes node;
    std::array<double, 4> side{}, angle{};
    double area;
  };
  Shape shape(const system::ElementGroup& group, std::size_t e) const {
    Shape s{group.nodes_per_element, group.nodes(e), {}, {}, 0.0};
    const auto place = [&](int a) { return vec(x_[s.node[a % s.corners]]); };
    for (int a = 0; a < s.corners; ++a) {
      const Vec3d next = place(a + 1) - place(a), last = place(a + s.corners - 1) - place(a);
      s.side[a] = norm(next);
      s.angle[a] = std::atan2(norm(cross(next, last)), dot(next, last));
    }
    s.area = 0.5 * norm(s.corners == 3 ? cross(place(1) - place(0), place(2) - place(0))
                                       : cross(place(2) - place(0), place(3) - place(1)));
    return s;
  }

  // Of angles at a node [rad]: in the middle of a sheet a whole turn, at its edge a half. Closed boxes of six count.
  static constexpr double hardly_surrounded = 0.76 * 2.0 * std::numbers::pi;
  static constexpr double thick = 0.3;  ///< of the root of the area
  const model::Model& model_;
  std::span<const Row> x_;
  std::vector<double> angle_;  ///< of the shells around each node
};

/// Between -1 and 1, without a symmetry that the fastest vibration could lack (the mixing of splitmix64).
double scattered(std::uint64_t i) {
  i = (i + 1) * 0x9e3779b97f4a7c15u;
  i = (i ^ (i >> 30)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
  return 0x1p-52 * static_cast<double>((i ^ (i >> 31)) >> 11) - 1.0;
}

constexpr std::size_t least_iterations = 24, most_iterations = 200, looked_back = 8;
constexpr double settled = 2e-4, roughly_settled = 0.05;  // change of the eigenvalue in so many iterations

}  // namespace

/// A symmetric matrix of three diagonals.
struct Tridiagonal {
  std::vector<double> diagonal, beside;  ///< beside[i] between i and i + 1

  /// The largest eigenvalue, by bisection (signs of Sturm's sequence).
  double largest() const {
    double low = diagonal[0], high = 0.0;
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      const double left = i > 0 ? beside[i - 1] : 0.0, right = i + 1 < diagonal.size() ? beside[i] : 0.0;
      low = std::max(low, diagonal[i]);
      high = std::max(high, diagonal[i] + left + right);
    }
    for (int k = 0; k < 60 && high - low > 1e-12 * high; ++k) {
      const double middle = 0.5 * (low + high);
      (exceeds(middle) ? low : high) = middle;
    }
    return high;
  }

  /// Its eigenvector, by powers of the matrix.
  std::vector<double> vector_of_largest() const {
    std::vector<double> s(diagonal.size(), 1.0), next(s.size());
    for (int k = 0; k < 2000; ++k) {
      double most = 0.0;
      for (std::size_t i = 0; i < s.size(); ++i) {
        next[i] = diagonal[i] * s[i];
        if (i > 0) next[i] += beside[i - 1] * s[i - 1];
        if (i + 1 < s.size()) next[i] += beside[i] * s[i + 1];
        most = std::max(most, std::abs(next[i]));
      }
      for (std::size_t i = 0; i < s.size(); ++i) s[i] = next[i] / most;
    }
    return s;
  }

 private:
  bool exceeds(double x) const {
    double d = 1.0;
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      d = diagonal[i] - x - (i > 0 ? beside[i - 1] * beside[i - 1] / d : 0.0);
      if (d > 0.0) return true;
      if (d == 0.0) d = -1e-300;
    }
    return false;
  }
};

/// The vectors of an iteration, and what acts on them.
class AssembledStep::Vibration {
 public:
  Vibration(const AssembledStep& step, const system::State& state)
      : step_(step),
        system_(step.system_),
        state_(state),
        map_(step.system_.map),
        v_(state.v.size()),
        w_(v_.size()),
        f_(v_.size()),
        m_(v_.size()),
        now_(step.independent_.size()),
        before_(now_.size()),
        slots_(step.rows_) {
    map_.follow_all();  // over several ranks each looks at all
  }

  /// The largest eigenvalue of M^-1 (dt^2 K + 2 dt C); 0 where nothing can move.
  double largest(double dt) {
    found_ = {};
    begin();
    for (std::size_t k = 0; k < most_iterations && advance(dt); ++k) {
      values_.push_back(found_.largest());
      // Far from 4 less will do: what could still bring it there would have shown.
      const bool far = values_.back() < 1.0;
      if (values_.size() > (far ? looked_back : least_iterations) &&
          values_.back() - values_[values_.size() - 1 - looked_back] <=
              (far ? roughly_settled : settled) * values_.back())
        break;
    }
    values_.clear();
    // Where few elements have nothing left to look at, the last step is one that was not asked above.
    return found_.diagonal.empty() ? 0.0 : found_.largest();
  }

  /// After `largest`: the chosen element with most of the energy of that vibration, as index in blocks_ and lane.
  std::pair<std::size_t, std::size_t> most_strained(double dt) {
    const Tridiagonal all = found_;
    const std::vector<double> share = all.vector_of_largest();
    std::vector<Load> sum(now_.size());
    found_ = {};
    begin();
    for (const double s : share) {
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i].force += s * now_[i].force;
        sum[i].moment += s * now_[i].moment;
      }
      if (!advance(dt)) break;
    }
    now_ = sum;
    move();
    find_forces(dt);
    std::pair<std::size_t, std::size_t> place{0, 0};
    double most = 0.0;
    for (std::size_t i = 0; i < step_.blocks_.size(); ++i) {
      const Block& b = step_.blocks_[i];
      const system::ElementGroup& group = *system_.groups[b.group];
      const std::size_t first = b.block * group.block_width(),
                        last = std::min(group.size(), first + group.block_width());
      for (std::size_t e = first; e < last; ++e) {
        const system::ElementNodes node = group.nodes(e);
        double power = 0.0;
        for (int a = 0; a < group.nodes_per_element; ++a) {
          const Row* slot = &slots_[b.first_row + group.row_in_block(e, at(a))];
          power += dot(vec(slot[0]), vec(v_[node[a]]));
          if (group.rotational) power += dot(vec(slot[1]), vec(w_[node[a]]));
        }
        if (power <= most) continue;
        most = power;
        place = {i, e};
      }
    }
    return place;
  }

 private:
  struct Load {
    Vec3d force, moment;
  };

  /// Velocities that belong to the momenta `now_`: M^-1 on what is free.
  void move() {
    const std::vector<int>& nodes = step_.independent_;
    parallel_for(nodes.size(), 1024, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const auto k = at(nodes[i]);
        Vec3d v, w;
        if (k < system_.nodes) {
          if (system_.mass[k] > 0.0) v = (1.0 / system_.mass[k]) * now_[i].force;
          if (system_.inertia[k] > 0.0) w = (1.0 / system_.inertia[k]) * now_[i].moment;
        } else if (const system::RigidBody& body = system_.bodies[k - system_.nodes]; body.mass > 0.0) {
          v = (1.0 / body.mass) * now_[i].force;
          const Frame3d& held = body.fixed_axes;
          for (const auto& [bit, axis] : {std::pair{1u, held.e1}, std::pair{2u, held.e2}, std::pair{4u, held.e3}})
            if (body.fixed & bit) v -= dot(v, axis) * axis;
          w = body.constrained_spin(now_[i].moment, body.axes);
        }
        set(v_[k], v);
        set(w_[k], w);
      }
    });
    step_.supports_.hold_for_good(v_, w_);
  }

  double power() const {
    return ordered_sum(now_.size(), [&](std::size_t i) {
      const int k = step_.independent_[i];
      return dot(now_[i].force, vec(v_[k])) + dot(now_[i].moment, vec(w_[k]));
    });
  }

  /// A random momentum of norm 1.
  void begin() {
    beside_ = 0.0;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      const auto k = at(step_.independent_[i]);
      double mass = 0.0, inertia = 0.0;
      if (k < system_.nodes) {
        mass = system_.mass[k];
        inertia = system_.inertia[k];
      } else {
        const system::RigidBody& body = system_.bodies[k - system_.nodes];
        mass = body.mass;
        inertia = (body.inertia[0] + body.inertia[3] + body.inertia[5]) / 3.0;
      }
      const auto any = [&](std::uint64_t first) {
        return Vec3d{scattered(6 * k + first), scattered(6 * k + first + 1), scattered(6 * k + first + 2)};
      };
      now_[i] = {std::sqrt(mass) * any(0), std::sqrt(inertia) * any(3)};
      before_[i] = {};
    }
    move();
    scale(power());
  }

  /// Divides momenta and velocities by the root of `square`.
  void scale(double square) {
    const double factor = square > 0.0 ? 1.0 / std::sqrt(square) : 0.0;
    parallel_for(now_.size(), 1024, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const int k = step_.independent_[i];
        now_[i] = {factor * now_[i].force, factor * now_[i].moment};
        set(v_[k], factor * vec(v_[k]));
        set(w_[k], factor * vec(w_[k]));
      }
    });
  }

  /// One step of Lanczos in the metric of the masses; false where it has nothing left to look at.
  bool advance(double dt) {
    find_forces(dt);
    const std::vector<int>& nodes = step_.independent_;
    const double diagonal = ordered_sum(nodes.size(), [&](std::size_t i) {
      return dot(vec(f_[nodes[i]]), vec(v_[nodes[i]])) + dot(vec(m_[nodes[i]]), vec(w_[nodes[i]]));
    });
    if (!(diagonal >= 0.0) || !std::isfinite(diagonal)) return false;
    if (!found_.diagonal.empty()) found_.beside.push_back(beside_);
    found_.diagonal.push_back(diagonal);
    parallel_for(nodes.size(), 1024, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Load next{vec(f_[nodes[i]]) - diagonal * now_[i].force - beside_ * before_[i].force,
                        vec(m_[nodes[i]]) - diagonal * now_[i].moment - beside_ * before_[i].moment};
        before_[i] = now_[i];
        now_[i] = next;
      }
    });
    move();
    const double square = power();
    if (!(square > 1e-24 * diagonal * diagonal)) return false;
    beside_ = std::sqrt(square);
    scale(square);
    return true;
  }

  /// dt^2 K + 2 dt C on the velocities.
  void find_forces(double dt) {
    map_.apply_to_velocities(0.0, v_, w_);
    parallel_for(step_.blocks_.size(), 16, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) add_block(step_.blocks_[i], dt);
    });
    for (const int k : step_.independent_) f_[k] = m_[k] = Row{};
    parallel_for(step_.nodes_.size(), 512, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        Vec3d f{}, m{};
        for (std::size_t j = step_.gather_start_[i]; j < step_.gather_start_[i + 1]; ++j) {
          const Row* slot = &slots_[step_.gather_[j] >> 1];
          f += vec(slot[0]);
          if (step_.gather_[j] & 1u) m += vec(slot[1]);
        }
        set(f_[step_.nodes_[i]], f);
        set(m_[step_.nodes_[i]], m);
      }
    });
    map_.transfer_forces(f_, m_);
  }

  void add_block(const Block& b, double dt) {
    const system::ElementGroup& group = *system_.groups[b.group];
    const std::size_t width = group.block_width(), rows = group.rows_of_element();
    const std::span<Row> slots = std::span(slots_).subspan(b.first_row, width * rows);
    group.vibrate(b.block, state_, v_, w_, dt, slots);
    for (std::size_t l = 0; l < width; ++l) {
      double factor = 2.0 * dt;
      if (const std::size_t e = b.block * width + l; e < group.size() && group.damped()) {
        // beta K v, with the velocity half a step before; and what damping over a range of frequencies adds to K.
        const double step = group.stable_step(e);
        if (std::isfinite(step)) factor *= 1.0 + 2.0 * group.damping_time_at(step) / dt;
      }
      factor *= 1.0 + group.damping_stiffness_ratio;
      for (Row& slot : slots.subspan(l * rows, rows)) set(slot, factor * vec(slot));
    }
  }

  const AssembledStep& step_;
  const system::System& system_;
  const system::State& state_;
  system::ConstraintMap map_;  ///< a copy: arms of rows turn
  std::vector<Row> v_, w_, f_, m_;
  std::vector<Load> now_, before_;  ///< momenta, by independent_
  std::vector<Row> slots_;
  double beside_ = 0.0;
  Tridiagonal found_;
  std::vector<double> values_;
};

AssembledStep::AssembledStep(system::System& system, const Supports& supports, std::span<const Row> x)
    : system_(system), supports_(supports) {
  choose_blocks(x);
  if (blocks_.empty()) return;
  link_slots();
  system.start_elements();
  std::vector<char> chosen(system.groups.size(), 0);
  for (const Block& b : blocks_) chosen[b.group] = 1;
  for (std::size_t g = 0; g < chosen.size(); ++g)
    if (chosen[g]) system.groups[g]->store_reference_state();
}

void AssembledStep::choose_blocks(std::span<const Row> x) {
  std::vector<char> touched(system_.all_nodes(), 0);
  bool any = false;
  const DoubtfulShells doubtful(system_, x);
  std::size_t shells = 0, inside_sheets = 0;
  for (const auto& group : system_.groups) {
    const bool bricks = steps_like_a_plane_wave(system_, *group);
    if (!bricks && group->kind != model::ElementKind::shell) continue;
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!bricks) {
        const bool free = doubtful.free(*group, e), inside = !free && doubtful.slanted_or_thick(*group, e);
        ++shells;
        inside_sheets += inside ? 1 : 0;
        if (!free && !inside) continue;
      }
      any = true;
      each_node(*group, e, [&](int k) { touched[k] = 1; });
    }
  }
  sheets_ = 10 * inside_sheets > shells;
  if (!any) return;
  // Nodes that theirs follow, and nodes that follow theirs. A rigid body's other nodes do not count: what hangs on them
  // only holds it.
  const std::vector<char> own = touched;
  for (std::size_t k = 0; k < system_.nodes; ++k) {
    if (!system_.map.dependent(static_cast<int>(k))) continue;
    if (own[k]) {
      for (const system::ConstraintMap::Block& b : system_.map.blocks(static_cast<int>(k)))
        if (at(b.node) < system_.nodes) touched[b.node] = 1;
      continue;
    }
    for (const system::ConstraintMap::Term& t : system_.map.terms(static_cast<int>(k)))
      if (at(t.node) < system_.nodes && own[t.node]) touched[k] = 1;
  }
  for (std::size_t g = 0; g < system_.groups.size(); ++g) {
    const system::ElementGroup& group = *system_.groups[g];
    const std::size_t width = group.block_width();
    for (std::size_t first = 0; first < group.size(); first += group.widest()) {
      bool meets = false;
      const std::size_t end = std::min(group.size(), first + group.widest());
      for (std::size_t e = first; e < end && !meets; ++e)
        each_node(group, e, [&](int k) { meets = meets || touched[k] != 0; });
      if (!meets) continue;
      for (std::size_t b = first / width; b * width < end; ++b) {
        blocks_.push_back({static_cast<int>(g), b, rows_});
        rows_ += width * group.rows_of_element();
      }
    }
  }
}

void AssembledStep::link_slots() {
  std::vector<std::vector<std::size_t>> of_node(system_.all_nodes());
  for (const Block& b : blocks_) {
    const system::ElementGroup& group = *system_.groups[b.group];
    const std::size_t first = b.block * group.block_width();
    for (std::size_t e = first; e < std::min(group.size(), first + group.block_width()); ++e) {
      const system::ElementNodes node = group.nodes(e);
      for (int a = 0; a < group.nodes_per_element; ++a)
        if (node[a] >= 0)
          of_node[node[a]].push_back((b.first_row + group.row_in_block(e, at(a))) << 1 | (group.rotational ? 1u : 0u));
    }
  }
  gather_start_.push_back(0);
  for (std::size_t k = 0; k < of_node.size(); ++k) {
    if (of_node[k].empty()) continue;
    nodes_.push_back(static_cast<int>(k));
    gather_.insert(gather_.end(), of_node[k].begin(), of_node[k].end());
    gather_start_.push_back(gather_.size());
    if (!system_.map.dependent(static_cast<int>(k))) {
      independent_.push_back(static_cast<int>(k));
      continue;
    }
    for (const system::ConstraintMap::Block& b : system_.map.blocks(static_cast<int>(k)))
      independent_.push_back(b.node);
    // What may come to be free: as long as it is not it has no mass, and stays where it is led.
    if (system_.follows_tied_node(static_cast<int>(k))) independent_.push_back(static_cast<int>(k));
    // Without a row for its spin the node keeps its own.
    if (!system_.map.rotations(static_cast<int>(k))) independent_.push_back(static_cast<int>(k));
  }
  std::sort(independent_.begin(), independent_.end());
  independent_.erase(std::unique(independent_.begin(), independent_.end()), independent_.end());
}

AssembledStep::Limit AssembledStep::limit(const system::State& state, double dt) const {
  Limit limit{std::numeric_limits<double>::infinity()};
  if (empty() || !(dt > 0.0) || !std::isfinite(dt)) return limit;
  Vibration vibration(*this, state);
  // Value over step, less 4 over step, rises nearly in a straight line: where it is 0 by the last two steps.
  double step = dt, before = 0.0, excess_before = 0.0;
  for (int pass = 0; pass < 6; ++pass) {
    const double value = vibration.largest(step);
    if (!(value > 0.0)) return limit;
    const double excess = (value - 4.0) / step;
    double next = step * 2.0 / std::sqrt(value);
    if (pass == 0 && next > 1.05 * dt) return {next};
    if (pass > 0 && excess != excess_before) next = step - excess * (step - before) / (excess - excess_before);
    limit.step = next;
    if (std::abs(next - step) <= 1e-3 * step) break;
    before = step;
    excess_before = excess;
    step = next;
  }
  const auto [block, element] = vibration.most_strained(step);
  limit.group = blocks_[block].group;
  limit.element = element;
  return limit;
}

}  // namespace nugget::impact
