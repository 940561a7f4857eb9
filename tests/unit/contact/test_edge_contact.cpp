// SPDX-License-Identifier: Apache-2.0
#include "contact/edge_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "base/parallel.hpp"
#include "unit/contact/point_masses.hpp"

namespace nugget::contact {
namespace {

/// Point masses and edges between them.
struct Bars : test::PointMasses {
  EdgeContactSetup setup;

  void add_edge(int a, int b, double thickness = 1.0, double stiffness = 1e5) {
    Edge e;
    e.node = {a, b};
    e.thickness = thickness;
    e.stiffness = stiffness;
    e.elements = {static_cast<int>(setup.edges.size())};
    setup.edges.push_back(e);
  }
  /// A chain of edges through the points; returns its first node.
  int add_line(const std::vector<Vec3d>& points, const Vec3d& velocity = {}, double m = 1e-5) {
    const int first = static_cast<int>(x.size());
    for (const Vec3d& p : points) add_node(p, velocity, m);
    for (int n = first; n + 1 < static_cast<int>(x.size()); ++n) add_edge(n, n + 1);
    return first;
  }
  EdgeContact contact() {
    alive.assign(setup.edges.size(), 1);
    force.assign(x.size(), {});
    return EdgeContact(setup, x);
  }
  Vec3d angular_momentum() const {
    Vec3d sum;
    for (std::size_t i = 0; i < x.size(); ++i) sum += mass[i] * cross(vec(x[i]), vec(v[i]));
    return sum;
  }
};

/// A bar along x at rest, and one along y above it that comes down.
struct Crossing : Bars {
  explicit Crossing(double speed, double across = 0.0, double gap = 0.1) {
    add_line({{-5.0, 0.0, 0.0}, {5.0, 0.0, 0.0}});
    add_line({{across, -5.0, 1.0 + gap}, {across, 5.0, 1.0 + gap}}, {0.0, 0.0, -speed});
  }
};

// An elastic impact of two bars of point masses at their ends: impulse 2 v / (sum of N^2/m), shared out by the lever
// rule. Sabotage: another share of the force at an end.
TEST(EdgeContact, CrossingBarsReboundAsTheClosedFormSays) {
  constexpr double speed = 1000.0, m = 1e-5;
  for (const double across : {0.0, 2.0, 4.0}) {
    Crossing s(speed, across);
    const Vec3d momentum = s.momentum(), angular = s.angular_momentum();
    const double energy = s.kinetic();
    EdgeContact contact = s.contact();
    s.evaluate(contact, 0.0);
    double deepest = 0.0;
    for (int i = 0; i < 10000; ++i) {
      s.step(contact);
      deepest = std::max(deepest, contact.deepest());
      const double kinetic = s.kinetic();  // at the middle of the step; close enough for 1 %
      if (contact.touching() == 0) {
        EXPECT_NEAR(kinetic + contact.energy(), energy, 0.01 * energy);
      }
    }
    EXPECT_GT(deepest, 0.0);
    EXPECT_EQ(contact.touching(), 0);
    const double at = 0.5 + 0.1 * across;  // along the lower bar, from its first end
    const double impulse = 2.0 * speed * m / ((1.0 - at) * (1.0 - at) + at * at + 0.5);
    EXPECT_NEAR(s.v[0].z, -(1.0 - at) * impulse / m, 0.01 * speed);
    EXPECT_NEAR(s.v[1].z, -at * impulse / m, 0.01 * speed);
    EXPECT_NEAR(s.v[2].z, -speed + 0.5 * impulse / m, 0.01 * speed);
    EXPECT_LT(norm(s.momentum() - momentum), 1e-14 * norm(momentum));
    EXPECT_LT(norm(s.angular_momentum() - angular), 1e-12 * norm(momentum) * 5.0);
    EXPECT_NEAR(contact.energy(), 0.0, 0.01 * energy);
  }
}

// The bars pass each other's centre line within a step or two; the side from which they came is kept. Sabotage: the
// direction from the points of now alone.
TEST(EdgeContact, AFastBarDoesNotTunnel) {
  for (const double speed : {2e5, 1e6, 2e6}) {  // 0.02, 0.1, 0.2 of the thickness in a step
    Crossing s(speed);
    for (Edge& e : s.setup.edges) e.stiffness = 1e10;  // as stiff as the step allows
    EdgeContact contact = s.contact();
    s.evaluate(contact, 0.0);
    for (int i = 0; i < 2000; ++i) s.step(contact);
    EXPECT_GT(s.x[2].z, s.x[0].z) << speed;
    EXPECT_GT(s.v[2].z, s.v[0].z) << speed;
  }
}

// Sliding along a line of edges a bar feels one edge at a time, the next when it comes to it. Sabotage: presses() that
// is always true.
TEST(EdgeContact, ALineOfEdgesIsFeltOnce) {
  Bars s;
  s.add_line({{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {12, 0, 0}}, {}, 1e10);
  s.add_line({{1.0, -5.0, 1.0 - 1e-3}, {1.0, 5.0, 1.0 - 1e-3}}, {2e5, 0.0, 0.0}, 1e10);
  EdgeContact contact = s.contact();
  // They overlap from the start by 1e-3, and that gives no force.
  s.evaluate(contact, 0.0);
  EXPECT_EQ(contact.touching(), 1);
  EXPECT_EQ(contact.deepest(), 0.0);
  for (int i = 0; i < 500; ++i) {
    s.step(contact);
    ASSERT_EQ(contact.touching(), 1) << i;
  }
}

TEST(EdgeContact, TheDepthGoesOnFromEdgeToEdge) {
  Bars s;
  s.add_line({{0, 0, 0}, {4, 0, 0}, {8, 0, 0}}, {}, 1e10);
  s.add_line({{3.0, -5.0, 1.0}, {3.0, 5.0, 1.0}}, {0.0, 0.0, -1e4}, 1e10);
  EdgeContact contact = s.contact();
  s.evaluate(contact, 0.0);
  for (int i = 0; i < 10; ++i) s.step(contact);
  EXPECT_NEAR(contact.deepest(), 1e-2, 1e-9);
  for (int n = 3; n < 5; ++n) s.v[n] = {1e5, 0.0, 0.0, 0.0};
  for (int i = 0; i < 300; ++i) {
    s.step(contact);
    ASSERT_NEAR(contact.deepest(), 1e-2, 1e-9) << i;
  }
}

// Sabotage caught: an offset forgotten from edge to edge, where the way along then became depth.
TEST(EdgeContact, AnInitialPenetrationGoesOnFromEdgeToEdge) {
  Bars s;
  s.add_line({{0, 0, 0}, {4, 0, 0}, {8, 0, 0}}, {}, 1e10);
  s.add_line({{3.0, -5.0, 0.9}, {3.0, 5.0, 0.9}}, {1e5, 0.0, 0.0}, 1e10);
  EdgeContact contact = s.contact();
  s.evaluate(contact, 0.0);
  for (int i = 0; i < 300; ++i) {
    s.step(contact);
    ASSERT_NEAR(contact.deepest(), 0.0, 1e-9) << i;
  }
  EXPECT_GT(s.x[3].x, 4.0);
}

// A closed polygon finer than it is thick does not press itself. Sabotage: belong_together() without the nodes.
TEST(EdgeContact, ALineDoesNotFightItself) {
  Bars s;
  std::vector<Vec3d> points;
  for (int i = 0; i <= 40; ++i) points.push_back({0.2 * i, 0.3 * std::sin(0.05 * i), 0.0});
  s.add_line(points);
  EdgeContact contact = s.contact();
  s.evaluate(contact, 1e-7);
  EXPECT_EQ(contact.touching(), 0);
}

TEST(EdgeContact, FrictionStopsAtItsBound) {
  Crossing s(0.0, 0.0, -1e-3);
  s.setup.law.friction = kernel::FrictionTable({0.3, 0.3, 0.0, 0.0});
  for (double& m : s.mass) m = 1e10;
  EdgeContact contact = s.contact();
  s.evaluate(contact, 1e-7);
  for (int n = 2; n < 4; ++n) s.v[n] = {0.0, 0.0, -1e4, 0.0};
  for (int i = 0; i < 10; ++i) s.step(contact);
  const double normal = s.force[2].z;
  EXPECT_GT(normal, 0.0);
  for (int n = 2; n < 4; ++n) s.v[n] = {1e4, 0.0, 0.0, 0.0};
  s.step(contact);
  EXPECT_LT(s.force[2].x, 0.0);
  EXPECT_LT(-s.force[2].x, 0.3 * normal);
  for (int i = 0; i < 40; ++i) s.step(contact);
  EXPECT_NEAR(-s.force[2].x, 0.3 * normal, 1e-6 * normal);
}

// A square of two by two shells: eight exterior edges, and four more inside that appear as shells are deleted.
TEST(EdgeContact, EdgesOfShells) {
  std::vector<Segment> segments;
  std::vector<Row> x;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) x.push_back({5.0 * i, 5.0 * j, 0.0, 0.0});
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      Segment s;
      const int a = 3 * j + i;
      s.node = {a, a + 1, a + 4, a + 3};
      s.thickness = 1.0;
      s.bulk_modulus = 1e5;
      s.element = static_cast<int>(segments.size());
      segments.push_back(s);
    }
  const std::vector<Edge> edges = edges_of(segments, x);
  EXPECT_EQ(edges.size(), 12u);
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const Edge& e) { return e.elements.size() == 1; }), 8);

  // A bar through the plate's plane, crossing its inner edge from 1 to 4 at its middle; the inner edge is felt only
  // where it is asked for, or one of its shells has gone.
  Bars s;
  s.x = x;
  s.v.assign(9, {});
  s.mass.assign(9, 1e-5);
  s.setup.edges = edges;
  const int a = s.add_node({2.0, 2.5, 0.9}), b = s.add_node({8.0, 2.5, 0.9});
  Edge bar;
  bar.node = {a, b};
  bar.thickness = 1.0;
  bar.stiffness = 1e5;
  bar.elements = {4};
  s.setup.edges.push_back(bar);
  s.alive.assign(5, 1);
  s.force.assign(s.x.size(), {});
  EdgeContact exterior(s.setup, s.x);
  s.evaluate(exterior, 0.0);
  EXPECT_EQ(exterior.touching(), 0);
  s.setup.interior = true;
  EdgeContact all(s.setup, s.x);
  s.evaluate(all, 0.0);
  EXPECT_EQ(all.touching(), 1);
  s.alive[0] = 0;
  exterior.surface_changed();
  s.evaluate(exterior, 0.0);
  EXPECT_EQ(exterior.touching(), 1);
}

TEST(EdgeContact, SameBitsForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    set_threads(threads);
    Bars s;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-20.0, 20.0), part(-1.0, 1.0);
    for (int i = 0; i < 400; ++i) {
      const Vec3d p{place(random), place(random), 0.3 * place(random)};
      const Vec3d d{part(random), part(random), part(random)};
      s.add_line({p, p + (2.0 / norm(d)) * d}, 1000.0 * Vec3d{part(random), part(random), part(random)});
    }
    EdgeContact contact = s.contact();
    s.evaluate(contact, 0.0);
    int touched = 0;
    const Vec3d momentum = s.momentum();
    for (int i = 0; i < 300; ++i) {
      s.step(contact);
      touched += contact.touching();
    }
    EXPECT_GT(touched, 1000);
    EXPECT_LT(norm(s.momentum() - momentum), 1e-13);
    set_threads(1);
    return s.x;
  };
  const std::vector<Row> one = run(1), three = run(3);
  EXPECT_EQ(std::memcmp(one.data(), three.data(), one.size() * sizeof(Row)), 0);
}

}  // namespace
}  // namespace nugget::contact
