// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Strains for results (STRFLG): rates of deformation on the geometry of mid-step, added up in axes that turn with the
/// element. In a stretch along fixed axes they are the logarithmic strains. Components xx yy zz xy yz zx in global
/// axes; xy is half the angle. The laws do not need them, so they cost something only where they are asked for.
class Strains {
 public:
  using Tensor = std::array<double, 6>;
  /// At the lowest and the uppermost integration point of a shell or a thick shell.
  struct Faces {
    Tensor lower{}, upper{};
  };

  Strains(const system::System& system, bool wanted);

  /// The strains of *INITIAL_STRAIN_SHELL, at time 0.
  void start(const system::State& state);
  /// Adds a step of length state.dt that ends at state.x, with its velocities.
  void update(const system::State& state);

  /// By model element; zero for elements without a kernel. Through the thickness a shell's strain follows from its
  /// stress: what changes the volume is elastic, zz = -(xx + yy) + (1 - 2 nu)/E (s_xx + s_yy).
  Faces shell(std::size_t e, const system::State& now) const;
  Tensor solid(std::size_t e) const;
  Faces thick_shell(std::size_t e) const;  ///< `e`: of the model's solids

  /// Over several ranks: strains of elements on their way to another one.
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);
  void archive(Archive& a);

 private:
  using InPlane = std::array<double, 5>;  ///< xx yy xy yz zx in the shell's frame
  struct ShellStrain {
    InPlane lower{}, upper{};
  };
  template <std::size_t corners>
  struct Chunk;
  template <std::size_t corners>
  class Chunks;
  void advance(const Chunk<4>& shells, const system::State& state);
  void advance(const Chunk<8>& solids, const system::State& state);
  void advance_triangle(std::size_t e, const system::State& state);
  void advance_solid(std::size_t e, const system::State& state);
  bool is_thick_shell(std::size_t solid) const { return !thick_rank_.empty() && thick_rank_[solid] != model::none; }
  void find_thick_shells();
  Tensor global(const InPlane& strain, std::size_t e, int layer, const system::State& now) const;

  const system::System& system_;
  std::vector<ShellStrain> shells_;
  std::vector<std::array<double, 2>> zeta_;  ///< by model shell: of its outermost layers
  std::vector<Tensor> solids_;
  std::vector<model::Index>
      thick_rank_;                     ///< by model solid: of a thick shell in `thick_`, or none; empty: there are none
  std::vector<double> thick_zeta_;     ///< by rank: place of the uppermost layer
  std::vector<char> has_separations_;  ///< by part: of cohesive bricks, which have no strains
  std::vector<Faces> thick_;
};

}  // namespace nugget::impact
