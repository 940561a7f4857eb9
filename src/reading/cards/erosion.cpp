// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/added_law.hpp"
#include "reading/cards/families.hpp"

// *MAT_ADD_EROSION: criteria of failure added to a law.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct FirstErosionCard {
  int mid = 0;
  double excl = 0, mxpres = 0, mneps = 0, effeps = 0, voleps = 0, numfip = 0, ncs = 0;
};
const CardOf<FirstErosionCard> first_card{
    {&FirstErosionCard::mid, id("mid", IdSpace::material, required, "material to which the criteria are added")},
    {&FirstErosionCard::excl, real("excl", dimension::number, 0, any_value, "criteria of this value do not count")},
    {&FirstErosionCard::mxpres, real("mxpres", dimension::stress, 0, any_value, "greatest pressure")},
    {&FirstErosionCard::mneps, real("mneps", dimension::number, 0, any_value, "least principal strain")},
    {&FirstErosionCard::effeps,
     real("effeps", dimension::number, 0, any_value, "greatest effective strain; below 0: effective plastic strain")},
    {&FirstErosionCard::voleps, real("voleps", dimension::number, 0, any_value,
                                     "volumetric strain, above 0 in expansion, below 0 in compression")},
    {&FirstErosionCard::numfip,
     real("numfip", dimension::number, 1, any_value,
          "failed points that delete the element; below 0: percentage of a shell's layers, below -100: points + 100")},
    {&FirstErosionCard::ncs, real("ncs", dimension::number, 1, at_least(1), "how many criteria must hold at once")},
};

struct SecondCard {
  double mnpres = 0, sigp1 = 0, sigvm = 0, mxeps = 0, epssh = 0, sigth = 0, impulse = 0, failtm = 0;
};
const CardOf<SecondCard> second_card{
    {&SecondCard::mnpres, real("mnpres", dimension::stress, 0, any_value, "least pressure")},
    {&SecondCard::sigp1, real("sigp1", dimension::stress, 0, any_value, "greatest principal stress")},
    {&SecondCard::sigvm, or_negative(real("sigvm", dimension::stress, 0, any_value,
                                          "greatest effective stress; below 0: curve over the strain rate"),
                                     IdSpace::function)},
    {&SecondCard::mxeps, real("mxeps", dimension::number, 0, any_value, "greatest principal strain")},
    {&SecondCard::epssh, real("epssh", dimension::number, 0, any_value, "greatest tensorial shear strain")},
    {&SecondCard::sigth,
     real("sigth", dimension::stress, 0, any_value, "threshold of the principal stress for IMPULSE")},
    {&SecondCard::impulse,
     real("impulse", {2, -2, -3}, 0, any_value, "integral of (principal stress - SIGTH)^2 over time")},
    {&SecondCard::failtm, real("failtm", dimension::time, 0, any_value, "time at which the material is taken away")},
};

struct ThirdCard : GissmoLawCard {
  int idam = 0;
  double dmgtyp = 0;
};
const CardOf<ThirdCard> third_card{
    {&ThirdCard::idam, integer("idam", 0, between(0, 1), "1: damage of GISSMO; DIEM (below 0) is not built")},
    {&ThirdCard::dmgtyp, real("dmgtyp", dimension::number, 0, any_value,
                              "1: what is damaged loses stress and fails; 0: damage is only summed")},
    {&ThirdCard::lcsdg, gissmo_field::lcsdg},
    {&ThirdCard::ecrit, gissmo_field::ecrit},
    {&ThirdCard::dmgexp, gissmo_field::dmgexp},
    {&ThirdCard::dcrit, gissmo_field::dcrit},
    {&ThirdCard::fadexp, gissmo_field::fadexp},
    {&ThirdCard::lcregd, gissmo_field::lcregd},
};

struct DamageCard : GissmoScaleCard {
  int nahsv = 0;
};
const CardOf<DamageCard> erosion_damage_card{
    integer("sizflg", 0, only(0), "size of an element: 0, that of the start"),
    {&DamageCard::refsz, gissmo_field::refsz},
    {&DamageCard::nahsv, integer("nahsv", 0, any_value, "history variables of damage; NEIPH and NEIPS count here")},
    {&DamageCard::lcsrs, gissmo_field::lcsrs},
    {&DamageCard::shrf, gissmo_field::shrf},
    {&DamageCard::biaxf, gissmo_field::biaxf},
    gissmo_field::lcdlim,
    gissmo_field::midfail,
};

struct FourthCard {
  double epsthin = 0;
};
const CardOf<FourthCard> fourth_card{
    integer("lcfld", 0, only(0), "forming limit curve"),
    integer("nsff", 10, any_value, "fade-out, for LCFLD only"),
    {&FourthCard::epsthin, real("epsthin", dimension::number, 0, at_least(0), "thinning strain of a layer")},
    real("engcrt", dimension::number, 0, only(0), "critical energy of a neighbourhood"),
    real("radcrt", dimension::length, 0, any_value, "its radius, for ENGCRT only"),
    integer("lceps12", 0, only(0), "in-plane shear strain over element size"),
    integer("lceps13", 0, only(0), "transverse shear strain over element size"),
    integer("lcepsmx", 0, only(0), "major strain over element size"),
};

const Card fifth_card{{
    real("dteflt", dimension::time, 0, any_value, "filter, for MXEPS below 0 only"),
    real("volfrac", dimension::number, 0, any_value, "for elements of higher order only"),
    real("mxtmp", dimension::number, 0, only(0), "greatest temperature"),
    real("dtmin", dimension::time, 0, only(0), "smallest time step; TSMIN and TDEL are built"),
}};

struct ErosionCards {
  RowOf<FirstErosionCard> first;
  RowOf<SecondCard> second;
  RowOf<ThirdCard> third;
  RowOf<FourthCard> fourth;
  std::optional<RowOf<DamageCard>> damage;  ///< with IDAM 1
  int stress_curve;                         ///< SIGVM below 0: id of the curve
};

/// The value of a criterion, if it counts. A zero in the first card never does.
std::optional<double> criterion(const ErosionCards& cards, double value, bool zero_counts = true) {
  if (value == cards.first->excl || (value == 0.0 && !zero_counts)) return std::nullopt;
  return value;
}

kernel::Erosion criteria(Builder& b, const ErosionCards& cards) {
  const auto one = [&](double value) { return criterion(cards, value, false); };
  const auto two = [&](double value) { return criterion(cards, value); };
  kernel::Erosion e;
  e.most_pressure = one(cards.first->mxpres);
  e.least_strain = one(cards.first->mneps);
  const auto of_volume = one(cards.first->voleps);
  (of_volume && *of_volume < 0.0 ? e.least_volume_strain : e.most_volume_strain) = of_volume;
  if (const auto strain = one(cards.first->effeps); strain && *strain > 0.0) e.effective_strain = strain;
  e.needed = static_cast<int>(cards.first->ncs);
  e.least_pressure = two(cards.second->mnpres);
  e.most_stress = two(cards.second->sigp1);
  e.most_strain = two(cards.second->mxeps);
  e.shear_strain = two(cards.second->epssh);
  if (const auto impulse = two(cards.second->impulse)) {
    e.impulse = impulse;
    e.threshold = cards.second->sigth;
  }
  if (const auto time = two(cards.second->failtm); time && *time != 0.0) e.time = std::abs(*time);
  if (cards.fourth->epsthin > 0.0) e.thinning = cards.fourth->epsthin;
  if (const auto stress = two(cards.second->sigvm); stress && *stress >= 0.0) {
    e.effective_stress = stress;
  } else if (stress) {
    if (const Index curve = b.curves.find(cards.stress_curve); curve != none)
      e.effective_stress_over_rate = b.model.curves[curve];
    else
      refuse(b, cards.second[&SecondCard::sigvm], fmt::format("curve {} is not defined", cards.stress_curve),
             "define it");
  }
  if (e.most_strain && *e.most_strain < 0.0)
    refuse(b, cards.second[&SecondCard::mxeps], "a curve over the strain rate is not supported", "give a strain");
  return e;
}

/// How many criteria count.
int number_of(const kernel::Erosion& e) {
  int n = !e.effective_stress_over_rate.empty();
  for (const auto* one : {&e.most_pressure, &e.least_pressure, &e.least_strain, &e.most_strain, &e.effective_strain,
                          &e.most_volume_strain, &e.least_volume_strain, &e.most_stress, &e.effective_stress,
                          &e.shear_strain, &e.impulse, &e.time, &e.thinning})
    n += one->has_value();
  return n;
}

/// Warns of criteria that can never be met, and of those that hold at rest.
void report_idle_fields(Builder& b, const ErosionCards& cards, const kernel::LawComponents& law) {
  const kernel::Erosion& e = *law.erosion;
  const auto warn = [&](const deck::Entry& field, std::string_view text, const char* remedy) {
    field.report(b.findings, Severity::warning, text, remedy);
  };
  const auto at_rest = [&](const deck::Entry& field, bool met) {
    if (met)
      warn(field, "the criterion is met where there is no stress and no strain: all elements go in the first cycle",
           "see its sign, and EXCL");
  };
  at_rest(cards.first[&FirstErosionCard::mxpres], e.most_pressure && *e.most_pressure < 0.0);
  at_rest(cards.first[&FirstErosionCard::mneps], e.least_strain && *e.least_strain > 0.0);
  at_rest(cards.second[&SecondCard::mnpres], e.least_pressure && *e.least_pressure > 0.0);
  at_rest(cards.second[&SecondCard::sigp1], e.most_stress && *e.most_stress < 0.0);
  at_rest(cards.second[&SecondCard::epssh], e.shear_strain && *e.shear_strain < 0.0);
  at_rest(cards.second[&SecondCard::impulse], e.impulse && *e.impulse < 0.0);
  if (const double threshold = cards.second->sigth; threshold != 0.0 && threshold != cards.first->excl && !e.impulse)
    warn(cards.second[&SecondCard::sigth], "a threshold without IMPULSE has no effect", "give IMPULSE");
  const double strain = cards.first->effeps;
  const bool by_plastic_strain = strain < 0.0 && strain != cards.first->excl;
  if (by_plastic_strain && !has_plastic_strain(law.flow))
    warn(cards.first[&FirstErosionCard::effeps], "below 0 it is a plastic strain, which this material does not have",
         "write it above 0 for the effective strain");
  const int count = number_of(e);
  if (count == 0 && !by_plastic_strain && !law.gissmo)
    warn(cards.first[&FirstErosionCard::mid], "none of the criteria counts: nothing is eroded",
         "give one, or remove the keyword");
  else if (count > 0 && e.needed > count && !by_plastic_strain)
    warn(cards.first[&FirstErosionCard::ncs],
         fmt::format("{} criteria must hold at once, but {} are given: nothing is eroded", e.needed, count),
         "lower NCS");
  if (e.time && b.model.control.relaxation.on())
    warn(cards.second[&SecondCard::failtm], "the time of dynamic relaxation counts too",
         "erode in a run without relaxation");
}

void add_erosion(Builder& b, const ErosionCards& cards) {
  const Index index = b.find(b.materials, "material", cards.first[&FirstErosionCard::mid]);
  if (index == none) return;
  Material& material = b.model.materials[index];
  std::optional<kernel::LawComponents> law = components_of(material.law);
  if (!law)
    return refuse(b, cards.first[&FirstErosionCard::mid],
                  fmt::format("erosion cannot be added to *{}", material.keyword),
                  "welds, discrete beams and adhesive have failure criteria of their own");
  if (law->erosion)
    return refuse(b, cards.first[&FirstErosionCard::mid],
                  fmt::format("material {} has criteria of erosion already", material.id),
                  "write all criteria on one *MAT_ADD_EROSION");
  take_points_to_delete(b, cards.first[&FirstErosionCard::numfip], *law, law->gissmo.has_value());
  if (cards.damage && law->gissmo)
    return refuse(b, cards.third[&ThirdCard::idam],
                  fmt::format("material {} has damage of GISSMO already", material.id),
                  "write one card for each material");
  if (cards.damage) {
    law->gissmo = gissmo(b, gissmo_entries(cards.third[&ThirdCard::dmgtyp], cards.third, *cards.damage), law->flow);
    if (!law->gissmo) return;
  }
  law->erosion = criteria(b, cards);
  if (const auto strain = criterion(cards, cards.first->effeps, false); strain && *strain < 0.0) {
    if (law->erosion->needed > 1)
      return refuse(b, cards.first[&FirstErosionCard::effeps],
                    "a plastic strain together with NCS above 1 is not supported", "write NCS 1");
    law->failure_strain = law->failure_strain > 0.0 ? std::min(law->failure_strain, -*strain) : -*strain;
  }
  report_idle_fields(b, cards, *law);
  if (law->gissmo && number_of(*law->erosion) == 0) law->erosion.reset();
  material.law = composed_law(std::move(*law));
}

void read_erosion(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  ErosionCards cards{cursor.read(first_card), cursor.read(second_card), cursor.read(third_card), {}, {}, 0};
  if (cards.third->idam == 1) {
    cards.damage = cursor.read(erosion_damage_card);
    expect(b, Severity::note,
           {{(*cards.damage)[&DamageCard::refsz], 0, "damage for another element size is not written"},
            {(*cards.damage)[&DamageCard::nahsv], 0, "NEIPH, NEIPS say how many history variables are written"}});
  }
  cards.fourth = cursor.read(fourth_card);
  cursor.read(fifth_card);
  expect_end(b, cursor);
  cards.stress_curve = curve_below_zero(cards.second->sigvm);
  // After the laws have their curves.
  b.defer(Phase::systems, [cards](Builder& later) { add_erosion(later, cards); });
}

}  // namespace

std::vector<Keyword> erosion_keywords() {
  return {
      {.name = "MAT_ADD_EROSION",
       .options = {"TITLE"},
       .layout = {{"", &first_card},
                  {"", &second_card},
                  {"", &third_card},
                  {"if IDAM = 1", &erosion_damage_card},
                  {"", &fourth_card},
                  {"", &fifth_card}},
       .read = read_erosion},
  };
}

}  // namespace nugget::reading
