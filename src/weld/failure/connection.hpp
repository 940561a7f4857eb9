// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/model.hpp"
#include "weld/tie/ties.hpp"

// Welds of MAT_100_DA: what *DEFINE_CONNECTION_PROPERTIES says of one of them (docs/theory/failure.md#connections).
namespace nugget::weld {

namespace failure {
struct Geometry;
}

using ConnectionRecord = model::ConnectionProperties::Record;

/// The record that holds for a weld between sheets of the materials given (PROPRUL 0 and 1): each sheet has that of its
/// material, or the defaults; of these the one with the lower RANK, where that is equal the weaker one: less strength
/// in shear, else in tension, else in bending (decision 0173).
const ConnectionRecord& connection_record(const model::ConnectionProperties& properties,
                                          std::array<model::Index, 2> sheet_materials);
/// The record of a weld, by rank or by functions of both its sheets (PROPRUL 2). Functions of the strain rate refer to
/// `model`.
ConnectionRecord connection_record(const model::Model& model, const model::ConnectionProperties& properties,
                                   const failure::Geometry& weld);
/// What functions of both sheets cannot give for a weld is an error at `place`; what depends on which sheet is the
/// first a warning.
void check_functions(const model::Model& model, const model::ConnectionProperties& properties,
                     const failure::Geometry& weld, const Place& place, Findings& findings);

/// The material that cards name for the part of a sheet: of a part that got one of its own (layers with laws of their
/// own, *DEFORMABLE_TO_RIGID) that of the deck. none: the sheet has none.
model::Index material_of_sheet(const model::Model& model, model::Index sheet);

/// Area of the weld's cross-section for stresses (AREAEQ): 0 as modelled, 1 that of the diameter 5 sqrt(t_min) in mm,
/// -1 the same in m; as modelled where no sheet's thickness is known [area].
double connection_area(int area_rule, double modelled, double thinner_sheet);

/// The law of a weld's points: yield stress and hardening of the record, for the area that the stresses are made with
/// in place of the modelled one. ETAN is the slope of the stress over the total strain. Without a yield stress the
/// points stay elastic. EFAIL belongs to the weld as a whole.
kernel::Spotweld connection_points(const kernel::Spotweld& law, const ConnectionRecord& record, double real_area,
                                   double modelled_area);
/// The same for a weld as it was tied; `law` itself for welds of other materials.
kernel::Spotweld points_of(const model::Model& model, const Weld& weld, const kernel::Spotweld& law);

}  // namespace nugget::weld
