// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "base/batch.hpp"

// Kernels are compiled for the lanes of a batch only. What follows runs one for one element, which stands in all lanes.
namespace nugget {

/// A struct of numbers, such as a motion, forces or a tensor, with another kind of number.
template <class Struct, class To>
struct WithNumbers;
template <template <class> class Struct, class From, class To>
struct WithNumbers<Struct<From>, To> {
  using Type = Struct<To>;
};
template <template <class, int> class Struct, class From, int n, class To>
struct WithNumbers<Struct<From, n>, To> {
  using Type = Struct<To, n>;
};

/// The same numbers in all lanes.
template <class One>
auto in_all_lanes(const One& one) {
  typename WithNumbers<One, NativeBatch>::Type all;
  static_assert(sizeof all == native_width * sizeof one && sizeof one % sizeof(double) == 0);
  std::array<double, sizeof one / sizeof(double)> number;
  std::array<double, sizeof all / sizeof(double)> numbers;
  std::memcpy(number.data(), &one, sizeof one);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number[i / native_width];
  std::memcpy(static_cast<void*>(&all), numbers.data(), sizeof all);
  return all;
}

/// Those of the first lane.
template <class All>
auto in_first_lane(const All& all) {
  typename WithNumbers<All, double>::Type one;
  static_assert(sizeof all == native_width * sizeof one && sizeof one % sizeof(double) == 0);
  std::array<double, sizeof one / sizeof(double)> number;
  std::array<double, sizeof all / sizeof(double)> numbers;
  std::memcpy(numbers.data(), static_cast<const void*>(&all), sizeof all);
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = numbers[i * native_width];
  std::memcpy(static_cast<void*>(&one), number.data(), sizeof one);
  return one;
}

/// The state of one element, or the history of one point, in all lanes while this lives; then that of the first lane is
/// put back. Number i of lane l stands at data()[i * native_width + l].
class StateInAllLanes {
 public:
  explicit StateInAllLanes(std::span<double> of_one) : one_(of_one), all_(of_one.size() * native_width) {
    for (std::size_t i = 0; i < all_.size(); ++i) all_[i] = one_[i / native_width];
  }
  ~StateInAllLanes() {
    for (std::size_t i = 0; i < one_.size(); ++i) one_[i] = all_[i * native_width];
  }
  StateInAllLanes(const StateInAllLanes&) = delete;
  StateInAllLanes& operator=(const StateInAllLanes&) = delete;

  double* data() { return all_.data(); }

 private:
  std::span<double> one_;
  std::vector<double> all_;
};

/// Forces of one element: cycle(motion, state) is the kernel of its kind with all its other arguments.
template <class Motion, class Cycle>
auto one_element(const Motion& motion, std::span<double> state, Cycle&& cycle) {
  StateInAllLanes lanes(state);
  return in_first_lane(cycle(in_all_lanes(motion), lanes.data()));
}

}  // namespace nugget
