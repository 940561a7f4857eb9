// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// An opening of a surface: its border, each edge in the direction in which the face behind it runs.
struct Opening {
  std::vector<std::array<Index, 2>> edges;
  std::vector<Index> nodes;  ///< of the border, ascending
};

/// A hole through which gas leaves: its area times the share of it that the jet fills.
struct Vent {
  double shape = 0.0, area = 0.0;               ///< [1], [length^2]
  Index shape_curve = none, area_curve = none;  ///< in the place of these, over the absolute pressure
  Index shape_over_time = none;                 ///< in the place of the shape
  std::vector<Segment> faces;                   ///< of the parts whose area is that of the vent, as it is now
};

/// Faces of fabric of one material through which gas leaks (FVOPT of *MAT_FABRIC). The share of their area that is open
/// is FLC FAC; or, with X0, their open area is A0 (X0 + X1 s + X2 q + X3 s q), A0 the area at the start, s that of now
/// over A0, q the ambient pressure over that of the gas (Anagonye and Wang).
struct PorousFabric {
  enum class Flow {
    orifice,   ///< FVOPT 1, 2: as through a vent
    pressure,  ///< FVOPT 3, 4: with the velocity sqrt(2 (p - pe) / density) (Graefe, Krummheuer and Siejak)
    velocity   ///< FVOPT 7, 8: FAC is the velocity of the gas
  };
  Flow flow = Flow::orifice;
  bool covered_by_contact = false;  ///< FVOPT 2, 4, 8: where a contact presses, the share ELA of it leaks
  double leakage = 0.0, share = 0.0, covered = 0.0;  ///< FLC, FAC, ELA
  Index leakage_curve = none, covered_curve = none;  ///< in the place of FLC and ELA, over time
  Index share_curve = none;                          ///< in the place of FAC, over the absolute pressure
  std::optional<std::array<double, 4>> by_stretch;   ///< X0, X1, X2, X3
  std::vector<Segment> faces;
};

/// An ideal gas that flows in and out (*AIRBAG_SIMPLE_AIRBAG_MODEL, _WANG_NEFSKE). Its heat capacity at constant
/// pressure is cp = heat + heat_slope T, that at constant volume cp - constant, all per mass.
struct FlowingGas {
  double constant = 0.0;                    ///< R, pressure / (density temperature)
  double heat = 0.0, heat_slope = 0.0;      ///< CP and 0, or A / MW and B / MW
  double temperature = 0.0, density = 0.0;  ///< at the start, at the ambient pressure; 0: vacuum
  double overpressure = 0.0;                ///< POVER: of the gas at the start, at this temperature [stress]
  double inflow_temperature = 0.0;          ///< T
  Index inflow_temperature_curve = none;    ///< LCT: in the place of it, over time
  Index inflow_curve = none;                ///< LCID, LCMT: mass flow over time
  Vent vent, leak;                          ///< MU, AREA; C23, A23 and CP23, AP23
  std::vector<PorousFabric> fabric;         ///< leaks as well
  double pop_pressure = 0.0;                ///< PPOP: gauge pressure that opens the vent for good [stress]
  Index outflow_curve = none;               ///< LOU, LCEFR: mass flow over the gauge pressure; in the place of the vent
};

/// Gas behind faces (*AIRBAG_...): its pressure follows from the volume that they enclose.
struct ControlVolume {
  int id = 0;
  std::string keyword, title;
  std::vector<Segment> segments;    ///< normals outwards
  std::vector<CornerShares> share;  ///< as of PressureLoad
  std::vector<Opening> openings;
  double volume_scale = 1.0, pressure_scale = 1.0;  ///< VSCA, PSCA

  enum class Gas {
    coefficient,  ///< SIMPLE_PRESSURE_VOLUME: p = beta CN / (V/V0)
    curve,        ///< the same with LCID: p(V/V0)
    adiabatic,    ///< ADIABATIC_GAS_MODEL: p = PSF ((P0 + PE) (V/V0)^-gamma - PE)
    flowing       ///< SIMPLE_AIRBAG_MODEL, WANG_NEFSKE: an ideal gas with inflow and outflow, p - PE
  };
  Gas gas = Gas::coefficient;
  Index curve = none;              ///< of `curve`
  Index coefficient_curve = none;  ///< CN over time, times beta; none: `coefficient`
  Index relaxation_curve = none;   ///< CN over time in dynamic relaxation; none: as in the run
  double coefficient = 0.0;        ///< beta CN; with `coefficient_curve` or `relaxation_curve`: see `beta`
  double beta = 1.0;
  double gamma = 0.0, absolute = 0.0, ambient = 0.0;  ///< GAMMA, P0 + PE, PE
  double density = 0.0;                               ///< RO, at the start; 0: not known
  Index preload_curve = none;  ///< adiabatic: until its first value above 0 the pressure is PSF P0
  FlowingGas flowing;          ///< of `flowing`
  Place place;
};

/// What a closed surface of these faces lacks. `twisted`: two faces that run along a common edge in the same direction,
/// so that their normals disagree; empty where there is none.
struct SurfaceBorder {
  std::vector<Opening> openings;
  std::vector<std::array<Index, 2>> twisted;
};
SurfaceBorder surface_border(const std::vector<Segment>& segments);

/// Turns faces until neighbours agree: of each surface that hangs together by its edges the fewer ones. Returns which,
/// rising. Edges at which more than two faces meet join nothing. Where no such turn exists, as on a Moebius strip,
/// `twisted` edges are left.
std::vector<std::size_t> turn_faces_to_agree(std::vector<Segment>& segments);

/// The volume within faces whose normals point outwards. Faces are bilinear; an opening is covered by triangles from
/// its border to the mean of its nodes, which is a plane where the border is plane. `x(node)` gives places.
template <class Places>
double enclosed_volume(const std::vector<Segment>& segments, const std::vector<Opening>& openings, const Places& x) {
  if (segments.empty()) return 0.0;
  const Vec3d origin = x(segments.front()[0]);
  double sum = 0.0;  // of six times the volumes of tetrahedra from the origin
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c, double weight) {
    sum += weight * dot(a - origin, cross(b - origin, c - origin));
  };
  for (const Segment& s : segments) {
    const Vec3d a = x(s[0]), b = x(s[1]), c = x(s[2]), d = x(s[3]);
    if (s[3] == s[2]) {
      add(a, b, c, 1.0);
      continue;
    }
    // Cut along either diagonal; their mean is that of the bilinear face.
    add(a, b, c, 0.5), add(a, c, d, 0.5), add(a, b, d, 0.5), add(b, c, d, 0.5);
  }
  for (const Opening& opening : openings) {
    Vec3d middle;
    for (const Index n : opening.nodes) middle += x(n) - origin;
    middle = origin + (1.0 / static_cast<double>(opening.nodes.size())) * middle;
    for (const auto& [from, to] : opening.edges) add(middle, x(to), x(from), 1.0);
  }
  return sum / 6.0;
}

/// Half the cross product of a face's diagonals.
template <class Places>
double face_area(const Segment& s, const Places& x) {
  return 0.5 * (s[3] == s[2] ? norm(cross(x(s[1]) - x(s[0]), x(s[2]) - x(s[0])))
                             : norm(cross(x(s[2]) - x(s[0]), x(s[3]) - x(s[1]))));
}

/// Area of the faces, openings left out.
template <class Places>
double surface_area(const std::vector<Segment>& segments, const Places& x) {
  double sum = 0.0;
  for (const Segment& s : segments) sum += face_area(s, x);
  return sum;
}

}  // namespace nugget::model
