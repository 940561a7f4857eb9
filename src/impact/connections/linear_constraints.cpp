// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/linear_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/index.hpp"

namespace nugget::impact {
namespace {

Vec3d product(const std::array<Vec3d, 3>& m, const Vec3d& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

}  // namespace

LinearConstraints::LinearConstraints(const system::System& system, const Supports& supports, Findings& findings)
    : system_(system) {
  const model::Model& model = system.model;
  std::map<std::pair<int, bool>, std::size_t> site_of;
  for (const model::LinearConstraint& equation : model.linear_constraints) {
    const std::size_t begin = terms_.size();
    for (const model::LinearConstraint::Term& t : equation.terms) {
      const int node = system.node_of[t.node];
      const auto [found, is_new] = site_of.try_emplace({node, t.rotation}, sites_.size());
      terms_.push_back({found->second, t.factor * t.direction});
      if (!is_new) continue;
      Site& s = sites_.emplace_back();
      s.node = at(node);
      s.rotation = t.rotation;
      const auto refuse = [&](const std::string& why, const char* remedy) {
        findings.error(equation.place, equation.keyword,
                       fmt::format("equation {}: node {} {}", equation.id, model.nodes.id[t.node], why), remedy);
      };
      const Supports::OfNode fixed = supports.of_node(static_cast<int>(s.node), t.rotation);
      s.held = fixed.held;
      s.driven = fixed.driven;
      if (fixed.passing)
        refuse("is held or driven for a time only, which is not built for a node of an equation",
               "hold or drive it from the beginning to the end");
      if (fixed.turning)
        refuse("is driven on a circle, or askew to what holds it, which is not built for a node of an equation",
               "drive it along the directions of the equation");
      const double inert = t.rotation ? system.inertia[s.node] : system.mass[s.node];
      if (!(inert > 0.0) && s.held.size() + s.driven.size() < 3) {
        Vec3d left = t.direction;
        for (const Vec3d& h : s.held) left -= dot(h, left) * h;
        for (const std::size_t d : s.driven) left -= dot(supports.axis_of(d), left) * supports.axis_of(d);
        if (norm(left) > 1e-9)
          refuse(t.rotation ? "has no rotary inertia: nothing turns there" : "has no mass, and nothing drives it",
                 t.rotation ? "take rotations of shells or beams" : "drive it, or give it an element or *ELEMENT_MASS");
      }
    }
    rows_.push_back({begin, terms_.size()});
  }
  if (rows_.empty()) return;
  for (const model::RigidWall& wall : model.walls)
    for (const Site& s : sites_)
      if (std::binary_search(wall.nodes.begin(), wall.nodes.end(), system.model_node[s.node])) {
        findings.error(
            wall.place, "*RIGIDWALL",
            fmt::format("node {} of a linear equation is stopped by this wall, too: both at once is not built",
                        model.nodes.id[system.model_node[s.node]]),
            "leave the nodes of equations out of the wall's");
        break;
      }
}

void LinearConstraints::hold(Site& site, double inverse) {
  site.mobility = {Vec3d{inverse, 0, 0}, Vec3d{0, inverse, 0}, Vec3d{0, 0, inverse}};
  const auto take = [&](const Vec3d& axis) {
    for (Vec3d& row : site.mobility) row = row - dot(row, axis) * axis;
    site.after -= dot(axis, site.after) * axis;
  };
  for (const Vec3d& axis : site.held) take(axis);
}

void LinearConstraints::spread(const std::vector<double>& x) {
  for (Site& s : sites_) s.force = {};
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t t = rows_[i].begin; t < rows_[i].end; ++t) sites_[terms_[t].site].force += x[i] * terms_[t].c;
}

double LinearConstraints::residual(std::size_t i, double velocity_interval) const {
  double sum = 0.0;
  for (std::size_t t = rows_[i].begin; t < rows_[i].end; ++t) {
    const Site& s = sites_[terms_[t].site];
    sum += velocity_interval * dot(terms_[t].c, product(s.mobility, s.force));
  }
  return sum;
}

void LinearConstraints::solve(double velocity_interval) {
  const std::size_t n = rows_.size();
  lambda_.assign(n, 0.0);
  rest_.assign(n, 0.0);
  direction_.assign(n, 0.0);
  image_.assign(n, 0.0);
  double square = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    Equation& row = rows_[i];
    row.diagonal = 0.0;
    double missing = 0.0;
    for (std::size_t t = row.begin; t < row.end; ++t) {
      const Site& s = sites_[terms_[t].site];
      row.diagonal += velocity_interval * dot(terms_[t].c, product(s.mobility, terms_[t].c));
      missing -= dot(terms_[t].c, s.after);
    }
    if (!(row.diagonal > 0.0)) continue;  // all of it is held or driven
    rest_[i] = missing;
    direction_[i] = missing / row.diagonal;
    square += missing * direction_[i];
  }
  const double enough = 1e-28 * square;
  for (std::size_t step = 0; step < 2 * n + 20 && square > enough; ++step) {
    spread(direction_);
    double curvature = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      image_[i] = rows_[i].diagonal > 0.0 ? residual(i, velocity_interval) : 0.0;
      curvature += direction_[i] * image_[i];
    }
    if (!(curvature > 0.0)) break;
    const double length = square / curvature;
    double next = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      lambda_[i] += length * direction_[i];
      rest_[i] -= length * image_[i];
      if (rows_[i].diagonal > 0.0) next += rest_[i] * rest_[i] / rows_[i].diagonal;
    }
    for (std::size_t i = 0; i < n; ++i)
      if (rows_[i].diagonal > 0.0) direction_[i] = rest_[i] / rows_[i].diagonal + (next / square) * direction_[i];
    square = next;
  }
  spread(lambda_);
}

void LinearConstraints::constrain_at_start(system::State& state, std::span<const double> inverse_mass,
                                           std::span<const double> inverse_inertia) {
  if (rows_.empty()) return;
  for (Site& s : sites_) {
    s.after = vec(s.rotation ? state.w[s.node] : state.v[s.node]);
    hold(s, s.driven.empty() ? (s.rotation ? inverse_inertia : inverse_mass)[s.node] : 0.0);
  }
  solve(1.0);
  for (const Site& s : sites_) add(s.rotation ? state.w[s.node] : state.v[s.node], product(s.mobility, s.force));
}

void LinearConstraints::apply(system::State& state, double velocity_interval, std::span<const double> inverse_mass,
                              std::span<const double> inverse_inertia, const Supports& supports) {
  if (rows_.empty() || !(velocity_interval > 0.0)) return;
  for (Site& s : sites_) {
    const double inverse = (s.rotation ? inverse_inertia : inverse_mass)[s.node];
    const Vec3d load = vec(s.rotation ? state.m[s.node] : state.f[s.node]);
    s.after = vec(s.rotation ? state.w[s.node] : state.v[s.node]) + (velocity_interval * inverse) * load;
    hold(s, inverse);
    for (const std::size_t d : s.driven) {
      const std::optional<double> speed = supports.coming_velocity(d, state, velocity_interval);
      if (!speed) continue;
      const Vec3d axis = supports.axis_of(d);
      for (Vec3d& row : s.mobility) row = row - dot(row, axis) * axis;
      s.after += (*speed - dot(axis, s.after)) * axis;
    }
  }
  solve(velocity_interval);
  for (const Site& s : sites_) add(s.rotation ? state.m[s.node] : state.f[s.node], s.force);
}

void LinearConstraints::archive(Archive& a) {
  a.built(system_, sites_, terms_, rows_, lambda_, rest_, direction_, image_);
}

}  // namespace nugget::impact
