// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/equation_of_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"

// *EOS_...: pressures of solids over volume and internal energy, for the parts that name them in EOSID.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

constexpr IntegerField eos_id = id("eosid", IdSpace::material, required, "id, as in EOSID of *PART");
constexpr RealField initial_energy =
    real("e0", dimension::stress, 0, any_value, "internal energy a volume, at the start");
constexpr RealField volume = real("v0", dimension::number, 1, at_least(0), "relative volume at the start; 0: 1");

struct StartCard {
  double e0 = 0, v0 = 0;
};
struct PolynomialCard : kernel::LinearPolynomial {
  int eosid = 0;
};
const CardOf<PolynomialCard> polynomial_card{
    {&PolynomialCard::eosid, eos_id},
    {&PolynomialCard::c0,
     real("c0", dimension::stress, 0, any_value, "pressure at the reference volume without energy")},
    {&PolynomialCard::c1, real("c1", dimension::stress, 0, any_value, "factor of mu = V0/V - 1: the bulk modulus")},
    {&PolynomialCard::c2, real("c2", dimension::stress, 0, any_value, "factor of its square, under compression only")},
    {&PolynomialCard::c3, real("c3", dimension::stress, 0, any_value, "factor of its cube")},
    {&PolynomialCard::c4,
     real("c4", dimension::number, 0, any_value, "factor of the energy; of a gas C4 = C5 = ratio of heats - 1")},
    {&PolynomialCard::c5, real("c5", dimension::number, 0, any_value, "factor of mu times the energy")},
    {&PolynomialCard::c6,
     real("c6", dimension::number, 0, any_value, "factor of mu squared times the energy, under compression only")},
};

const CardOf<StartCard> polynomial_start_card{
    {&StartCard::e0, initial_energy},
    {&StartCard::v0, volume},
};

struct GruneisenCard : StartCard {
  int eosid = 0;
  double c = 0, s1 = 0, s2 = 0, s3 = 0, gamao = 0, a = 0;
};
const CardOf<GruneisenCard> gruneisen_card{
    {&GruneisenCard::eosid, eos_id},
    {&GruneisenCard::c, real("c", dimension::velocity, required, above_zero(),
                             "speed of sound: shock velocity without particle velocity")},
    {&GruneisenCard::s1,
     real("s1", dimension::number, 0, any_value, "slope of the shock velocity over the particle velocity")},
    {&GruneisenCard::s2, real("s2", dimension::number, 0, any_value, "second coefficient of that slope")},
    {&GruneisenCard::s3, real("s3", dimension::number, 0, any_value, "third coefficient of that slope")},
    {&GruneisenCard::gamao, real("gamao", dimension::number, 0, any_value, "Gruneisen's gamma")},
    {&GruneisenCard::a, real("a", dimension::number, 0, any_value, "change of gamma with mu")},
    {&GruneisenCard::e0, initial_energy},
};

const CardOf<StartCard> gruneisen_start_card{
    {&StartCard::v0, volume},
    unused(),
    integer("lcid", 0, only(0), "curve of the energy that is put in: not supported"),
};

struct IdealGasCard : StartCard {
  int eosid = 0;
  double cv0 = 0, cp0 = 0, t0 = 0;
};
const CardOf<IdealGasCard> ideal_gas_card{
    {&IdealGasCard::eosid, eos_id},
    {&IdealGasCard::cv0,
     real("cv0", {0, 2, -2}, required, above_zero(), "heat capacity at constant volume, a mass and degree")},
    {&IdealGasCard::cp0, real("cp0", {0, 2, -2}, required, above_zero(), "the same at constant pressure")},
    real("cl", {0, 2, -2}, 0, only(0), "growth of both with the temperature: not built"),
    real("cq", {0, 2, -2}, 0, only(0), "growth of both with its square: not built"),
    {&IdealGasCard::t0, real("t0", dimension::number, required, above_zero(), "temperature at the start")},
    {&IdealGasCard::v0, volume},
    real("vco", dimension::number, 0, only(0), "covolume of Van der Waals: not built"),
};

const Card ideal_gas_form_card{{
    real("adiab", dimension::number, 0, only(0), "1: pressure by the adiabat instead of the energy: not built"),
}};

struct TabulatedCard : StartCard {
  int eosid = 0;
  double gama = 0;
  int lcc = 0, lct = 0;
};
const CardOf<TabulatedCard> tabulated_card{
    {&TabulatedCard::eosid, eos_id},
    {&TabulatedCard::gama, real("gama", dimension::number, 0, any_value, "gamma, the factor of T E")},
    {&TabulatedCard::e0, initial_energy},
    {&TabulatedCard::v0, volume},
    {&TabulatedCard::lcc,
     id("lcc", IdSpace::function, 0, "curve of C over ln V, V the relative volume; 0: by the cards that follow")},
    {&TabulatedCard::lct, id("lct", IdSpace::function, 0, "curve of T over ln V; 0: by the cards that follow")},
};

/// Five values of an *EOS_TABULATED, which has two such cards of each kind.
struct FiveCard {
  std::array<double, 5> value{};
};
CardOf<FiveCard> five(Dimension dimension, std::string_view meaning) {
  static constexpr std::string_view names[] = {"v1", "v2", "v3", "v4", "v5"};
  CardOf<FiveCard> card;
  for (std::size_t i = 0; i < 5; ++i)
    card.add({at(&FiveCard::value, i), wide(real(names[i], dimension, 0, any_value, meaning), 16)});
  return card;
}
const CardOf<FiveCard> tabulated_strain_card =
    five(dimension::number, "ln V, V the relative volume; in order, up to ten values");
const CardOf<FiveCard> tabulated_cold_card = five(dimension::stress, "C, the pressure without energy, at these");
const CardOf<FiveCard> tabulated_heat_card = five(dimension::number, "T, the factor of gamma E, at these");

double start_volume(const StartCard& start) {
  return start.v0 > 0.0 ? start.v0 : 1.0;
}

/// Young's modulus and Poisson's ratio of a flow that goes with bulk modulus K.
bool set_elastic(kernel::LawComponents& law, double K) {
  return std::visit(
      [&](auto& flow) {
        if constexpr (requires { flow.set_bulk_modulus(K); }) {
          flow.set_bulk_modulus(K);
          return true;
        }
        const double G = law.solid_shear > 0.0 ? law.solid_shear : flow.E / (2.0 * (1.0 + flow.nu));
        if (!(G > 0.0)) return false;
        flow.E = 9.0 * K * G / (3.0 * K + G);
        flow.nu = (3.0 * K - 2.0 * G) / (6.0 * K + 2.0 * G);
        return true;
      },
      law.flow);
}

bool shells_share(const Model& model, Index material) {
  return std::any_of(model.parts.begin(), model.parts.end(), [&](const Part& p) {
    return p.material == material && (p.kind == ElementKind::shell || p.kind == ElementKind::beam);
  });
}

/// What solids of a material are made of, before they have an equation of state.
kernel::LawComponents components(const Material& material) {
  const auto* null = std::get_if<kernel::Null>(&material.law);
  if (null == nullptr) return *std::get<kernel::ComposedLaw>(material.law).components;
  kernel::LawComponents law{kernel::Fluid{.viscosity = null->viscosity}};
  if (null->tension > 0.0) law.spall = kernel::Spall{kernel::Spall::Form::limited_tension, null->tension};
  if (null->most_volume > 1.0 || null->least_volume > 0.0) {
    // The strain of a point is the time integral of its rate: of its trace, ln V.
    law.erosion.emplace();
    if (null->most_volume > 1.0) law.erosion->most_volume_strain = std::log(null->most_volume);
    if (null->least_volume > 0.0) law.erosion->least_volume_strain = std::log(null->least_volume);
  }
  return law;
}

/// Gives a material its equation of state; one that is refused too, so that it is not reported as missing.
void give(Builder& b, const RowOf<PartCard>& part_row, Material& material, bool shells,
          const kernel::EquationOfState& state) {
  kernel::LawComponents law = components(material);
  if (law.state)
    return refuse(b, part_row[&PartCard::eosid],
                  fmt::format("material {} has another equation of state already", material.id),
                  "give each equation of state materials of its own");
  law.state = state;
  const std::array<double, kernel::EquationOfStateKernel::size> at_start{};
  const double K = kernel::EquationOfStateKernel(state).modulus<double>(at_start.data());
  const bool sheared = K > 0.0 && set_elastic(law, K);
  material.law = composed_law(std::move(law));
  if (shells)
    refuse(b, part_row[&PartCard::mid],
           fmt::format("material {} is of shells or beams too, which have no equation of state", material.id),
           "give them and solids materials of their own");
  else if (!(K > 0.0))
    refuse(b, part_row[&PartCard::eosid], "this equation of state has no bulk modulus at the start",
           "give C1 (polynomial), or an energy E0 with C4");
  else if (!sheared)
    refuse(b, part_row[&PartCard::mid], fmt::format("material {} has no shear modulus", material.id),
           "give G of *MAT_JOHNSON_COOK");
}

/// What an *EOS_ card says of a material of this density.
using StateOf = std::function<kernel::EquationOfState(double density)>;

/// Once the laws are whole, the materials of the parts that name the equation get it.
void hand_out(Builder& b, int eosid, const StateOf& state) {
  b.defer(Phase::systems, [eosid, state](Builder& later) {
    std::set<Index> done;
    for (const auto& [index, part_row] : later.part_rows) {
      const Part& part = later.model.parts[index];
      if (part_row->eosid != eosid || part.material == none) continue;
      Material& material = later.model.materials[part.material];
      if (part.kind == ElementKind::solid && takes_equation_of_state(material) && done.insert(part.material).second)
        give(later, part_row, material, shells_share(later.model, part.material), state(material.density));
    }
  });
}

void read_polynomial(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(polynomial_card);
  const auto start = cursor.read(polynomial_start_card);
  expect_end(b, cursor);
  hand_out(b, row->eosid, [=](double) {
    return kernel::EquationOfState{kernel::LinearPolynomial(*row), start->e0, start_volume(*start)};
  });
}

/// An ideal gas is the polynomial (CP/CV - 1) E/V, E = density CV T0 at the start.
void read_ideal_gas(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(ideal_gas_card);
  if (!at_end(cursor)) cursor.read(ideal_gas_form_card);
  expect_end(b, cursor);
  const double cv = row->cv0, cp = row->cp0;
  if (!(cp > cv))
    return refuse(b, row[&IdealGasCard::cp0], "a gas has a CP above its CV", "give both a mass and degree");
  hand_out(b, row->eosid, [=](double density) {
    kernel::LinearPolynomial pressure;
    pressure.c4 = pressure.c5 = cp / cv - 1.0;
    return kernel::EquationOfState{pressure, density * cv * row->t0, start_volume(*row)};
  });
}

/// The abscissae of an equation's points and one of its functions of them, as a curve over ln V.
Curve tabulated(const std::vector<double>& strain, const std::vector<double>& value) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < strain.size(); ++i) points.emplace_back(strain[i], value[i]);
  std::stable_sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
  Curve curve;
  for (const auto& [x, y] : points) {
    curve.x.push_back(x);
    curve.y.push_back(y);
  }
  return curve;
}

/// A function of an *EOS_TABULATED: a curve of the deck, or ten values on two cards.
Curve function_of(Builder& b, const deck::Entry& field, const std::vector<double>& strain,
                  const std::vector<double>& value) {
  const Index curve = field.integer() != 0 ? b.curve(field) : none;
  if (curve != none) return b.model.curves[curve];
  return tabulated(strain, value);
}

void read_tabulated(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(tabulated_card);
  std::array<std::vector<double>, 3> values;  // ln V, C, T
  const std::array cards{&tabulated_strain_card, &tabulated_cold_card, &tabulated_heat_card};
  for (std::size_t kind = 0; kind < 3; ++kind)
    for (int card = 0; card < 2 && !at_end(cursor); ++card) {
      const auto points = cursor.read(*cards[kind]);
      values[kind].insert(values[kind].end(), points->value.begin(), points->value.end());
    }
  expect_end(b, cursor);
  // Fewer than ten points leave blanks behind them, where the abscissae stop to go on as they began.
  const std::vector<double>& strain = values[0];
  std::size_t count = std::min<std::size_t>(strain.size(), 1);
  while (count > 0 && count < strain.size() && (strain[count] - strain[count - 1]) * (strain[1] - strain[0]) > 0.0)
    ++count;
  for (std::vector<double>& list : values) list.resize(count);
  const double gamma = row->gama;
  b.defer(Phase::mesh, [=](Builder& later) {
    kernel::TabulatedPressure pressure{function_of(later, row[&TabulatedCard::lcc], values[0], values[1]),
                                       function_of(later, row[&TabulatedCard::lct], values[0], values[2])};
    if (pressure.cold.x.size() < 2)
      return refuse(later, row[&TabulatedCard::lcc], "an equation of state needs a pressure at two volumes or more",
                    "give LCC, or ln V and C on the cards that follow");
    for (double& heat : pressure.heat.y) heat *= gamma;
    if (pressure.heat.x.size() < 2) pressure.heat = {};
    hand_out(later, row->eosid, [=](double) { return kernel::EquationOfState{pressure, row->e0, start_volume(*row)}; });
  });
}

void read_gruneisen(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(gruneisen_card);
  const auto start = cursor.read(gruneisen_start_card);
  expect_end(b, cursor);
  hand_out(b, row->eosid, [=](double density) {
    const kernel::Gruneisen pressure{density * row->c * row->c, row->s1, row->s2, row->s3, row->gamao, row->a};
    return kernel::EquationOfState{pressure, row->e0, start_volume(*start)};
  });
}

}  // namespace

void refuse_unknown_state(Builder& b, const RowOf<PartCard>& row) {
  refuse(b, row[&PartCard::eosid],
         fmt::format("equation of state {} is not defined, or of a kind that is not built", row->eosid),
         "define it by *EOS_LINEAR_POLYNOMIAL, _GRUNEISEN, _TABULATED or _IDEAL_GAS");
}

bool takes_equation_of_state(const Material& material) {
  if (std::holds_alternative<kernel::Null>(material.law)) return true;
  const auto* law = std::get_if<kernel::ComposedLaw>(&material.law);
  return law != nullptr && (material.keyword == "MAT_JOHNSON_COOK" || law->components->state);
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
      {.name = "EOS_TABULATED",
       .aliases = {"EOS_009"},
       .options = {"TITLE"},
       .layout = {{"", &tabulated_card},
                  {"twice, unless LCC is given", &tabulated_strain_card},
                  {"twice, unless LCC is given", &tabulated_cold_card},
                  {"twice, unless LCC is given", &tabulated_heat_card}},
       .read = read_tabulated},
      {.name = "EOS_IDEAL_GAS",
       .aliases = {"EOS_012"},
       .options = {"TITLE"},
       .layout = {{"", &ideal_gas_card}, {"may be left out", &ideal_gas_form_card}},
       .read = read_ideal_gas},
  };
}

}  // namespace nugget::reading
