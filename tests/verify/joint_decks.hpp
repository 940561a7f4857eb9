// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/index.hpp"
#include "specimen.hpp"

// Decks of rigid bodies and joints, and what a run says of them.
namespace nugget::verify {

struct Body {
  Vec3d center{};
  double mass = 1.0;
  Vec3d inertia{1.0, 1.0, 1.0};
  Vec3d velocity{}, spin{};
  bool fixed = false;
};

/// A rigid part without elements: mass and tensor as given, and nodes.
inline void body(Specimen& s, int id, const Body& b, const std::vector<int>& nodes) {
  const double held = b.fixed ? 7 : 0;
  s.card("MAT_RIGID", {double(id), 1e-9, 210000.0, 0.3}).text(fields({b.fixed ? 1.0 : 0.0, held, held}) + fields({}));
  s.text(fmt::format("*PART_INERTIA\nbody {}\n", id) + fields({double(id), 0, double(id)}) +
         fields({b.center.x, b.center.y, b.center.z, b.mass}) +
         fields({b.inertia.x, 0, 0, b.inertia.y, 0, b.inertia.z}) +
         fields({b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x, b.spin.y, b.spin.z}));
  s.node_set(id, nodes).card("CONSTRAINED_EXTRA_NODES_SET", {double(id), double(id)});
}

/// Pairs of coincident nodes at the places: the first of each pair for A, the second for B.
struct Pairs {
  std::vector<int> a, b;
  Pairs(Specimen& s, std::initializer_list<Vec3d> places) {
    for (const Vec3d& x : places) {
      a.push_back(s.node(x));
      b.push_back(s.node(x));
    }
  }
};

inline void joint(Specimen& s, const std::string& kind, const Pairs& p, double damp = 1.0) {
  std::vector<double> n(6, 0.0);
  for (std::size_t i = 0; i < p.a.size(); ++i) n[2 * i] = p.a[i], n[2 * i + 1] = p.b[i];
  s.card("CONSTRAINED_JOINT_" + kind, {n[0], n[1], n[2], n[3], n[4], n[5], 1.0, damp});
}

/// The same by points: `a` on body 1; on body 2 only a second one that is apart from it is `b`.
inline void joint_by_points(Specimen& s, const std::string& kind, const std::vector<Vec3d>& a, const Vec3d& b = {}) {
  std::string text = "*CONSTRAINED_JOINT_COOR_" + kind + '\n' + fields({1, 2});
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& x = i < a.size() ? a[i] : Vec3d{};
    // What stands for the second point of a pair does not count.
    const Vec3d other = i == 1 && kind == "UNIVERSAL" ? b : Vec3d{9, 9, 9};
    text += fields({x.x, x.y, x.z}) + fields({other.x, other.y, other.z});
  }
  s.text(text);
}

inline Specimen& timing(Specimen& s, double end, double step) {
  return s.text(constant_curve(90, step))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 90})
      .card("CONTROL_TERMINATION", {end});
}

inline const system::RigidBody& body_of(const impact::Snapshot& now, int id) {
  for (const system::RigidBody& b : now.system.bodies)
    if (b.id == id) return b;
  throw std::runtime_error("no such body");
}
inline Vec3d velocity(const impact::Snapshot& now, int id) {
  return now.velocity(at(body_of(now, id).node));
}
inline Vec3d spin(const impact::Snapshot& now, int id) {
  return now.spin(at(body_of(now, id).node));
}
inline Vec3d place(const impact::Snapshot& now, int id) {
  return vec(now.state.x[body_of(now, id).node]);
}

/// How far momentum, angular momentum and the energy ratio of bodies 1 and 2 have gone from where they were.
class Drift {
 public:
  void add(const impact::Snapshot& now) {
    Vec3d l, a;
    for (const int id : {1, 2}) {
      const system::RigidBody& b = body_of(now, id);
      // Velocities and momenta at t(n+1/2): places half a step on.
      const Vec3d v = vec(now.state.v[b.node]);
      l += b.mass * v;
      a += b.angular_momentum + cross(place(now, id) + (0.5 * now.state.dt) * v, b.mass * v);
    }
    if (!linear_) linear_ = l, angular_ = a;
    linear = std::max(linear, norm(l - *linear_));
    angular = std::max(angular, norm(a - *angular_));
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
  }

  double linear = 0.0, angular = 0.0, ratio = 0.0;  ///< the greatest so far

 private:
  std::optional<Vec3d> linear_, angular_;
};

}  // namespace nugget::verify
