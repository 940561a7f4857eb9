// SPDX-License-Identifier: Apache-2.0
#include "report/vtk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "base/index.hpp"
#include "output/d3plot_reader.hpp"
#include "output/history_reader.hpp"
#include "output/vtu_file.hpp"
#include "report/colour_field.hpp"
#include "report/quantity.hpp"
#include "report/shown_welds.hpp"
#include "report/stress.hpp"
#include "report/weld_page.hpp"

namespace nugget::report {
namespace {

namespace fs = std::filesystem;
using output::D3plotGeometry;
using output::D3plotReader;
using output::D3plotState;
using output::VtuGrid;

// VTK's numbers of cells.
constexpr std::uint8_t vertex = 1, line = 3, triangle = 5, quadrilateral = 9, tetrahedron = 10, hexahedron = 12,
                       wedge = 13, pyramid = 14;
constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

void add_shell(VtuGrid& grid, const std::array<int, 4>& n) {
  if (n[2] == n[3])
    grid.add_cell(triangle, std::array{n[0], n[1], n[2]});
  else
    grid.add_cell(quadrilateral, n);
}

/// Bricks, and what d3plot writes as bricks with repeated nodes.
void add_solid(VtuGrid& grid, const std::array<int, 8>& n) {
  if (n[3] == n[4] && n[4] == n[5] && n[5] == n[6] && n[6] == n[7])
    grid.add_cell(tetrahedron, std::array{n[0], n[1], n[2], n[3]});
  else if (n[4] == n[5] && n[5] == n[6] && n[6] == n[7])
    grid.add_cell(pyramid, std::array{n[0], n[1], n[2], n[3], n[4]});
  else if (n[4] == n[5] && n[6] == n[7])  // triangles 1 2 5 and 4 3 6
    grid.add_cell(wedge, std::array{n[0], n[1], n[4], n[3], n[2], n[6]});
  else
    grid.add_cell(hexahedron, n);
}

/// Fields of cells, in the order in which cells are added.
class CellFields {
 public:
  void begin_cell() { ++cells_; }
  void put(const std::string& name, double value) { put(name, {value}); }
  void put(const std::string& name, std::initializer_list<double> values) { put_all(name, values); }
  template <class Values>
  void put_all(const std::string& name, const Values& values) {
    Field& field = fields_[name];
    field.components = values.size();
    field.values.resize((cells_ - 1) * values.size(), no_value);
    for (const double value : values) field.values.push_back(static_cast<float>(value));
  }
  void put_id(const std::string& name, int value) { ids_[name].push_back(value); }
  void move_to(std::vector<output::VtuArray>& arrays) {
    for (auto& [name, values] : ids_) arrays.push_back({name, 1, std::move(values)});
    for (auto& [name, field] : fields_) {
      field.values.resize(cells_ * field.components, no_value);
      arrays.push_back({name, static_cast<int>(field.components), std::move(field.values)});
    }
  }

 private:
  struct Field {
    std::size_t components = 1;
    std::vector<float> values;
  };
  std::size_t cells_ = 0;
  std::map<std::string, Field> fields_;
  std::map<std::string, std::vector<std::int32_t>> ids_;
};

void put_solid(CellFields& fields, const output::SolidRecord& r, const D3plotGeometry& g) {
  fields.put_all("stress", r.stress);
  fields.put("von_mises_stress", von_mises(r.stress));
  fields.put("plastic_strain", r.plastic_strain);
  if (g.solid_histories > 0) fields.put("damage", damage_of(r));
  if (g.strains) fields.put_all("strain", r.strain);
}

void put_shell(CellFields& fields, const output::ShellRecord& r, std::span<const output::StressRecord> layers,
               const D3plotGeometry& g) {
  double plastic = 0.0, equivalent = 0.0, damage = 0.0;
  std::array<double, 6> mean{};
  for (const output::StressRecord& layer : layers) {
    plastic = std::max(plastic, layer.plastic_strain);
    equivalent = std::max(equivalent, von_mises(layer.stress));
    damage = std::max(damage, damage_of(layer));
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += layer.stress[i] / static_cast<double>(layers.size());
  }
  fields.put_all("stress", mean);
  fields.put("von_mises_stress", equivalent);
  fields.put("plastic_strain", plastic);
  if (g.shell_histories > 0) fields.put("damage", damage);
  fields.put("thickness", r.thickness);
  fields.put("internal_energy_density", r.internal_energy);
  fields.put("membrane_forces", {r.nx, r.ny, r.nxy});
  fields.put("bending_moments", {r.mx, r.my, r.mxy});
  fields.put("transverse_shear", {r.qx, r.qy, 0.0});
  if (g.strains) {
    fields.put_all("strain_inner", r.inner_strain);
    fields.put_all("strain_outer", r.outer_strain);
  }
}

void put_beam(CellFields& fields, const output::BeamRecord& r) {
  fields.put("beam_axial_force", r.axial);
  fields.put("beam_shear_forces", {r.shear_s, r.shear_t, 0.0});
  fields.put("beam_moments", {r.moment_s, r.moment_t, r.torsion});
}

std::vector<float> vectors(const std::vector<Vec3d>& all) {
  std::vector<float> values;
  values.reserve(3 * all.size());
  for (const Vec3d& v : all)
    for (const double value : {v.x, v.y, v.z}) values.push_back(static_cast<float>(value));
  return values;
}

VtuGrid grid_of(const D3plotGeometry& g, const D3plotState& s) {
  const bool modes = g.family == D3plotGeometry::Family::d3eigv;
  VtuGrid grid;
  grid.points = s.x;
  std::vector<Vec3d> displacement(s.x.size());
  for (std::size_t i = 0; i < s.x.size(); ++i) displacement[i] = s.x[i] - g.x[i];
  if (modes) grid.points = g.x;  // warp by `shape` to see it
  grid.of_points.push_back({"node", 1, std::vector<std::int32_t>(g.node_ids.begin(), g.node_ids.end())});
  grid.of_points.push_back({modes ? "shape" : "displacement", 3, vectors(displacement)});
  if (!s.v.empty()) grid.of_points.push_back({"velocity", 3, vectors(s.v)});
  if (!s.a.empty()) grid.of_points.push_back({"acceleration", 3, vectors(s.a)});
  CellFields fields;
  const auto begin = [&](int id, int part) {
    fields.begin_cell();
    fields.put_id("element", id);
    fields.put_id("part", g.parts[at(part)].id);
  };
  for (std::size_t e = 0; e < g.solids.size(); ++e) {
    if (s.solid_alive[e] == 0) continue;
    add_solid(grid, g.solids[e].nodes);
    begin(g.solids[e].id, g.solids[e].part);
    if (!modes) put_solid(fields, s.solids[e], g);
  }
  for (std::size_t e = 0; e < g.shells.size(); ++e) {
    if (s.shell_alive[e] == 0) continue;
    add_shell(grid, g.shells[e].nodes);
    begin(g.shells[e].id, g.shells[e].part);
    if (!modes) put_shell(fields, s.shells[e], std::span(s.shell_layers).subspan(e * at(g.layers), at(g.layers)), g);
  }
  for (std::size_t e = 0; e < g.beams.size(); ++e) {
    if (s.beam_alive[e] == 0) continue;
    grid.add_cell(line, g.beams[e].nodes);
    begin(g.beams[e].id, g.beams[e].part);
    if (!modes) put_beam(fields, s.beams[e]);
  }
  fields.move_to(grid.of_cells);
  return grid;
}

// ---- welds

/// swforc by weld.
class WeldHistories {
 public:
  explicit WeldHistories(const fs::path& directory) {
    constexpr std::string_view file = "swforc";
    std::vector<output::HistoryRecord> found = output::read_histories(directory, {&file, 1});
    if (!found.empty()) record_ = std::move(found[0]);
    for (const output::Channel& channel : record_.channels) of_[channel.entity].push_back(&channel);
  }
  /// What it says at the last time up to `time`.
  void put(CellFields& fields, int weld, double time) const {
    constexpr double single_precision = 1e-6;  // of the times in d3plot
    const auto after = std::upper_bound(record_.times.begin(), record_.times.end(), time * (1.0 + single_precision));
    const auto channels = of_.find(fmt::format("weld {}", weld));
    if (after == record_.times.begin() || channels == of_.end()) return;
    const auto i = static_cast<std::size_t>(after - record_.times.begin()) - 1;
    for (const output::Channel* channel : channels->second) fields.put(channel->quantity, channel->values[i]);
  }

 private:
  output::HistoryRecord record_;
  std::map<std::string, std::vector<const output::Channel*>> of_;
};

/// A line from the first end of a weld beam to the second; a point in the middle of what has more nodes.
VtuGrid grid_of_welds(const std::vector<ShownWeld>& welds, const D3plotState& s, const WeldHistories& histories) {
  VtuGrid grid;
  CellFields fields;
  for (const ShownWeld& weld : welds) {
    const auto first = static_cast<std::int64_t>(grid.points.size());
    if (weld.nodes.size() == 2) {
      for (const std::size_t node : weld.nodes) grid.points.push_back(s.x[node]);
      grid.add_cell(line, std::array{first, first + 1});
    } else {
      grid.points.push_back(middle_of(weld.nodes, s.x));
      grid.add_cell(vertex, std::array{first});
    }
    fields.begin_cell();
    fields.put_id("weld", weld.id);
    fields.put_id("tied", weld.tied ? 1 : 0);
    fields.put_id("failed", weld.has_failed_by(s.time) ? 1 : 0);
    fields.put("diameter", weld.diameter);
    histories.put(fields, weld.id, s.time);
  }
  fields.move_to(grid.of_cells);
  return grid;
}

/// `.vtu` of each state and the `.pvd` that lists them.
std::vector<std::string> write_family(const fs::path& directory, const fs::path& target, const RunData& run,
                                      D3plotGeometry::Family family) {
  const D3plotReader file(directory, family);
  const bool modes = family == D3plotGeometry::Family::d3eigv;
  const std::string stem = modes ? "mode" : "state";
  const std::vector<ShownWeld> welds = modes ? std::vector<ShownWeld>{} : shown_welds(run, file.geometry());
  const WeldHistories histories(directory);
  std::vector<std::pair<double, std::string>> states, of_welds;
  D3plotState s;
  for (std::size_t i = 0; i < file.times().size(); ++i) {
    file.read(i, s);
    states.emplace_back(s.time, fmt::format("{}{:04}.vtu", stem, i + 1));
    output::write_vtu(target / states.back().second, grid_of(file.geometry(), s));
    if (welds.empty()) continue;
    of_welds.emplace_back(s.time, fmt::format("welds{:04}.vtu", i + 1));
    output::write_vtu(target / of_welds.back().second, grid_of_welds(welds, s, histories));
  }
  std::vector<std::string> written{stem + "s.pvd"};
  output::write_pvd(target / written[0], states);
  if (!of_welds.empty()) {
    written.emplace_back("welds.pvd");
    output::write_pvd(target / written[1], of_welds);
  }
  return written;
}

}  // namespace

std::vector<std::string> write_vtk(const fs::path& directory, const fs::path& target, const RunData& run) {
  std::vector<std::string> written;
  for (const auto& [file, family] :
       {std::pair{"d3plot", D3plotGeometry::Family::d3plot}, std::pair{"d3eigv", D3plotGeometry::Family::d3eigv}}) {
    if (!fs::exists(directory / file)) continue;
    const std::vector<std::string> of_family = write_family(directory, target, run, family);
    written.insert(written.end(), of_family.begin(), of_family.end());
  }
  if (written.empty())
    throw std::runtime_error(fmt::format(
        "{} has neither d3plot nor d3eigv: *DATABASE_BINARY_D3PLOT asks for states, nugget modes leaves shapes",
        directory.string()));
  return written;
}

}  // namespace nugget::report
