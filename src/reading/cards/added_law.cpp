// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/added_law.hpp"

#include <utility>
#include <variant>

namespace nugget::reading {

std::optional<kernel::LawComponents> components_of(const Law& law) {
  if (const auto* elastic = std::get_if<kernel::Elastic>(&law)) return kernel::LawComponents{*elastic};
  if (const auto* kinematic = std::get_if<kernel::PlasticKinematic>(&law)) {
    kernel::PlasticKinematic flow = *kinematic;
    const double failure = std::exchange(flow.failure_strain, 0.0);
    return kernel::LawComponents{flow, failure};
  }
  if (const auto* curves = std::get_if<kernel::PiecewiseLinear>(&law)) {
    kernel::PiecewiseLinear flow = *curves;
    kernel::LawComponents made{kernel::Elastic{}, std::exchange(flow.failure_strain, 0.0)};
    made.deletion_step = std::exchange(flow.tdel, 0.0);
    made.flow = std::move(flow);
    return made;
  }
  if (const auto* compound = std::get_if<kernel::ComposedLaw>(&law); compound && !compound->components->bond)
    return *compound->components;
  return std::nullopt;
}

bool has_plastic_strain(const kernel::Flow& flow) {
  return std::holds_alternative<kernel::PlasticKinematic>(flow) ||
         std::holds_alternative<kernel::PiecewiseLinear>(flow) || std::holds_alternative<kernel::JohnsonCook>(flow) ||
         std::holds_alternative<kernel::PowerLaw>(flow);
}

void take_points_to_delete(Builder& b, const deck::Entry& numfip, kernel::LawComponents& law, bool said_before) {
  const double points = numfip.value < -100.0 ? -numfip.value - 100.0 : numfip.value;
  if (said_before && law.points_to_delete != points)
    refuse(b, numfip, "differs between *MAT_ADD_EROSION and *MAT_ADD_DAMAGE_GISSMO of the material",
           "write the same number on both");
  law.points_to_delete = points;
}

}  // namespace nugget::reading
