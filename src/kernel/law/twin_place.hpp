// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/twin.hpp"
#include "kernel/law/stress_space.hpp"

namespace nugget::kernel {

/// The states of two points, in the place of one pointer: what a law finds and leaves there is a Twin.
template <class N>
struct TwinPlace {
  N *a, *b;
};

template <class T, class N>
requires(is_twin<T>) T load_field(const TwinPlace<N>& state, int field) {
  using R = decltype(T::a);
  return {load_field<R>(state.a, field), load_field<R>(state.b, field)};
}
template <class N, class R>
void store_field(const TwinPlace<N>& state, int field, const Twin<R>& value) {
  store_field(state.a, field, value.a);
  store_field(state.b, field, value.b);
}

/// Field `field` of a state and those behind it.
template <class R>
Number<R>* from_field(Number<R>* state, int field) {
  return state + field * lanes<R>;
}
template <class R>
const Number<R>* from_field(const Number<R>* state, int field) {
  return state + field * lanes<R>;
}
template <class T, class N>
requires(is_twin<T>) TwinPlace<N> from_field(const TwinPlace<N>& state, int field) {
  using R = decltype(T::a);
  return {from_field<R>(state.a, field), from_field<R>(state.b, field)};
}

/// Where the state of a layer stands.
template <class R>
struct LayerPlace {
  Number<R>*stress, *history;
  ThicknessStrain<R>* thickness;
};

}  // namespace nugget::kernel
