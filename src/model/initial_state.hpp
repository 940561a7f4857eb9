// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "model/cross_section.hpp"
#include "model/parts.hpp"

// *INITIAL_STRESS_..., *INITIAL_STRAIN_SHELL, *INITIAL_AXIAL_FORCE_BEAM.
namespace nugget::model {

/// Stress xx yy zz xy yz zx and plastic strain at one point of an element, in global axes.
struct InitialPoint {
  double zeta = 0.0;  ///< T: place through the thickness of a shell, -1 .. 1; unused in bricks
  std::array<double, 6> stress{};
  double plastic_strain = 0.0;
};
/// *INITIAL_STRESS_SHELL, *INITIAL_STRESS_SOLID: points of one element. In-plane points of a shell, and the points of a
/// brick, stand one after the other; each place through the thickness gets their mean.
struct InitialStress {
  Index element = none;  ///< shell or solid
  std::vector<InitialPoint> points;
  Place place;
};
/// *INITIAL_STRAIN_SHELL: at the lowest and the uppermost point, global axes.
struct InitialStrain {
  Index shell = none;
  std::array<double, 6> lower{}, upper{};
};

/// *INITIAL_AXIAL_FORCE_BEAM: as long as its curve lasts, all points of these beams have the same axial stress, which
/// makes the force.
struct AxialForce {
  std::vector<Index> beams;
  Index curve = none;
  double scale = 1.0;
  bool bends = false;  ///< KBEND 1: the force is their mean; the differences between them are what the material says
  Place place;
};
/// *INITIAL_STRESS_SECTION: as long as its curve lasts, the bricks of a cross section have this normal stress.
struct SectionStress {
  std::vector<Index> solids;
  Index section = none;      ///< in Requests::cross_sections, whose bricks these are
  std::vector<Index> parts;  ///< only those of these parts; empty: of all
  Vec3d normal;
  Index curve = none;
  bool keep_shear = false;  ///< IZSHEAR 1, 2: the other stresses grow as the material says
  bool bends = false;       ///< IZSHEAR 2: so do the differences between the points of a brick
  Place place;
};

struct InitialState {
  std::vector<InitialStress> shells, solids;
  std::vector<InitialStrain> shell_strains;
  std::vector<AxialForce> axial_forces;
  std::vector<SectionStress> section_stresses;
};

}  // namespace nugget::model
