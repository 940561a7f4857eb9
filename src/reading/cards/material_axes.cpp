// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/material.hpp"

// AOPT of materials.
namespace nugget::reading {

using deck::Block;
using By = kernel::MaterialAxes::By;

kernel::MaterialAxes material_axes(Builder& b, const Block& block, const AxesCards& cards, const deck::Entry& option,
                                   const deck::Entry& a1, const deck::Entry& v1) {
  kernel::MaterialAxes axes;
  if (cards.aopt == 2.0) {
    axes.by = By::vectors;
    axes.a = direction(block, {cards.a1, cards.a2, cards.a3});
    axes.d = direction(block, {cards.d1, cards.d2, cards.d3});
    if (!(norm(axes.a) > 0.0)) refuse(b, a1, "AOPT 2 needs the vector a", "give A1 to A3; for bricks also D1 to D3");
  } else if (cards.aopt == 3.0) {
    axes.by = By::cross;
    axes.a = direction(block, {cards.v1, cards.v2, cards.v3});
    if (!(norm(axes.a) > 0.0)) refuse(b, v1, "AOPT 3 needs the vector v", "give V1 to V3");
  } else if (cards.aopt > 0.0) {
    refuse(b, option, "only 0, 2, 3 and the id of a coordinate system below 0 are built", "use vectors of AOPT 2");
  }
  return axes;
}

void take_axes_of_system(Builder& b, const deck::Entry& option, Index material) {
  if (!(option.value < 0.0)) return;
  const int id = -option.integer();
  const auto take = [=](Builder& later) {
    const Index found = later.systems.find(id);
    if (found == none)
      return refuse(later, option, fmt::format("coordinate system {} is not defined", id),
                    "define it with *DEFINE_COORDINATE_...");
    const CoordinateSystem& system = later.model.systems[found];
    if (system.turning)
      return refuse(
          later, option,
          fmt::format("coordinate system {} turns with its nodes (FLAG 1); the axes are those of the start", id),
          "define one with FLAG 0");
    auto* compound = std::get_if<kernel::ComposedLaw>(&later.model.materials[material].law);
    if (compound == nullptr) return;  // refused
    kernel::LawComponents made = *compound->components;
    if (kernel::MaterialAxes* axes = axes_of(made.flow)) {
      axes->by = By::vectors;
      axes->a = system.axes.e1;
      axes->d = system.axes.e2;
      if (std::vector<char>& mirrored = later.mirrored_materials; !mirrored.empty())
        mirrored[material] = later.mirrored_systems.contains(id);
    }
    *compound = kernel::composed_law(std::move(made));
  };
  // Behind the systems of that phase, and before layers take the laws of their materials.
  b.defer(Phase::systems, [take](Builder& later) { later.defer(Phase::systems, take); });
}

double yield_exponent(Builder& b, const deck::Entry& field, double exponent) {
  if (exponent < 0.0)
    refuse(b, field, "kinematic hardening (CRC, CRA) is not built",
           "give it above 0 without the card of CRC1: hardening is then isotropic");
  else if (exponent < 2.0)
    refuse(b, field, "expected 2 or more", "about 6 for steel, 8 for aluminium");
  return std::max(exponent, 2.0);
}

}  // namespace nugget::reading
