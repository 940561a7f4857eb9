// SPDX-License-Identifier: Apache-2.0
// *AIRBAG_...: gas in a volume, the air of tyres above all.
#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"
#include "model/cards/families.hpp"
#include "model/cards/reading.hpp"
#include "model/segments.hpp"

namespace nugget::model {
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
    real("p0", dimension::stress, required, above_zero(), "pressure at the start, absolute"),
    real("pe", dimension::stress, 0, at_least(0), "ambient pressure"),
    real("ro", dimension::density, 0, at_least(0), "density at the start, for abstat; has no effect on the pressure"),
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
    row.complain(b.findings, Severity::warning, "mwd", "not obeyed: the surface is not damped",
                 "use *DAMPING_PART_MASS");
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

void read_pressure_volume(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const Heading heading = read_heading(cursor, options.contains("ID"));
    const Row row = cursor.read(volume_card), gas = cursor.read(coefficient_card);
    ControlVolume volume = read_volume(block, row, heading);
    const double cn = gas.real("cn");
    volume.beta = gas.real("beta");
    volume.coefficient = volume.beta * cn;
    const int cn_curve = cn < 0.0 ? static_cast<int>(-cn) : 0;
    const bool by_curve = gas.integer("lcid") != 0;
    if (by_curve)
      volume.gas = ControlVolume::Gas::curve;
    else if (volume.coefficient == 0.0)
      refuse(builder, gas, cn == 0.0 ? "cn" : "beta", "there is no pressure: neither LCID nor CN times BETA is given",
             "give CN, the pressure at the start, and BETA 1");
    builder.later(Phase::conditions, [row, gas, volume, by_curve, cn_curve](Builder& b) mutable {
      volume.curve = b.curve(gas, "lcid");
      volume.relaxation_curve = b.curve(gas, "lciddr");
      if (!by_curve && cn_curve > 0) {
        volume.coefficient_curve = b.curves.find(cn_curve);
        if (volume.coefficient_curve == none)
          return refuse(b, gas, "cn", fmt::format("curve {} is not defined", cn_curve));
      }
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
    volume.absolute = gas.real("p0");
    volume.ambient = gas.real("pe");
    volume.density = gas.real("ro");
    if (volume.gamma <= 1.0)
      refuse(builder, gas, "gamma", "a ratio of heat capacities is above 1", "write 1.4 for air");
    builder.later(Phase::conditions, [row, gas, volume](Builder& b) mutable {
      volume.preload_curve = b.curve(gas, "lcid");
      add_volume(b, row, std::move(volume));
    });
  }
}

Keyword volume_keyword(std::string_view name, const Card& gas, void (*read)(Builder&, const Block&, const Options&)) {
  return {name, {}, {"ID"}, Verdict::used, {}, {{"with _ID", &heading_card}, {{}, &volume_card}, {{}, &gas}}, read};
}

}  // namespace

std::vector<Keyword> airbag_keywords() {
  return {volume_keyword("AIRBAG_SIMPLE_PRESSURE_VOLUME", coefficient_card, read_pressure_volume),
          volume_keyword("AIRBAG_ADIABATIC_GAS_MODEL", adiabatic_card, read_adiabatic)};
}

}  // namespace nugget::model
