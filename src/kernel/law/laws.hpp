// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "kernel/law/anisotropic_sheet.hpp"
#include "kernel/law/composite_layer.hpp"
#include "kernel/law/compression_tension.hpp"
#include "kernel/law/elastic_kernel.hpp"
#include "kernel/law/fabric.hpp"
#include "kernel/law/fluid.hpp"
#include "kernel/law/foam.hpp"
#include "kernel/law/honeycomb.hpp"
#include "kernel/law/johnson_cook.hpp"
#include "kernel/law/laminated_fabric.hpp"
#include "kernel/law/modified_johnson_cook.hpp"
#include "kernel/law/orthotropic.hpp"
#include "kernel/law/piecewise_linear_kernel.hpp"
#include "kernel/law/plastic_kinematic_kernel.hpp"
#include "kernel/law/power_law.hpp"
#include "kernel/law/rubber.hpp"
#include "kernel/law/tabulated_johnson_cook.hpp"
#include "kernel/law/tabulated_rubber.hpp"
#include "kernel/law/viscoelastic.hpp"
#include "kernel/law/viscoplastic.hpp"
#include "kernel/law/woven_fabric.hpp"

namespace nugget::kernel {

/// How a point flows: the list of laws. A law is its own file, and its include and its line here; laws with curves or
/// axes have a card file besides (law_cards.hpp).
using Flow = std::variant<  //
    Elastic,                //
    PlasticKinematic,       //
    PiecewiseLinear,        //
    ModifiedJohnsonCook,    //
    JohnsonCook,            //
    TabulatedJohnsonCook,   //
    PowerLaw,               //
    Viscoplastic,           //
    CompressionTension,     //
    Viscoelastic,           //
    GeneralViscoelastic,    //
    BlatzKo,                //
    MooneyRivlin,           //
    Ogden,                  //
    PolynomialRubber,       //
    TabulatedRubber,        //
    LowDensityFoam,         //
    CrushableFoam,          //
    RateFoam,               //
    Orthotropic,            //
    CompositeLayer,         //
    LaminatedFabric,        //
    Fabric,                 //
    WovenFabric,            //
    AnisotropicSheet,       //
    Yld2000Sheet,           //
    Honeycomb,              //
    Fluid>;

}  // namespace nugget::kernel
