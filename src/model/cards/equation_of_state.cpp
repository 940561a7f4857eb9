// SPDX-License-Identifier: Apache-2.0
#include "model/cards/equation_of_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "kernel/law/composition.hpp"
#include "model/cards/reading.hpp"

// *EOS_...: pressures of solids over volume and internal energy, for the parts that name them in EOSID.
namespace nugget::model {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

constexpr Field eos_id = id("eosid", IdSpace::material, required, "id, as in EOSID of *PART");
constexpr Field energy = real("e0", dimension::stress, 0, any_value, "internal energy a volume, at the start");
constexpr Field volume = real("v0", dimension::number, 1, at_least(0), "relative volume at the start; 0: 1");

const Card polynomial_card{{
    eos_id,
    real("c0", dimension::stress, 0, any_value, "pressure at the reference volume without energy"),
    real("c1", dimension::stress, 0, any_value, "factor of mu = V0/V - 1: the bulk modulus"),
    real("c2", dimension::stress, 0, any_value, "factor of its square, under compression only"),
    real("c3", dimension::stress, 0, any_value, "factor of its cube"),
    real("c4", dimension::number, 0, any_value, "factor of the energy; of a gas C4 = C5 = ratio of heats - 1"),
    real("c5", dimension::number, 0, any_value, "factor of mu times the energy"),
    real("c6", dimension::number, 0, any_value, "factor of mu squared times the energy, under compression only"),
}};

const Card polynomial_start_card{{energy, volume}};

const Card gruneisen_card{{
    eos_id,
    real("c", dimension::velocity, required, above_zero(), "speed of sound: shock velocity without particle velocity"),
    real("s1", dimension::number, 0, any_value, "slope of the shock velocity over the particle velocity"),
    real("s2", dimension::number, 0, any_value, "second coefficient of that slope"),
    real("s3", dimension::number, 0, any_value, "third coefficient of that slope"),
    real("gamao", dimension::number, 0, any_value, "Gruneisen's gamma"),
    real("a", dimension::number, 0, any_value, "change of gamma with mu"),
    energy,
}};

const Card gruneisen_start_card{{
    volume,
    unused(),
    integer("lcid", 0, only(0), "curve of the energy that is put in: not supported"),
}};

double start_volume(const Row& row) {
  return row.real("v0") > 0.0 ? row.real("v0") : 1.0;
}

/// Young's modulus and Poisson's ratio of a flow that goes with bulk modulus K.
bool set_elastic(kernel::Composition& law, double K) {
  return std::visit(
      [&](auto& flow) {
        const double G = law.solid_shear > 0.0 ? law.solid_shear : flow.E / (2.0 * (1.0 + flow.nu));
        if (!(G > 0.0)) return false;
        flow.E = 9.0 * K * G / (3.0 * K + G);
        flow.nu = (3.0 * K - 2.0 * G) / (6.0 * K + 2.0 * G);
        return true;
      },
      law.flow);
}

bool shells_share(const Model& model, Index material) {
  return std::any_of(model.parts.begin(), model.parts.end(),
                     [&](const Part& p) { return p.material == material && p.kind == ElementKind::shell; });
}

/// Gives a material its equation of state; one that is refused too, so that it is not told to be missing.
void give(Builder& b, const Row& part_row, Material& material, bool shells, const kernel::EquationOfState& state) {
  kernel::Composition law = *std::get<kernel::Compound>(material.law).made_of;
  if (law.state)
    return refuse(b, part_row, "eosid", fmt::format("material {} has another equation of state already", material.id),
                  "give each equation of state materials of its own");
  law.state = state;
  const std::array<double, kernel::PreparedPressure::size> at_start{};
  const double K = kernel::PreparedPressure(state).modulus<double>(at_start.data());
  const bool sheared = K > 0.0 && set_elastic(law, K);
  material.law = compound(std::move(law));
  if (shells)
    refuse(b, part_row, "mid",
           fmt::format("material {} is of shells too, which have no equation of state", material.id),
           "give shells and solids materials of their own");
  else if (!(K > 0.0))
    refuse(b, part_row, "eosid", "this equation of state has no bulk modulus at the start",
           "give C1 (polynomial), or an energy E0 with C4");
  else if (!sheared)
    refuse(b, part_row, "mid", fmt::format("material {} has no shear modulus", material.id),
           "give G of *MAT_JOHNSON_COOK");
}

/// What an *EOS_ card says of a material of this density.
using StateOf = std::function<kernel::EquationOfState(double density)>;

/// Once the laws are whole, the materials of the parts that name the equation get it.
void hand_out(Builder& b, const Row& row, const StateOf& state) {
  b.later(Phase::systems, [row, state](Builder& later) {
    std::set<Index> done;
    for (const auto& [index, part_row] : later.part_rows) {
      const Part& part = later.model.parts[static_cast<std::size_t>(index)];
      if (part_row.integer("eosid") != row.integer("eosid") || part.material == none) continue;
      Material& material = later.model.materials[static_cast<std::size_t>(part.material)];
      if (part.kind == ElementKind::solid && takes_equation_of_state(material) && done.insert(part.material).second)
        give(later, part_row, material, shells_share(later.model, part.material), state(material.density));
    }
  });
}

void read_polynomial(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const Row row = cursor.read(polynomial_card);
  const Row start = cursor.read(polynomial_start_card);
  expect_end(b, cursor);
  const kernel::LinearPolynomial pressure{row.real("c0"), row.real("c1"), row.real("c2"), row.real("c3"),
                                          row.real("c4"), row.real("c5"), row.real("c6")};
  hand_out(b, row, [=](double) { return kernel::EquationOfState{pressure, start.real("e0"), start_volume(start)}; });
}

void read_gruneisen(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const Row row = cursor.read(gruneisen_card);
  const Row start = cursor.read(gruneisen_start_card);
  expect_end(b, cursor);
  hand_out(b, row, [=](double density) {
    const kernel::Gruneisen pressure{density * row.real("c") * row.real("c"),
                                     row.real("s1"),
                                     row.real("s2"),
                                     row.real("s3"),
                                     row.real("gamao"),
                                     row.real("a")};
    return kernel::EquationOfState{pressure, row.real("e0"), start_volume(start)};
  });
}

}  // namespace

bool takes_equation_of_state(const Material& material) {
  return material.keyword == "MAT_JOHNSON_COOK" && std::holds_alternative<kernel::Compound>(material.law);
}

std::vector<Keyword> equation_of_state_keywords() {
  return {
      {.name = "EOS_LINEAR_POLYNOMIAL",
       .aliases = {"EOS_001"},
       .options = {"TITLE"},
       .layout = {{"", &polynomial_card}, {"", &polynomial_start_card}},
       .read = read_polynomial},
      {.name = "EOS_GRUNEISEN",
       .aliases = {"EOS_004"},
       .options = {"TITLE"},
       .layout = {{"", &gruneisen_card}, {"", &gruneisen_start_card}},
       .read = read_gruneisen},
  };
}

}  // namespace nugget::model
