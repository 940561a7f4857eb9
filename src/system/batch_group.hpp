// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/batch.hpp"
#include "base/denormals.hpp"
#include "base/index.hpp"
#include "base/row.hpp"
#include "base/zeroed.hpp"
#include "system/archive_by_element.hpp"
#include "system/before_cycle.hpp"
#include "system/element_group.hpp"
#include "system/elements_elsewhere.hpp"
#include "system/imposed_stress.hpp"
#include "system/joined_beams.hpp"
#include "system/lane_forces.hpp"
#include "system/small_motions.hpp"

namespace nugget::system {

/// Walks the blocks of one kind of element: gathers nodal rows into lanes, calls the kernel, books the work of the
/// nodal forces as internal energy, and writes the forces into slots. What is particular to a kind of element comes
/// from `Element`. In single precision (N float) the kernel's lanes, the state and the slots are floats; motions are
/// differences to the element's first node, taken of doubles; energies are added up, and steps kept, as doubles. The
/// forces of an element then add up to nothing exactly, as far as a float can say it, so that momentum is kept.
///   corners, rotational               number of nodes; whether nodes carry spins and moments
///   Layout: alive, density_scale, hourglass_energy   fields of the state
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
class BatchGroup final : public ElementGroup, public BeforeCycle, public TakesStress, public JoinedBeams {
 public:
  using R = NativeBatchOf<N>;
  static constexpr bool single = is_single<R>;
  static constexpr int width = lanes<R>;
  static constexpr int line = 64 / sizeof(N);  ///< numbers in a cache line
  static constexpr std::size_t widest_width = single ? 2 * widest_block : widest_block;
  static_assert(widest_width % width == 0);
  using Numbers = std::vector<N, Aligned<N>>;
  using SlotRow = std::conditional_t<single, SingleRow, Row>;
  static constexpr int corners = Element::corners;
  static constexpr int rows = Element::rotational ? 2 : 1;
  /// A step that moves nothing; of floats one after which strains are still normal numbers, whatever the units.
  static constexpr double no_step = single ? 0x1p-40 : 0x1p-100;
  static constexpr double unlimited = std::numeric_limits<double>::infinity();
  static constexpr std::size_t blocks_ahead = 2;  ///< for whose nodes the memory is asked
  static constexpr bool is_weld = requires(Element & kernel) { kernel.freeze_yield(nullptr, 0); };
  static constexpr bool is_joined = requires { Element::most_state; };
  static constexpr bool stays_here = is_weld || is_joined;  ///< on every rank: welds are looked at by others
  /// Its kernel's own derivative is not exact.
  static constexpr bool has_own_stiffness =
      requires(const Element& kernel, double (*field)(int), std::array<Vec3d, corners> x, std::span<double> k) {
    kernel.stiffness(field, x, k);
  };

  /// `connectivity`: system nodes of each element. `starts_later`: states come with `start`, unless these are welds.
  BatchGroup(Element kernel, model::ElementKind k, model::Index p, std::vector<model::Index> elements,
             const std::vector<ElementNodes>& connectivity, std::span<const Vec3d> x, bool starts_later = false)
      : kernel_(std::move(kernel)), small_(for_small_motions(kernel_)), inviscid_(without_viscosity(small_)) {
    kind = k;
    part = p;
    element = std::move(elements);
    nodes_per_element = corners;
    rotational = Element::rotational;
    const std::size_t count = blocks() * width;
    nodes_.resize(count * corners);
    state_.resize(count * at(state_size()));
    energy_.resize(count);
    step_.resize(count);
    mass_.resize(size());
    inertia_.resize(size());
    for (std::size_t e = 0; e < count; ++e) {
      // Padding lanes repeat the last element, deleted from the start: they do no work and get no node's attention.
      const std::size_t own = std::min(e, size() - 1);
      std::array<Vec3d, corners> place;
      for (int a = 0; a < corners; ++a) {
        const int node = connectivity[own][a];
        nodes_[node_index(e, a)] = node;
        place[a] = x[node];
      }
      if (e >= size()) continue;
      mass_[e] = kernel_.mass(element[own], place);
      inertia_[e] = kernel_.nodal_inertia(element[own], place);
    }
    starts_later = starts_later && !stays_here;
    for (std::size_t e = 0; starts_later && e < size(); ++e) elsewhere_.put(e, size(), true, 1.0);
    for (std::size_t b = 0; !starts_later && b < blocks(); ++b) start(b, [&x](int node) { return x[node]; });
  }

  void start(const std::function<Vec3d(int)>& place, const std::function<bool(std::size_t)>& here) override {
    for (std::size_t b = blocks(); b-- > 0;) {  // blocks of padding go with the last element, which is then still there
      if (!elsewhere_.has(std::min(b * width, size() - 1)) || !here(b)) continue;
      elsewhere_.take_out(b * width, (b + 1) * width);
      start(b, place);
    }
  }
  void leave(const std::function<bool(std::size_t)>& here) override {
    if (stays_here) return;
    for (std::size_t b = 0, end; b < blocks(); b = end) {
      for (end = b + 1; end < blocks() && here(end) == here(b);) ++end;
      if (here(b)) continue;
      for (std::size_t e = b * width; e < std::min(size(), end * width); ++e)
        if (!elsewhere_.has(e)) elsewhere_.put(e, size(), alive(e), mass_scale(e));
      forget(state_, b * width * at(state_size()), end * width * at(state_size()));
      forget(energy_, b * width, end * width);
      forget(step_, b * width, end * width);
      std::fill_n(block_step.begin() + static_cast<std::ptrdiff_t>(b), end - b, unlimited);
    }
  }
  std::size_t elsewhere() const override { return elsewhere_.count(); }

  std::size_t blocks() const override { return (size() + widest_width - 1) / widest_width * widest_width / width; }
  std::size_t widest() const override { return widest_width; }
  bool single_precision() const override { return single; }
  std::size_t block_width() const override { return width; }
  std::size_t slot_rows() const override { return blocks() * width * corners * rows; }
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
          [this](std::size_t e, int i, double value) { set_number(e, i, value); });
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
      for (int i = 0; i < state_size(); ++i) own[at(i)] = field(e, i);
      kernel_.joint_trial(motion, now.dt, own.data(), trial);
    }
  }
  void set_joint_flow([[maybe_unused]] std::size_t e, [[maybe_unused]] std::span<const double> flow) override {
    if constexpr (is_joined)
      for (std::size_t i = 0; i < flow.size(); ++i)
        put_field(e, kernel_.layout().joint_flow() + static_cast<int>(i), flow[i]);
  }

  void cycle(std::size_t begin, std::size_t end, const State& now, double dt, std::span<Row> slots,
             std::span<Row> damping) override {
    [[maybe_unused]] const Denormals denormals;
    for (std::size_t b = begin; b < end; ++b) {
      // On their way from memory while the kernel runs: the forces of the step before, and the state of the next block.
      SlotRow* slot = slots_of(b, slots);
      for (int row = 0; row < width * corners * rows; row += 64 / sizeof(SlotRow)) __builtin_prefetch(slot + row, 1);
      const N* next = state(std::min(b + 1, end - 1) * width);
      for (int i = 0; i < width * state_size(); i += line) __builtin_prefetch(next + i, 1);
      ask_for_nodes(std::min(b + blocks_ahead, end - 1), now);
      const typename Element::template Motion<R> motion = motion_of(b, now);
      const R alive_before = real_load<R>(state(b * width) + Element::Layout::alive * width);
      auto out = kernel_.template cycle<R>(motion, dt, state(b * width));
      if constexpr (can_take_stress) {
        if (!imposed_.empty()) impose(b, motion, out);
      }
      if constexpr (requires { out.volume; }) zero_forces_of_inverted<R, Element::rotational>(out);
      if constexpr (single) balance(out.f);
      if (const R alive_now = real_load<R>(state(b * width) + Element::Layout::alive * width);
          any(alive_now < alive_before))
        deletions += lanes_below<N, width>(alive_now, alive_before);

      // Work over the step: trapezoid of the forces before and after, times the velocities in between.
      R work(0.0);
      for (int a = 0; a < corners; ++a) {
        int row[width];
        for (int l = 0; l < width; ++l) row[l] = (l * corners + a) * rows;
        work += dot(rows_at(slot, row) + out.f[a], motion.v[a]);
        put_rows(slot, row, out.f[a]);
        if constexpr (Element::rotational) {
          work += dot(rows_at(slot + 1, row) + out.m[a], motion.w[a]);
          put_rows(slot + 1, row, out.m[a]);
        }
      }
      add_as_doubles(&energy_[b * width], R(0.5 * dt) * work);
      store_as_doubles(&step_[b * width], out.stable_step);
      if constexpr (requires { out.volume; }) note_inverted(b, out.volume);
      find_block_step(b);
      if (damped()) damp(b, motion, dt, damping);
    }
  }

  bool takes_stress() const override {
    if constexpr (requires { kernel_.takes_stress(); }) return kernel_.takes_stress();
    return can_take_stress;
  }
  void impose(std::vector<ImposedStress> stresses) override { imposed_ = std::move(stresses); }

  /// The kernel's forces after a step with unit velocity in one freedom, a freedom a lane. The step is so short that it
  /// moves nothing and meets no yield, and a power of two: what is left is the exact derivative (docs/decisions/0017).
  void own_stiffness(std::size_t e, const State& start, std::span<double> k) const override {
    if constexpr (requires { kernel_.stiffness(reader(e), places(e, start), k); })
      return kernel_.stiffness(reader(e), places(e, start), k);
    constexpr int per_node = Element::rotational ? 6 : 3, size = corners * per_node;
    [[maybe_unused]] const Denormals denormals;
    typename Element::template Motion<R> motion;
    for (int a = 0; a < corners; ++a) {
      Vec3d x = vec(start.x[nodes_[node_index(e, a)]]);
      if (single) x -= vec(start.x[nodes_[node_index(e, 0)]]);
      motion.x[a] = {R(x.x), R(x.y), R(x.z)};
    }
    std::fill(k.begin(), k.end(), 0.0);
    Numbers scratch(at(state_size() * width));
    constexpr auto signs = signs_of_steps<Element>();
    for (int first = 0; first < size; first += width)
      for (const double sign : signs) {
        const double share = sign / (static_cast<double>(signs.size()) * no_step);
        for (int i = 0; i < state_size(); ++i)
          for (int l = 0; l < width; ++l) scratch[i * width + l] = state(e)[i * width + lane(e)];
        for (int a = 0; a < corners; ++a) {
          motion.v[a] = R(sign) * unit_motion<R, width>(first - a * per_node);
          if constexpr (Element::rotational) motion.w[a] = R(sign) * unit_motion<R, width>(first - a * per_node - 3);
        }
        const auto out = inviscid_.template cycle<R>(motion, no_step, scratch.data());
        for (int l = 0; l < std::min(width, size - first); ++l)
          for (int a = 0; a < corners; ++a) {
            add_to_column(k, size, a * per_node, first + l, out.f[a], l, share);
            if constexpr (Element::rotational) add_to_column(k, size, a * per_node + 3, first + l, out.m[a], l, share);
          }
      }
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

  /// So small velocities that nothing moves and nothing yields: a power of two, as for `stiffness`.
  void vibrate(std::size_t b, const State& now, std::span<const Row> v, std::span<const Row> w, double dt,
               std::span<Row> slots) const override {
    if constexpr (has_own_stiffness) {
      ElementGroup::vibrate(b, now, v, w, dt, slots);
    } else {
      std::fill(slots.begin(), slots.end(), Row{});
      [[maybe_unused]] const Denormals denormals;
      thread_local Numbers scratch;
      const auto forces = [&](const Element& kernel, double sign, double step) {
        load_reference(b, scratch);
        for (const int i : {Element::Layout::alive, Element::Layout::density_scale})
          real_store(&scratch[i * width], real_load<R>(state(b * width) + i * width));
        return kernel.template cycle<R>(small_motion(b, now, v, w, sign * no_step), step, scratch.data());
      };
      const auto add = [&](const auto& out, double share, const std::array<double, width>& stiffer) {
        for (int l = 0; l < width; ++l) {
          if (b * width + at(l) >= size() || !alive(b * width + at(l))) continue;
          const double factor = share * stiffer[l] / no_step;
          const auto put = [&](Row& slot, const Vec3<R>& f) {
            nugget::add(slot, factor * Vec3d{nugget::lane(f.x, l), nugget::lane(f.y, l), nugget::lane(f.z, l)});
          };
          for (int a = 0; a < corners; ++a) {
            Row* slot = &slots[at((l * corners + a) * rows)];
            put(slot[0], out.f[a]);
            if constexpr (Element::rotational) put(slot[1], out.m[a]);
          }
        }
      };
      std::array<double, width> stiffer;
      stiffer.fill(1.0);
      if constexpr (requires { kernel_.viscous_stiffness(); }) stiffer.fill(kernel_.viscous_stiffness());
      const bool solid = kind == model::ElementKind::solid;
      if (!solid && !compresses_viscously()) {
        add(forces(small_, 1.0, 0.5 * dt), 1.0, stiffer);
        return;
      }
      const auto out = forces(small_, 1.0, dt);
      for (int l = 0; solid && l < width; ++l) {
        const double ratio = nugget::lane(out.stable_step, l) / step_[b * width + at(l)];
        if (ratio > 0.0 && std::isfinite(ratio)) stiffer[l] = ratio * ratio;
      }
      // (dt K + C) v of the whole step, with bulk viscosity, which acts under compression only, as half of both signs;
      // less half of K.
      add(out, 0.5, stiffer);
      add(forces(small_, -1.0, dt), -0.5, stiffer);
      add(forces(inviscid_, 1.0, dt), -0.5, stiffer);
    }
  }

  void store_reference_state() override {
    if (reference_kept_) return;
    if (elsewhere_.count() > 0) throw std::logic_error("states of elements are asked for that other ranks have");
    reference_kept_ = true;
    for (int i = 0; i < state_size(); ++i) {
      const auto holds = [this, i](std::size_t b) {
        const N* values = state(b * width) + i * width;
        return std::any_of(values, values + width, [](N x) { return x != N(0.0); });
      };
      for (std::size_t b = 0; b < blocks(); ++b) {
        if (!holds(b)) continue;
        reference_fields_.push_back(i);
        break;
      }
    }
    for (std::size_t b = 0; b < blocks(); ++b)
      for (const int i : reference_fields_) {
        const N* values = state(b * width) + i * width;
        reference_state_.insert(reference_state_.end(), values, values + width);
      }
  }
  void archive(Archive& a) override {
    const Archive::Holders to_all{holders.giver, {}}, &of_states = stays_here ? to_all : holders;
    ElementGroup::archive(a);
    archive_known(a, *this, elsewhere_);
    archive_by_element(a, state_, at(state_size()), width, of_states);
    archive_by_element(a, reference_state_, reference_fields_.size(), width, {});
    for (ZeroedVector<double>* numbers : {&energy_, &step_}) a.parts(*numbers, of_states);
    for (std::size_t b = 0; a.reading() && b < blocks(); ++b) find_block_step(b);
    a.built(kernel_, nodes_, reference_fields_, reference_kept_, small_, inviscid_, mass_, inertia_, imposed_,
            elsewhere_);
  }

  ElementNodes nodes(std::size_t e) const override {
    ElementNodes n{};
    for (int a = 0; a < corners; ++a) n[a] = nodes_[node_index(e, a)];
    return n;
  }
  bool alive(std::size_t e) const override {
    return elsewhere_.has(e) ? elsewhere_.alive(e) : field(e, Element::Layout::alive) != 0.0;
  }
  void remove(std::size_t e) override {
    if (elsewhere_.has(e))
      elsewhere_.remove(e);
    else
      put_field(e, Element::Layout::alive, 0.0);
    ++deletions;
  }
  std::vector<int> crash_front_fields() const override {
    if constexpr (requires { kernel_.crash_front_fields(); }) return kernel_.crash_front_fields();
    return {};
  }
  void set_number(std::size_t e, int i, double value) override {
    if (!elsewhere_.has(e)) put_field(e, i, value);
  }
  void release_step(std::size_t e) override {
    if (elsewhere_.has(e))
      elsewhere_.release_step(e);
    else
      step_[e] = unlimited;
    find_block_step(e / width);
  }
  void take_step(std::size_t e, double step) override {
    if (elsewhere_.has(e))
      elsewhere_.take_step(e, step);
    else
      step_[e] = step;
    find_block_step(e / width);
  }
  void carry(std::size_t begin, std::size_t end, Carried what, Parcel& parcel) override {
    const std::size_t first = begin * width, count = (end - begin) * width;
    parcel(&energy_[first], count);
    if (what == Carried::energies && !stays_here) {
      for (std::size_t e = first; e < std::min(size(), first + count); ++e) {
        ElementsElsewhere::Energies of_element;
        if (!parcel.reading())
          of_element = {alive(e) ? 1.0 : 0.0, mass_scale(e), hourglass_energy(e), bulk_viscosity_work(e)};
        parcel(&of_element, 1);
        if (parcel.reading()) elsewhere_.take(e, of_element);
      }
      return;
    }
    parcel(state(first), count * at(state_size()));
    if (parcel.reading()) elsewhere_.take_out(first, first + count);
    if (what != Carried::whole) return;
    parcel(&step_[first], count);
    for (std::size_t b = begin; parcel.reading() && b < end; ++b) find_block_step(b);
  }
  double stable_step(std::size_t e) const override { return elsewhere_.has(e) ? elsewhere_.step(e) : step_[e]; }
  double internal_energy(std::size_t e) const override { return energy_[e] - hourglass_energy(e); }
  void add_internal_energy(std::size_t e, double work) override { energy_[e] += work; }
  double hourglass_energy(std::size_t e) const override {
    if constexpr (Element::Layout::hourglass_energy < 0) return 0.0;
    if (elsewhere_.has(e)) return elsewhere_.hourglass_energy(e);
    return field(e, Element::Layout::hourglass_energy);
  }
  double bulk_viscosity_work(std::size_t e) const override {
    if constexpr (requires { Element::Layout::bulk_viscosity_work; })
      return elsewhere_.has(e) ? elsewhere_.bulk_viscosity_work(e) : field(e, Element::Layout::bulk_viscosity_work);
    else
      return 0.0;
  }
  double mass(std::size_t e) const override { return mass_[e]; }
  double nodal_inertia(std::size_t e) const override { return inertia_[e]; }
  double mass_scale(std::size_t e) const override {
    return elsewhere_.has(e) ? elsewhere_.scale(e) : field(e, Element::Layout::density_scale);
  }
  double kept_mass_scale(double factor) const override {
    const N kept = static_cast<N>(factor);
    return kept < factor ? std::nextafter(kept, std::numeric_limits<N>::infinity()) : kept;
  }
  void scale_mass(std::size_t e, double factor) override {
    if (elsewhere_.has(e)) return elsewhere_.scale(e, factor);
    step_[e] *= std::sqrt(factor / mass_scale(e));
    put_field(e, Element::Layout::density_scale, factor);
    find_block_step(e / width);
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
  static int lane(std::size_t e) { return static_cast<int>(e % width); }
  std::size_t node_index(std::size_t e, int a) const { return e / width * width * corners + at(a * width + lane(e)); }
  /// Numbers of state an element; see ShellLayout of those that only single precision has.
  int state_size() const {
    if constexpr (single) return kernel_.state_size() + Element::Layout::rests;
    return kernel_.state_size();
  }
  N* state(std::size_t e) { return &state_[e / width * width * at(state_size())]; }
  const N* state(std::size_t e) const { return &state_[e / width * width * at(state_size())]; }
  void put_field(std::size_t e, int i, double value) { state(e)[i * width + lane(e)] = static_cast<N>(value); }
  double field(std::size_t e, int i) const { return state(e)[i * width + lane(e)]; }
  auto reader(std::size_t e) const {
    return [s = state(e), l = lane(e)](int i) -> double { return s[i * width + l]; };
  }

  struct NoDenormals {};
  using Denormals = std::conditional_t<single, FlushedDenormals, NoDenormals>;
  SlotRow* slots_of(std::size_t b, std::span<Row> slots) const {
    if constexpr (single)
      return &single_slots[slot_row(b * width, 0) - first_slot];
    else
      return &slots[slot_row(b * width, 0)];
  }
  [[gnu::always_inline]] static inline Vec3<R> rows_at(const SlotRow* base, const int* id) {
    if constexpr (single)
      return gather_single<width>(base, id);
    else
      return gather<R>(base, id);
  }
  [[gnu::always_inline]] static inline void put_rows(SlotRow* base, const int* id, const Vec3<R>& v) {
    if constexpr (single)
      scatter_single<width>(base, id, v);
    else
      scatter<R>(base, id, v);
  }
  [[gnu::always_inline]] inline typename Element::template Motion<R> motion_of(std::size_t b, const State& now) const {
    const int* id = &nodes_[b * width * corners];
    typename Element::template Motion<R> motion;
    for (int a = 0; a < corners; ++a) {
      motion.x[a] = places_at(now.x, id, a);
      motion.v[a] = places_at(now.v, id, a);
      if constexpr (Element::rotational) motion.w[a] = spins_at(now.w, id, a);
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
  std::array<Vec3d, corners> places(std::size_t e, const State& now) const {
    std::array<Vec3d, corners> x;
    for (int a = 0; a < corners; ++a) x[a] = vec(now.x[nodes_[node_index(e, a)]]);
    return x;
  }
  /// Remembers the first active element whose volume is no longer positive, whichever thread finds it.
  void note_inverted(std::size_t b, const R& volume) {
    for (int l = 0; l < width; ++l) {
      const int e = static_cast<int>(b * width) + l;
      if (at(e) >= size() || nugget::lane(volume, l) > 0.0 || !alive(at(e))) continue;
      int first = inverted;
      while ((first < 0 || e < first) && !inverted.compare_exchange_weak(first, e)) {
      }
    }
  }
  void start(std::size_t b, const std::function<Vec3d(int)>& place_of) {
    std::vector<double> one;  // of an element in double precision, of which in single the numbers are rounded
    if (single) one.resize(at(kernel_.state_size()) * native_width);
    for (std::size_t e = b * width; e < (b + 1) * width; ++e) {
      const model::Index own = element[std::min(e, size() - 1)];
      std::array<Vec3d, corners> place;
      for (int a = 0; a < corners; ++a) place[a] = place_of(nodes_[node_index(e, a)]);
      if constexpr (single) {
        kernel_.start(one.data(), 0, own, place);
        for (int i = 0; i < kernel_.state_size(); ++i) put_field(e, i, one[at(i * native_width)]);
      } else {
        kernel_.start(state(e), lane(e), own, place);
      }
      if (e >= size()) put_field(e, Element::Layout::alive, 0.0);
      step_[e] = unlimited;
    }
  }
  void find_block_step(std::size_t b) {
    if (elsewhere_.has(b * width)) {
      block_step[b] = unlimited;
      for (std::size_t e = b * width; e < std::min(size(), (b + 1) * width); ++e)
        if (!(elsewhere_.step(e) >= block_step[b])) block_step[b] = elsewhere_.step(e);
      return;
    }
    double smallest = step_[b * width];
    for (int l = 1; l < width; ++l) {
      const double s = step_[b * width + at(l)];
      // A NaN must not get lost: it compares false with everything.
      if (!(s >= smallest) && smallest == smallest) smallest = s;
    }
    block_step[b] = smallest;
  }

  static constexpr bool can_take_stress = requires(Element & kernel, double (*field)(int), void (*put)(int, double),
                                                   void (*change)(std::array<double, 6>&)) {
    kernel.change_stresses(field, put, change);
  };
  /// Gives the elements of block b the stresses that are imposed on them, and `out` the forces of these: those of a
  /// step that moves nothing, so that viscous forces, which go with the velocities, are the same.
  template <class Out>
  void impose(std::size_t b, const typename Element::template Motion<R>& motion, Out& out) {
    const auto before = [](const ImposedStress& s, std::size_t e) { return s.element < e; };
    const auto first = std::lower_bound(imposed_.begin(), imposed_.end(), b * width, before),
               last = std::lower_bound(first, imposed_.end(), (b + 1) * width, before);
    if (first == last) return;
    thread_local Numbers scratch;
    const N* block = state(b * width);
    scratch.assign(block, block + state_size() * width);
    for (auto s = first; s != last; ++s)
      if (alive(s->element)) put_stress<width>(kernel_, *s, scratch.data() + lane(s->element));
    const auto again = kernel_.template cycle<R>(motion, no_step, scratch.data());
    for (auto s = first; s != last; ++s) {
      if (!alive(s->element)) continue;
      const int l = lane(s->element);
      for (int i = 0; i < state_size(); ++i) put_field(s->element, i, scratch[i * width + l]);
      for (int a = 0; a < corners; ++a) {
        copy_lane(again.f[a], out.f[a], l);
        if constexpr (Element::rotational) copy_lane(again.m[a], out.m[a], l);
      }
    }
  }
  /// Stiffness-proportional damping of a block. In the middle of the step the velocities, which are chords, of a steady
  /// turning strain nothing; at its end they would stretch, by dt/2 times the centripetal acceleration.
  void damp(std::size_t b, typename Element::template Motion<R> motion, double dt, std::span<Row> slots) const {
    Row* slot = &slots[slot_row(b * width, 0)];
    for (int row = 0; row < width * corners * rows; row += 2) __builtin_prefetch(slot + row, 1);
    thread_local Numbers scratch;
    load_reference(b, scratch);
    const R alive_field = real_load<R>(state(b * width) + Element::Layout::alive * width);
    real_store(&scratch[Element::Layout::alive * width], alive_field);
    for (int a = 0; a < corners; ++a) motion.x[a] = motion.x[a] - R(0.5 * dt) * motion.v[a];
    const auto out = inviscid_.template cycle<R>(motion, no_step, scratch.data());

    R step;
    for (int l = 0; l < width; ++l) set_lane(step, l, step_[b * width + at(l)]);
    const R beta = R(1.0 / no_step) * (damping_time > 0.0 ? R(damping_time) : R(damping_share) * step);
    const auto alive = R(0.0) < alive_field;
    const auto damping = [&](const Vec3<R>& f) {
      return Vec3<R>{select(alive, beta * f.x, R(0.0)), select(alive, beta * f.y, R(0.0)),
                     select(alive, beta * f.z, R(0.0))};
    };
    for (int a = 0; a < corners; ++a) {
      int row[width];
      for (int l = 0; l < width; ++l) row[l] = (l * corners + a) * rows;
      scatter<R>(slot, row, damping(out.f[a]));
      if constexpr (Element::rotational) scatter<R>(slot + 1, row, damping(out.m[a]));
    }
  }
  typename Element::template Motion<R> small_motion(std::size_t b, const State& now, std::span<const Row> v,
                                                    std::span<const Row> w, double factor) const {
    const int* id = &nodes_[b * width * corners];
    typename Element::template Motion<R> motion;
    for (int a = 0; a < corners; ++a) {
      motion.x[a] = places_at(now.x, id, a);
      motion.v[a] = R(factor) * places_at(v, id, a);
      if constexpr (Element::rotational) motion.w[a] = R(factor) * spins_at(w, id, a);
    }
    return motion;
  }
  /// The state of block b that `store_reference_state` kept.
  void load_reference(std::size_t b, Numbers& values) const {
    const std::size_t fields = reference_fields_.size();
    const N* reference = &reference_state_[b * fields * width];
    values.assign(at(state_size() * width), N(0.0));
    for (std::size_t i = 0; i < fields; ++i)
      real_store(&values[reference_fields_[i] * width], real_load<R>(reference + i * width));
  }
  Element kernel_, small_, inviscid_;  ///< the second for small motions, the third without viscous forces, too
  std::vector<int> nodes_;             ///< block by block, node by node, lane by lane
  ZeroedVector<N> state_;
  ZeroedVector<double> energy_, step_;
  ElementsElsewhere elsewhere_;
  std::vector<int> reference_fields_;  ///< of the state, those that are not 0 in all elements free of stress
  Numbers reference_state_;            ///< their values, block by block, field by field; empty where they were not kept
  bool reference_kept_ = false;
  std::vector<double> mass_, inertia_;
  std::vector<ImposedStress> imposed_;  ///< by rising element; given anew before each cycle
};

}  // namespace nugget::system
