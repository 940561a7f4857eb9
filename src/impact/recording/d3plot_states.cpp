// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/d3plot_states.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "impact/recording/node_motion.hpp"
#include "impact/simulation/strains.hpp"
#include "output/element_stresses.hpp"

namespace nugget::impact {
namespace {

using Layout = output::D3plotLayout;

/// The group that holds an element, or null where the element has no kernel.
const system::ElementGroup* group_of(const Snapshot& now, const system::System::ElementLocation& location) {
  return location.group < 0 ? nullptr : now.system.groups[location.group].get();
}

bool is_there(const Snapshot& now, const system::System::ElementLocation& location) {
  const system::ElementGroup* group = group_of(now, location);
  return group == nullptr || group->alive(at(location.element));
}

void put_node(const Snapshot& now, Layout::Stretch stretch, std::size_t n, char* to) {
  const auto k = at(now.system.node_of[n]);
  if (stretch == Layout::coordinates) return Layout::put(to, vec(now.state.x[k]));
  const NodeMotion motion = node_motion(now, k);
  Layout::put(to, stretch == Layout::velocities ? motion.velocity : motion.acceleration);
}

void put_shell(const Snapshot& now, const Layout& layout, std::size_t e, char* to) {
  const model::Model& model = now.system.model;
  thread_local std::vector<output::StressRecord> layers;
  layers.resize(layout.layers());
  const system::System::ElementLocation location = now.system.shell_location[e];
  output::ShellRecord shell = output::shell_forces(now.system, now.state, location, layers);
  shell.thickness = model.shells.thickness[e];
  const system::ElementGroup* group = group_of(now, location);
  const std::size_t i = at(location.element);
  if (group != nullptr) {
    shell.thickness = group->thickness(i);
    const double density = model.materials[model.parts[group->part].material].density;
    shell.internal_energy = group->mass(i) > 0.0 ? group->internal_energy(i) * density / group->mass(i) : 0.0;
  }
  if (group != nullptr && model.requests.strains) {
    const FaceStrains faces = shell_strains(now.system, *group, i, now.state);
    const auto axes = [&](int layer, const Strain& strain) {
      return output::by_cmpflg(model, *group, i, layer, now.state, strain);
    };
    shell.inner_strain = axes(0, faces.lower);
    shell.outer_strain = axes(group->layers() - 1, faces.upper);
  }
  layout.put(to, shell, layers);
}

void put_thick_shell(const Snapshot& now, const Layout& layout, std::size_t e, char* to) {
  thread_local std::vector<output::StressRecord> layers;
  layers.resize(layout.layers());
  const system::System::ElementLocation location = now.system.solid_location[e];
  output::thick_shell_stresses(now.system, now.state, location, layers);
  const system::ElementGroup* group = group_of(now, location);
  const std::size_t i = at(location.element);
  const FaceStrains faces = group != nullptr ? thick_shell_strains(*group, i) : FaceStrains{};
  output::ThickShellRecord record{faces.lower, faces.upper, 0.0};
  if (group != nullptr && group->mass(i) > 0.0)
    record.internal_energy = group->internal_energy(i) *
                             now.system.model.materials[now.system.model.parts[group->part].material].density /
                             group->mass(i);
  layout.put(to, record, layers);
}

void put_solid(const Snapshot& now, const Layout& layout, std::size_t e, char* to) {
  const system::System::ElementLocation location = now.system.solid_location[e];
  output::SolidRecord solid{output::solid_stress(now.system, now.state, location), {}};
  if (const system::ElementGroup* group = group_of(now, location))
    solid.strain = output::by_cmpflg(now.system.model, *group, at(location.element), 0, now.state,
                                     solid_strain(*group, at(location.element)));
  layout.put(to, solid);
}

void put_beam(const Snapshot& now, const Layout& layout, std::size_t e, char* to) {
  thread_local std::vector<output::BeamPointRecord> points;
  points.resize(layout.beam_points());
  const output::BeamRecord beam = output::beam_forces(now.system, now.state, now.system.beam_location[e], points);
  layout.put(to, beam, points);
}

bool beam_is_there(const Snapshot& now, std::size_t e) {
  const system::System::ElementLocation location = now.system.beam_location[e];
  if (group_of(now, location) != nullptr) return is_there(now, location);
  // A weld was taken out before the run; beams of rigid parts have no group either, but are there.
  const model::Model& model = now.system.model;
  const model::Law& law = model.materials[model.parts[model.beams.part[e]].material].law;
  return !std::holds_alternative<kernel::Spotweld>(law) && !std::holds_alternative<kernel::DiscreteBeam>(law);
}

/// Nodes or elements of a stretch, by their place in it.
struct Entities {
  std::function<int(std::size_t)> owner;
  std::function<void(std::size_t, char*)> put;
};

/// `numbers`: of the bricks, or of the thick shells; empty where all solids are.
Entities entities(const Snapshot& now, const Layout& layout, const ResultParcels& parcels, Layout::Stretch stretch,
                  std::span<const model::Index> numbers) {
  const model::Model& model = now.system.model;
  const auto solid = [numbers](std::size_t i) { return numbers.empty() ? i : at(numbers[i]); };
  const auto of = [&](const std::vector<system::System::ElementLocation>& locations, auto number) {
    return [&parcels, &locations, number](std::size_t i) { return parcels.owner(locations[number(i)]); };
  };
  const auto of_solid = of(now.system.solid_location, solid);
  const auto same = [](std::size_t e) { return e; };
  const auto of_beam = of(now.system.beam_location, same), of_shell = of(now.system.shell_location, same);
  switch (stretch) {
    case Layout::coordinates:
    case Layout::velocities:
    case Layout::accelerations:
      return {[&](std::size_t n) { return parcels.owner_of_node(at(now.system.node_of[n])); },
              [&now, stretch](std::size_t n, char* to) { put_node(now, stretch, n, to); }};
    case Layout::solids:
      return {of_solid, [&, solid](std::size_t i, char* to) { put_solid(now, layout, solid(i), to); }};
    case Layout::thick_shells:
      return {of_solid, [&, solid](std::size_t i, char* to) { put_thick_shell(now, layout, solid(i), to); }};
    case Layout::beams: return {of_beam, [&](std::size_t e, char* to) { put_beam(now, layout, e, to); }};
    case Layout::shells: return {of_shell, [&](std::size_t e, char* to) { put_shell(now, layout, e, to); }};
    case Layout::solid_deletion:
    case Layout::thick_deletion:
      return {of_solid, [&, solid](std::size_t i, char* to) {
                const std::size_t e = solid(i);
                Layout::put_deletion(to, model.solids.part[e], is_there(now, now.system.solid_location[e]));
              }};
    case Layout::shell_deletion:
      return {of_shell, [&](std::size_t e, char* to) {
                Layout::put_deletion(to, model.shells.part[e], is_there(now, now.system.shell_location[e]));
              }};
    case Layout::beam_deletion:
      return {of_beam,
              [&](std::size_t e, char* to) { Layout::put_deletion(to, model.beams.part[e], beam_is_there(now, e)); }};
    case Layout::stretches: break;
  }
  return {};
}

std::string totals_of(const Snapshot& now, const Layout& layout) {
  output::D3plotTotals totals;
  totals.time = now.state.time;
  totals.kinetic = now.energy.kinetic;
  totals.internal = now.energy.internal;
  totals.total = now.energy.total();
  for (const PartEnergy& p : now.parts)
    totals.parts.push_back(
        {p.internal, p.kinetic, p.hourglass, p.mass, p.mass > 0.0 ? (1.0 / p.mass) * p.momentum : Vec3d{}});
  totals.velocity = mean_velocity(now.energy, now.parts);
  for (const contact::RigidWall& w : now.components.walls.all()) totals.wall_forces.push_back(w.normal_force());
  std::string words(layout.begin(Layout::coordinates) * sizeof(float), '\0');
  layout.put(words.data(), totals);
  return words;
}

/// Entities [begin, end) of a stretch, each of so many bytes.
std::string piece(const Entities& of, std::size_t begin, std::size_t end, std::size_t size, ResultParcels& parcels) {
  std::vector<std::size_t> own;
  for (std::size_t i = begin; i < end; ++i)
    if (parcels.own(of.owner(i))) own.push_back(i);
  const bool all = parcels.writes();
  std::string words((all ? end - begin : own.size()) * size, '\0');
  parallel_for(own.size(), 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) of.put(own[k], words.data() + (all ? own[k] - begin : k) * size);
  });
  if (!all) {
    constexpr std::size_t at_once = 1 << 14;
    for (std::size_t done = 0; done < words.size(); done += at_once)
      parcels.to_first()(words.data() + done, std::min(at_once, words.size() - done));
    return {};
  }
  for (std::size_t i = begin, next; own.size() < end - begin && i < end; i = next) {
    const int owner = of.owner(i);
    for (next = i + 1; next < end && of.owner(next) == owner;) ++next;
    if (!parcels.own(owner)) parcels.from(owner)(words.data() + (i - begin) * size, (next - i) * size);
  }
  return words;
}

}  // namespace

void put_state(const Snapshot& now, const Layout& layout, ResultParcels& parcels,
               const std::function<void(std::string)>& take) {
  constexpr std::size_t piece_size = 1 << 20;
  const model::Model& model = now.system.model;
  if (parcels.writes()) take(totals_of(now, layout));
  std::array<std::vector<model::Index>, 2> solids;  // bricks, thick shells
  for (std::size_t e = 0; layout.count(Layout::thick_shells) > 0 && e < model.solids.size(); ++e)
    solids[model.has_thick_shells(model.solids.part[e]) ? 1 : 0].push_back(static_cast<model::Index>(e));
  for (int s = 0; s < Layout::stretches; ++s) {
    const auto stretch = static_cast<Layout::Stretch>(s);
    const std::size_t size = layout.words(stretch) * sizeof(float), count = layout.count(stretch);
    if (size == 0) continue;
    const bool thick = stretch == Layout::thick_shells || stretch == Layout::thick_deletion;
    const Entities of = entities(now, layout, parcels, stretch, solids[thick ? 1 : 0]);
    const std::size_t at_a_time = std::max<std::size_t>(1, piece_size / size);
    for (std::size_t begin = 0; begin < count; begin += at_a_time) {
      std::string words = piece(of, begin, std::min(count, begin + at_a_time), size, parcels);
      if (parcels.writes()) take(std::move(words));
    }
  }
}

}  // namespace nugget::impact
