// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "kernel/law/law_components.hpp"
#include "small_model.hpp"

// Decks of one material, and the law that they make.
namespace nugget::reading {

/// A deck of these cards, whose run ends at 1.
inline Built built(const std::string& more) {
  return Built("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n" + more);
}
/// Of the first material.
inline const kernel::LawComponents& composition(const Built& b) {
  return *std::get<kernel::ComposedLaw>(b.model.materials.at(0).law).components;
}
template <class Flow>
const Flow& flow(const Built& b) {
  return std::get<Flow>(composition(b).flow);
}

}  // namespace nugget::reading
