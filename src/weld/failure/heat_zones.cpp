// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/heat_zones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

using Zone = model::HeatZone;

/// Where a weld touches a sheet.
struct Spot {
  Vec3d x;
  double diameter = 0.0;  ///< 0: of a rigid weld
};
/// A piece of a seam, or its one node twice.
struct Piece {
  Vec3d a, b;
};
/// All that heats one part.
struct Heat {
  std::array<std::vector<Spot>, 3> spots;  ///< by Zone::Weld
  std::vector<Piece> seam;
};

double distance(const Piece& piece, const Vec3d& x) {
  const Vec3d along = piece.b - piece.a;
  const double length2 = dot(along, along);
  const double share = length2 > 0.0 ? std::clamp(dot(x - piece.a, along) / length2, 0.0, 1.0) : 0.0;
  return norm(x - piece.a - share * along);
}

std::size_t kind_of(const Weld& weld) {
  return weld.kind == Weld::Kind::rigid ? Zone::constrained : weld.of_bricks() ? Zone::bricks : Zone::beams;
}

bool in(const std::vector<Index>& parts, Index part) {
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

Heat heat_of(const model::Model& model, const Ties& ties, Index part) {
  Heat heat;
  std::vector<char> of_part(model.nodes.size(), 0);
  for (std::size_t e = 0; e < model.shells.size(); ++e)
    if (model.shells.part[e] == part)
      for (const Index n : model.shells.node[e]) of_part[n] = 1;
  for (const Weld& weld : ties.welds) {
    if (weld.deleted || weld.kind == Weld::Kind::connector) continue;
    std::vector<Spot>& spots = heat.spots[kind_of(weld)];
    // A rigid weld may go through more than two sheets.
    if (weld.kind == Weld::Kind::rigid)
      for (const Projection& p : weld.ends)
        if (of_part[p.node]) spots.push_back({ties.x[p.node], 0.0});
    for (int end = 0; end < 2; ++end)
      if (weld.kind != Weld::Kind::rigid && weld.sheets[end] == part)
        spots.push_back({face_centre(weld, end, ties.x), weld.diameter});
  }
  for (const model::WeldSeam& seam : model.weld_seams) {
    if (!seam.parts.empty() && !in(seam.parts, part)) continue;
    for (std::size_t i = 0; i < seam.nodes.size(); ++i)
      heat.seam.push_back({ties.x[seam.nodes[i]], ties.x[seam.nodes[std::min(i + 1, seam.nodes.size() - 1)]]});
  }
  return heat;
}

double factor(const Zone::Factor& of, double distance, double diameter) {
  if (of.curve.empty() || !std::isfinite(distance) || (of.by_diameter && !(diameter > 0.0))) return 1.0;
  return of.curve.clamped(of.by_diameter ? distance / diameter : distance);
}

double rounded(double value) {
  return std::round(256.0 * value) / 256.0;
}

Softening softening_at(const Zone& zone, const Heat& heat, const Vec3d& x) {
  Softening s{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const auto take = [&](int kind, double distance, double diameter) {
    if (!std::isfinite(distance)) return;
    if (!zone.yield[kind].curve.empty()) s.yield = std::min(s.yield, factor(zone.yield[kind], distance, diameter));
    if (!zone.strain[kind].curve.empty()) s.strain = std::min(s.strain, factor(zone.strain[kind], distance, diameter));
  };
  for (int kind = 0; kind < 3; ++kind) {
    double closest = std::numeric_limits<double>::infinity(), diameter = 0.0;
    for (const Spot& spot : heat.spots[kind])
      if (const double d = norm(x - spot.x); d < closest) {
        closest = d;
        diameter = spot.diameter;
      }
    take(kind, closest, diameter);
  }
  double closest = std::numeric_limits<double>::infinity();
  for (const Piece& piece : heat.seam) closest = std::min(closest, distance(piece, x));
  take(Zone::seam, closest, 0.0);
  return {std::isfinite(s.yield) ? rounded(s.yield) : 1.0, std::isfinite(s.strain) ? rounded(s.strain) : 1.0};
}

Vec3d centre(const model::Shells& shells, std::size_t e, const std::vector<Vec3d>& x) {
  Vec3d sum;
  const int corners = shells.triangle(e) ? 3 : 4;
  for (int i = 0; i < corners; ++i) sum += x[shells.node[e][i]];
  return (1.0 / corners) * sum;
}

void soften(const model::Model& model, const Ties& ties, const Zone& zone, Index part, std::vector<Softening>& all) {
  const Heat heat = heat_of(model, ties, part);
  parallel_for(model.shells.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      if (model.shells.part[e] == part) all[e] = softening_at(zone, heat, centre(model.shells, e, ties.x));
  });
}

}  // namespace

std::vector<Softening> softening(const model::Model& model, const Ties& ties) {
  std::vector<Softening> all;
  if (model.heat_zones.empty()) return all;
  all.resize(model.shells.size());
  for (const Zone& zone : model.heat_zones)
    for (const Index part : zone.parts) soften(model, ties, zone, part, all);
  return all;
}

model::Law softened(const model::Law& law, const Softening& by) {
  model::Law soft = law;
  if (auto* bilinear = std::get_if<kernel::PlasticKinematic>(&soft)) {
    const double e = bilinear->E, h = by.yield * e * bilinear->tangent_modulus / (e - bilinear->tangent_modulus);
    bilinear->yield *= by.yield;
    bilinear->tangent_modulus = e * h / (e + h);
    bilinear->failure_strain *= by.strain;
  } else if (auto* curves = std::get_if<kernel::PiecewiseLinear>(&soft)) {
    for (Curve& curve : curves->yield)
      for (double& y : curve.y) y *= by.yield;
    curves->rate_yield *= by.yield;
    curves->failure_strain *= by.strain;
  }
  return soft;
}

/// Discrete beams between sheets have no heat of their own: what LS-DYNA takes them for in a zone is not documented,
/// and self-piercing rivets are cold.
static void report_connectors_in(const Ties& ties, const Zone& zone, Findings& findings) {
  int count = 0;
  const Weld* first = nullptr;
  for (const Weld& weld : ties.welds) {
    const auto on_zone = [&](Index sheet) { return sheet != none && in(zone.parts, sheet); };
    if (weld.deleted || !weld.interpolated || weld.self_piercing) continue;
    if (!on_zone(weld.sheets[0]) && !on_zone(weld.sheets[1])) continue;
    if (count++ == 0) first = &weld;
  }
  if (count > 0)
    findings.warning(
        zone.place, "*DEFINE_HAZ_PROPERTIES",
        fmt::format("zone {} is not softened around {} interpolation spot weld{}, first {}: it has curves "
                    "for beams, bricks, rigid welds and seams alone",
                    zone.id, count, count == 1 ? "" : "s", first->id),
        "write them as beams or bricks of *MAT_SPOTWELD, or name the softened shells as parts of their own");
}

void note_heat_zones(const model::Model& model, const Ties& ties, Findings& findings) {
  const std::vector<Softening> all = softening(model, ties);
  std::map<Index, const Zone*> zone_of;
  for (const Zone& zone : model.heat_zones) {
    for (const Index part : zone.parts)
      if (const auto [before, is_new] = zone_of.try_emplace(part, &zone); !is_new)
        findings.warning(zone.place, "*DEFINE_HAZ_PROPERTIES",
                         fmt::format("part {} is of zone {} already: this one holds for it", model.parts[part].id,
                                     std::exchange(before->second, &zone)->id),
                         "name each part in one zone");
    report_connectors_in(ties, zone, findings);
    int count = 0;
    Softening least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (std::size_t e = 0; e < model.shells.size(); ++e) {
      if (!in(zone.parts, model.shells.part[e]) || all[e] == Softening{}) continue;
      ++count;
      least = {std::min(least.yield, all[e].yield), std::min(least.strain, all[e].strain)};
    }
    if (count == 0)
      findings.warning(
          zone.place, "*DEFINE_HAZ_PROPERTIES",
          fmt::format("zone {} changes no shell: none of its parts carries a weld that it has a curve for", zone.id),
          "see whether its parts and curves are meant");
    else
      findings.note(zone.place, "*DEFINE_HAZ_PROPERTIES",
                    fmt::format("zone {} changes {} shells; least factor {:.3g} on the yield stress, {:.3g} on the "
                                "strain at failure",
                                zone.id, count, least.yield, least.strain));
  }
}

}  // namespace nugget::weld
