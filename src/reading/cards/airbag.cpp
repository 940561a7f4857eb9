// SPDX-License-Identifier: Apache-2.0
// *AIRBAG_...: gas in a volume, the air of tyres above all.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "model/segments.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card volume_card{{
    id("sid", IdSpace::set, required, "segment set or part set that encloses the gas"),
    integer("sidtyp", 0, any_value, "0 segment set; others: part set, its shells"),
    integer("rbid", 0, only(0), "rigid body of a sensor of the user"),
    real("vsca", dimension::number, 1, above_zero(), "scale of the volume"),
    real("psca", dimension::number, 1, above_zero(), "scale of the pressure"),
    real("vini", dimension::volume, 0, only(0), "volume filled at the start"),
    real("mwd", dimension::number, 0, any_value, "damping weighted by mass"),
    real("spsf", dimension::number, 0, only(0), "scale of the stagnation pressure"),
}};
const Card coefficient_card{{
    or_negative(real("cn", dimension::stress, 0, any_value,
                     "pressure at the volume of the start over beta; below 0: -CN is a curve of it over time"),
                IdSpace::function),
    real("beta", dimension::number, 0, any_value, "factor on CN"),
    id("lcid", IdSpace::function, 0, "curve of the pressure over volume by volume at the start, in the place of both"),
    id("lciddr", IdSpace::function, 0, "curve of CN over time in dynamic relaxation"),
}};
const Card adiabatic_card{{
    real("psf", dimension::number, 1, any_value, "factor on the pressure"),
    id("lcid", IdSpace::function, 0, "curve over time: until its first value above 0 the pressure is PSF P0"),
    real("gamma", dimension::number, required, above_zero(), "ratio of heat capacities"),
    real("p0", dimension::stress, required, any_value, "pressure at the start, above the ambient one"),
    real("pe", dimension::stress, 0, at_least(0), "ambient pressure"),
    real("ro", dimension::density, 0, at_least(0), "density at the start, for abstat; has no effect on the pressure"),
}};
constexpr Dimension specific_heat{0, 2, -2}, molar_heat{1, 2, -2};  // per mass or mole and temperature
const Card heat_card{{
    real("cv", specific_heat, 0, at_least(0), "heat capacity at constant volume; 0: of A, B, MW and GASC"),
    real("cp", specific_heat, 0, at_least(0), "heat capacity at constant pressure"),
    real("t", dimension::number, 0, at_least(0), "absolute temperature of the gas that flows in"),
    id("lcid", IdSpace::function, 0, "curve over time of the mass flow into the volume"),
    or_negative(real("mu", dimension::number, 0, any_value,
                     "shape factor of the vent; below 0: -MU is a curve of it over the absolute pressure"),
                IdSpace::function),
    or_negative(real("area", dimension::area, 0, any_value,
                     "area of the vent; below 0: -AREA is a curve of it over the absolute pressure"),
                IdSpace::function),
    real("pe", dimension::stress, 0, at_least(0), "ambient pressure, that of the gas at the start"),
    real("ro", dimension::density, 0, at_least(0), "ambient density, that of the gas at the start"),
}};
const Card outflow_card{{
    id("lou", IdSpace::function, 0,
       "curve over the pressure above PE of the mass flow out of it, in the place of the vent"),
    real("text", dimension::number, 0, at_least(0), "with CV 0: absolute temperature of the gas at the start"),
    real("a", molar_heat, 0, any_value, "with CV 0: heat capacity of a mole at constant pressure, at temperature 0"),
    real("b", molar_heat, 0, any_value, "with CV 0: what it grows by, per temperature"),
    real("mw", dimension::mass, 0, at_least(0), "with CV 0: mass of a mole"),
    real("gasc", molar_heat, 0, at_least(0), "with CV 0: universal gas constant"),
}};

std::vector<Segment> faces(Builder& b, const Row& row) {
  std::vector<Segment> segments;
  if (row.integer("sidtyp") == 0) {
    if (const auto* set = b.segment_set(row, "sid")) segments = set->members;
    return segments;
  }
  const auto* parts = b.part_set(row, "sid");
  if (parts == nullptr) return segments;
  const Shells& shells = b.model.shells;
  for (std::size_t e = 0; e < shells.size(); ++e)
    if (std::find(parts->members.begin(), parts->members.end(), shells.part[e]) != parts->members.end())
      segments.push_back(shells.node[e]);
  if (segments.empty()) refuse(b, row, "sid", "the parts of this set have no shells", "give a segment set");
  return segments;
}

/// Finds the surface, its openings and its volume at the start.
void add_volume(Builder& b, const Row& row, ControlVolume volume) {
  volume.segments = faces(b, row);
  volume.share = share_pressure(b.model, volume.segments);
  if (volume.segments.empty()) return;
  SurfaceBorder border = surface_border(volume.segments);
  if (!border.twisted.empty()) {
    const auto& edge = border.twisted.front();
    return refuse(b, row, "sid",
                  fmt::format("the normals of neighbours disagree at {} edge{}, the first from node {} to {}",
                              border.twisted.size(), border.twisted.size() == 1 ? "" : "s",
                              b.model.nodes.id[at(edge[0])], b.model.nodes.id[at(edge[1])]),
                  "turn the elements so that all normals point out of the volume");
  }
  volume.openings = std::move(border.openings);
  const double v = enclosed_volume(volume.segments, volume.openings, [&](Index n) { return b.model.nodes.x[at(n)]; });
  if (!(v > 0.0))
    return refuse(b, row, "sid", fmt::format("the enclosed volume is {:.6g}: the normals point into it", v),
                  "turn the elements so that the normals point outwards");
  if (row.real("mwd") != 0.0)
    row.report(b.findings, Severity::warning, "mwd", "not obeyed: the surface is not damped", "use *DAMPING_PART_MASS");
  b.findings.note(volume.place, row.keyword(),
                  fmt::format("{} faces enclose a volume of {:.6g}{}", volume.segments.size(), v,
                              volume.openings.empty() ? std::string{}
                                                      : fmt::format("; {} opening{} covered", volume.openings.size(),
                                                                    volume.openings.size() == 1 ? " is" : "s are")));
  b.model.control_volumes.push_back(std::move(volume));
}

ControlVolume read_volume(const Block& block, const Row& row, const Heading& heading) {
  ControlVolume volume;
  volume.id = heading.id;
  volume.title = heading.text;
  volume.keyword = block.keyword;
  volume.volume_scale = row.real("vsca");
  volume.pressure_scale = row.real("psca");
  volume.place = row.place();
  return volume;
}

/// Finds a curve by its id, if that is not 0; false where there is none.
bool find_curve(Builder& b, const Row& row, std::string_view field, int id, Index& curve) {
  if (id == 0) return true;
  curve = b.curves.find(id);
  if (curve == none) refuse(b, row, field, fmt::format("curve {} is not defined", id));
  return curve != none;
}

void read_pressure_volume(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const Row row = cursor.read(volume_card), gas = cursor.read(coefficient_card);
    ControlVolume volume = read_volume(block, row, heading);
    const double cn = gas.real("cn");
    volume.beta = gas.real("beta");
    volume.coefficient = volume.beta * cn;
    const int cn_curve = curve_below_zero(gas, "cn");
    const bool by_curve = gas.integer("lcid") != 0;
    if (by_curve)
      volume.gas = ControlVolume::Gas::curve;
    else if (volume.coefficient == 0.0)
      refuse(builder, gas, cn == 0.0 ? "cn" : "beta", "there is no pressure: neither LCID nor CN times BETA is given",
             "give CN, the pressure at the start, and BETA 1");
    builder.defer(Phase::conditions, [row, gas, volume, by_curve, cn_curve](Builder& b) mutable {
      volume.curve = b.curve(gas, "lcid");
      volume.relaxation_curve = b.curve(gas, "lciddr");
      if (!by_curve && !find_curve(b, gas, "cn", cn_curve, volume.coefficient_curve)) return;
      if (by_curve && volume.curve == none) return;
      add_volume(b, row, std::move(volume));
    });
  }
}

void read_adiabatic(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const Row row = cursor.read(volume_card), gas = cursor.read(adiabatic_card);
    ControlVolume volume = read_volume(block, row, heading);
    volume.gas = ControlVolume::Gas::adiabatic;
    volume.beta = gas.real("psf");
    volume.gamma = gas.real("gamma");
    volume.ambient = gas.real("pe");
    volume.absolute = gas.real("p0") + volume.ambient;
    volume.density = gas.real("ro");
    if (!(volume.absolute > 0.0))
      refuse(builder, gas, "p0", "the absolute pressure P0 + PE is not above 0",
             "give P0 above the ambient pressure PE");
    if (volume.gamma <= 1.0)
      refuse(builder, gas, "gamma", "a ratio of heat capacities is above 1", "write 1.4 for air");
    builder.defer(Phase::conditions, [row, gas, volume](Builder& b) mutable {
      volume.preload_curve = b.curve(gas, "lcid");
      add_volume(b, row, std::move(volume));
    });
  }
}

/// The heat capacities, and with them what is known of the gas at the start.
FlowingGas read_heat(Builder& b, const Row& heat, const Row& outflow, double ambient) {
  FlowingGas gas;
  gas.density = heat.real("ro");
  if (heat.real("cv") > 0.0) {
    gas.heat = heat.real("cp");
    gas.constant = gas.heat - heat.real("cv");
    if (gas.constant <= 0.0)
      refuse(b, heat, "cp", "the heat capacity at constant pressure is not above CV", "CP is 1.4 times CV for air");
    for (const std::string_view field : {"text", "a", "b", "mw", "gasc"})
      if (outflow.real(field) != 0.0)
        outflow.report(b.findings, Severity::warning, field, "not obeyed: it is for CV 0, and CV is given");
  } else if (const double mole = outflow.real("mw"); mole > 0.0 && outflow.real("gasc") > 0.0) {
    gas.heat = outflow.real("a") / mole;
    gas.heat_slope = outflow.real("b") / mole;
    gas.constant = outflow.real("gasc") / mole;
    if (gas.heat <= gas.constant || gas.heat_slope < 0.0)
      refuse(b, outflow, gas.heat_slope < 0.0 ? "b" : "a",
             "the heat capacity at constant volume, A + B T - GASC, is not above 0 at all temperatures",
             "A is 29.1 J/K and B 0 for a mole of air");
    if (heat.real("cp") > 0.0)
      heat.report(b.findings, Severity::warning, "cp", "not obeyed: with CV 0 it comes from A, B and MW");
    gas.temperature = outflow.real("text");
    if (gas.temperature > 0.0) gas.density = ambient / (gas.constant * gas.temperature);
    if (heat.real("ro") > 0.0 && std::abs(gas.density / heat.real("ro") - 1.0) > 0.01)
      heat.report(b.findings, Severity::warning, "ro",
                  fmt::format("not obeyed: PE, TEXT, MW and GASC give {:.4g}", gas.density));
  } else {
    refuse(b, heat, "cv", "without CV the gas needs MW and GASC", "give CV and CP, or A, B, MW, GASC and TEXT");
  }
  if (gas.temperature == 0.0 && gas.density > 0.0 && gas.constant > 0.0)
    gas.temperature = ambient / (gas.density * gas.constant);
  if (gas.density == 0.0 && ambient > 0.0)
    refuse(b, heat, "ro", "there is no mass at the start, at a pressure of PE", "give the density of the ambient gas");
  if (gas.density > 0.0 && ambient == 0.0)
    refuse(b, heat, "pe", "the gas at the start has mass, but no pressure", "give the ambient pressure, or RO 0");
  return gas;
}

/// Flows are one way each.
void expect_no_backflow(Builder& b, const Row& row, std::string_view field, Index curve) {
  if (curve == none) return;
  const Curve& c = b.model.curves[static_cast<std::size_t>(curve)];
  if (std::any_of(c.y.begin(), c.y.end(), [](double y) { return y < 0.0; }))
    refuse(b, row, field, "this curve has values below 0",
           "use LCID for what flows in and the vent or LOU for what flows out");
}

void read_simple_airbag(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const Row row = cursor.read(volume_card), heat = cursor.read(heat_card), outflow = cursor.read(outflow_card);
    ControlVolume volume = read_volume(block, row, heading);
    volume.gas = ControlVolume::Gas::flowing;
    volume.ambient = heat.real("pe");
    FlowingGas& gas = volume.flowing;
    gas = read_heat(builder, heat, outflow, volume.ambient);
    gas.inflow_temperature = heat.real("t");
    gas.shape = std::max(0.0, heat.real("mu"));
    gas.area = std::max(0.0, heat.real("area"));
    const int shape = curve_below_zero(heat, "mu"), area = curve_below_zero(heat, "area");
    if (heat.integer("lcid") != 0 && gas.inflow_temperature == 0.0)
      refuse(builder, heat, "t", "the gas that flows in has no temperature", "give its absolute temperature");
    if (heat.real("area") != 0.0 && heat.real("mu") == 0.0)
      heat.report(builder.findings, Severity::warning, "mu", "the vent is closed: its shape factor is 0",
                  "give MU, e.g. 0.7 for a sharp edge, or AREA 0");
    if (outflow.integer("lou") != 0 && heat.real("area") != 0.0 && heat.real("mu") != 0.0)
      refuse(builder, outflow, "lou", "the outflow is given twice, by this curve and by MU and AREA",
             "set MU and AREA, or LOU, to 0");
    builder.defer(Phase::conditions, [row, heat, outflow, volume, shape, area](Builder& b) mutable {
      FlowingGas& flowing = volume.flowing;
      flowing.inflow_curve = b.curve(heat, "lcid");
      flowing.outflow_curve = b.curve(outflow, "lou");
      if (!find_curve(b, heat, "mu", shape, flowing.shape_curve)) return;
      if (!find_curve(b, heat, "area", area, flowing.area_curve)) return;
      expect_no_backflow(b, heat, "lcid", flowing.inflow_curve);
      expect_no_backflow(b, heat, "mu", flowing.shape_curve);
      expect_no_backflow(b, heat, "area", flowing.area_curve);
      expect_no_backflow(b, outflow, "lou", flowing.outflow_curve);
      b.findings.note(volume.place, row.keyword(),
                      fmt::format("the gas at the start has a temperature of {:.4g} and a density of {:.4g}; its gas "
                                  "constant is {:.4g}",
                                  flowing.temperature, flowing.density, flowing.constant));
      add_volume(b, row, std::move(volume));
    });
  }
}

Keyword volume_keyword(std::string_view name, std::initializer_list<const Card*> cards,
                       void (*read)(Builder&, const Block&, const Options&)) {
  Keyword keyword{name, {}, {"ID"}, KeywordStatus::used, {}, {{"with _ID", &heading_card}, {{}, &volume_card}}, read};
  for (const Card* card : cards) keyword.layout.push_back({{}, card});
  return keyword;
}

}  // namespace

std::vector<Keyword> airbag_keywords() {
  return {volume_keyword("AIRBAG_SIMPLE_PRESSURE_VOLUME", {&coefficient_card}, read_pressure_volume),
          volume_keyword("AIRBAG_SIMPLE_AIRBAG_MODEL", {&heat_card, &outflow_card}, read_simple_airbag),
          volume_keyword("AIRBAG_ADIABATIC_GAS_MODEL", {&adiabatic_card}, read_adiabatic)};
}

}  // namespace nugget::reading
