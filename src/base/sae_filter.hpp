// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

namespace nugget {

/// Channel frequency classes of SAE J211-1 (ISO 6487): -3 dB at 5/3 of the class in hertz.
inline constexpr std::array<int, 4> channel_classes{60, 180, 600, 1000};

/// Values over ascending times.
struct TimeHistory {
  std::vector<double> times, values;
};

/// The signal filtered to a channel frequency class, at as many times, evenly spaced: a second-order Butterworth filter
/// run forwards and backwards, so that no phase is shifted (SAE J211-1, appendix C). `second` is one second in the unit
/// of the times. Until the first time the signal was `before`: nothing acted before a run began, and a first sample
/// that is the blow of one cycle must not count as a force that had long been there. Throws std::runtime_error with the
/// reason where times do not ascend, are fewer than three, or lie too far apart for the class.
TimeHistory sae_filtered(std::span<const double> times, std::span<const double> values, int channel_class,
                         double second, double before = 0.0);

}  // namespace nugget
