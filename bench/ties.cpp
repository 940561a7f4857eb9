// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>

#include "base/parallel.hpp"
#include "weld/tie/ties.hpp"

// Ties of a large car body: 1e5 weld nodes on 1e6 segments. Aim: seconds.
namespace {

using namespace nugget;
using model::Index;

/// A wavy sheet of columns x rows shells of 5 mm.
void add_sheet(model::Model& m, int columns, int rows, double z) {
  const auto part = static_cast<Index>(m.parts.size());
  m.parts.emplace_back().id = part + 1;
  m.parts.back().kind = model::ElementKind::shell;
  const auto first = static_cast<Index>(m.nodes.size());
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      m.nodes.id.push_back(static_cast<int>(m.nodes.size()) + 1);
      m.nodes.x.push_back({5.0 * i, 5.0 * j, z + 20.0 * std::sin(0.01 * i) * std::cos(0.013 * j)});
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Index n = first + j * (columns + 1) + i;
      m.shells.id.push_back(static_cast<int>(m.shells.size()) + 1);
      m.shells.part.push_back(part);
      m.shells.node.push_back({n, n + 1, n + columns + 2, n + columns + 1});
      m.shells.thickness.push_back(1.0);
      m.shells.place.push_back(0, 0);
    }
}

void add_welds(model::Model& m, int count, int columns, int rows) {
  const auto part = static_cast<Index>(m.parts.size());
  m.materials.emplace_back().law = kernel::Spotweld{};
  m.beam_sections.emplace_back().outer = {5.0, 5.0};
  m.parts.emplace_back().id = part + 1;
  m.parts.back().kind = model::ElementKind::beam;
  m.parts.back().material = 0;
  m.parts.back().section = 0;
  for (int w = 0; w < count; ++w) {
    // Low-discrepancy places, away from the border.
    const double i = 1.0 + std::fmod(0.7548776662466927 * w, 1.0) * (columns - 2);
    const double j = 1.0 + std::fmod(0.5698402909980532 * w, 1.0) * (rows - 2);
    const double z = 20.0 * std::sin(0.01 * i) * std::cos(0.013 * j);
    for (const double height : {0.1, 0.9}) {
      m.nodes.id.push_back(static_cast<int>(m.nodes.size()) + 1);
      m.nodes.x.push_back({5.0 * i, 5.0 * j, z + height});
    }
    const auto last = static_cast<Index>(m.nodes.size());
    m.beams.id.push_back(static_cast<int>(m.beams.size()) + 1);
    m.beams.part.push_back(part);
    m.beams.node.push_back({last - 2, last - 1});
    m.beams.orientation.push_back(model::none);
    m.beams.tied_parts.push_back({model::none, model::none});
    m.beams.place.push_back(0, 0);
  }
  model::Contact contact;
  contact.keyword = "CONTACT_SPOTWELD";
  contact.kind = model::Contact::Kind::spotweld;
  contact.a.parts = {part};
  for (Index p = 0; p < part; ++p) contact.b.parts.push_back(p);
  m.contacts.push_back(contact);
}

void tie_welds(benchmark::State& state) {
  constexpr int columns = 1000, rows = 500, welds = 50000;
  model::Model m;
  add_sheet(m, columns, rows, 0.0);
  add_sheet(m, columns, rows, 1.0);
  add_welds(m, welds, columns, rows);
  const int before = threads();
  set_threads(static_cast<int>(state.range(0)));
  std::size_t tied = 0;
  for (auto _ : state) {
    Findings findings;
    tied = weld::tie(m, findings).ties.size();
  }
  set_threads(before);
  state.counters["segments"] = static_cast<double>(m.shells.size());
  state.counters["nodes_tied"] = static_cast<double>(tied);
}
BENCHMARK(tie_welds)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
