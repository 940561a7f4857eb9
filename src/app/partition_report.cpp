// SPDX-License-Identifier: Apache-2.0
#include "app/partition_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "app/run_log.hpp"
#include "base/index.hpp"
#include "output/vtu_file.hpp"

namespace nugget::app {
namespace {

/// VTK's number of a cell between the nodes of an element.
std::uint8_t cell_type(const system::ElementGroup& group) {
  const bool solid = group.kind == model::ElementKind::solid;
  switch (group.nodes_per_element) {
    case 1: return 1;
    case 2: return 3;
    case 3: return 5;
    case 4: return solid ? 10 : 9;
    case 6: return 13;
    case 10: return 24;
    default: return 12;
  }
}

void write_picture(const std::filesystem::path& path, const system::System& system,
                   const system::Partition& partition) {
  output::VtuGrid grid;
  grid.points = system.ties.x;
  std::vector<std::int32_t> rank, id, part;
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const system::ElementGroup& group = *system.groups[g];
    for (std::size_t e = 0; e < group.size(); ++e) {
      const system::ElementNodes nodes = group.nodes(e);
      std::vector<int> corners;
      corners.reserve(at(group.nodes_per_element));
      for (int a = 0; a < group.nodes_per_element; ++a) corners.push_back(system.model_node[nodes[a]]);
      if (corners.size() == 6)  // one triangle, then the other
        corners = {corners[0], corners[1], corners[4], corners[3], corners[2], corners[5]};
      grid.add_cell(cell_type(group), corners);
      rank.push_back(partition.of_element(static_cast<int>(g), e));
      id.push_back(system.element_id(group, group.element[e]));
      part.push_back(system.model.parts[group.part].id);
    }
  }
  grid.of_cells = {{"rank", 1, std::move(rank)}, {"element", 1, std::move(id)}, {"part", 1, std::move(part)}};
  output::write_vtu(path, grid);
}

}  // namespace

std::string report_partition(const std::filesystem::path& directory, impact::Simulation& run, int ranks) {
  const system::System& system = run.system();
  const system::Partition partition = run.partition(ranks, run.contact_costs(nullptr));
  std::string s =
      fmt::format("Elements on {} ranks (partition.vtu shows them)\n\n", ranks) + log_computed_by_all(run, partition);
  if (const std::size_t all = partition.elements_of_everyone(system); all > 0)
    s += fmt::format(
        " {} elements are computed by every rank: springs, and those that others look at in each cycle\n\n", all);
  s += " rank  elements     nodes    shared  expected load  of contact  neighbours\n";
  const std::vector<system::Partition::Share> shares = partition.shares(system, run.followed_by_all());
  const auto listed = [](const std::vector<int>& neighbours) {
    constexpr std::size_t on_a_line = 12;
    return neighbours.size() > on_a_line ? fmt::format("{} ranks", neighbours.size())
                                         : fmt::format("{}", fmt::join(neighbours, " "));
  };
  for (std::size_t r = 0; r < shares.size(); ++r)
    s += fmt::format(" {:>4} {:>9} {:>9} {:>9} {:>14.3f} {:>11.3f}  {}\n", r, shares[r].elements, shares[r].nodes,
                     shares[r].shared_nodes, shares[r].cost, shares[r].contact, listed(shares[r].neighbours));
  write_picture(directory / "partition.vtu", system, partition);
  return s + "\n";
}

}  // namespace nugget::app
