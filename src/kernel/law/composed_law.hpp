// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace nugget::kernel {

struct LawComponents;

/// A law put together at run time, of what law/law_components.hpp lists. All such laws share one set of element
/// kernels, which calls the law point by point; the commonest laws have kernels of their own (docs/decisions/0024).
struct ComposedLaw {
  double E = 0.0;   ///< Young's modulus [stress]
  double nu = 0.0;  ///< Poisson's ratio [1]
  std::shared_ptr<const LawComponents> components;
};

}  // namespace nugget::kernel
