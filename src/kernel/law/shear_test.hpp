// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "base/curve.hpp"

namespace nugget::kernel {

/// Whether a test may end at this plastic strain [1] and effective stress [stress].
using EndOfTest = std::function<bool(double plastic, double stress)>;

/// Effective stress [stress] over plastic strain [1] of a layer of a law under shear in its plane, by steps of strain
/// at a rate [1/time], up to an engineering strain of `most_strain` [1], the failure of the point or the end of the
/// test. It begins at a plastic strain of 0 and the first yield stress; empty where the law does not flow.
///
/// Instantiated for PlasticKinematic, PiecewiseLinear, ComposedLaw.
template <class Law>
Curve shear_test(const Law& law, double strain_rate, double most_strain, const EndOfTest& enough);

}  // namespace nugget::kernel
