// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/mode_files.hpp"

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "nvh/matrices/stresses.hpp"
#include "output/eigout.hpp"
#include "output/model_geometry.hpp"

namespace nugget::nvh {
namespace {

void write_shapes(const std::filesystem::path& directory, const Matrices& m, const Modes& modes) {
  output::D3plotGeometry geometry = output::d3plot_geometry(m.system);
  geometry.family = output::D3plotGeometry::Family::d3eigv;
  geometry.rigid_walls = 0;
  // Readers take thick shells to have what shells have.
  geometry.shell_stresses = m.system.model.implicit.modal_stresses || !geometry.thick.empty();
  output::D3plotState state = output::unstressed_state(m.system, geometry);
  output::D3plot file(directory, std::move(geometry));
  for (std::size_t mode = 0; mode < modes.eigenvalue.size(); ++mode) {
    state.time = modes.frequency(mode);
    parallel_for(state.x.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const SixDof u = m.equations.motion(m.system.node_of[n], modes.shape[mode]);
        state.x[n] = m.system.ties.x[n] + Vec3d{u[0], u[1], u[2]};
      }
    });
    if (m.system.model.implicit.modal_stresses) {
      std::vector<SixDof> motion(m.system.all_nodes());
      for (std::size_t k = 0; k < motion.size(); ++k)
        motion[k] = m.equations.motion(static_cast<int>(k), modes.shape[mode]);
      ElasticStresses(m.system, motion).fill(1.0, state);
    }
    file.write(state);
  }
}

void write_energy(const std::filesystem::path& directory, const Matrices& m, const Modes& modes,
                  const EnergyShares& shares) {
  std::string text = "kind,id";
  for (std::size_t mode = 0; mode < modes.eigenvalue.size(); ++mode) text += fmt::format(",mode {}", mode + 1);
  const auto row = [&](const char* kind, int id, const Columns& table, std::size_t i) {
    text += fmt::format("\n{},{}", kind, id);
    for (std::size_t mode = 0; mode < table.count; ++mode) text += fmt::format(",{:.6g}", table[mode][i]);
  };
  for (std::size_t p = 0; p < shares.part.rows; ++p) row("part", m.system.model.parts[p].id, shares.part, p);
  for (std::size_t w = 0; w < shares.weld.rows; ++w) row("weld", m.system.ties.welds[w].id, shares.weld, w);
  output::write_whole_file(directory / "mode_energy.csv", text + '\n');
}

}  // namespace

Columns nodal_shapes(const Matrices& m, const Modes& modes) {
  const std::size_t nodes = m.system.nodes;
  Columns shapes(3 * nodes, modes.eigenvalue.size());
  parallel_for(shapes.count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t mode = begin; mode < end; ++mode)
      for (std::size_t n = 0; n < nodes; ++n) {
        const SixDof u = m.equations.motion(m.system.node_of[n], modes.shape[mode]);
        for (std::size_t i = 0; i < 3; ++i) shapes[mode][3 * n + i] = u[i];
      }
  });
  return shapes;
}

void write_modes(const std::filesystem::path& directory, const output::Header& header, const Matrices& m,
                 const Modes& modes, const EnergyShares& shares) {
  write_shapes(directory, m, modes);
  std::vector<output::EigoutMode> rows;
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) {
    output::EigoutMode row{modes.eigenvalue[i], modes.participation[i], {}};
    for (std::size_t k = 0; k < 6; ++k) row.effective_mass[k] = row.participation[k] * row.participation[k];
    rows.push_back(row);
  }
  output::write_eigout(directory / "eigout", header, rows, modes.total);
  write_energy(directory, m, modes, shares);
}

}  // namespace nugget::nvh
