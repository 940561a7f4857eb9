// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weld/placement/placement.hpp"

namespace nugget::weld {

/// What welds are modelled as.
enum class WeldForm { beam, solid, solid4, solid8 };

/// Fields of *MAT_SPOTWELD by their names (`sigy`, `nrr`), for one class of spots.
using WeldFields = std::map<std::string, double>;

struct PlacementDeck {
  std::string text;  ///< the deck
  std::size_t spots = 0, elements = 0;
};

/// A deck that includes `included` (as written after *INCLUDE) and adds the welds, with all that a run needs of them:
/// nodes, elements, a part for each class and diameter, sections, a material for each class, hourglass control of
/// bricks, sets, one *CONTACT_SPOTWELD, *DATABASE_SWFORC unless the model has it. Ids begin above the model's own.
/// Beams of one stack share the nodes in its middle sheets; bricks stand on the sheets with every corner. `fields` by
/// class; the class "" holds for all. Density and stiffness default to steel's in the units of the model, yield to 500
/// MPa, hardening to 1000 MPa.
///
/// Findings: fields without a default where the units are not known, bricks that reach over the edge of a sheet (left
/// out), ids too large for their columns.
PlacementDeck write_placement(const model::Model& model, const Sheets& sheets, const std::vector<Spot>& spots,
                              WeldForm form, const std::map<std::string, WeldFields>& fields,
                              const std::string& included, Findings& findings);

/// Names of the fields that may be given, in the order of the cards.
const std::vector<std::string>& weld_fields();

}  // namespace nugget::weld
