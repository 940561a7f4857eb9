// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>
#include <vector>

#include "base/index.hpp"
#include "kernel/element/hexahedron.hpp"
#include "motion.hpp"
#include "one_element.hpp"

// One solid element, driven by the velocities of its nodes, and what all of them must keep. `Element` has
//   corners, Layout, Motion<R>, Forces<R>
//   plastic_strain(layout)   where that of the first point stands
//   layout(law), start(layout, places, state), cycle<R>(properties, law, layout, nodes, dt, state)
namespace nugget::kernel {

/// Without bulk viscosity: all forces are those of stresses.
inline HexahedronProperties inviscid_solid() {
  HexahedronProperties b;
  b.density = steel_density;
  b.bulk_linear = b.bulk_quadratic = 0.0;
  return b;
}

template <class Element>
using PlacesOf = std::array<Vec3d, Element::corners>;

template <class Element, class Law>
struct DrivenSolid {
  using Forces = typename Element::template Forces<double>;
  HexahedronProperties properties;
  LawKernel<Law> law;
  typename Element::Layout layout;
  std::vector<double> state;
  typename Element::template Motion<double> nodes;
  Forces force{};

  DrivenSolid(const HexahedronProperties& of, const Law& parameters, const PlacesOf<Element>& x)
      : properties(of), law(parameters), layout(Element::layout(law)), state(static_cast<std::size_t>(layout.size())) {
    for (std::size_t i = 0; i < Element::corners; ++i) nodes.x[i] = x[i];
    Element::start(layout, x, state.data());
  }
  const Forces& step(double dt) {
    for (std::size_t i = 0; i < Element::corners; ++i) nodes.x[i] += dt * nodes.v[i];
    return force = one_element(nodes, state, [&](const auto& all, double* store) {
             return Element::cycle(properties, law, layout, all, dt, store);
           });
  }
  double at(int field) const { return state[field]; }
};

template <class Forces>
double largest(const Forces& f) {
  double most = 0.0;
  for (const Vec3d& a : f.f) most = std::max(most, norm(a));
  return most;
}

/// Elements of different shape and motion, one of them deleted, alone and as lanes of a batch. The first one
/// must have flowed where its law can.
template <class Element, class Law>
void batch_gives_the_bits_of_each_alone(const HexahedronProperties& properties, const Law& parameters,
                                        const std::function<PlacesOf<Element>(Random&)>& places, int dead) {
  constexpr int W = native_width;
  using Layout = typename Element::Layout;
  const double dt = 1e-7;
  Random random;
  std::vector<DrivenSolid<Element, Law>> single;
  for (int l = 0; l < W; ++l) single.emplace_back(properties, parameters, places(random));
  const std::size_t size = single[0].state.size();
  std::vector<double> together(size * W);
  for (int l = 0; l < W; ++l) {
    DrivenSolid<Element, Law>& one = single[l];
    if (l == dead) one.state[Layout::alive] = 0.0;
    for (std::size_t i = 0; i < size; ++i) together[i * W + at(l)] = one.state[i];
  }
  for (int cycle = 0; cycle < 60; ++cycle) {
    typename Element::template Motion<NativeBatch> nodes;
    const auto put = [](Vec3<NativeBatch>& to, int l, const Vec3d& from) {
      set_lane(to.x, l, from.x);
      set_lane(to.y, l, from.y);
      set_lane(to.z, l, from.z);
    };
    for (int l = 0; l < W; ++l) {
      DrivenSolid<Element, Law>& one = single[l];
      const Vec3d spin = random.vector(1e4);
      for (std::size_t i = 0; i < Element::corners; ++i)
        one.nodes.v[i] = cross(spin, one.nodes.x[i]) + random.vector(20000.0 * (l + 1));
      one.step(dt);
      for (std::size_t i = 0; i < Element::corners; ++i) {
        put(nodes.x[i], l, one.nodes.x[i]);
        put(nodes.v[i], l, one.nodes.v[i]);
      }
    }
    const auto force = Element::cycle(properties, single[0].law, single[0].layout, nodes, dt, together.data());
    for (int l = 0; l < W; ++l) {
      const DrivenSolid<Element, Law>& one = single[l];
      for (std::size_t i = 0; i < Element::corners; ++i) {
        const Vec3d f = get(force.f[i], l);
        ASSERT_EQ(0, std::memcmp(&f, &one.force.f[i], sizeof f)) << cycle;
      }
      ASSERT_EQ(lane(force.stable_step, l), one.force.stable_step);
      for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(together[i * W + at(l)], one.state[i]) << i;
    }
  }
  if constexpr (LawKernel<Law>::has_plastic_strain) {
    EXPECT_GT(single[0].at(Element::plastic_strain(single[0].layout)), 0.0);
  }
}

/// Turns an element that has flowed once around an axis, slowly: its state and its forces are what they were.
template <class Element, class Law>
void expect_that_a_turn_strains_nothing(DrivenSolid<Element, Law>& d, double dt) {
  const std::vector<double> before = d.state;
  const auto start = d.force;
  const Vec3d axis = unit(Vec3d{1, 2, 3});
  for (int cycle = 0; cycle < 360; ++cycle) {
    for (std::size_t i = 0; i < Element::corners; ++i)
      d.nodes.v[i] = (1.0 / dt) * (turned(axis, 2 * M_PI / 360, d.nodes.x[i]) - d.nodes.x[i]);
    d.step(dt);
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(d.state[i], before[i], 1e-7 * (1 + std::abs(before[i]))) << i;
  for (std::size_t i = 0; i < Element::corners; ++i) EXPECT_LT(norm(d.force.f[i] - start.f[i]), 1e-7 * largest(start));
}

/// Stretches an element of eight nodes and four layers along x, more on top, until it is deleted: when its last layer
/// has reached the plastic strain at which its law fails.
template <class Element, class Law>
void expect_that_it_goes_with_its_last_layer(DrivenSolid<Element, Law>& d, double failure_strain) {
  constexpr int layers = 4;
  int cycle = 0, most_failed = 0;
  for (; cycle < 5000 && d.at(Element::Layout::alive) > 0.5; ++cycle) {
    for (std::size_t i = 0; i < 8; ++i) {
      const bool far = i == 1 || i == 2 || i == 5 || i == 6;
      d.nodes.v[i] = {far ? (i > 3 ? 2000.0 : 1000.0) : 0.0, 0.0, 0.0};
    }
    d.step(1e-7);
    int failed = 0;
    for (int k = 0; k < layers; ++k) failed += d.at(d.layout.history_of(k)) >= failure_strain;
    if (d.at(Element::Layout::alive) > 0.5) most_failed = std::max(most_failed, failed);
  }
  EXPECT_EQ(most_failed, layers - 1);
  EXPECT_LT(cycle, 5000);
  EXPECT_EQ(largest(d.force), 0.0);
  EXPECT_TRUE(std::isinf(d.force.stable_step));
}

}  // namespace nugget::kernel
