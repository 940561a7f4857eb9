// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/orthotropic.hpp"
#include "reading/cards/material.hpp"

namespace nugget::reading {

/// Fields of orthotropic elasticity, as several materials have them.
namespace orthotropy {
inline constexpr RealField ratio_ba =
    real("prba", dimension::number, 0, any_value, "strain along a over that along b, negative, under stress along b");
inline constexpr RealField ratio_ca =
    real("prca", dimension::number, 0, any_value, "the same along a, under stress along c");
inline constexpr RealField ratio_cb =
    real("prcb", dimension::number, 0, any_value, "the same along b, under stress along c");
inline constexpr RealField shear_ab = real("gab", dimension::stress, required, above_zero(), "shear modulus ab");
inline constexpr RealField shear_bc = real("gbc", dimension::stress, required, above_zero(), "shear modulus bc");
inline constexpr RealField shear_ca = real("gca", dimension::stress, required, above_zero(), "shear modulus ca");
}  // namespace orthotropy

/// Where on the cards of a material what concerns its axes stands.
struct OrthotropicEntries {
  deck::Entry ratio_ba, option, a1, v1;
};
/// Completes the constants of `law` as they are on the cards: EC, the material axes with the angle `beta` [degrees],
/// the isotropic constants that go with them. An error where moduli and Poisson's ratios would give energy.
void complete_orthotropic(Builder& builder, const deck::Block& block, kernel::Orthotropic& law, const AxesCards& cards,
                          double beta, const OrthotropicEntries& entries);

}  // namespace nugget::reading
