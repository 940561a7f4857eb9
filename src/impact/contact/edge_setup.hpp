// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/edge_contact.hpp"
#include "contact/surface_contact.hpp"
#include "impact/contact/contact_setup.hpp"

namespace nugget::impact {

/// The beams of the parts of a contact as round bars; discrete beams are none, and weld beams only `with_welds`.
std::vector<contact::Edge> bars(const ContactMesh& mesh, const model::Contact& contact, bool with_welds);

/// The lines of a contact that checks them: the edges of the shells in `surface`, the beams, and in segment-based
/// contact the edges of bricks. Coordinates `x`.
std::optional<contact::EdgeContactSetup> edge_setup(const ContactMesh& mesh, const model::Contact& contact,
                                                    const contact::SurfaceContactSetup& surface,
                                                    std::span<const Row> x);

}  // namespace nugget::impact
