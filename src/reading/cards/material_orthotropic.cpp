// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_ORTHOTROPIC_ELASTIC.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card moduli_card{{
    material_id,
    density,
    real("ea", dimension::stress, required, above_zero(), "Young's modulus along a"),
    real("eb", dimension::stress, required, above_zero(), "Young's modulus along b"),
    real("ec", dimension::stress, 0, at_least(0), "Young's modulus along c; 0, of shells: EB"),
    real("prba", dimension::number, 0, any_value, "strain along a over that along b, negative, under stress along b"),
    real("prca", dimension::number, 0, any_value, "the same along a, under stress along c"),
    real("prcb", dimension::number, 0, any_value, "the same along b, under stress along c"),
}};

const Card shears_card{{
    real("gab", dimension::stress, required, above_zero(), "shear modulus ab"),
    real("gbc", dimension::stress, required, above_zero(), "shear modulus bc"),
    real("gca", dimension::stress, required, above_zero(), "shear modulus ca"),
    aopt::option,
    real("g", dimension::stress, 0, only(0), "shear modulus of frictional damping"),
    real("sigf", dimension::stress, 0, only(0), "limit of frictional damping"),
}};

const Card axes_card{{
    aopt::xp,
    aopt::yp,
    aopt::zp,
    aopt::a1,
    aopt::a2,
    aopt::a3,
    aopt::macf,
    integer("ihis", 0, only(0), "axes from *INITIAL_STRESS_SOLID"),
}};

const Card angle_card{{
    aopt::v1,
    aopt::v2,
    aopt::v3,
    aopt::d1,
    aopt::d2,
    aopt::d3,
    real("beta", dimension::number, 0, any_value, "angle of AOPT 0 and 3 in shells [degrees]"),
    real("ref", dimension::number, 0, only(0), "stress from a reference geometry"),
}};

void read_orthotropic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row moduli = cursor.read(moduli_card);
  const Row shears = cursor.read(shears_card);
  const Row first = cursor.read(axes_card);
  const Row second = cursor.read(angle_card);
  expect_end(b, cursor);
  kernel::Orthotropic law;
  law.young_a = moduli.real("ea");
  law.young_b = moduli.real("eb");
  law.young_c = moduli.real("ec") > 0.0 ? moduli.real("ec") : law.young_b;
  law.poisson_ba = moduli.real("prba");
  law.poisson_ca = moduli.real("prca");
  law.poisson_cb = moduli.real("prcb");
  law.shear_ab = shears.real("gab");
  law.shear_bc = shears.real("gbc");
  law.shear_ca = shears.real("gca");
  law.axes = read_axes(b, block, shears, first, second, second);
  law.axes.angle = second.real("beta") * (std::numbers::pi / 180.0);
  if (!(law.definiteness() > 0.0))
    refuse(b, moduli, "prba", "with these moduli and Poisson's ratios the material would give energy",
           "PRBA is the ratio under stress along b: PRBA/EB = PRAB/EA; PRCA and PRCB are those under stress along c");
  const double product = std::clamp(law.poisson_ba * law.poisson_ba * law.young_a / law.young_b, 0.0, 0.99);
  law.nu = std::min(std::sqrt(product), 0.45);
  law.E = std::max(law.young_a, law.young_b) / (1.0 - product) * (1.0 - law.nu * law.nu);
  const Index material =
      add_material(b, moduli, std::move(title), "MAT_ORTHOTROPIC_ELASTIC", kernel::composed_law({law}));
  take_axes_of_system(b, shears, material);
}

}  // namespace

std::vector<Keyword> orthotropic_material_keywords() {
  return {{.name = "MAT_ORTHOTROPIC_ELASTIC",
           .aliases = {"MAT_002"},
           .options = {"TITLE"},
           .layout = {{"", &moduli_card}, {"", &shears_card}, {"", &axes_card}, {"", &angle_card}},
           .read = read_orthotropic}};
}

}  // namespace nugget::reading
