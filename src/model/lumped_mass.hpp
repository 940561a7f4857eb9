// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/model.hpp"

namespace nugget::model {

struct NodeMass {
  Index node = none;
  double mass = 0.0;
};

/// Mass that an element of mass `mass` has at one of its nodes: an equal share, of a tetrahedron of ten nodes that of
/// its kernel.
double mass_at(double mass, std::size_t nodes, std::size_t node);

/// By part: mass of its elements at its nodes, in ascending order of nodes, by `mass_at` (a triangle gives thirds).
/// Shells rho A t plus MAREA, bricks rho V, beams rho A L plus NSM, discrete beams rho VOL. One walk over all elements.
std::vector<std::vector<NodeMass>> lumped_masses(const Model& model);

/// Mass of all elements, of which lumped_masses() has the shares of nodes [mass].
double mass_of_elements(const Model& model);

/// By node: the mass of elements, *ELEMENT_MASS and *ELEMENT_INERTIA.
std::vector<double> nodal_masses(const Model& model);

/// Area of a shell, half the cross product of its diagonals [length^2].
double shell_area(const Model& model, std::size_t shell);
/// Eight times the Jacobian determinant at the centre: the volume that a one-point brick integrates. Of tetrahedra
/// their own, where they are not computed as collapsed bricks; of those of ten nodes that of their four points
/// [length^3].
double solid_volume(const Model& model, std::size_t solid);
/// Of a beam's cross-section: A, a rectangle, or a round tube [length^2].
double beam_area(const SectionBeam& section);
double beam_length(const Model& model, std::size_t beam);

}  // namespace nugget::model
