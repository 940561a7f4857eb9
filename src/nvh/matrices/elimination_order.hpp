// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nvh/matrices/matrices.hpp"

namespace nugget::nvh {

/// Order of elimination: nested dissection by METIS. Position by equation, counted from 1 as MUMPS wants it.
///
/// Unknowns of a node follow each other as far as the matrices couple them, there or with its neighbours. In a flat
/// sheet along the axes, motions in its plane and out of it are uncoupled: they are dissected as two graphs,
/// which halves the factor there.
std::vector<int> elimination_order(const Matrices& matrices);

}  // namespace nugget::nvh
