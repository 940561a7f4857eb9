// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/added_law.hpp"

#include <type_traits>
#include <variant>

namespace nugget::reading {

std::optional<kernel::LawComponents> components_of(const Law& law) {
  return std::visit(
      []<class Own>(const Own& own) -> std::optional<kernel::LawComponents> {
        if constexpr (std::is_same_v<Own, kernel::ComposedLaw>)
          return own.components->bond ? std::nullopt : std::optional(*own.components);
        else if constexpr (kernel::ComposableLaw<Own>)
          return kernel::components_of(own);
        else
          return std::nullopt;
      },
      law);
}

void take_points_to_delete(Builder& b, const deck::Entry& numfip, kernel::LawComponents& law, bool said_before) {
  const double points = numfip.value < -100.0 ? -numfip.value - 100.0 : numfip.value;
  if (said_before && law.points_to_delete != points)
    refuse(b, numfip, "differs between *MAT_ADD_EROSION and *MAT_ADD_DAMAGE_GISSMO of the material",
           "write the same number on both");
  law.points_to_delete = points;
}

}  // namespace nugget::reading
