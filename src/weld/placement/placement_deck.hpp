// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weld/placement/placement.hpp"
#include "weld/placement/weld_form.hpp"

namespace nugget::weld {

/// Fields of *MAT_SPOTWELD, or of an interpolation spot weld, by their names (`sigy`, `nrr`), for one class of spots.
using WeldFields = std::map<std::string, double>;

/// What is given of them.
struct GivenMaterial {
  std::map<std::string, WeldFields> fields;  ///< by class; the class "" holds for all
  /// Diameter of the weld that the strengths NRR to MTT are those of; 0: they hold for every weld as they are [length]
  double strength_diameter = 0.0;
};

struct PlacementDeck {
  std::string text;  ///< the deck
  std::size_t spots = 0, elements = 0;
};

/// A deck that includes `included` (as written after *INCLUDE) and adds the welds, with all that a run needs of them:
/// nodes, elements, a part for each class and diameter, sections, a material for each class, hourglass control of
/// bricks, sets, one *CONTACT_SPOTWELD, *DATABASE_SWFORC unless the model has it. Ids begin above the model's own.
/// Beams of one stack share the nodes in its middle sheets; bricks stand on the sheets with every corner. Interpolation
/// spot welds are a node between each two sheets and a *CONSTRAINED_INTERPOLATION_SPOTWELD for each class, diameter and
/// pair of parts. Density and stiffness default to steel's in the units of the model, yield to 500 MPa, hardening to
/// 1000 MPa. With a strength diameter D a weld of diameter d has the given NRR, NRS, NRT by (d/D)^2 and MRR, MSS, MTT
/// by (d/D)^3, in a material for each class and diameter.
///
/// Findings: fields without a default where the units are not known, bricks that reach over the edge of a sheet (left
/// out), ids too large for their columns; of which diameters the given strengths are (a warning where welds of several
/// diameters have the same).
PlacementDeck write_placement(const model::Model& model, const Sheets& sheets, const std::vector<Spot>& spots,
                              WeldForm form, const GivenMaterial& given, const std::string& included,
                              Findings& findings);

/// Names of the fields that may be given, in the order of the cards.
const std::vector<std::string>& weld_fields(WeldForm form);
/// How a strength grows with the diameter: 2 of a force (`nrr`, `nrs`, `nrt`), 3 of a moment (`mrr`, `mss`, `mtt`); 0
/// of every other field.
int strength_power(const std::string& field);

}  // namespace nugget::weld
