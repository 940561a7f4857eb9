// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::system {

/// An element without its viscous forces, where it has such (`inviscid()`); else itself.
template <class Element>
Element without_viscosity(const Element& kernel) {
  if constexpr (requires { kernel.inviscid(); })
    return kernel.inviscid();
  else
    return kernel;
}

}  // namespace nugget::system
