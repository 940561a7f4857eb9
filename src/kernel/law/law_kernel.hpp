// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/twin_place.hpp"

namespace nugget::kernel {

/// A law made ready for the kernels: moduli, look-up tables. Made once from the parameters, then only read (by any
/// number of threads).
///   has_plastic_strain                      whether the history holds the effective plastic strain
///   layer_history(), solid_history(), fibre_history()   numbers of history a point needs in each stress space, beside
///                                           its stress
///   layer(), solid(), fibre()               add a step of strain rate to a stress: a law is one of the elements whose
///                                           stress space it has
///   wave_modulus()                          of a solid point as it is, for the stable step [stress]
/// What only some laws have is found by its name, and left out where there is none:
///   rotate()                                turns a solid point's history with the material
///   can_fail(), failed()                    whether, and which, points have failed (their stress is 0)
///   axes()                                  material axes at the start; the history holds those of now
///   (axes_field.hpp) temperature_field()                     where the history holds a temperature rise; 0: nowhere
///   crash_front_field()                     where the history says that its element stands beside a deleted one
///   spin_field()                            where a membrane writes by how fast its material turns beside its axes
///   step_share()                            what the viscous stress of layers leaves of the stable step, of membranes
///   stiffness_share()                       stiffness of a point now over that of its elastic constants
///   shear_wave_modulus()                    part of wave_modulus() beside the bulk modulus of an equation of state
///   strain_layer(), elastic_thickness()     the elastic part of layer(), and what that gives
///   flow_layer(), flow_layers()             its plastic part, of one layer and of two together
///   may_pull_otherwise                      whether the slope at rest may differ between tension and compression
/// Laws with element kernels of their own (own_kernels.hpp) have besides:
///   elastic()                               elastic constants
///   points_to_delete()                      failed points that delete an element, as in ComposedLaw; 0: all
///   deletion_step()                         an element whose stable time step falls below is deleted; 0: never
template <class Law>
class LawKernel;

/// Field of a point's history that holds the effective plastic strain: the first, which laws without one leave at 0.
inline constexpr int plastic_strain_field = 0;
/// The first of those that are the law's own.
inline constexpr int first_own_field = plastic_strain_field + 1;

/// Laws of shells, which have a stress in layers.
template <class Law>
concept LawOfLayers = requires(const LawKernel<Law>& law, LayerTensor<double>& s, double* history) {
  law.layer(s, s, 0.0, history);
};
/// Laws of which two layers that have been strained can flow together.
template <class Law>
concept FlowsInPairs = requires(const LawKernel<Law>& law, const LayerPlace<double>& layer) {
  law.flow_layers(layer, layer, 0.0);
};
/// Laws of bricks.
template <class Law>
concept LawOfSolids = requires(const LawKernel<Law>& law, SolidTensor<double>& s, double* history) {
  law.solid(s, s, 0.0, history);
};
/// Laws of beams.
template <class Law>
concept LawOfFibres = requires(const LawKernel<Law>& law, FibreTensor<double>& s, double* history) {
  law.fibre(s, s, 0.0, history);
};
/// Laws of welds: damage leaves a share of a point's stress, and the weld as a whole may freeze its yield stress.
template <class Law>
concept LawOfWelds = requires(const LawKernel<Law>& law, const double* history) {
  law.template integrity<double>(history);
  law.frozen_stress(0.0);
};

}  // namespace nugget::kernel
