// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/elastic_kernel.hpp"
#include "kernel/law/piecewise_linear_kernel.hpp"
#include "kernel/law/plastic_kinematic_kernel.hpp"
#include "kernel/law/spotweld_kernel.hpp"

// The laws whose element kernels are compiled for themselves (docs/decisions/0024); all others are composed at run
// time.
namespace nugget::kernel {

/// Those of them whose shells and bricks are compiled in single precision, too.
template <class Law>
inline constexpr bool built_for_single =
    std::is_same_v<Law, Elastic> || std::is_same_v<Law, PlasticKinematic> || std::is_same_v<Law, PiecewiseLinear>;

}  // namespace nugget::kernel
