// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Places of the layers of a shell through its thickness, -1 .. 1, from the bottom.
std::vector<double> layer_places(const model::Model& model, int layers);

/// Area of a beam's section: of the circle or ring of a weld, of the volume over the length of a discrete beam.
double beam_area(const model::Model& model, model::Index beam);

/// *INITIAL_STRESS_..., *INITIAL_AXIAL_FORCE_BEAM, *INITIAL_STRESS_SECTION: stresses that the elements do not get from
/// their own deformation.
class Preloads {
 public:
  /// Elements that cannot take a stress become findings.
  Preloads(system::System& system, Findings& findings);

  /// Stresses of time 0, before the first internal forces.
  void start(const system::State& state);
  /// Before the internal forces at state.time: stresses that follow a curve, as long as it lasts.
  void apply(const system::State& state);

  void archive(Archive& a);

 private:
  /// Elements with one prescribed stress component, in a direction or along the beam's axis.
  struct Prescribed {
    std::vector<system::System::Seat> seats;
    std::vector<double> scale;  ///< curve to stress, by element
    const Curve* curve;
    bool beams = false;
    Vec3d normal;
    bool keep_others = true;
    bool active = false;
    void archive(Archive& a);
  };
  /// Elements whose stress is set before each step answer to it by E dt times their strain rate, as a dashpot. That is
  /// stable with steps of 1/sqrt(3) of the usual ones: their groups take half of it while the curve lasts.
  void set_active(Prescribed& p, bool active);

  void start(const model::InitialStress& stress, const system::System::Seat& seat, bool shell,
             const system::State& state);

  system::System& system_;
  std::vector<Prescribed> prescribed_;
};

}  // namespace nugget::impact
