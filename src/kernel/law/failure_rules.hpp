// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "kernel/law/ductile_fracture.hpp"
#include "kernel/law/johnson_cook_fracture.hpp"

namespace nugget::kernel {

/// Rules by which a point of any element fails, whatever its flow: their list. A rule is its own file, and its include
/// and its line here. It has
///   history              numbers of a point's history, 0 at the start
///   needs_plastic_flow   whether a point can only fail in a step with plastic strain
///   advance()            takes a step; `h`: its history, a number every `stride`
///   used()               what of the point is used up: it fails at 1
/// and, where *MAT_ADD_... adds it to a material, cards() as in law_cards.hpp.
using FailureRule = std::variant<  //
    DuctileFracture,               //
    JohnsonCookFracture>;

}  // namespace nugget::kernel
