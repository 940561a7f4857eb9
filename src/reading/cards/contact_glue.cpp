// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/contact_glue.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "reading/builder/common_cards.hpp"

namespace nugget::reading {
CardOf<ElastoplasticModeCard> elastoplastic_mode_card(const std::array<std::string_view, 8>& names) {
  using Card = ElastoplasticModeCard;
  constexpr Dimension energy_per_area{1, 0, -2}, rate{0, 0, -1};
  return {
      {&Card::energy, real(names[0], energy_per_area, 0, any_value, "energy per area; negative: at low rates")},
      {&Card::fast_energy, real(names[1], energy_per_area, 0, any_value, "at high rates, where that is negative")},
      {&Card::energy_rate, real(names[2], rate, 0, at_least(0), "rate that parts low from high")},
      {&Card::yield, real(names[3], dimension::stress, 0, any_value, "yield stress; negative: at low rates")},
      {&Card::growth, real(names[4], dimension::stress, 0, any_value,
                           "its growth with the square of the logarithm of the rate; negative: with the logarithm")},
      {&Card::yield_rate, real(names[5], rate, 0, at_least(0), "rate from which on it grows")},
      {&Card::plateau, real(names[6], dimension::number, 0, any_value,
                            "share of the plateau in the energy; negative: in the opening beyond the yield point")},
      {&Card::curve, integer(names[7], 0, any_value, "curve of the energy over the thickness")},
  };
}
kernel::ElastoplasticMode elastoplastic_mode(Builder& builder, const deck::RowOf<ElastoplasticModeCard>& row) {
  using Card = ElastoplasticModeCard;
  const auto required = [&](double Card::*field, const char* why) {
    if ((*row).*field == 0.0) refuse(builder, row[field], why, "give it");
  };
  kernel::ElastoplasticMode mode;
  required(&Card::energy, "must be given");
  required(&Card::yield, "must be given");
  mode.energy = std::abs(row->energy);
  mode.yield = std::abs(row->yield);
  mode.plateau = row->plateau;
  if (row->energy < 0.0) {
    required(&Card::fast_energy, "must be given where the energy depends on the rate");
    required(&Card::energy_rate, "must be given where the energy depends on the rate");
    mode.fast_energy = std::abs(row->fast_energy);
    mode.energy_rate = row->energy_rate;
  }
  if (row->yield < 0.0) {
    required(&Card::yield_rate, "must be given where the yield stress depends on the rate");
    mode.yield_growth = row->growth;
    mode.yield_rate = row->yield_rate;
  }
  if (!(std::abs(mode.plateau) < 1.0))
    refuse(builder, row[&Card::plateau], "expected a share, between -1 and 1", "0 is glue without a plateau");
  if (row->curve != 0)
    refuse(builder, row[&Card::curve], "an energy by the thickness of the layer is not built; expected 0",
           "read the energy off the curve at the thickness of the layer");
  return mode;
}

namespace {

using deck::Cursor;
using deck::RowOf;

/// What SFLS and PARAM are depends on the option.
CardOf<GlueCards> tiebreak_card_of(const FieldOf<GlueCards>& shear, Dimension parameter) {
  return {
      {&GlueCards::option,
       integer(
           "option", 0, any_value,
           "1: what touches sticks, also later; 3: until it fails; 2: what touches at the start is glued until it "
           "fails; 4: along the normal alone; 5: it yields, and fades by a curve; 6, 8: the stress falls to 0 at a "
           "distance; 7, 9, 10, 11: by an energy; 13, 14: it yields and softens as *MAT_240; -1, -2, -3: as without "
           "the sign, with moments")},
      {&GlueCards::nfls, real("nfls", dimension::stress, 0, at_least(0),
                              "normal stress at which it fails; 0: does not count; 5: at which it yields")},
      shear,
      {&GlueCards::param,
       real("param", parameter, 0, any_value,
            "2: 1 leaves out thicknesses; 4: 1 makes SFLS friction; 6, 8: the distance (CCRIT); 7, 10: angle of "
            "friction "
            "[degrees]; 9, 11: exponent of mixed modes, negative: after Benzeggagh and Kenane; 13, 14: thickness")},
      {&GlueCards::eraten,
       real("eraten", Dimension{1, 0, -2}, 0, at_least(0), "7, 9, 10, 11: energy per area in tension")},
      {&GlueCards::erates,
       real("erates", Dimension{1, 0, -2}, 0, at_least(0), "7, 9, 10, 11: energy per area in shear")},
      {&GlueCards::ct2cn,
       real("ct2cn", dimension::number, 1, above_zero(), "9, 11, 13, 14: stiffness in shear over that in tension")},
      {&GlueCards::cn, real("cn", Dimension{1, -2, -2}, 0, at_least(0),
                            "9, 11, 13, 14: stiffness in tension per area; 0: the penalty's")},
  };
}
FieldOf<GlueCards> shear_strength() {
  return {&GlueCards::sfls,
          real("sfls", dimension::stress, 0, at_least(0),
               "shear stress at which it fails; 0: does not count; 4: of friction; 5: curve of the factor on NFLS over "
               "the opening")};
}
const CardOf<GlueCards> tiebreak_card = tiebreak_card_of(shear_strength(), dimension::number);
const CardOf<GlueCards> tiebreak_by_length = tiebreak_card_of(shear_strength(), dimension::length);
const CardOf<GlueCards> tiebreak_by_curve = tiebreak_card_of(
    {&GlueCards::curve, id("sfls", IdSpace::function, 0, "curve: factor on NFLS over the opening")}, dimension::number);

const CardOf<ElastoplasticModeCard> tiebreak_tension_card =
    elastoplastic_mode_card({"g1c_0", "g1c_inf", "edot_g1", "t0", "t1", "edot_t", "fg1", "lcg1c"});
const CardOf<ElastoplasticModeCard> tiebreak_shear_card =
    elastoplastic_mode_card({"g2c_0", "g2c_inf", "edot_g2", "s0", "s1", "edot_s", "fg2", "lcg2c"});

/// The card of the older *CONTACT_TIEBREAK_NODES_...
const CardOf<GlueCards> tiebreak_nodes_card{
    {&GlueCards::nflf, real("nflf", dimension::force, 0, above_zero(), "normal force on a node at which it fails")},
    {&GlueCards::sflf, real("sflf", dimension::force, 0, above_zero(), "shear force on a node at which it fails")},
    {&GlueCards::nen, real("nen", dimension::number, 2, above_zero(), "exponent of the normal force")},
    {&GlueCards::mes, real("mes", dimension::number, 2, above_zero(), "exponent of the shear force")},
};
/// And of *CONTACT_TIEBREAK_SURFACE_TO_SURFACE.
const CardOf<GlueCards> tiebreak_surface_card{
    {&GlueCards::nfls, real("nfls", dimension::stress, 0, above_zero(),
                            "normal stress at which it fails; with TBLCID: at which it yields")},
    {&GlueCards::sfls, real("sfls", dimension::stress, 0, at_least(0), "shear stress at which it fails")},
    {&GlueCards::curve,
     id("tblcid", IdSpace::function, 0, "curve: factor on the stress over the opening, as with OPTION 5")},
    {&GlueCards::thkoff, integer("thkoff", 0, between(0, 1), "1: the thickness of shells counts")},
};

bool by_length(double option) {
  return option == 6.0 || option == 8.0 || option == 13.0 || option == 14.0;
}

const CardOf<GlueCards>& card_of_glue(const Cursor& cursor) {
  const auto option = cursor.peek_number(0);
  if (option == 5.0) return tiebreak_by_curve;
  return by_length(option) ? tiebreak_by_length : tiebreak_card;
}

/// Fields without which an option of the glue has no meaning.
void require(Builder& builder, const RowOf<GlueCards>& row, std::initializer_list<double GlueCards::*> fields) {
  for (const auto field : fields)
    if ((*row).*field == 0.0)
      refuse(builder, row[field], fmt::format("must be given with OPTION {}", row->option),
             "give it, or use OPTION 2, which needs NFLS and SFLS alone");
}

/// Fields that an option does not look at, in LS-DYNA neither.
void report_idle(Builder& builder, const RowOf<GlueCards>& row, std::initializer_list<double GlueCards::*> fields) {
  for (const auto field : fields)
    if ((*row).*field != 0.0)
      row[field].report(builder.findings, Severity::note, fmt::format("is not looked at with OPTION {}", row->option),
                        {});
}

void take_strengths(const RowOf<GlueCards>& row, kernel::Cohesion& law) {
  law.normal_strength = row->nfls;
  law.shear_strength = row->sfls;
}

/// OPTION 2, 3: fails at once.
void take_brittle(const RowOf<GlueCards>& row, Contact& contact) {
  take_strengths(row, contact.glue->law);
}

void take_thickness_switch(Builder& builder, const RowOf<GlueCards>& row, Contact& contact) {
  const double param = row->param;
  if (param != 0.0 && param != 1.0)
    refuse(builder, row[&GlueCards::param], "expected 0, or 1 to leave out the thickness of shells", "give 0 or 1");
  contact.glue->without_thickness = param == 1.0;
}

/// OPTION 4.
void take_sliding(Builder& builder, const RowOf<GlueCards>& row, Contact& contact) {
  const double param = row->param;
  if (param != 0.0 && param != 1.0)
    refuse(builder, row[&GlueCards::param], "expected 0, or 1 to make SFLS the stress of friction", "give 0 or 1");
  contact.glue->slides = true;
  contact.glue->law.normal_strength = row->nfls;
  if (param == 1.0) {
    require(builder, row, {&GlueCards::sfls});
    contact.glue->slip_stress = row->sfls;
  } else if (row->sfls != 0.0) {
    row[&GlueCards::sfls].report(builder.findings, Severity::note, "is looked at with PARAM = 1 alone", {});
  }
}

/// OPTION 6, 8.
void take_distance(Builder& builder, const RowOf<GlueCards>& row, Contact& contact) {
  kernel::Cohesion& law = contact.glue->law;
  take_strengths(row, law);
  require(builder, row, {&GlueCards::param});
  law.softening = kernel::Cohesion::Softening::to_distance;
  law.distance = row->param;
  if (law.distance < 0.0) refuse(builder, row[&GlueCards::param], "expected a distance", "give CCRIT, 0 or more");
}

/// OPTION 7, 10 and 9, 11.
void take_energies(Builder& builder, const RowOf<GlueCards>& row, Contact& contact) {
  kernel::Cohesion& law = contact.glue->law;
  take_strengths(row, law);
  require(builder, row, {&GlueCards::nfls, &GlueCards::sfls, &GlueCards::eraten, &GlueCards::erates});
  law.softening = kernel::Cohesion::Softening::by_energy;
  law.normal_energy = row->eraten;
  law.shear_energy = row->erates;
  const int option = row->option;
  if (option == 7 || option == 10) {
    const double angle = row->param;
    if (!(angle >= 0.0) || !(angle < 90.0))
      refuse(builder, row[&GlueCards::param], "expected the angle of friction, 0 to 90 degrees", "give 0 for none");
    law.pressure_share = std::sin(angle * std::numbers::pi / 180.0);
    return;
  }
  require(builder, row, {&GlueCards::param});
  law.exponent = row->param;
  law.normal_stiffness = row->cn;
  law.shear_ratio = row->ct2cn;
}

/// OPTION 13, 14.
void take_layer(Builder& builder, Cursor& cursor, const RowOf<GlueCards>& row, Contact& contact) {
  kernel::Cohesion& law = contact.glue->law;
  law.softening = kernel::Cohesion::Softening::elastoplastic;
  law.thickness = row->param;
  law.normal_stiffness = row->cn;
  law.shear_ratio = row->ct2cn;
  if (law.thickness < 0.0)
    refuse(builder, row[&GlueCards::param],
           "rates that are filtered (a negative thickness and card 4.2c) are not built",
           "give the thickness without its sign and leave out that card");
  const auto tension = cursor.read(tiebreak_tension_card);
  law.tension = elastoplastic_mode(builder, tension);
  const auto shear = cursor.read(tiebreak_shear_card);
  law.shear = elastoplastic_mode(builder, shear);
  const bool by_rate =
      law.tension.yield_rate + law.tension.energy_rate + law.shear.yield_rate + law.shear.energy_rate > 0.0;
  if (by_rate && law.thickness == 0.0)
    refuse(builder, row[&GlueCards::param], "the thickness makes a strain rate of a speed and must be given here",
           "give it, or stresses and energies that do not depend on the rate");
  report_idle(builder, row, {&GlueCards::nfls, &GlueCards::sfls, &GlueCards::eraten, &GlueCards::erates});
}

void take_glue(Builder& builder, Cursor& cursor, const RowOf<GlueCards>& row, Contact& contact) {
  contact.glue.emplace();
  const int option = row->option;
  contact.glue->moments = option < 0;
  switch (option < 0 && option >= -3 ? -option : option) {
    case 1:
      contact.glue->bonds_later = true;
      report_idle(builder, row, {&GlueCards::nfls, &GlueCards::sfls, &GlueCards::eraten, &GlueCards::erates});
      break;
    case 2:
      take_brittle(row, contact);
      take_thickness_switch(builder, row, contact);
      break;
    case 3:
      take_brittle(row, contact);
      contact.glue->bonds_later = true;
      break;
    case 4: take_sliding(builder, row, contact); break;
    case 5:
      require(builder, row, {&GlueCards::nfls});
      contact.glue->law.normal_strength = row->nfls;
      break;
    case 6:
    case 8: take_distance(builder, row, contact); break;
    case 7:
    case 9:
    case 10:
    case 11: take_energies(builder, row, contact); break;
    case 13:
    case 14: take_layer(builder, cursor, row, contact); break;
    default:
      refuse(builder, row[&GlueCards::option], "expected 1 to 11, 13 or 14, or -1 to -3",
             "2 fails at once, 6 and 8 give way up to a distance, 9 and 11 up to an energy");
  }
}

/// *CONTACT_TIEBREAK_NODES_TO_SURFACE and _NODES_ONLY.
void take_glue_of_nodes(const RowOf<GlueCards>& row, Contact& contact) {
  Glue& glue = contact.glue.emplace();
  glue.by_force = true;
  glue.without_thickness = true;
  glue.law.normal_strength = row->nflf;
  glue.law.shear_strength = row->sflf;
  glue.law.normal_exponent = row->nen;
  glue.law.shear_exponent = row->mes;
}

/// *CONTACT_TIEBREAK_SURFACE_TO_SURFACE.
void take_glue_of_surfaces(Builder& builder, const RowOf<GlueCards>& row, Contact& contact) {
  Glue& glue = contact.glue.emplace();
  glue.without_thickness = row->thkoff == 0;
  glue.law.normal_strength = row->nfls;
  if (row->curve == 0) {
    glue.law.shear_strength = row->sfls;
    if (glue.law.shear_strength == 0.0)
      refuse(builder, row[&GlueCards::sfls], "must be given where there is no TBLCID",
             "give a large number for no failure");
  } else if (row->sfls != 0.0) {
    row[&GlueCards::sfls].report(builder.findings, Severity::note,
                                 "is not looked at with TBLCID: the glue yields in shear at NFLS over the root of 3",
                                 {});
  }
}

/// The curve of OPTION 5, and TBLCID: a factor on the yield stress, or that stress itself.
void take_resistance(Builder& builder, const deck::Entry& field, Contact& contact) {
  const Index c = builder.curve(field);
  if (c == none) {
    if (field.integer() == 0)
      refuse(builder, field, "must be the curve of the stress over the opening with OPTION 5",
             "give the id of a *DEFINE_CURVE that begins with 1 and ends with 0");
    return;
  }
  const Curve& curve = builder.model.curves[c];
  if (curve.empty()) return;  // reported where it is defined
  kernel::Cohesion& law = contact.glue->law;
  law.softening = kernel::Cohesion::Softening::by_curve;
  law.resistance = curve;
  const double first = law.resistance.clamped(0.0);
  const auto is = [first](double level) { return std::abs(first - level) <= 1e-6 * level; };
  if (!is(1.0) && !is(law.normal_strength))
    refuse(
        builder, field,
        fmt::format("the curve is {:g} where nothing has opened; expected 1 (a factor on NFLS) or NFLS itself", first),
        "scale the curve");
  if (std::any_of(law.resistance.y.begin(), law.resistance.y.end(), [](double y) { return y < 0.0; }))
    refuse(builder, field, "the curve has negative ordinates", "end it with 0");
  if (law.resistance.y.back() > 0.0)
    field.report(builder.findings, Severity::warning, "the curve does not end with 0: this glue never fails",
                 "end it with 0 at the opening where nothing holds any more");
  if (first > 0.0)
    for (double& y : law.resistance.y) y /= first;
}

}  // namespace

std::optional<RowOf<GlueCards>> read_glue(Builder& builder, Cursor& cursor, const Options& options, Contact& contact) {
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_NODES")) {
    const auto row = cursor.read(tiebreak_nodes_card);
    take_glue_of_nodes(row, contact);
    contact.glue->alone = contact.keyword.starts_with("CONTACT_TIEBREAK_NODES_ONLY");
    return row;
  }
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_SURFACE")) {
    const auto row = cursor.read(tiebreak_surface_card);
    take_glue_of_surfaces(builder, row, contact);
    contact.glue->alone = contact.keyword.find("_ONLY") != std::string::npos;
    return row;
  }
  if (!options.contains("TIEBREAK")) return std::nullopt;
  const auto row = cursor.read(card_of_glue(cursor));
  take_glue(builder, cursor, row, contact);
  return row;
}

void finish_glue(Builder& builder, const RowOf<GlueCards>& row, Contact& contact) {
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_NODES")) return;
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_SURFACE")) {
    if (row->curve != 0) take_resistance(builder, row[&GlueCards::curve], contact);
  } else if (row->option == 5) {
    take_resistance(builder, row[&GlueCards::curve], contact);
  }
}

std::vector<LayoutCard> glue_layout(std::string_view name, bool option) {
  std::vector<LayoutCard> layout;
  if (option)
    layout = {{"with _TIEBREAK", &tiebreak_card},
              {"with _TIEBREAK, OPTION 13 and 14", &tiebreak_tension_card},
              {"with _TIEBREAK, OPTION 13 and 14", &tiebreak_shear_card}};
  if (name.starts_with("CONTACT_TIEBREAK_NODES")) layout.push_back({{}, &tiebreak_nodes_card});
  if (name.starts_with("CONTACT_TIEBREAK_SURFACE")) layout.push_back({{}, &tiebreak_surface_card});
  return layout;
}

}  // namespace nugget::reading
