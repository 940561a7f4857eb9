// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <optional>

#include "kernel/law/law_cards.hpp"
#include "kernel/law/material_axes.hpp"
#include "kernel/law/point_damage.hpp"
#include "reading/builder/builder.hpp"
#include "reading/builder/common_cards.hpp"

// What the cards of all materials begin with.
namespace nugget::reading {

/// The first card of a material, as far as all have it.
struct MaterialCard {
  int mid = 0;
  double ro = 0.0;
};
inline constexpr IntegerField material_id = id("mid", IdSpace::material, required, "material id");
inline constexpr RealField density = real("ro", dimension::density, required, above_zero(), "density");
using kernel::law_field::poisson;
using kernel::law_field::young;

// Of metals. Whatever VP says, the yield stress goes by the rate of the plastic strain, found together with the stress:
// a stress that leaps with the total strain rate is a dashpot for which the elements' step is too long
// (docs/decisions/0041).
inline constexpr RealField vp = real("vp", dimension::number, 0, between(0, 1),
                                     "rate of 0: the total strain, computed as 1; 1: the plastic strain");
inline constexpr RealField vp_of_curves = real(
    "vp", dimension::number, 0, between(-1, 4),
    "rate of 0: the total strain, -1: its deviator, computed as 1; 1: the plastic strain; 3, 4: as 0, 1, filtered");
inline constexpr RealField tdel =
    real("tdel", dimension::time, 0, at_least(0), "smallest time step of an element before it is deleted; 0: none");
inline constexpr RealField numint =
    real("numint", dimension::number, 0, any_value,
         "failed points that delete a shell; 0: all; below 0: percentage of its layers");

/// LS-DYNA's "no failure" values are 0 and numbers of 1e20 and more; ours is 0.
double failure_value(double written);

/// The same for plastic strains, of which 1e12 and more are none.
double plastic_strain_at_failure(double written);

/// Damage that begins at a plastic strain `onset` and is 1 at `rupture`, or grows by the curve in `lcdm`:
/// none where the strains are as large as LS-DYNA's for none. A curve together with a rupture is refused: the manual
/// leaves open which counts. Without an onset all is lost at the rupture at once.
std::optional<kernel::PlasticDamage> plastic_damage(Builder& builder, const deck::Entry& onset,
                                                    const deck::Entry& rupture, const deck::Entry& lcdm);

/// The id of a coordinate system that stands in a field for real numbers, with the offset of its include.
int system_id(const deck::Block& block, double written);

/// Fields of AOPT, which many materials have in other places of their cards.
namespace aopt {
inline constexpr RealField option =
    or_negative(real("aopt", dimension::number, 0, any_value,
                     "material axes: 0 by nodes, 2 by vectors a and d, 3 by v x normal, -id by a coordinate system"),
                IdSpace::define);
inline constexpr RealField xp =
    real("xp", dimension::length, 0, any_value, "point of AOPT 1 and 4, which are not built");
inline constexpr RealField yp = real("yp", dimension::length, 0, any_value, "the same");
inline constexpr RealField zp = real("zp", dimension::length, 0, any_value, "the same");
inline constexpr RealField a1 = real("a1", dimension::number, 0, any_value, "vector a of AOPT 2, x");
inline constexpr RealField a2 = real("a2", dimension::number, 0, any_value, "y");
inline constexpr RealField a3 = real("a3", dimension::number, 0, any_value, "z");
inline constexpr RealField d1 = real("d1", dimension::number, 0, any_value, "vector d of AOPT 2, x");
inline constexpr RealField d2 = real("d2", dimension::number, 0, any_value, "y");
inline constexpr RealField d3 = real("d3", dimension::number, 0, any_value, "z");
inline constexpr RealField v1 = real("v1", dimension::number, 0, any_value, "vector v of AOPT 3, x");
inline constexpr RealField v2 = real("v2", dimension::number, 0, any_value, "y");
inline constexpr RealField v3 = real("v3", dimension::number, 0, any_value, "z");
inline constexpr IntegerField macf = integer("macf", 1, between(0, 1), "exchange of axes: 1, none");
}  // namespace aopt

/// What AOPT needs, on whichever of a material's cards it stands: the fields of namespace aopt.
struct AxesCards {
  double aopt = 0.0;
  double a1 = 0.0, a2 = 0.0, a3 = 0.0, d1 = 0.0, d2 = 0.0, d3 = 0.0, v1 = 0.0, v2 = 0.0, v3 = 0.0;
};
/// The card that begins with V1 to D3, and what a material has behind them.
template <class Cards>
CardOf<Cards> axes_vectors_card(std::initializer_list<FieldOf<Cards>> rest) {
  return with_rest(CardOf<Cards>{{&AxesCards::v1, aopt::v1},
                                 {&AxesCards::v2, aopt::v2},
                                 {&AxesCards::v3, aopt::v3},
                                 {&AxesCards::d1, aopt::d1},
                                 {&AxesCards::d2, aopt::d2},
                                 {&AxesCards::d3, aopt::d3}},
                   rest);
}

/// Exponent of a yield surface: refused below 0, where a card of kinematic hardening follows, which must be read
/// before, and below 2; at least 2.
double yield_exponent(Builder& builder, const deck::Entry& field, double exponent);

/// Material axes by AOPT, with the vectors a, v and d, which turn with *INCLUDE_TRANSFORM; a finding where they are not
/// built. `option`, `a1`, `v1`: the fields of these names. Those of a coordinate system (AOPT below 0) come later, by
/// take_axes_of_system.
kernel::MaterialAxes material_axes(Builder& builder, const deck::Block& block, const AxesCards& cards,
                                   const deck::Entry& option, const deck::Entry& a1, const deck::Entry& v1);

/// Where AOPT is below 0, gives the material's law, once that is there, the x and y axes of the system as a and d.
void take_axes_of_system(Builder& builder, const deck::Entry& option, Index material);

/// Adds a material with the id and density of its first card `row`; gives its index.
Index add_material(Builder& builder, const MaterialCard& card, const deck::Row& row, std::string title,
                   std::string_view name, Law law);
template <class Card>
requires std::is_base_of_v<MaterialCard, Card> Index add_material(Builder& builder, const deck::RowOf<Card>& row,
                                                                  std::string title, std::string_view name, Law law) {
  return add_material(builder, *row, row, std::move(title), name, std::move(law));
}

}  // namespace nugget::reading
