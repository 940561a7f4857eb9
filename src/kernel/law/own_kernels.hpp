// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/elastic_kernel.hpp"
#include "kernel/law/piecewise_linear_kernel.hpp"
#include "kernel/law/plastic_kinematic_kernel.hpp"
#include "kernel/law/spotweld_kernel.hpp"

// The laws whose element kernels are compiled for themselves (docs/decisions/0024); all others are composed at run
// time.
