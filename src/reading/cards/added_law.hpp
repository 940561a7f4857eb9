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
void take_points_to_delete(Builder& builder, const deck::Entry& numfip, kernel::LawComponents& law, bool said_before);

/// The curve, or the table where one may stand, of this id, whose values must be above 0; not given and a finding where
/// there is none. After Phase::curves.
CurveTable positive_curves(Builder& builder, const deck::Entry& field, int id, bool may_be_table);

/// Fields of GISSMO on the cards of two keywords.
namespace gissmo_field {
inline constexpr IntegerField lcsdg = id(
    "lcsdg", IdSpace::function, 0, "curve: plastic strain at fracture over triaxiality; a table: for Lode parameters");
inline constexpr RealField ecrit =
    or_negative(real("ecrit", dimension::number, 0, any_value,
                     "plastic strain at instability; below 0: curve over triaxiality, or table; 0: DCRIT holds"),
                IdSpace::function);
inline constexpr RealField dmgexp =
    real("dmgexp", dimension::number, 1, above_zero(), "exponent of the growth of damage");
inline constexpr RealField dcrit =
    real("dcrit", dimension::number, 0, between(0, 1), "damage from which on stress is lost, without ECRIT");
inline constexpr RealField fadexp =
    or_negative(real("fadexp", dimension::number, 1, any_value,
                     "exponent of the loss of stress; below 0: curve over element size, or table of triaxialities"),
                IdSpace::function);
inline constexpr IntegerField lcregd =
    or_negative(id("lcregd", IdSpace::function, 0,
                   "curve: factor on the strain at fracture over element size; below 0: table of triaxialities"),
                IdSpace::function);
inline constexpr RealField refsz =
    real("refsz", dimension::length, 0, any_value, "element size of a further output, which is not written");
inline constexpr IntegerField lcsrs = or_negative(
    id("lcsrs", IdSpace::function, 0,
       "curve: factor on the strain at fracture and at instability over the rate; below 0: of fracture only"),
    IdSpace::function);
inline constexpr RealField shrf =
    real("shrf", dimension::number, 0, any_value, "share of the effect of LCREGD that is missing in shear");
inline constexpr RealField biaxf =
    real("biaxf", dimension::number, 0, any_value, "share of the effect of LCREGD that is missing in biaxial tension");
inline constexpr IntegerField lcdlim = integer("lcdlim", 0, only(0), "curve of greatest damage over triaxiality");
inline constexpr RealField midfail =
    real("midfail", dimension::number, 0, only(0), "instability at the mid-plane only");
}  // namespace gissmo_field

/// What these fields say.
struct GissmoLawCard {
  int lcsdg = 0;
  double ecrit = 0.0, dmgexp = 0.0, dcrit = 0.0, fadexp = 0.0;
  int lcregd = 0;
};
struct GissmoScaleCard {
  double refsz = 0.0;
  int lcsrs = 0;
  double shrf = 0.0, biaxf = 0.0;
};
/// The same fields as they stand on either keyword's cards.
struct GissmoEntries {
  deck::Entry type, lcsdg, ecrit, dmgexp, dcrit, fadexp, lcregd, lcsrs, shrf, biaxf;  ///< `type`: DTYP, DMGTYP
};
template <class Law, class Scales>
GissmoEntries gissmo_entries(const deck::Entry& type, const deck::RowOf<Law>& law, const deck::RowOf<Scales>& scales) {
  GissmoEntries entries;
  entries.type = type;
  entries.lcsdg = law[&GissmoLawCard::lcsdg];
  entries.ecrit = law[&GissmoLawCard::ecrit];
  entries.dmgexp = law[&GissmoLawCard::dmgexp];
  entries.dcrit = law[&GissmoLawCard::dcrit];
  entries.fadexp = law[&GissmoLawCard::fadexp];
  entries.lcregd = law[&GissmoLawCard::lcregd];
  entries.lcsrs = scales[&GissmoScaleCard::lcsrs];
  entries.shrf = scales[&GissmoScaleCard::shrf];
  entries.biaxf = scales[&GissmoScaleCard::biaxf];
  return entries;
}

/// The damage that the fields ask for, of a material with this flow; nullopt and findings where they cannot be obeyed.
/// After Phase::curves.
std::optional<kernel::Gissmo> gissmo(Builder& builder, const GissmoEntries& entries, const kernel::Flow& flow);

}  // namespace nugget::reading
