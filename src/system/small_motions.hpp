// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::system {

/// An element for motions so small that its forces are linear in them: its law without the pressure that an equation of
/// state has at the start (`linear_at_start()`), where it has one; else itself.
template <class Element>
Element for_small_motions(Element kernel) {
  if constexpr (requires { kernel.law.linear_at_start(); }) kernel.law = kernel.law.linear_at_start();
  return kernel;
}

/// An element without its viscous forces, where it has such (`inviscid()`); else itself.
template <class Element>
Element without_viscosity(const Element& kernel) {
  if constexpr (requires { kernel.inviscid(); })
    return kernel.inviscid();
  else
    return kernel;
}

}  // namespace nugget::system
