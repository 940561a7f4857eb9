// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

// Gas that leaks through fabric: FLC, FAC, ELA, FVOPT, X0 and X1 of *MAT_FABRIC and *MAT_ADD_AIRBAG_POROSITY_LEAKAGE.
namespace nugget::reading {

/// The fields of one card.
struct LeakageFields {
  deck::Entry flc{}, fac{}, ela{}, fvopt{}, x0{}, x1{};
  deck::Entry a0ref{};               ///< A0REF; of the card that has none an entry of 0
  bool moves_curve_numbers = false;  ///< the file is one whose numbers of curves are moved: so are numbers below 0
};

/// Remembers what a material leaks by, in Phase::parts, and refuses what is not built of it; `material`: its place, or
/// none and `mid`, its number.
void add_leakage(Builder& b, const LeakageFields& fields, Index material, const deck::Entry& mid);

/// The fabric among the faces of a gas that leaks, with `option` (OPT of the gas) where the fabric has no FVOPT.
std::vector<PorousFabric> leaking_faces(Builder& b, const std::vector<Segment>& faces, const deck::Entry& option);

/// In the end: a warning for each material that would leak and whose shells enclose no gas that leaks through fabric.
void report_unused_leakage(Builder& b);

}  // namespace nugget::reading
