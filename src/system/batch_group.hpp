// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "system/before_cycle.hpp"
#include "system/block_group.hpp"
#include "system/imposed_stress.hpp"
#include "system/joined_beams.hpp"
#include "system/lane_forces.hpp"
#include "system/small_motions.hpp"

namespace nugget::system {

/// Walks the blocks of one kind of element: gathers nodal rows into lanes, calls the kernel, books the work of the
/// nodal forces as internal energy, and writes the forces into slots. What is particular to a kind of element comes
/// from `Element`. In single precision motions are differences to the element's first node, taken of doubles. The
/// forces of an element then add up to nothing exactly, as far as a float can say it, so that momentum is kept.
///   corners, rotational               number of nodes; whether nodes carry spins and moments
///   Layout: alive, density_scale, hourglass_energy, bulk_viscosity_work (may be absent)   fields of the state
///   state_size()                      numbers of state an element
///   start(state, lane, element)       initial state of an element (model index)
///   cycle<R>(motion, dt, state)       the kernel; returns f, m (where rotational) and stable_step
///   mass, nodal_inertia (element)     of the undeformed element
///   layers(), layer(...), thickness(...), resultants(...)   for output
///   frame_of(places), material_axes_of(field, k, places)   may be absent; see ElementGroup::axes, material_axes
///   before_cycle(state, alive, put)   may be absent; see BeforeCycle
///   layer_in(frame, field, k)         may be absent: a layer, in the frame of frame_of
///   set_layer(put, k, layer, places), inviscid()   may be absent; see ElementGroup::set_layer, cycle
///   change_stresses(state, put, change), takes_stress()   may be absent; the stresses of all points, in the order of
///                                     ElementGroup::layer; see TakesStress
///   stiffness(state, places, k)       where the kernel's own derivative is not exact; may be absent
///   viscosity(state, places, c)       of dashpots; may be absent
///   joint_trial(motion, dt, state), most_state   may be absent; see JoinedBeams
///   viscous_stiffness()               of shells: factor for vibrate on forces that are viscous in part; may be absent
///   Layout::integrity, integrity(state), freeze_yield(state, lane), plastic_strain(state, k)   of welds only: the
///                                     integrity of the weld as a whole, then that of its points
template <class Element, class N = double>
class BatchGroup final : public BlockGroup<N>, public BeforeCycle, public TakesStress, public JoinedBeams {
  using Blocks = BlockGroup<N>;
  using typename Blocks::Denormals;
  using typename Blocks::Forces;
  using typename Blocks::Motion;
  using typename Blocks::Numbers;
  using typename Blocks::Places;
  using typename Blocks::R;
  using ElementMotion = typename Element::template Motion<R>;
  using Layer = ElementGroup::Layer;
  using Blocks::energy_;
  using Blocks::field;
  using Blocks::fields_;
  using Blocks::lane;
  using Blocks::node_index;
  using Blocks::nodes_;
  using Blocks::put_field;
  using Blocks::reader;
  using Blocks::single;
  using Blocks::state;
  using Blocks::step_;
  using Blocks::width;

 public:
  using Blocks::alive;
  static constexpr int line = 64 / sizeof(N);  ///< numbers in a cache line
  static constexpr int slot_lanes = SlotsOf<N>::lanes;
  static constexpr int corners = Element::corners;
  static constexpr int rows = Element::rotational ? 2 : 1;
  static constexpr std::size_t blocks_ahead = 2;  ///< for whose nodes the memory is asked
  static constexpr bool is_weld = requires(Element & kernel) { kernel.freeze_yield(nullptr, 0); };
  static constexpr bool is_joined = requires { Element::most_state; };
  /// Its kernel's own derivative is not exact.
  static constexpr bool has_own_stiffness =
      requires(const Element& kernel, double (*field)(int), std::array<Vec3d, corners> x, std::span<double> k) {
    kernel.stiffness(field, x, k);
  };

  /// `connectivity`: system nodes of each element. `starts_later`: states come with `start`, unless these are welds.
  BatchGroup(Element kernel, model::ElementKind k, model::Index p, std::vector<model::Index> elements,
             const std::vector<ElementNodes>& connectivity, std::span<const Vec3d> x, bool starts_later = false)
      : Blocks(k, p, std::move(elements), corners, Element::rotational, fields_of(kernel), is_weld || is_joined),
        kernel_(std::move(kernel)),
        small_(for_small_motions(kernel_)),
        inviscid_(without_viscosity(small_)) {
    this->fill(connectivity, x, starts_later);
  }

  bool looks_at_neighbours() const override {
    if constexpr (requires { kernel_.nodal_pressure; }) return kernel_.nodal_pressure != nullptr;
    return false;
  }
  void before_cycle(const State& now) override {
    if constexpr (requires(bool (*alive)(std::size_t), void (*put)(std::size_t, int, double)) {
                    kernel_.before_cycle(now, alive, put);
                  })
      kernel_.before_cycle(
          now, [this](std::size_t e) { return alive(e); },
          [this](std::size_t e, int i, double value) { this->set_number(e, i, value); });
  }

  void joint_trial([[maybe_unused]] std::size_t e, [[maybe_unused]] const State& now,
                   [[maybe_unused]] kernel::WeldTrial& trial) const override {
    if constexpr (is_joined) {
      typename Element::template Motion<double> motion;
      for (int a = 0; a < corners; ++a) {
        const int node = nodes_[node_index(e, a)];
        motion.v[a] = vec(now.v[node]);
        motion.w[a] = vec(now.w[node]);
        motion.x[a] = vec(now.x[node]) + now.dt * motion.v[a];
      }
      std::array<double, Element::most_state> own;
      for (int i = 0; i < fields_.size; ++i) own[at(i)] = field(e, i);
      kernel_.joint_trial(motion, now.dt, own.data(), trial);
    }
  }
  void set_joint_flow([[maybe_unused]] std::size_t e, [[maybe_unused]] std::span<const double> flow) override {
    if constexpr (is_joined)
      for (std::size_t i = 0; i < flow.size(); ++i)
        put_field(e, kernel_.layout().joint_flow() + static_cast<int>(i), flow[i]);
  }

  void cycle(std::size_t begin, std::size_t end, const State& now, double dt, Slots& slots, Slots& damping) override {
    [[maybe_unused]] const Denormals denormals;
    for (std::size_t b = begin; b < end; ++b) {
      // On their way from memory while the kernel runs: the forces of the step before, and the state of the next block.
      N* slot = slots_of(b, slots);
      for (int i = 0; i < 3 * corners * rows; ++i) __builtin_prefetch(slot + i * slot_lanes, 1);
      const N* next = state(std::min(b + 1, end - 1) * width);
      for (int i = 0; i < width * fields_.size; i += line) __builtin_prefetch(next + i, 1);
      ask_for_nodes(std::min(b + blocks_ahead, end - 1), now);
      const ElementMotion motion = motion_of(b, now);
      const R alive_before = real_load<R>(state(b * width) + Element::Layout::alive * width);
      auto out = kernel_.template cycle<R>(motion, dt, state(b * width));
      if constexpr (can_take_stress) {
        if (!imposed_.empty()) impose(b, motion, out);
      }
      if constexpr (requires { out.volume; }) zero_forces_of_inverted<R, Element::rotational>(out);
      if constexpr (single) balance(out.f);
      if (const R alive_now = real_load<R>(state(b * width) + Element::Layout::alive * width);
          any(alive_now < alive_before))
        this->deletions += lanes_below<N, width>(alive_now, alive_before);

      // Work over the step: trapezoid of the forces before and after, times the velocities in between.
      R work(0.0);
      for (int a = 0; a < corners; ++a) {
        work += dot(exchanged(slot, out.f[a]) + out.f[a], motion.v[a]);
        slot += 3 * slot_lanes;
        if constexpr (Element::rotational) {
          work += dot(exchanged(slot, out.m[a]) + out.m[a], motion.w[a]);
          slot += 3 * slot_lanes;
        }
      }
      add_as_doubles(&energy_[b * width], R(0.5 * dt) * work);
      this->keep_steps(b, out.stable_step);
      if constexpr (requires { out.volume; }) this->note_inverted(b, out.volume);
      if (this->strains_.wanted()) add_strains_of(b, motion, dt);
      if (this->damped()) this->damp(b, copy_of(motion), dt, damping);
    }
  }

  bool takes_stress() const override {
    if constexpr (requires { kernel_.takes_stress(); }) return kernel_.takes_stress();
    return can_take_stress;
  }
  void impose(std::vector<ImposedStress> stresses) override { imposed_ = std::move(stresses); }

  void own_stiffness(std::size_t e, const State& start, std::span<double> k) const override {
    if constexpr (has_own_stiffness)
      kernel_.stiffness(reader(e), places(e, start), k);
    else
      this->derive_stiffness(e, start, k, pulls_otherwise<Element>());
  }

  bool viscosity(std::size_t e, const State& start, std::span<double> c) const override {
    if constexpr (requires { kernel_.viscosity(reader(e), places(e, start), c); })
      return kernel_.viscosity(reader(e), places(e, start), c);
    return false;
  }
  bool force_at_start(std::size_t e, const State& start, std::span<double> f) const override {
    if constexpr (requires { kernel_.force_at_start(reader(e), places(e, start), f); })
      return kernel_.force_at_start(reader(e), places(e, start), f);
    return false;
  }

  void vibrate(std::size_t b, const State& now, std::span<const Row> v, std::span<const Row> w, double dt,
               std::span<Row> slots) const override {
    if constexpr (has_own_stiffness) {
      ElementGroup::vibrate(b, now, v, w, dt, slots);
    } else {
      double stiffer = 1.0;
      if constexpr (requires { kernel_.viscous_stiffness(); }) stiffer = kernel_.viscous_stiffness();
      this->vibrate_by_kernel(b, now, v, w, dt, slots, stiffer, compresses_viscously());
    }
  }

  void archive(Archive& a) override {
    Blocks::archive(a);
    a.built(kernel_, small_, inviscid_, imposed_);
  }

  std::vector<int> crash_front_fields() const override {
    if constexpr (requires { kernel_.crash_front_fields(); }) return kernel_.crash_front_fields();
    return {};
  }
  double integrity(std::size_t e) const override {
    if constexpr (is_weld) return field(e, Element::Layout::integrity) * kernel_.integrity(reader(e));
    return 1.0;
  }
  void set_integrity(std::size_t e, double share) override {
    if constexpr (is_weld) put_field(e, Element::Layout::integrity, share);
  }
  void freeze_yield(std::size_t e) override {
    if constexpr (is_weld) kernel_.freeze_yield(state(e), lane(e));
  }

  int layers() const override { return kernel_.layers(); }
  Layer layer(std::size_t e, int k, const State& now) const override {
    return kernel_.layer(reader(e), k, places(e, now));
  }
  void through(std::size_t e, const State& now, const std::optional<Frame3d>& axes,
               std::span<Layer> layers) const override {
    if constexpr (requires { kernel_.layer_in(*axes, reader(e), 0); })
      for (std::size_t k = 0; k < layers.size(); ++k)
        layers[k] = kernel_.layer_in(*axes, reader(e), static_cast<int>(k));
    else
      ElementGroup::through(e, now, axes, layers);
  }
  bool set_layer(std::size_t e, int k, const Layer& l, const State& now) override {
    const auto put = [this, e](int i, double value) { put_field(e, i, value); };
    if constexpr (requires { kernel_.set_layer(put, k, l, places(e, now)); }) {
      kernel_.set_layer(put, k, l, places(e, now));
      return true;
    }
    return false;
  }
  double plastic_strain(std::size_t e, int k) const override {
    if constexpr (is_weld) return kernel_.plastic_strain(reader(e), k);
    return 0.0;
  }
  std::optional<Frame3d> axes(std::size_t e, const State& now) const override {
    if constexpr (requires { kernel_.frame_of(places(e, now)); }) return kernel_.frame_of(places(e, now));
    if constexpr (requires { kernel_.axes_now(reader(e)); }) return kernel_.axes_now(reader(e));
    return {};
  }
  std::optional<Frame3d> material_axes(std::size_t e, int k, const State& now) const override {
    if constexpr (requires { kernel_.material_axes_of(reader(e), k, places(e, now)); })
      return kernel_.material_axes_of(reader(e), k, places(e, now));
    return {};
  }
  double thickness(std::size_t e) const override { return kernel_.thickness(reader(e)); }
  std::array<double, 8> resultants(std::size_t e) const override { return kernel_.resultants(reader(e)); }
  std::array<double, 6> displacements(std::size_t e) const override {
    if constexpr (requires { kernel_.displacements(reader(e)); }) return kernel_.displacements(reader(e));
    return {};
  }
  double strain_rate(std::size_t e) const override {
    if constexpr (requires { Element::Layout::strain_rate; }) return field(e, Element::Layout::strain_rate);
    return 0.0;
  }

 private:
  /// A shell with bulk viscosity, which acts under compression only, as that of solids does.
  bool compresses_viscously() const {
    if constexpr (requires { kernel_.shell.bulk_linear; }) return kernel_.shell.bulk_linear > 0.0;
    return false;
  }
  N* slots_of(std::size_t b, Slots& slots) const {
    if constexpr (single)
      return this->single_slots + SlotsOf<N>::place(this->slot(b * width, 0) - this->first_slot);
    else
      return slots.data() + Slots::place(this->slot(b * width, 0));
  }
  /// Puts a vector into the slots of a block, and returns what stood there.
  [[gnu::always_inline]] static inline Vec3<R> exchanged(N* slot, const Vec3<R>& now) {
    N *const y = slot + slot_lanes, *const z = y + slot_lanes;
    const Vec3<R> before{real_load<R>(slot), real_load<R>(y), real_load<R>(z)};
    real_store(slot, now.x);
    real_store(y, now.y);
    real_store(z, now.z);
    return before;
  }
  [[gnu::always_inline]] inline ElementMotion motion_of(std::size_t b, const State& now) const {
    const int* id = &nodes_[b * width * corners];
    ElementMotion motion;
    for (int a = 0; a < corners; ++a) {
      motion.x[a] = Blocks::places_at(now.x, id, a);
      motion.v[a] = Blocks::places_at(now.v, id, a);
      if constexpr (Element::rotational) motion.w[a] = Blocks::spins_at(now.w, id, a);
    }
    return motion;
  }
  /// Two corners of four: the others are those of neighbours.
  [[gnu::always_inline]] inline void ask_for_nodes(std::size_t b, const State& now) const {
    for (int a = 0; a < corners; a += 2)
      for (int l = 0; l < width; ++l) {
        const int node = nodes_[b * width * corners + at(a * width + l)];
        __builtin_prefetch(&now.x[node]);
        __builtin_prefetch(&now.v[node]);
        if constexpr (Element::rotational) __builtin_prefetch(&now.w[node]);
      }
  }
  std::array<Vec3d, corners> places(std::size_t e, const State& now) const {
    std::array<Vec3d, corners> x;
    for (int a = 0; a < corners; ++a) x[a] = vec(now.x[nodes_[node_index(e, a)]]);
    return x;
  }
  static constexpr bool can_take_stress = requires(Element & kernel, double (*field)(int), void (*put)(int, double),
                                                   void (*change)(std::array<double, 6>&)) {
    kernel.change_stresses(field, put, change);
  };
  /// Gives the elements of block b the stresses that are imposed on them, and `out` the forces of these: those of a
  /// step that moves nothing, so that viscous forces, which go with the velocities, are the same.
  template <class Out>
  void impose(std::size_t b, const ElementMotion& motion, Out& out) {
    const auto before = [](const ImposedStress& s, std::size_t e) { return s.element < e; };
    const auto first = std::lower_bound(imposed_.begin(), imposed_.end(), b * width, before),
               last = std::lower_bound(first, imposed_.end(), (b + 1) * width, before);
    if (first == last) return;
    thread_local Numbers scratch;
    const N* block = state(b * width);
    scratch.assign(block, block + fields_.size * width);
    for (auto s = first; s != last; ++s)
      if (alive(s->element)) put_stress<width>(kernel_, *s, scratch.data() + lane(s->element));
    const auto again = kernel_.template cycle<R>(motion, Blocks::no_step, scratch.data());
    for (auto s = first; s != last; ++s) {
      if (!alive(s->element)) continue;
      const int l = lane(s->element);
      for (int i = 0; i < fields_.size; ++i) put_field(s->element, i, scratch[i * width + l]);
      for (int a = 0; a < corners; ++a) {
        copy_lane(again.f[a], out.f[a], l);
        if constexpr (Element::rotational) copy_lane(again.m[a], out.m[a], l);
      }
    }
  }
  static StateFields fields_of(const Element& kernel) {
    using Layout = typename Element::Layout;
    StateFields fields{.size = kernel.state_size(),
                       .alive = Layout::alive,
                       .density_scale = Layout::density_scale,
                       .hourglass_energy = Layout::hourglass_energy};
    if constexpr (single) fields.size += Layout::rests;  // see ShellLayout
    if constexpr (requires { Layout::bulk_viscosity_work; }) fields.bulk_viscosity_work = Layout::bulk_viscosity_work;
    return fields;
  }
  static std::array<Vec3d, corners> first_places(const Places& x) {
    std::array<Vec3d, corners> first;
    std::copy_n(x.begin(), corners, first.begin());
    return first;
  }
  void start_state(double* values, int l, model::Index own, const Places& x) const override {
    kernel_.start(values, l, own, first_places(x));
  }
  std::array<double, 2> lump(model::Index own, const Places& x) const override {
    return {kernel_.mass(own, first_places(x)), kernel_.nodal_inertia(own, first_places(x))};
  }
  void small_cycle(bool viscous, const Motion& of, double dt, N* values, Forces& forces) const override {
    ElementMotion motion;
    for (std::size_t a = 0; a < corners; ++a) {
      motion.x[a] = of.x[a];
      motion.v[a] = of.v[a];
      if constexpr (Element::rotational) motion.w[a] = of.w[a];
    }
    const auto out = (viscous ? small_ : inviscid_).template cycle<R>(motion, dt, values);
    for (std::size_t a = 0; a < corners; ++a) {
      forces.f[a] = out.f[a];
      if constexpr (Element::rotational) forces.m[a] = out.m[a];
    }
    forces.stable_step = out.stable_step;
  }
  void add_strains_of(std::size_t b, const ElementMotion& motion, double dt) {
    if constexpr (Element::rotational)
      this->add_strains(b, motion.x, motion.v, motion.w, dt);
    else
      this->add_strains(b, motion.x, motion.v, {}, dt);
  }
  static Motion copy_of(const ElementMotion& motion) {
    Motion of;
    for (std::size_t a = 0; a < corners; ++a) {
      of.x[a] = motion.x[a];
      of.v[a] = motion.v[a];
      if constexpr (Element::rotational) of.w[a] = motion.w[a];
    }
    return of;
  }

  Element kernel_, small_, inviscid_;   ///< the second for small motions, the third without viscous forces, too
  std::vector<ImposedStress> imposed_;  ///< by rising element; given anew before each cycle
};

}  // namespace nugget::system
