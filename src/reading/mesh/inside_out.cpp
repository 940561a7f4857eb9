// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "model/lumped_mass.hpp"
#include "reading/builder/builder.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

/// The same solid numbered the other way round: as a mirror between its sides 1-2 and 3-4 would.
void turn(std::array<Index, 8>& n) {
  if (n[3] == n[4] && n[3] == n[5] && n[3] == n[6] && n[3] == n[7]) return std::swap(n[0], n[1]);  // a tetrahedron
  for (std::size_t a = 0; a < 8; a += 2) std::swap(n[a], n[a + 1]);
}

}  // namespace

void turn_parts_inside_out(Builder& b) {
  Solids& solids = b.model.solids;
  std::vector<long> count(b.model.parts.size(), 0);
  std::vector<char> others(b.model.parts.size(), 0);  // some of its solids has a volume, or is not looked at
  for (std::size_t e = 0; e < solids.size(); ++e) {
    const auto part = at(solids.part[e]);
    const bool thick = e < b.thick_solids.size() && b.thick_solids[e];
    if (thick || solids.quadratic(e) || !(solid_volume(b.model, e) < 0.0))
      others[part] = 1;
    else
      ++count[part];
  }
  const auto whole = [&](std::size_t part) { return count[part] > 1 && others[part] == 0; };
  for (std::size_t p = 0; p < b.model.parts.size(); ++p)
    if (whole(p))
      b.findings.warning(b.model.parts[p].place, "*PART",
                         fmt::format("part {}: all of its {} solids are numbered inside out, as in a mesh that was "
                                     "mirrored; they are turned, and material axes by their nodes (AOPT 0) with them",
                                     b.model.parts[p].id, count[p]),
                         "number nodes 1-4 around the bottom and 5-8 above them, seen from inside right-handed");
  for (std::size_t e = 0; e < solids.size(); ++e)
    if (whole(at(solids.part[e]))) turn(solids.node[e]);
}

}  // namespace nugget::reading
