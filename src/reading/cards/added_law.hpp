// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "kernel/law/law_components.hpp"
#include "reading/builder/builder.hpp"

// What *MAT_ADD_... cards add to a law.
namespace nugget::reading {

/// The law as one put together at run time; nothing for those that cannot be: rigid and null materials, welds, springs,
/// discrete beams and adhesive.
std::optional<kernel::LawComponents> components_of(const Law& law);

/// Takes NUMFIP of a row into the law; an error where it differs from what another card has said, if one has.
void take_points_to_delete(Builder& builder, const deck::Row& row, kernel::LawComponents& law, bool said_before);

/// Fields of GISSMO on the cards of two keywords.
namespace gissmo_field {
inline constexpr Field lcsdg = id("lcsdg", IdSpace::function, 0,
                                  "curve: plastic strain at fracture over triaxiality; a table: for Lode parameters");
inline constexpr Field ecrit =
    or_negative(real("ecrit", dimension::number, 0, any_value,
                     "plastic strain at instability; below 0: curve over triaxiality, or table; 0: DCRIT holds"),
                IdSpace::function);
inline constexpr Field dmgexp = real("dmgexp", dimension::number, 1, above_zero(), "exponent of the growth of damage");
inline constexpr Field dcrit =
    real("dcrit", dimension::number, 0, between(0, 1), "damage from which on stress is lost, without ECRIT");
inline constexpr Field fadexp =
    or_negative(real("fadexp", dimension::number, 1, any_value,
                     "exponent of the loss of stress; below 0: curve over element size, or table of triaxialities"),
                IdSpace::function);
inline constexpr Field lcregd =
    or_negative(id("lcregd", IdSpace::function, 0,
                   "curve: factor on the strain at fracture over element size; below 0: table of triaxialities"),
                IdSpace::function);
inline constexpr Field refsz =
    real("refsz", dimension::length, 0, any_value, "element size of a further output, which is not written");
inline constexpr Field lcsrs = or_negative(
    id("lcsrs", IdSpace::function, 0,
       "curve: factor on the strain at fracture and at instability over the rate; below 0: of fracture only"),
    IdSpace::function);
inline constexpr Field shrf =
    real("shrf", dimension::number, 0, any_value, "share of the effect of LCREGD that is missing in shear");
inline constexpr Field biaxf =
    real("biaxf", dimension::number, 0, any_value, "share of the effect of LCREGD that is missing in biaxial tension");
inline constexpr Field lcdlim = integer("lcdlim", 0, only(0), "curve of greatest damage over triaxiality");
inline constexpr Field midfail = real("midfail", dimension::number, 0, only(0), "instability at the mid-plane only");
}  // namespace gissmo_field

/// The rows that hold the fields of GISSMO.
struct GissmoRows {
  const deck::Row &type, &law, &scales;
  std::string_view type_field;  ///< DTYP, DMGTYP
};

/// The damage that the rows ask for, of a material with this flow; nullopt and findings where they cannot be obeyed.
/// After Phase::curves.
std::optional<kernel::Gissmo> gissmo(Builder& builder, const GissmoRows& rows, const kernel::Flow& flow);

}  // namespace nugget::reading
