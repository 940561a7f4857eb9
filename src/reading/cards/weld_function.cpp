// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/weld_function.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reading/builder/common_cards.hpp"

namespace nugget::reading {

void refuse_transformed_functions(Builder& b, const deck::Block& block, const deck::Entry& field) {
  if (block.transform == nullptr) return;
  const bool offset = block.transform->id_offset[static_cast<std::size_t>(IdSpace::function)] != 0;
  if (offset || block.transform->changes_units())
    refuse(b, field,
           "ids of functions in place of numbers take neither an offset nor a unit factor of *INCLUDE_TRANSFORM",
           "write this keyword in the main deck");
}

Index weld_function(Builder& b, const deck::Entry& field) {
  const Index function = b.functions.find(field.integer());
  if (function == none) {
    refuse(b, field, fmt::format("*DEFINE_FUNCTION {} is not in the deck", field.text), "define it");
    return none;
  }
  const std::string wrong = model::wrong_arguments(b.model.functions[function].formula);
  if (wrong.empty()) return function;
  // LS-DYNA goes by their order, which only their names show to be the one that is meant.
  refuse(b, field,
         fmt::format("{}; expected ({}), the last of which may be missing", wrong,
                     fmt::join(model::weld_function_names, ", ")),
         "name them so: thicknesses, yield stresses, strengths, strain rate, area, moduli");
  return none;
}

}  // namespace nugget::reading
