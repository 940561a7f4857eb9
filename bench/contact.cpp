// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "base/parallel.hpp"
#include "contact/rigid_wall.hpp"
#include "contact/surface_contact.hpp"

// Cost of contact per surface node and cycle. Two wavy sheets of 5 mm elements, 1 mm thick, slide past each other at 10
// m/s in steps of half a microsecond: apart, and in touch all over.
namespace {

using namespace nugget;

constexpr int side = 300;
constexpr double element = 5.0, dt = 5e-7;

struct Sheets {
  contact::SurfaceContactSetup setup;
  std::vector<Row> x, v, force;
  std::vector<double> mass;

  explicit Sheets(double gap) {
    for (int layer = 0; layer < 2; ++layer)
      for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
          const double a = element * (i + 0.3 * layer), b = element * (j + 0.2 * layer);
          x.push_back({a, b, gap * layer + 20.0 * std::sin(0.02 * a) * std::cos(0.017 * b), 0.0});
          v.push_back({layer * 1e4, 0.0, 0.0, 0.0});
        }
    for (int layer = 0; layer < 2; ++layer)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const int a = (layer * (side + 1) + j) * (side + 1) + i;
          contact::Segment s;
          s.node = {a, a + 1, a + side + 2, a + side + 1};
          s.thickness = 1.0;
          s.bulk_modulus = 175000.0;
          setup.segments.push_back(s);
        }
    setup.nodes = contact::nodes_of(setup.segments);
    force.resize(x.size());
    mass.assign(x.size(), 2e-7);
  }
  void slide() {
    for (std::size_t i = x.size() / 2; i < x.size(); ++i) x[i].x += dt * v[i].x;
  }
};

void run(benchmark::State& state, double gap) {
  set_threads(static_cast<int>(state.range(0)));
  Sheets sheets(gap);
  contact::SurfaceContact contact(sheets.setup, sheets.x);
  for (auto _ : state) {
    sheets.slide();
    contact.apply({0.0, dt, dt, dt, sheets.x, sheets.v, sheets.mass, {}}, sheets.force);
  }
  set_threads(1);
  state.counters["node_cycles"] =
      benchmark::Counter(static_cast<double>(sheets.x.size()) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["searches"] = static_cast<double>(contact.searches());
  state.counters["pairs_per_node"] = static_cast<double>(contact.listed()) / static_cast<double>(sheets.x.size());
  state.counters["touching"] = contact.touching();
}

void contact_apart(benchmark::State& state) {
  run(state, 12.0);
}
void contact_near(benchmark::State& state) {
  run(state, 1.5);
}
void contact_all_touching(benchmark::State& state) {
  run(state, 0.9);
}
BENCHMARK(contact_apart)->Arg(1)->Arg(2)->Iterations(400)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(contact_near)->Arg(1)->Arg(2)->Iterations(60)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(contact_all_touching)->Arg(1)->Arg(2)->Iterations(60)->Unit(benchmark::kMillisecond)->UseRealTime();

void wall_apart(benchmark::State& state) {
  set_threads(static_cast<int>(state.range(0)));
  Sheets sheets(1.0);
  model::RigidWall card;
  card.shape = model::RigidWall::Shape::cylinder;
  card.normal = {0.0, 0.0, 1.0};
  card.origin = {-500.0, 0.0, 0.0};
  card.radius = 177.0;
  card.death = 1.0;
  std::vector<int> nodes;
  for (const auto& tracked : sheets.setup.nodes) nodes.push_back(tracked.node);
  contact::RigidWall wall(card, nodes);
  const std::vector<Row> free(sheets.x.size());
  for (auto _ : state) wall.constrain(0.0, dt, dt, sheets.x, sheets.v, free, sheets.mass, {});
  set_threads(1);
  state.counters["node_cycles"] =
      benchmark::Counter(static_cast<double>(nodes.size()) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(wall_apart)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
