// SPDX-License-Identifier: Apache-2.0
// *AIRBAG_...: gas in a volume, the air of tyres above all.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "model/segments.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/fabric_leakage.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct VolumeCard {
  int sid = 0, sidtyp = 0;
  double vsca = 0, psca = 0, mwd = 0;
};
const CardOf<VolumeCard> volume_card{
    {&VolumeCard::sid, id("sid", IdSpace::set, required, "segment set or part set that encloses the gas")},
    {&VolumeCard::sidtyp, integer("sidtyp", 0, any_value, "0 segment set; others: part set, its shells")},
    integer("rbid", 0, only(0), "rigid body of a sensor of the user"),
    {&VolumeCard::vsca, real("vsca", dimension::number, 1, above_zero(), "scale of the volume")},
    {&VolumeCard::psca, real("psca", dimension::number, 1, above_zero(), "scale of the pressure")},
    real("vini", dimension::volume, 0, only(0), "volume filled at the start"),
    {&VolumeCard::mwd, real("mwd", dimension::number, 0, any_value, "damping weighted by mass")},
    real("spsf", dimension::number, 0, only(0), "scale of the stagnation pressure"),
};
struct CoefficientCard {
  double cn = 0, beta = 0;
  int lcid = 0, lciddr = 0;
};
const CardOf<CoefficientCard> coefficient_card{
    {&CoefficientCard::cn,
     or_negative(real("cn", dimension::stress, 0, any_value,
                      "pressure at the volume of the start over beta; below 0: -CN is a curve of it over time"),
                 IdSpace::function)},
    {&CoefficientCard::beta, real("beta", dimension::number, 0, any_value, "factor on CN")},
    {&CoefficientCard::lcid, id("lcid", IdSpace::function, 0,
                                "curve of the pressure over volume by volume at the start, in the place of both")},
    {&CoefficientCard::lciddr, id("lciddr", IdSpace::function, 0, "curve of CN over time in dynamic relaxation")},
};
struct AdiabaticCard {
  double psf = 0;
  int lcid = 0;
  double gamma = 0, p0 = 0, pe = 0, ro = 0;
};
const CardOf<AdiabaticCard> adiabatic_card{
    {&AdiabaticCard::psf, real("psf", dimension::number, 1, any_value, "factor on the pressure")},
    {&AdiabaticCard::lcid,
     id("lcid", IdSpace::function, 0, "curve over time: until its first value above 0 the pressure is PSF P0")},
    {&AdiabaticCard::gamma, real("gamma", dimension::number, required, above_zero(), "ratio of heat capacities")},
    {&AdiabaticCard::p0,
     real("p0", dimension::stress, required, any_value, "pressure at the start, above the ambient one")},
    {&AdiabaticCard::pe, real("pe", dimension::stress, 0, at_least(0), "ambient pressure")},
    {&AdiabaticCard::ro,
     real("ro", dimension::density, 0, at_least(0), "density at the start, for abstat; has no effect on the pressure")},
};
constexpr Dimension specific_heat{0, 2, -2}, molar_heat{1, 2, -2};  // per mass or mole and temperature
struct HeatCard {
  double cv = 0, cp = 0, t = 0;
  int lcid = 0;
  double mu = 0, area = 0, pe = 0, ro = 0;
};
const CardOf<HeatCard> heat_card{
    {&HeatCard::cv,
     real("cv", specific_heat, 0, at_least(0), "heat capacity at constant volume; 0: of A, B, MW and GASC")},
    {&HeatCard::cp, real("cp", specific_heat, 0, at_least(0), "heat capacity at constant pressure")},
    {&HeatCard::t, real("t", dimension::number, 0, at_least(0), "absolute temperature of the gas that flows in")},
    {&HeatCard::lcid, id("lcid", IdSpace::function, 0, "curve over time of the mass flow into the volume")},
    {&HeatCard::mu,
     or_negative(real("mu", dimension::number, 0, any_value,
                      "shape factor of the vent; below 0: -MU is a curve of it over the absolute pressure"),
                 IdSpace::function)},
    {&HeatCard::area, or_negative(real("area", dimension::area, 0, any_value,
                                       "area of the vent; below 0: -AREA is a curve of it over the absolute pressure"),
                                  IdSpace::function)},
    {&HeatCard::pe, real("pe", dimension::stress, 0, at_least(0), "ambient pressure, that of the gas at the start")},
    {&HeatCard::ro, real("ro", dimension::density, 0, at_least(0), "ambient density, that of the gas at the start")},
};
struct OutflowCard {
  int lou = 0;
  double text = 0, a = 0, b = 0, mw = 0, gasc = 0;
};
const CardOf<OutflowCard> outflow_card{
    {&OutflowCard::lou, id("lou", IdSpace::function, 0,
                           "curve over the pressure above PE of the mass flow out of it, in the place of the vent")},
    {&OutflowCard::text,
     real("text", dimension::number, 0, at_least(0), "with CV 0: absolute temperature of the gas at the start")},
    {&OutflowCard::a,
     real("a", molar_heat, 0, any_value, "with CV 0: heat capacity of a mole at constant pressure, at temperature 0")},
    {&OutflowCard::b, real("b", molar_heat, 0, any_value, "with CV 0: what it grows by, per temperature")},
    {&OutflowCard::mw, real("mw", dimension::mass, 0, at_least(0), "with CV 0: mass of a mole")},
    {&OutflowCard::gasc, real("gasc", molar_heat, 0, at_least(0), "with CV 0: universal gas constant")},
};

struct InflatorCard {
  double cv = 0, cp = 0, t = 0;
  int lct = 0, lcmt = 0;
  double tvol = 0, iabt = 0;
};
const CardOf<InflatorCard> inflator_card{
    {&InflatorCard::cv,
     real("cv", specific_heat, 0, at_least(0), "heat capacity at constant volume; 0: of A, B, MW and GASC")},
    {&InflatorCard::cp, real("cp", specific_heat, 0, at_least(0), "heat capacity at constant pressure")},
    {&InflatorCard::t, real("t", dimension::number, 0, at_least(0), "absolute temperature of the gas that flows in")},
    {&InflatorCard::lct, id("lct", IdSpace::function, 0, "curve of it over time, in the place of T")},
    {&InflatorCard::lcmt, id("lcmt", IdSpace::function, 0, "curve over time of the mass flow into the volume")},
    real("tvol", dimension::volume, 0, only(0), "volume of a tank, whose pressure LCMT would be"),
    integer("lcdt", 0, only(0), "curve of the rate of temperature in a tank"),
    {&InflatorCard::iabt,
     real("iabt", dimension::number, 0, at_least(0), "absolute temperature of the gas at the start; 0: by PE and RO")},
};
struct HolesCard {
  double c23 = 0;
  int lcc23 = 0;
  double a23 = 0;
  int lca23 = 0;
  double cp23 = 0;
  int lccp23 = 0;
  double ap23 = 0;
  int lcap23 = 0;
};
const CardOf<HolesCard> holes_card{
    {&HolesCard::c23, real("c23", dimension::number, 0, at_least(0), "shape factor of the vent")},
    {&HolesCard::lcc23, id("lcc23", IdSpace::function, 0, "curve of it over time, where C23 is 0")},
    {&HolesCard::a23, or_negative(real("a23", dimension::area, 0, any_value,
                                       "area of the vent; below 0: that of the shells of part -A23, as it is now"),
                                  IdSpace::part)},
    {&HolesCard::lca23, id("lca23", IdSpace::function, 0, "curve of it over the absolute pressure, where A23 is 0")},
    {&HolesCard::cp23, real("cp23", dimension::number, 0, at_least(0), "shape factor of what leaks")},
    {&HolesCard::lccp23, id("lccp23", IdSpace::function, 0, "curve of it over time, where CP23 is 0")},
    {&HolesCard::ap23, real("ap23", dimension::area, 0, at_least(0), "area that leaks")},
    {&HolesCard::lcap23, id("lcap23", IdSpace::function, 0, "curve of it over the absolute pressure, where AP23 is 0")},
};
struct AmbienceCard {
  double pe = 0, ro = 0, gc = 0;
  int lcefr = 0;
  double pover = 0, ppop = 0;
  int opt = 0;
};
const CardOf<AmbienceCard> ambience_card{
    {&AmbienceCard::pe, real("pe", dimension::stress, 0, at_least(0), "ambient pressure")},
    {&AmbienceCard::ro, real("ro", dimension::density, 0, at_least(0), "ambient density, that of the gas at PE")},
    {&AmbienceCard::gc,
     real("gc", dimension::number, 1, only(1), "conversion of units; 1 where they are consistent, as here")},
    {&AmbienceCard::lcefr, id("lcefr", IdSpace::function, 0,
                              "curve over the pressure above PE of the mass flow out of it, in the place of the vent")},
    {&AmbienceCard::pover, real("pover", dimension::stress, 0, at_least(0), "pressure above PE at the start")},
    {&AmbienceCard::ppop,
     real("ppop", dimension::stress, 0, at_least(0), "pressure above PE at which the vent opens for good")},
    {&AmbienceCard::opt,
     integer("opt", 0, between(0, 8), "above 0: FVOPT of fabric that has none, in the place of CP23 and AP23")},
    integer("knkdn", 0, only(0), "curve of jets"),
};
const Card inflator_model_card{{
    real("ioc", dimension::number, 0, only(0), "model of the inflator: shape of its opening"),
    real("ioa", dimension::area, 0, only(0), "the same: its area"),
    real("ivol", dimension::volume, 0, only(0), "the same: volume"),
    real("iro", dimension::density, 0, only(0), "the same: density"),
    real("it", dimension::number, 0, only(0), "the same: temperature"),
    integer("lcbf", 0, only(0), "the same: curve of what has burnt"),
}};
struct MoleCard {
  double text = 0, a = 0, b = 0, mw = 0, gasc = 0;
};
const CardOf<MoleCard> mole_card{
    {&MoleCard::text, real("text", dimension::number, 0, at_least(0), "absolute temperature of the gas at the start")},
    {&MoleCard::a,
     real("a", molar_heat, 0, any_value, "heat capacity of a mole at constant pressure, at temperature 0")},
    {&MoleCard::b, real("b", molar_heat, 0, any_value, "what it grows by, per temperature")},
    {&MoleCard::mw, real("mw", dimension::mass, 0, at_least(0), "mass of a mole")},
    {&MoleCard::gasc, real("gasc", molar_heat, 0, at_least(0), "universal gas constant")},
    real("hconv", dimension::number, 0, only(0), "heat given to the air outside"),
};

std::vector<Segment> shells_of(const Builder& b, std::span<const Index> parts) {
  std::vector<Segment> segments;
  const Shells& shells = b.model.shells;
  for (std::size_t e = 0; e < shells.size(); ++e)
    if (std::ranges::find(parts, shells.part[e]) != parts.end()) segments.push_back(shells.node[e]);
  return segments;
}

std::vector<Segment> faces(Builder& b, const RowOf<VolumeCard>& row) {
  std::vector<Segment> segments;
  if (row->sidtyp == 0) {
    if (const auto* set = b.segment_set(row[&VolumeCard::sid])) segments = set->members;
    return segments;
  }
  const auto* parts = b.part_set(row[&VolumeCard::sid]);
  if (parts == nullptr) return segments;
  segments = shells_of(b, parts->members);
  if (segments.empty()) refuse(b, row[&VolumeCard::sid], "the parts of this set have no shells", "give a segment set");
  return segments;
}

/// The shell that a face is, or its nodes.
std::string name_of_face(const Builder& b, Segment face) {
  const Shells& shells = b.model.shells;
  const auto sorted = [](Segment s) {
    std::sort(s.begin(), s.end());
    return s;
  };
  for (std::size_t e = 0; e < shells.size(); ++e)
    if (sorted(shells.node[e]) == sorted(face)) return fmt::format("shell {}", shells.id[e]);
  std::vector<int> ids;
  for (const Index n : face) ids.push_back(b.model.nodes.id[n]);
  return fmt::format("face {}", fmt::join(ids, " "));
}

/// The faces along an edge.
std::string faces_along(const Builder& b, const std::vector<Segment>& segments, const std::array<Index, 2>& edge) {
  std::vector<std::string> names;
  for (const Segment& s : segments)
    for (std::size_t i = 0; i < 4; ++i)
      if (std::pair(s[i], s[(i + 1) % 4]) == std::pair(edge[0], edge[1]) ||
          std::pair(s[i], s[(i + 1) % 4]) == std::pair(edge[1], edge[0]))
        names.push_back(name_of_face(b, s));
  return fmt::format("{}", fmt::join(names, " and "));
}

/// Turns faces whose normals disagree with those of their neighbours; false where that cannot be.
bool turn_faces(Builder& b, const RowOf<VolumeCard>& row, ControlVolume& volume) {
  const SurfaceBorder before = surface_border(volume.segments);
  if (before.twisted.empty()) return true;
  const auto& edge = before.twisted.front();
  const std::string where =
      fmt::format("the normals of neighbours disagree at {} edge{}, the first from node {} to {}, between {}",
                  before.twisted.size(), before.twisted.size() == 1 ? "" : "s", b.model.nodes.id[edge[0]],
                  b.model.nodes.id[edge[1]], faces_along(b, volume.segments, edge));
  const char* remedy = "turn the elements so that all normals point out of the volume";
  const std::vector<Segment> as_given = volume.segments;
  const std::vector<std::size_t> turned = model::turn_faces_to_agree(volume.segments);
  if (!surface_border(volume.segments).twisted.empty()) {
    refuse(b, row[&VolumeCard::sid], where, remedy);
    return false;
  }
  row[&VolumeCard::sid].report(b.findings, Severity::warning,
                               fmt::format("{}: {} faces are taken the other way round, the first {}", where,
                                           turned.size(), name_of_face(b, as_given[turned.front()])),
                               remedy);
  return true;
}

/// What of the faces leaks; a note on it.
void find_leaking_fabric(Builder& b, const deck::Entry& option, ControlVolume& volume) {
  std::vector<PorousFabric>& fabric = volume.flowing.fabric;
  fabric = leaking_faces(b, volume.segments, option);
  if (fabric.empty()) {
    if (option.value != 0.0)
      option.report(b.findings, Severity::note, "nothing leaks: no fabric of this gas has FLC and FAC");
    return;
  }
  std::size_t faces = 0;
  double area = 0.0;
  for (const PorousFabric& f : fabric) {
    faces += f.faces.size();
    area += surface_area(f.faces, [&](Index n) { return b.model.nodes.x[n]; });
  }
  b.findings.note(volume.place, '*' + volume.keyword,
                  fmt::format("gas leaks through {} shells of fabric with an area of {:.6g}", faces, area));
}

/// Finds the surface, its openings and its volume at the start.
/// `option`: OPT of a gas that leaks through fabric.
void add_volume(Builder& b, const RowOf<VolumeCard>& row, ControlVolume volume, const deck::Entry* option = nullptr) {
  volume.segments = faces(b, row);
  if (volume.segments.empty()) return;
  if (!turn_faces(b, row, volume)) return;
  SurfaceBorder border = surface_border(volume.segments);
  const auto enclosed = [&] {
    return enclosed_volume(volume.segments, border.openings, [&](Index n) { return b.model.nodes.x[n]; });
  };
  double v = enclosed();
  const double nothing =
      1e-9 * std::pow(surface_area(volume.segments, [&](Index n) { return b.model.nodes.x[n]; }), 1.5);
  if (v < -nothing) {
    row[&VolumeCard::sid].report(b.findings, Severity::warning,
                                 "all normals point into the volume: its faces are taken the other way round",
                                 "turn the elements so that the normals point outwards");
    for (Segment& s : volume.segments) s = model::turned_over(s);
    border = surface_border(volume.segments);
    v = enclosed();
  }
  if (!(v > nothing))
    return refuse(b, row[&VolumeCard::sid], "the faces enclose no volume at the start",
                  "give a bag that is not quite flat, with normals that point outwards");
  volume.share = share_pressure(b.model, volume.segments);
  if (option != nullptr) find_leaking_fabric(b, *option, volume);
  volume.openings = std::move(border.openings);
  if (row->mwd != 0.0)
    row[&VolumeCard::mwd].report(b.findings, Severity::warning, "not obeyed: the surface is not damped",
                                 "use *DAMPING_PART_MASS");
  b.findings.note(volume.place, row.keyword(),
                  fmt::format("{} faces enclose a volume of {:.6g}{}", volume.segments.size(), v,
                              volume.openings.empty() ? std::string{}
                                                      : fmt::format("; {} opening{} covered", volume.openings.size(),
                                                                    volume.openings.size() == 1 ? " is" : "s are")));
  b.model.control_volumes.push_back(std::move(volume));
}

ControlVolume read_volume(const Block& block, const RowOf<VolumeCard>& row, const Heading& heading) {
  ControlVolume volume;
  volume.id = heading.id;
  volume.title = heading.text;
  volume.keyword = block.keyword;
  volume.volume_scale = row->vsca;
  volume.pressure_scale = row->psca;
  volume.place = row.place();
  return volume;
}

/// Finds a curve by its id, if that is not 0; false where there is none.
bool find_curve(Builder& b, const deck::Entry& field, int id, Index& curve) {
  if (id == 0) return true;
  curve = b.curves.find(id);
  if (curve == none) refuse(b, field, fmt::format("curve {} is not defined", id));
  return curve != none;
}

void read_pressure_volume(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const auto row = cursor.read(volume_card);
    const auto gas = cursor.read(coefficient_card);
    ControlVolume volume = read_volume(block, row, heading);
    const double cn = gas->cn;
    volume.beta = gas->beta;
    volume.coefficient = volume.beta * cn;
    const int cn_curve = curve_below_zero(gas->cn);
    const bool by_curve = gas->lcid != 0;
    if (by_curve)
      volume.gas = ControlVolume::Gas::curve;
    else if (volume.coefficient == 0.0)
      refuse(builder, gas[cn == 0.0 ? &CoefficientCard::cn : &CoefficientCard::beta],
             "there is no pressure: neither LCID nor CN times BETA is given",
             "give CN, the pressure at the start, and BETA 1");
    builder.defer(Phase::conditions, [row, gas, volume, by_curve, cn_curve](Builder& b) mutable {
      volume.curve = b.curve(gas[&CoefficientCard::lcid]);
      volume.relaxation_curve = b.curve(gas[&CoefficientCard::lciddr]);
      if (!by_curve && !find_curve(b, gas[&CoefficientCard::cn], cn_curve, volume.coefficient_curve)) return;
      if (by_curve && volume.curve == none) return;
      add_volume(b, row, std::move(volume));
    });
  }
}

void read_adiabatic(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const auto row = cursor.read(volume_card);
    const auto gas = cursor.read(adiabatic_card);
    ControlVolume volume = read_volume(block, row, heading);
    volume.gas = ControlVolume::Gas::adiabatic;
    volume.beta = gas->psf;
    volume.gamma = gas->gamma;
    volume.ambient = gas->pe;
    volume.absolute = gas->p0 + volume.ambient;
    volume.density = gas->ro;
    if (!(volume.absolute > 0.0))
      refuse(builder, gas[&AdiabaticCard::p0], "the absolute pressure P0 + PE is not above 0",
             "give P0 above the ambient pressure PE");
    if (volume.gamma <= 1.0)
      refuse(builder, gas[&AdiabaticCard::gamma], "a ratio of heat capacities is above 1", "write 1.4 for air");
    builder.defer(Phase::conditions, [row, gas, volume](Builder& b) mutable {
      volume.preload_curve = b.curve(gas[&AdiabaticCard::lcid]);
      add_volume(b, row, std::move(volume));
    });
  }
}

/// The heat capacities, and with them what is known of the gas at the start.
FlowingGas read_heat(Builder& b, const RowOf<HeatCard>& heat, const RowOf<OutflowCard>& outflow, double ambient) {
  FlowingGas gas;
  gas.density = heat->ro;
  if (heat->cv > 0.0) {
    gas.heat = heat->cp;
    gas.constant = gas.heat - heat->cv;
    if (gas.constant <= 0.0)
      refuse(b, heat[&HeatCard::cp], "the heat capacity at constant pressure is not above CV",
             "CP is 1.4 times CV for air");
    for (double OutflowCard::*const field :
         {&OutflowCard::text, &OutflowCard::a, &OutflowCard::b, &OutflowCard::mw, &OutflowCard::gasc})
      if (outflow[field].value != 0.0)
        outflow[field].report(b.findings, Severity::warning, "not obeyed: it is for CV 0, and CV is given");
  } else if (const double mole = outflow->mw; mole > 0.0 && outflow->gasc > 0.0) {
    gas.heat = outflow->a / mole;
    gas.heat_slope = outflow->b / mole;
    gas.constant = outflow->gasc / mole;
    if (gas.heat <= gas.constant || gas.heat_slope < 0.0)
      refuse(b, outflow[gas.heat_slope < 0.0 ? &OutflowCard::b : &OutflowCard::a],
             "the heat capacity at constant volume, A + B T - GASC, is not above 0 at all temperatures",
             "A is 29.1 J/K and B 0 for a mole of air");
    if (heat->cp > 0.0)
      heat[&HeatCard::cp].report(b.findings, Severity::warning, "not obeyed: with CV 0 it comes from A, B and MW");
    gas.temperature = outflow->text;
    if (gas.temperature > 0.0) gas.density = ambient / (gas.constant * gas.temperature);
    if (heat->ro > 0.0 && std::abs(gas.density / heat->ro - 1.0) > 0.01)
      heat[&HeatCard::ro].report(b.findings, Severity::warning,
                                 fmt::format("not obeyed: PE, TEXT, MW and GASC give {:.4g}", gas.density));
  } else {
    refuse(b, heat[&HeatCard::cv], "without CV the gas needs MW and GASC",
           "give CV and CP, or A, B, MW, GASC and TEXT");
  }
  if (gas.temperature == 0.0 && gas.density > 0.0 && gas.constant > 0.0)
    gas.temperature = ambient / (gas.density * gas.constant);
  if (gas.density == 0.0 && ambient > 0.0)
    refuse(b, heat[&HeatCard::ro], "there is no mass at the start, at a pressure of PE",
           "give the density of the ambient gas");
  if (gas.density > 0.0 && ambient == 0.0)
    refuse(b, heat[&HeatCard::pe], "the gas at the start has mass, but no pressure",
           "give the ambient pressure, or RO 0");
  return gas;
}

/// Flows are one way each.
void expect_no_backflow(Builder& b, const deck::Entry& field, Index curve) {
  if (curve == none) return;
  const Curve& c = b.model.curves[curve];
  if (std::any_of(c.y.begin(), c.y.end(), [](double y) { return y < 0.0; }))
    refuse(b, field, "this curve has values below 0",
           "use LCID for what flows in and the vent or LOU for what flows out");
}

/// Temperature and density of the gas at the start: a quick check of the units.
void note_gas(Builder& b, const RowOf<VolumeCard>& row, const ControlVolume& volume) {
  const FlowingGas& gas = volume.flowing;
  const double density =
      gas.density + (gas.overpressure > 0.0 ? gas.overpressure / (gas.constant * gas.temperature) : 0.0);
  b.findings.note(volume.place, row.keyword(),
                  fmt::format("the gas at the start has a temperature of {:.4g} and a density of {:.4g}; its gas "
                              "constant is {:.4g}",
                              gas.temperature, density, gas.constant));
}

void read_simple_airbag(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const auto row = cursor.read(volume_card);
    const auto heat = cursor.read(heat_card);
    const auto outflow = cursor.read(outflow_card);
    ControlVolume volume = read_volume(block, row, heading);
    volume.gas = ControlVolume::Gas::flowing;
    volume.ambient = heat->pe;
    FlowingGas& gas = volume.flowing;
    gas = read_heat(builder, heat, outflow, volume.ambient);
    gas.inflow_temperature = heat->t;
    gas.vent.shape = std::max(0.0, heat->mu);
    gas.vent.area = std::max(0.0, heat->area);
    const int shape = curve_below_zero(heat->mu), area = curve_below_zero(heat->area);
    if (heat->lcid != 0 && gas.inflow_temperature == 0.0)
      refuse(builder, heat[&HeatCard::t], "the gas that flows in has no temperature", "give its absolute temperature");
    if (heat->area != 0.0 && heat->mu == 0.0)
      heat[&HeatCard::mu].report(builder.findings, Severity::warning, "the vent is closed: its shape factor is 0",
                                 "give MU, e.g. 0.7 for a sharp edge, or AREA 0");
    if (outflow->lou != 0 && heat->area != 0.0 && heat->mu != 0.0)
      refuse(builder, outflow[&OutflowCard::lou], "the outflow is given twice, by this curve and by MU and AREA",
             "set MU and AREA, or LOU, to 0");
    builder.defer(Phase::conditions, [row, heat, outflow, volume, shape, area](Builder& b) mutable {
      FlowingGas& flowing = volume.flowing;
      flowing.inflow_curve = b.curve(heat[&HeatCard::lcid]);
      flowing.outflow_curve = b.curve(outflow[&OutflowCard::lou]);
      if (!find_curve(b, heat[&HeatCard::mu], shape, flowing.vent.shape_curve)) return;
      if (!find_curve(b, heat[&HeatCard::area], area, flowing.vent.area_curve)) return;
      expect_no_backflow(b, heat[&HeatCard::lcid], flowing.inflow_curve);
      expect_no_backflow(b, heat[&HeatCard::mu], flowing.vent.shape_curve);
      expect_no_backflow(b, heat[&HeatCard::area], flowing.vent.area_curve);
      expect_no_backflow(b, outflow[&OutflowCard::lou], flowing.outflow_curve);
      note_gas(b, row, volume);
      add_volume(b, row, std::move(volume));
    });
  }
}

/// What a vent's two numbers are given by: a curve counts where the number is 0.
void find_vent(Builder& b, const deck::RowOf<HolesCard>& row, double HolesCard::*shape, int HolesCard::*shape_curve,
               double HolesCard::*area, int HolesCard::*area_curve, Vent& vent) {
  vent.shape = row[shape].value;
  vent.area = std::max(0.0, row[area].value);
  if (vent.shape == 0.0) vent.shape_over_time = b.curve(row[shape_curve]);
  if (row[area].value == 0.0) vent.area_curve = b.curve(row[area_curve]);
  expect_no_backflow(b, row[shape_curve], vent.shape_over_time);
  expect_no_backflow(b, row[area_curve], vent.area_curve);
  const bool has_area = vent.area > 0.0 || vent.area_curve != none || !vent.faces.empty(),
             has_shape = vent.shape > 0.0 || vent.shape_over_time != none;
  if (has_area != has_shape)
    row[has_area ? shape : area].report(b.findings, Severity::warning,
                                        "this opening is closed: its area times its shape factor is 0",
                                        "give both, or neither");
}

/// A23 below 0: the area of the vent is that of the shells of a part.
void take_area_of_part(Builder& b, const RowOf<HolesCard>& holes, Vent& vent) {
  const deck::Entry& field = holes[&HolesCard::a23];
  if (!(holes->a23 < 0.0)) return;
  if (holes->lca23 < 0)
    refuse(b, holes[&HolesCard::lca23], "a part set of vents is not built", "give A23 the number of one part");
  const Index part = b.parts.find(static_cast<int>(-holes->a23));
  if (part == none) return refuse(b, field, fmt::format("part {:g} is not defined", -holes->a23));
  vent.faces = shells_of(b, std::span(&part, 1));
  if (vent.faces.empty()) refuse(b, field, fmt::format("part {:g} has no shells", -holes->a23));
}

/// With OPT the fabric leaks in the place of CP23 and AP23 (keyword manual).
void report_fields_without_effect(Builder& b, const RowOf<HolesCard>& holes) {
  for (double HolesCard::*const field : {&HolesCard::cp23, &HolesCard::ap23})
    if (holes[field].value != 0.0)
      holes[field].report(b.findings, Severity::warning, "no effect: with OPT the fabric leaks in its place",
                          "write OPT 0, or leave it blank");
}

/// As those of the simple airbag, which has them in other fields.
FlowingGas read_heat(Builder& b, const RowOf<InflatorCard>& inflator, const RowOf<AmbienceCard>& outside,
                     const std::optional<RowOf<MoleCard>>& mole) {
  FlowingGas gas;
  gas.density = outside->ro;
  gas.temperature = inflator->iabt;
  const double ambient = outside->pe;
  if (inflator->cv > 0.0) {
    gas.heat = inflator->cp;
    gas.constant = gas.heat - inflator->cv;
    if (gas.constant <= 0.0)
      refuse(b, inflator[&InflatorCard::cp], "the heat capacity at constant pressure is not above CV",
             "CP is 1.4 times CV for air");
  } else if (mole && (*mole)->mw > 0.0 && (*mole)->gasc > 0.0) {
    const MoleCard& m = **mole;
    gas.heat = m.a / m.mw;
    gas.heat_slope = m.b / m.mw;
    gas.constant = m.gasc / m.mw;
    if (gas.heat <= gas.constant || gas.heat_slope < 0.0)
      refuse(b, (*mole)[gas.heat_slope < 0.0 ? &MoleCard::b : &MoleCard::a],
             "the heat capacity at constant volume, A + B T - GASC, is not above 0 at all temperatures",
             "A is 29.1 J/K and B 0 for a mole of air");
    if (gas.temperature == 0.0) gas.temperature = m.text;
  } else {
    refuse(b, inflator[&InflatorCard::cv], "without CV the gas needs MW and GASC",
           "give CV and CP, or A, B, MW, GASC and TEXT");
    return gas;
  }
  if (gas.constant <= 0.0) return gas;
  // The temperature, where it is given, counts before the density.
  if (gas.temperature > 0.0) {
    const double by_temperature = ambient / (gas.constant * gas.temperature);
    if (gas.density > 0.0 && std::abs(by_temperature / gas.density - 1.0) > 0.01)
      outside[&AmbienceCard::ro].report(
          b.findings, Severity::warning,
          fmt::format("not obeyed: PE and the temperature at the start give {:.4g}", by_temperature));
    gas.density = by_temperature;
  } else if (gas.density > 0.0) {
    gas.temperature = ambient / (gas.density * gas.constant);
  }
  if (gas.density == 0.0 && ambient > 0.0)
    refuse(b, outside[&AmbienceCard::ro], "there is no mass at the start, at a pressure of PE",
           "give the density of the ambient gas");
  if (gas.density > 0.0 && ambient == 0.0)
    refuse(b, outside[&AmbienceCard::pe], "the gas at the start has mass, but no pressure",
           "give the ambient pressure, or RO 0");
  return gas;
}

void read_wang_nefske(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const auto row = cursor.read(volume_card);
    const auto inflator = cursor.read(inflator_card);
    const auto holes = cursor.read(holes_card);
    const auto outside = cursor.read(ambience_card);
    cursor.read(inflator_model_card);
    std::optional<RowOf<MoleCard>> mole;
    if (inflator->cv == 0.0) mole = cursor.read(mole_card);
    ControlVolume volume = read_volume(block, row, heading);
    volume.gas = ControlVolume::Gas::flowing;
    volume.ambient = outside->pe;
    FlowingGas& gas = volume.flowing;
    gas = read_heat(builder, inflator, outside, mole);
    gas.inflow_temperature = inflator->t;
    gas.overpressure = outside->pover;
    gas.pop_pressure = outside->ppop;
    if (gas.overpressure > 0.0 && gas.temperature == 0.0)
      refuse(builder, outside[&AmbienceCard::pover], "the gas at the start has a pressure, but no temperature",
             "give PE and RO, or IABT");
    if (inflator->lcmt != 0 && gas.inflow_temperature == 0.0 && inflator->lct == 0)
      refuse(builder, inflator[&InflatorCard::t], "the gas that flows in has no temperature",
             "give its absolute temperature, T or LCT");
    if (outside->lcefr != 0 && (holes->a23 != 0.0 || holes->lca23 != 0))
      refuse(builder, outside[&AmbienceCard::lcefr], "the outflow is given twice, by this curve and by the vent",
             "set A23 and LCA23, or LCEFR, to 0");
    builder.defer(Phase::conditions, [row, inflator, holes, outside, volume](Builder& b) mutable {
      FlowingGas& flowing = volume.flowing;
      flowing.inflow_curve = b.curve(inflator[&InflatorCard::lcmt]);
      flowing.inflow_temperature_curve = b.curve(inflator[&InflatorCard::lct]);
      flowing.outflow_curve = b.curve(outside[&AmbienceCard::lcefr]);
      using H = HolesCard;
      take_area_of_part(b, holes, flowing.vent);
      find_vent(b, holes, &H::c23, &H::lcc23, &H::a23, &H::lca23, flowing.vent);
      if (outside->opt == 0)
        find_vent(b, holes, &H::cp23, &H::lccp23, &H::ap23, &H::lcap23, flowing.leak);
      else
        report_fields_without_effect(b, holes);
      expect_no_backflow(b, inflator[&InflatorCard::lcmt], flowing.inflow_curve);
      expect_no_backflow(b, inflator[&InflatorCard::lct], flowing.inflow_temperature_curve);
      expect_no_backflow(b, outside[&AmbienceCard::lcefr], flowing.outflow_curve);
      note_gas(b, row, volume);
      const deck::Entry option = outside[&AmbienceCard::opt];
      add_volume(b, row, std::move(volume), &option);
    });
  }
}

Keyword volume_keyword(std::string_view name, std::initializer_list<const Card*> cards,
                       void (*read)(Builder&, const Block&, const Options&)) {
  Keyword keyword{
      .name = name, .options = {"ID"}, .layout = {{"with _ID", &heading_card}, {{}, &volume_card}}, .read = read};
  for (const Card* card : cards) keyword.layout.push_back({{}, card});
  return keyword;
}

}  // namespace

std::vector<Keyword> airbag_keywords() {
  return {
      volume_keyword("AIRBAG_SIMPLE_PRESSURE_VOLUME", {&coefficient_card}, read_pressure_volume),
      volume_keyword("AIRBAG_SIMPLE_AIRBAG_MODEL", {&heat_card, &outflow_card}, read_simple_airbag),
      volume_keyword("AIRBAG_WANG_NEFSKE",
                     {&inflator_card, &holes_card, &ambience_card, &inflator_model_card, &mole_card}, read_wang_nefske),
      volume_keyword("AIRBAG_ADIABATIC_GAS_MODEL", {&adiabatic_card}, read_adiabatic)};
}

}  // namespace nugget::reading
