// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "kernel/law/composed_law.hpp"

// Layers: a shell whose integration points through the thickness have laws of their own.
namespace nugget::kernel {

/// How mass and stiffness in the plane lie through the thickness of a shell: of one material as it stands here. Places
/// from -1 (bottom) to 1 (top); spreads are second moments about these places over t^2 / 12 [1].
struct ThicknessProfile {
  double mass_centre = 0.0, mass_spread = 1.0;
  double stiffness_centre = 0.0, stiffness_spread = 1.0;
};

/// A law of shells that is another one in each layer. To the element as a whole it is the isotropic material whose
/// stiffness in the plane is the mean of the layers', A / t of classical laminate theory.
struct Laminate {
  struct Layer {
    ComposedLaw law;
    double density = 0.0;             ///< [mass/volume]
    double place = 0.0, share = 1.0;  ///< from -1 (bottom) to 1 (top); share of the thickness
    double angle = 0.0;        ///< B: turns the material axes of laws that have them about the shell's normal [rad]
    double shear_scale = 1.0;  ///< SHRFAC, factor on its transverse shear stress [1]
    double shear = 1.0;        ///< transverse shear strain of the layer over the element's [1]; see use_laminated_shear
  };
  double E = 0.0;                         ///< [stress]
  double nu = 0.0;                        ///< [1]
  double density = 0.0;                   ///< mean [mass/volume]
  double shear_factor = 0.0;              ///< kappa of use_laminated_shear, in the place of SHRF; 0: there is none
  bool kept_by_unfailing_layers = false;  ///< FAILOPT 1: layers whose law has no failure keep the element alive
  ThicknessProfile profile;
  std::shared_ptr<const std::vector<Layer>> layers;  ///< from the bottom up
};

/// The laminate of the layers given, at least one. Means are taken as the first layer's value plus what the others
/// differ by: a laminate of one material has its very constants.
Laminate laminate(std::vector<Laminate::Layer> layers, bool kept_by_unfailing_layers);

/// Laminated shell theory: gives each layer its own transverse shear strain, so that the stresses are in equilibrium
/// with those of bending. In cylindrical bending about the centre of stiffness z0 the shear stress is
///     tau(z) = Q_s g(z) / D,   g(z) = - integral of E/(1 - nu^2) (z - z0) from the bottom to z,
/// with D the integral of E/(1 - nu^2) (z - z0)^2; its energy is that of the shear stiffness
///     K = D^2 / integral of g^2 / G,   kappa = K / integral of G
/// (J.M. Whitney, J. Appl. Mech. 40 (1973); of one material kappa = 5/6). A layer's strain is its root mean square,
/// K sqrt(mean g^2) / (D G), with which the layers of one point each have exactly K. Moduli are those of the start.
/// Layers are slices stacked from the bottom, as thick as their shares say.
void use_laminated_shear(Laminate& laminate);

/// Bending stiffness of slices with one point each over that of classical laminate theory, D about the centre of
/// stiffness [1]: of n equal slices 1 - 1/n^2.
double share_of_bending(const Laminate& laminate);

}  // namespace nugget::kernel
