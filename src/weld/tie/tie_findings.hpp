// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "weld/tie/reference.hpp"
#include "weld/tie/surroundings.hpp"

// Findings on ties. Every message names weld, node and place, the distance to the closest segment, and
// a remedy.
namespace nugget::weld {

/// `rigid part 5`.
std::string name_body(const model::RigidBody& body);
/// `shell 5 of part 2`, `a face of part 3`.
std::string name_segment(const model::Model& model, Index shell, Index part);
/// `node 17 at (1, 2, 3)`, with the coordinates of the deck.
std::string name_node(const model::Model& model, Index node);
/// `*CONTACT_SPOTWELD 3`; the id only if there is one.
std::string name_contact(const model::Contact& contact);

/// Birth of a tie, sheets whose reference surface is not the one of their nodes.
void report_what_is_not_built(const model::Model& model, const model::Contact& contact,
                              const std::vector<ReferenceSegment>& segments, Findings& findings);
void report_empty_side(const model::Contact& contact, bool reference_side, Findings& findings);
/// Tracked nodes that stay with their rigid bodies.
void report_rigid_tracked_nodes(const model::Model& model, const model::Contact& contact, const Surroundings& around,
                                const std::vector<Index>& nodes, Findings& findings);
void report_second_tie(const model::Model& model, Index node, Index first, Index second, Findings& findings);
/// Tracked nodes without a weld that found no segment.
void report_untied_nodes(const model::Model& model, const model::Contact& contact, const std::vector<Index>& nodes,
                         double distance, double tolerance, Findings& findings);

/// Looks for segments whose nodes are constrained themselves. A tie whose segment lies in one rigid body gets that
/// body's index (one note a part); otherwise a constrained segment node gives a warning that names both constraints,
/// and ties that go round in a circle an error. IPBACK makes springs of such ties. Also reported: nodes with rotations
/// that are tied by translations only. `x`: places after projection [length].
void check_segments(const model::Model& model, const Surroundings& around, const std::vector<Vec3d>& x,
                    std::vector<Tie>& ties, Findings& findings);

/// The projection cases 4 to 8 weld by weld, what SPOTSTP does about untied welds, and one note on how far nodes were
/// moved.
void report_welds(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
