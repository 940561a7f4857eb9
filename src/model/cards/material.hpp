// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/builder.hpp"

// What the cards of all materials begin with.
namespace nugget::model {

inline constexpr Field material_id = id("mid", IdSpace::material, required, "material id");
inline constexpr Field density = real("ro", dimension::density, required, above_zero(), "density");
inline constexpr Field young = real("e", dimension::stress, required, above_zero(), "Young's modulus");
inline constexpr Field poisson = real("pr", dimension::number, 0, between(0, 0.5), "Poisson's ratio");

/// LS-DYNA's "no failure" values are 0 and numbers of 1e20 and more; ours is 0.
double failure_value(double written);

/// Adds a material with the id and density of its first card; gives its index.
Index add_material(Builder& builder, const deck::Row& row, std::string title, std::string_view name, Law law);

}  // namespace nugget::model
