// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "base/archive.hpp"
#include "base/batch.hpp"
#include "base/vec3.hpp"
#include "base/zeroed.hpp"
#include "system/parcel.hpp"
#include "system/strain_rule.hpp"

namespace nugget::system {

/// Strains of the elements of a group, in its blocks: rates of deformation on the geometry of mid-step, added up in
/// axes that turn with the element. In a stretch along fixed axes they are the logarithmic strains. xy is half the
/// angle. Kept as doubles.
template <class N>
class BlockStrains {
 public:
  using R = NativeBatchOf<N>;
  static constexpr std::size_t width = lanes<R>;

  /// `elements`: with those that fill up the last block.
  void start(StrainRule rule, std::size_t elements);
  bool wanted() const { return rule_.of != StrainRule::Of::nothing; }
  const StrainRule& rule() const { return rule_; }

  /// Adds a step that ends at the places `x`, with the velocities and spins of mid-step, to the elements of block b
  /// that are active: 1, 0 otherwise. `thickness` [length]: of shells.
  void add(std::size_t b, std::span<const Vec3<R>> x, std::span<const Vec3<R>> v, std::span<const Vec3<R>> w,
           const R& active, const R& thickness, double dt);

  double number(std::size_t e, std::size_t i) const { return values_[place(e, i)]; }
  void set(std::size_t e, std::size_t i, double value) { values_[place(e, i)] = value; }

  void leave(std::size_t first_block, std::size_t end);
  void carry(std::size_t first_block, std::size_t end, Parcel& parcel);
  void archive(Archive& a, const Archive::Holders& holders);

 private:
  std::size_t place(std::size_t e, std::size_t i) const {
    return (e / width * rule_.numbers() + i) * width + e % width;
  }
  StrainRule rule_;
  ZeroedVector<double> values_;  ///< block by block, number by number, lane by lane
};

extern template class BlockStrains<double>;
extern template class BlockStrains<float>;

}  // namespace nugget::system
