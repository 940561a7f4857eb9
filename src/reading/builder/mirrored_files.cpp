// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/mirrored_files.hpp"

#include <algorithm>
#include <array>

namespace nugget::reading {

namespace {

/// By their beginnings.
constexpr auto mirrored = std::to_array<std::string_view>({
    "AIRBAG_",
    "BOUNDARY_PRESCRIBED_MOTION_NODE",
    "BOUNDARY_PRESCRIBED_MOTION_RIGID",
    "BOUNDARY_PRESCRIBED_MOTION_SET",
    "BOUNDARY_SPC_",
    "COMMENT",
    "CONSTRAINED_ADAPTIVITY",
    "CONSTRAINED_EXTRA_NODES_",
    "CONSTRAINED_GENERALIZED_WELD_SPOT",
    "CONSTRAINED_INTERPOLATION",
    "CONSTRAINED_JOINT_COOR_CYLINDRICAL",
    "CONSTRAINED_JOINT_COOR_LOCKING",
    "CONSTRAINED_JOINT_COOR_PLANAR",
    "CONSTRAINED_JOINT_COOR_REVOLUTE",
    "CONSTRAINED_JOINT_COOR_SPHERICAL",
    "CONSTRAINED_JOINT_COOR_TRANSLATIONAL",
    "CONSTRAINED_JOINT_COOR_UNIVERSAL",
    "CONSTRAINED_JOINT_CYLINDRICAL",
    "CONSTRAINED_JOINT_LOCKING",
    "CONSTRAINED_JOINT_PLANAR",
    "CONSTRAINED_JOINT_REVOLUTE",
    "CONSTRAINED_JOINT_SPHERICAL",
    "CONSTRAINED_JOINT_TRANSLATIONAL",
    "CONSTRAINED_JOINT_UNIVERSAL",
    "CONSTRAINED_NODAL_RIGID_BODY",
    "CONSTRAINED_RIGID_BODIES",
    "CONSTRAINED_RIVET",
    "CONSTRAINED_SPOTWELD",
    "CONSTRAINED_SPR2",
    "CONTACT_",
    "CONTROL_",
    "DAMPING_",
    "DATABASE_",
    "DEFINE_",
    "DEFORMABLE_TO_RIGID",
    "ELEMENT_",
    "END",
    "EOS_",
    "HOURGLASS",
    "INITIAL_AXIAL_FORCE_BEAM",
    "INITIAL_STRESS_SECTION",
    "INITIAL_STRESS_SHELL",
    "INITIAL_STRESS_SOLID",
    "INITIAL_STRAIN_SHELL",
    "INITIAL_VELOCITY",
    "INTEGRATION_BEAM",
    "INTEGRATION_SHELL",
    "INTERFACE_SPRINGBACK_",
    "KEYWORD",
    "LOAD_",
    "MAT_",
    "NODE",
    "PARAMETER",
    "PART",
    "RIGIDWALL_",
    "SECTION_",
    "SET_",
    "TERMINATION_",
    "TITLE",
});

/// And which of these cannot.
constexpr auto not_mirrored = std::to_array<std::string_view>({
    "BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL",
    "NODE_TRANSFORM",
});

bool is_among(std::string_view keyword, const auto& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(), [&](std::string_view b) { return keyword.starts_with(b); });
}

}  // namespace

bool can_be_mirrored(std::string_view keyword) {
  return is_among(keyword, mirrored) && !is_among(keyword, not_mirrored);
}

}  // namespace nugget::reading
