// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/batch.hpp"
#include "base/denormals.hpp"
#include "base/index.hpp"
#include "base/row.hpp"
#include "base/zeroed.hpp"
#include "system/block_strains.hpp"
#include "system/element_group.hpp"
#include "system/elements_elsewhere.hpp"

namespace nugget::system {

/// Where numbers stand in an element's state that more than its kernel asks for; -1: this kind of element has none.
struct StateFields {
  int size = 0;  ///< numbers of state an element
  int alive = -1, density_scale = -1, hourglass_energy = -1, bulk_viscosity_work = -1;
};

/// A group whose elements stand in blocks, a lane each: what does not depend on the kind of element, and so is compiled
/// once for each precision. Kernels come with BatchGroup. In single precision (N float) the kernel's lanes, the state
/// and the slots are floats; energies are added up, and steps kept, as doubles.
template <class N>
class BlockGroup : public ElementGroup {
 public:
  using R = NativeBatchOf<N>;
  static constexpr bool single = is_single<R>;
  static constexpr int width = lanes<R>;
  static constexpr std::size_t widest_width = single ? 2 * widest_block : widest_block;
  static_assert(widest_width % width == 0);
  using Numbers = std::vector<N, Aligned<N>>;
  static constexpr std::size_t most_corners = std::tuple_size_v<ElementNodes>;
  using Places = std::array<Vec3d, most_corners>;
  /// A step that moves nothing; of floats one after which strains are still normal numbers, whatever the units.
  static constexpr double no_step = single ? 0x1p-40 : 0x1p-100;
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  void start(const std::function<Vec3d(int)>& place, const std::function<bool(std::size_t)>& here) override;
  void leave(const std::function<bool(std::size_t)>& here) override;
  std::size_t elsewhere() const override { return elsewhere_.count(); }

  std::size_t blocks() const override { return (size() + widest_width - 1) / widest_width * widest_width / width; }
  std::size_t widest() const override { return widest_width; }
  bool single_precision() const override { return single; }
  std::size_t block_width() const override { return width; }

  void store_reference_state() override;
  void archive(Archive& a) override;

  ElementNodes nodes(std::size_t e) const override;
  bool alive(std::size_t e) const final {
    return elsewhere_.has(e) ? elsewhere_.alive(e) : field(e, fields_.alive) != 0.0;
  }
  void remove(std::size_t e) override;
  void set_number(std::size_t e, int i, double value) override {
    if (!elsewhere_.has(e)) put_field(e, i, value);
  }
  void release_step(std::size_t e) override;
  void take_step(std::size_t e, double step) override;
  void carry(std::size_t begin, std::size_t end, Carried what, Parcel& parcel) override;
  double stable_step(std::size_t e) const override { return elsewhere_.has(e) ? elsewhere_.step(e) : step_[e]; }
  double internal_energy(std::size_t e) const final { return energy_[e] - hourglass_energy(e); }
  void add_internal_energy(std::size_t e, double work) override { energy_[e] += work; }
  double hourglass_energy(std::size_t e) const final {
    if (fields_.hourglass_energy < 0) return 0.0;
    return elsewhere_.has(e) ? elsewhere_.hourglass_energy(e) : field(e, fields_.hourglass_energy);
  }
  double bulk_viscosity_work(std::size_t e) const final {
    if (fields_.bulk_viscosity_work < 0) return 0.0;
    return elsewhere_.has(e) ? elsewhere_.bulk_viscosity_work(e) : field(e, fields_.bulk_viscosity_work);
  }
  Energies energies(std::size_t begin, std::size_t end) const final;
  double mass(std::size_t e) const override { return mass_[e]; }
  double nodal_inertia(std::size_t e) const override { return inertia_[e]; }
  double mass_scale(std::size_t e) const override {
    return elsewhere_.has(e) ? elsewhere_.scale(e) : field(e, fields_.density_scale);
  }
  double kept_mass_scale(double factor) const override;
  void add_up_strains(StrainRule rule) override { strains_.start(std::move(rule), blocks() * width); }
  const StrainRule* strain_rule() const override { return strains_.wanted() ? &strains_.rule() : nullptr; }
  double strain(std::size_t e, std::size_t i) const override { return strains_.number(e, i); }
  void set_strain(std::size_t e, std::size_t i, double value) override { strains_.set(e, i, value); }
  void scale_mass(std::size_t e, double factor) override;

 protected:
  /// Of a block: place, velocity and spin of the elements' nodes.
  struct Motion {
    std::array<Vec3<R>, most_corners> x, v, w;
  };
  /// Forces and moments on them, and the elements' stable steps.
  struct Forces {
    std::array<Vec3<R>, most_corners> f, m;
    R stable_step;
  };

  /// `everywhere`: all ranks compute these elements.
  BlockGroup(model::ElementKind k, model::Index p, std::vector<model::Index> elements, int corners, bool turns,
             const StateFields& fields, bool everywhere);
  /// `connectivity`: system nodes of each element, at the places `x`. `starts_later`: states come with `start`, unless
  /// all ranks compute them.
  void fill(const std::vector<ElementNodes>& connectivity, std::span<const Vec3d> x, bool starts_later);

  // What the kernels of elements know.
  /// Sets the state of the element `own` of the model free of stress: field i at values[i * native_width + lane].
  virtual void start_state(double* values, int lane, model::Index own, const Places& x) const = 0;
  /// Of the undeformed element: its mass, and the rotary inertia at each of its nodes.
  virtual std::array<double, 2> lump(model::Index own, const Places& x) const = 0;
  /// The forces after a step in which a motion is so small that they are linear in it. Not `viscous`: without
  /// viscosity.
  virtual void small_cycle(bool viscous, const Motion& motion, double dt, N* values, Forces& out) const = 0;

  /// The kernel's forces after a step with unit velocity in one freedom, a freedom a lane. The step is so short that it
  /// moves nothing and meets no yield, and a power of two: what is left is the exact derivative (docs/decisions/0017).
  /// `both_ways`: the mean of a step forth and one back.
  void derive_stiffness(std::size_t e, const State& start, std::span<double> k, bool both_ways) const;
  /// ElementGroup::vibrate by the kernel: so small velocities that nothing moves and nothing yields, a power of two as
  /// for the stiffness. `stiffer`: factor on what comes out; `compresses_viscously`: bulk viscosity acts under
  /// compression only.
  void vibrate_by_kernel(std::size_t b, const State& now, std::span<const Row> v, std::span<const Row> w, double dt,
                         std::span<Row> forces, double stiffer, bool compresses_viscously) const;
  /// Adds the step to the strains of a block; places, velocities and spins of its nodes as in Motion.
  void add_strains(std::size_t b, std::span<const Vec3<R>> x, std::span<const Vec3<R>> v, std::span<const Vec3<R>> w,
                   double dt);
  /// Stiffness-proportional damping of a block. In the middle of the step the velocities, which are chords, of a steady
  /// turning strain nothing; at its end they would stretch, by dt/2 times the centripetal acceleration.
  void damp(std::size_t b, Motion motion, double dt, Slots& slots) const;

  std::size_t corners() const { return at(nodes_per_element); }
  static int lane(std::size_t e) { return static_cast<int>(e % width); }
  std::size_t node_index(std::size_t e, std::size_t a) const {
    return e / width * width * corners() + a * width + e % width;
  }
  N* state(std::size_t e) { return &state_[e / width * width * at(fields_.size)]; }
  const N* state(std::size_t e) const { return &state_[e / width * width * at(fields_.size)]; }
  void put_field(std::size_t e, int i, double value) { state(e)[i * width + lane(e)] = static_cast<N>(value); }
  double field(std::size_t e, int i) const { return state(e)[i * width + lane(e)]; }
  auto reader(std::size_t e) const {
    return [s = state(e), l = lane(e)](int i) -> double { return s[i * width + l]; };
  }
  /// Rows of the nodes a; in single precision less those of the first nodes, so that no digit goes into where an
  /// element is or how fast it flies.
  [[gnu::always_inline]] static inline Vec3<R> places_at(std::span<const Row> rows_of_nodes, const int* id, int a) {
    if constexpr (single)
      return a == 0 ? Vec3<R>{} : gather_differences<R>(rows_of_nodes.data(), id + a * width, id);
    else
      return gather<R>(rows_of_nodes.data(), id + a * width);
  }
  [[gnu::always_inline]] static inline Vec3<R> spins_at(std::span<const Row> rows_of_nodes, const int* id, int a) {
    if constexpr (single)
      return gather_single<width>(rows_of_nodes.data(), id + a * width);
    else
      return gather<R>(rows_of_nodes.data(), id + a * width);
  }
  /// Remembers the first active element whose volume is no longer positive, whichever thread finds it.
  void note_inverted(std::size_t b, const R& volume) {
    if (any(!(volume > R(0.0)))) note_first_inverted(b, volume);
  }
  void find_block_step(std::size_t b);
  /// Keeps the steps of a block that has been computed. One that is no number is that of the block, although it is less
  /// than none.
  [[gnu::always_inline]] inline void keep_steps(std::size_t b, const R& steps) {
    double* of_element = &step_[b * width];
    store_as_doubles(of_element, steps);
    double least = of_element[0];
    for (int l = 1; l < width; ++l) least = of_element[l] < least ? of_element[l] : least;
    block_step[b] = any(!(steps >= steps)) ? std::numeric_limits<double>::quiet_NaN() : least;
  }

  struct NoDenormals {};
  using Denormals = std::conditional_t<single, FlushedDenormals, NoDenormals>;

  const StateFields fields_;
  std::vector<int> nodes_;  ///< block by block, node by node, lane by lane
  ZeroedVector<N> state_;
  ZeroedVector<double> energy_, step_;
  BlockStrains<N> strains_;

 private:
  void note_first_inverted(std::size_t b, const R& volume);
  void start(std::size_t b, const std::function<Vec3d(int)>& place_of);
  Motion small_motion(std::size_t b, const State& now, std::span<const Row> v, std::span<const Row> w,
                      double factor) const;
  /// The state of block b that `store_reference_state` kept.
  void load_reference(std::size_t b, Numbers& values) const;

  const bool everywhere_;  ///< welds are looked at by others
  ElementsElsewhere elsewhere_;
  std::vector<int> reference_fields_;  ///< of the state, those that are not 0 in all elements free of stress
  Numbers reference_state_;            ///< their values, block by block, field by field; empty where they were not kept
  bool reference_kept_ = false;
  std::vector<double> mass_, inertia_;
};

extern template class BlockGroup<double>;
extern template class BlockGroup<float>;

}  // namespace nugget::system
