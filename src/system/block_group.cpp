// SPDX-License-Identifier: Apache-2.0
#include "system/block_group.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "system/archive_by_element.hpp"

namespace nugget::system {

template <class N>
BlockGroup<N>::BlockGroup(model::ElementKind k, model::Index p, std::vector<model::Index> elements, int corners,
                          bool turns, const StateFields& fields, bool everywhere)
    : fields_(fields), everywhere_(everywhere) {
  kind = k;
  part = p;
  element = std::move(elements);
  nodes_per_element = corners;
  rotational = turns;
  const std::size_t count = blocks() * width;
  nodes_.resize(count * at(corners));
  state_.resize(count * at(fields_.size));
  energy_.resize(count);
  step_.resize(count);
  mass_.resize(size());
  inertia_.resize(size());
}

template <class N>
void BlockGroup<N>::fill(const std::vector<ElementNodes>& connectivity, std::span<const Vec3d> x, bool starts_later) {
  for (std::size_t e = 0; e < blocks() * width; ++e) {
    // Padding lanes repeat the last element, deleted from the start: they do no work and get no node's attention.
    const std::size_t own = std::min(e, size() - 1);
    Places place{};
    for (std::size_t a = 0; a < corners(); ++a) {
      const int node = connectivity[own][a];
      nodes_[node_index(e, a)] = node;
      place[a] = x[at(node)];
    }
    if (e >= size()) continue;
    const auto [mass, inertia] = lump(element[own], place);
    mass_[e] = mass;
    inertia_[e] = inertia;
  }
  starts_later = starts_later && !everywhere_;
  for (std::size_t e = 0; starts_later && e < size(); ++e) elsewhere_.put(e, size(), true, 1.0);
  for (std::size_t b = 0; !starts_later && b < blocks(); ++b) start(b, [&x](int node) { return x[at(node)]; });
}

template <class N>
void BlockGroup<N>::start(const std::function<Vec3d(int)>& place, const std::function<bool(std::size_t)>& here) {
  for (std::size_t b = blocks(); b-- > 0;) {  // blocks of padding go with the last element, which is then still there
    if (!elsewhere_.has(std::min(b * width, size() - 1)) || !here(b)) continue;
    elsewhere_.take_out(b * width, (b + 1) * width);
    start(b, place);
  }
}

template <class N>
void BlockGroup<N>::start(std::size_t b, const std::function<Vec3d(int)>& place_of) {
  std::vector<double> one;  // of an element in double precision, of which in single the numbers are rounded
  if (single) one.resize(at(fields_.size) * native_width);
  for (std::size_t e = b * width; e < (b + 1) * width; ++e) {
    const model::Index own = element[std::min(e, size() - 1)];
    Places place{};
    for (std::size_t a = 0; a < corners(); ++a) place[a] = place_of(nodes_[node_index(e, a)]);
    if constexpr (single) {
      start_state(one.data(), 0, own, place);
      for (int i = 0; i < fields_.size; ++i) put_field(e, i, one[at(i * native_width)]);
    } else {
      start_state(state(e), lane(e), own, place);
    }
    if (e >= size()) put_field(e, fields_.alive, 0.0);
    step_[e] = unlimited;
  }
}

template <class N>
void BlockGroup<N>::leave(const std::function<bool(std::size_t)>& here) {
  if (everywhere_) return;
  const std::size_t numbers = at(fields_.size);
  for (std::size_t b = 0, end; b < blocks(); b = end) {
    for (end = b + 1; end < blocks() && here(end) == here(b);) ++end;
    if (here(b)) continue;
    for (std::size_t e = b * width; e < std::min(size(), end * width); ++e)
      if (!elsewhere_.has(e)) elsewhere_.put(e, size(), alive(e), mass_scale(e));
    forget(state_, b * width * numbers, end * width * numbers);
    forget(energy_, b * width, end * width);
    forget(step_, b * width, end * width);
    strains_.leave(b, end);
    std::fill_n(block_step.begin() + static_cast<std::ptrdiff_t>(b), end - b, unlimited);
  }
}

template <class N>
void BlockGroup<N>::store_reference_state() {
  if (reference_kept_) return;
  if (elsewhere_.count() > 0) throw std::logic_error("states of elements are asked for that other ranks have");
  reference_kept_ = true;
  for (int i = 0; i < fields_.size; ++i) {
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

template <class N>
void BlockGroup<N>::load_reference(std::size_t b, Numbers& values) const {
  const std::size_t fields = reference_fields_.size();
  const N* reference = &reference_state_[b * fields * width];
  values.assign(at(fields_.size) * width, N(0.0));
  for (std::size_t i = 0; i < fields; ++i)
    real_store(&values[at(reference_fields_[i]) * width], real_load<R>(reference + i * width));
}

template <class N>
void BlockGroup<N>::archive(Archive& a) {
  const Archive::Holders to_all{holders.giver, {}}, &of_states = everywhere_ ? to_all : holders;
  ElementGroup::archive(a);
  archive_known(a, *this, elsewhere_);
  archive_by_element(a, state_, at(fields_.size), width, of_states);
  archive_by_element(a, reference_state_, reference_fields_.size(), width, {});
  for (ZeroedVector<double>* numbers : {&energy_, &step_}) a.parts(*numbers, of_states);
  strains_.archive(a, of_states);
  for (std::size_t b = 0; a.reading() && b < blocks(); ++b) find_block_step(b);
  a.built(fields_, nodes_, everywhere_, elsewhere_, reference_fields_, reference_kept_, mass_, inertia_);
}

template <class N>
ElementNodes BlockGroup<N>::nodes(std::size_t e) const {
  ElementNodes n{};
  for (std::size_t a = 0; a < corners(); ++a) n[a] = nodes_[node_index(e, a)];
  return n;
}

template <class N>
void BlockGroup<N>::remove(std::size_t e) {
  if (elsewhere_.has(e))
    elsewhere_.remove(e);
  else
    put_field(e, fields_.alive, 0.0);
  ++deletions;
}

template <class N>
void BlockGroup<N>::release_step(std::size_t e) {
  if (elsewhere_.has(e))
    elsewhere_.release_step(e);
  else
    step_[e] = unlimited;
  find_block_step(e / width);
}

template <class N>
void BlockGroup<N>::take_step(std::size_t e, double step) {
  if (elsewhere_.has(e))
    elsewhere_.take_step(e, step);
  else
    step_[e] = step;
  find_block_step(e / width);
}

template <class N>
void BlockGroup<N>::carry(std::size_t begin, std::size_t end, Carried what, Parcel& parcel) {
  const std::size_t first = begin * width, count = (end - begin) * width;
  parcel(&energy_[first], count);
  if (what == Carried::energies && !everywhere_) {
    for (std::size_t e = first; e < std::min(size(), first + count); ++e) {
      ElementsElsewhere::Energies of_element;
      if (!parcel.reading())
        of_element = {alive(e) ? 1.0 : 0.0, mass_scale(e), hourglass_energy(e), bulk_viscosity_work(e)};
      parcel(&of_element, 1);
      if (parcel.reading()) elsewhere_.take(e, of_element);
    }
    return;
  }
  parcel(state(first), count * at(fields_.size));
  strains_.carry(begin, end, parcel);
  if (parcel.reading()) elsewhere_.take_out(first, first + count);
  if (what != Carried::whole) return;
  parcel(&step_[first], count);
  for (std::size_t b = begin; parcel.reading() && b < end; ++b) find_block_step(b);
}

template <class N>
ElementGroup::Energies BlockGroup<N>::energies(std::size_t begin, std::size_t end) const {
  Energies sum;
  for (std::size_t e = begin; e < end; ++e)
    sum.add(alive(e), internal_energy(e), hourglass_energy(e), bulk_viscosity_work(e));
  return sum;
}

template <class N>
double BlockGroup<N>::kept_mass_scale(double factor) const {
  const N kept = static_cast<N>(factor);
  return kept < factor ? std::nextafter(kept, std::numeric_limits<N>::infinity()) : kept;
}

template <class N>
void BlockGroup<N>::scale_mass(std::size_t e, double factor) {
  if (elsewhere_.has(e)) return elsewhere_.scale(e, factor);
  step_[e] *= std::sqrt(factor / mass_scale(e));
  put_field(e, fields_.density_scale, factor);
  find_block_step(e / width);
}

template <class N>
void BlockGroup<N>::find_block_step(std::size_t b) {
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

template <class N>
void BlockGroup<N>::note_first_inverted(std::size_t b, const R& volume) {
  for (int l = 0; l < width; ++l) {
    const int e = static_cast<int>(b * width) + l;
    if (at(e) >= size() || nugget::lane(volume, l) > 0.0 || !alive(at(e))) continue;
    int first = inverted;
    while ((first < 0 || e < first) && !inverted.compare_exchange_weak(first, e)) {
    }
  }
}

namespace {

/// Component first + l of three is 1 in lane l; everything else is 0.
template <class R>
Vec3<R> unit_motion(int first) {
  Vec3<R> v;
  for (int l = 0; l < lanes<R>; ++l) {
    if (first + l == 0) set_lane(v.x, l, 1.0);
    if (first + l == 1) set_lane(v.y, l, 1.0);
    if (first + l == 2) set_lane(v.z, l, 1.0);
  }
  return v;
}

/// Adds a share of a lane of `f` to three rows of a column of the square matrix k.
template <class R>
void add_to_column(std::span<double> k, int size, int row, int column, const Vec3<R>& f, int lane, double share) {
  for (const R* c : {&f.x, &f.y, &f.z}) k[at(row++ * size + column)] += share * nugget::lane(*c, lane);
}

}  // namespace

template <class N>
void BlockGroup<N>::derive_stiffness(std::size_t e, const State& start, std::span<double> k, bool both_ways) const {
  const int per_node = freedoms(), size = nodes_per_element * per_node;
  [[maybe_unused]] const Denormals denormals;
  Motion motion;
  for (std::size_t a = 0; a < corners(); ++a) {
    Vec3d x = vec(start.x[at(nodes_[node_index(e, a)])]);
    if (single) x -= vec(start.x[at(nodes_[node_index(e, 0)])]);
    motion.x[a] = {R(x.x), R(x.y), R(x.z)};
  }
  std::fill(k.begin(), k.end(), 0.0);
  // So slow that laws of strain rates are at rest, whatever the unit of time. No law in single precision knows rates.
  constexpr double slow = single ? 1.0 : 0x1p-30;
  Numbers scratch(at(fields_.size) * width);
  Forces out;
  for (int first = 0; first < size; first += width)
    for (const double sign : {1.0, -1.0}) {
      if (sign < 0.0 && !both_ways) continue;
      const double share = sign / ((both_ways ? 2.0 : 1.0) * no_step * slow);
      for (int i = 0; i < fields_.size; ++i)
        for (int l = 0; l < width; ++l) scratch[at(i * width + l)] = state(e)[i * width + lane(e)];
      for (int a = 0; a < nodes_per_element; ++a) {
        motion.v[at(a)] = R(sign * slow) * unit_motion<R>(first - a * per_node);
        if (rotational) motion.w[at(a)] = R(sign * slow) * unit_motion<R>(first - a * per_node - 3);
      }
      small_cycle(false, motion, no_step, scratch.data(), out);
      for (int l = 0; l < std::min(width, size - first); ++l)
        for (int a = 0; a < nodes_per_element; ++a) {
          add_to_column(k, size, a * per_node, first + l, out.f[at(a)], l, share);
          if (rotational) add_to_column(k, size, a * per_node + 3, first + l, out.m[at(a)], l, share);
        }
    }
}

template <class N>
typename BlockGroup<N>::Motion BlockGroup<N>::small_motion(std::size_t b, const State& now, std::span<const Row> v,
                                                           std::span<const Row> w, double factor) const {
  const int* id = &nodes_[b * width * corners()];
  Motion motion;
  for (int a = 0; a < nodes_per_element; ++a) {
    motion.x[at(a)] = places_at(now.x, id, a);
    motion.v[at(a)] = R(factor) * places_at(v, id, a);
    if (rotational) motion.w[at(a)] = R(factor) * spins_at(w, id, a);
  }
  return motion;
}

template <class N>
void BlockGroup<N>::vibrate_by_kernel(std::size_t b, const State& now, std::span<const Row> v, std::span<const Row> w,
                                      double dt, std::span<Row> forces, double stiffer,
                                      bool compresses_viscously) const {
  std::fill(forces.begin(), forces.end(), Row{});
  [[maybe_unused]] const Denormals denormals;
  thread_local Numbers scratch;
  Forces out;
  const auto find_forces = [&](bool viscous, double sign, double step) {
    load_reference(b, scratch);
    for (const int i : {fields_.alive, fields_.density_scale})
      real_store(&scratch[at(i * width)], real_load<R>(state(b * width) + i * width));
    small_cycle(viscous, small_motion(b, now, v, w, sign * no_step), step, scratch.data(), out);
  };
  std::array<double, width> factors;
  factors.fill(stiffer);
  const auto add = [&](double share) {
    for (int l = 0; l < width; ++l) {
      if (b * width + at(l) >= size() || !alive(b * width + at(l))) continue;
      const double factor = share * factors[at(l)] / no_step;
      const auto put = [&](Row& row, const Vec3<R>& f) {
        nugget::add(row, factor * Vec3d{nugget::lane(f.x, l), nugget::lane(f.y, l), nugget::lane(f.z, l)});
      };
      for (std::size_t a = 0; a < corners(); ++a) {
        Row* row = &forces[this->row_in_block(at(l), a)];
        put(row[0], out.f[a]);
        if (rotational) put(row[1], out.m[a]);
      }
    }
  };
  const bool solid = kind == model::ElementKind::solid;
  if (!solid && !compresses_viscously) {
    find_forces(true, 1.0, 0.5 * dt);
    add(1.0);
    return;
  }
  find_forces(true, 1.0, dt);
  for (int l = 0; solid && l < width; ++l) {
    const double ratio = nugget::lane(out.stable_step, l) / step_[b * width + at(l)];
    if (ratio > 0.0 && std::isfinite(ratio)) factors[at(l)] = ratio * ratio;
  }
  // (dt K + C) v of the whole step, with bulk viscosity, which acts under compression only, as half of both signs;
  // less half of K.
  add(0.5);
  find_forces(true, -1.0, dt);
  add(-0.5);
  find_forces(false, 1.0, dt);
  add(-0.5);
}

template <class N>
void BlockGroup<N>::add_strains(std::size_t b, std::span<const Vec3<R>> x, std::span<const Vec3<R>> v,
                                std::span<const Vec3<R>> w, double dt) {
  const bool shells = strains_.rule().of == StrainRule::Of::shells;
  const R depth = shells ? each_lane<R>([&](int l) { return thickness(b * width + at(l)); }) : R(0.0);
  strains_.add(b, x, v, w, real_load<R>(state(b * width) + fields_.alive * width), depth, dt);
}

template <class N>
void BlockGroup<N>::damp(std::size_t b, Motion motion, double dt, Slots& slots) const {
  const double* ahead = slots.data() + Slots::place(slot(b * width, 0));
  for (std::size_t i = 0; i < 3 * this->rows_of_element(); ++i) __builtin_prefetch(ahead + i * Slots::lanes, 1);
  thread_local Numbers scratch;
  load_reference(b, scratch);
  const R alive_field = real_load<R>(state(b * width) + fields_.alive * width);
  real_store(&scratch[at(fields_.alive * width)], alive_field);
  for (std::size_t a = 0; a < corners(); ++a) motion.x[a] = motion.x[a] - R(0.5 * dt) * motion.v[a];
  Forces out;
  small_cycle(false, motion, no_step, scratch.data(), out);

  R step;  // 0 of what has no stiffness
  for (int l = 0; l < width; ++l) {
    const double own = step_[b * width + at(l)];
    set_lane(step, l, own < std::numeric_limits<double>::infinity() ? own : 0.0);
  }
  const R beta = R(1.0 / no_step) * (damping_time > 0.0 ? R(damping_time) : R(damping_share) * step);
  const auto alive = R(0.0) < alive_field;
  const auto damping = [&](const Vec3<R>& f) {
    return Vec3<R>{select(alive, beta * f.x, R(0.0)), select(alive, beta * f.y, R(0.0)),
                   select(alive, beta * f.z, R(0.0))};
  };
  const auto put = [&slots](std::size_t first, const Vec3<R>& v) {
    for (int l = 0; l < width; ++l)
      slots.set(first + at(l), {nugget::lane(v.x, l), nugget::lane(v.y, l), nugget::lane(v.z, l)});
  };
  for (int a = 0; a < nodes_per_element; ++a) {
    put(slot(b * width, a), damping(out.f[at(a)]));
    if (rotational) put(this->moment_slot(b * width, a), damping(out.m[at(a)]));
  }
}

template class BlockGroup<double>;
template class BlockGroup<float>;

}  // namespace nugget::system
