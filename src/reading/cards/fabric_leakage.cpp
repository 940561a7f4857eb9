// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/fabric_leakage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "reading/builder/common_cards.hpp"

namespace nugget::reading {
namespace {

using Flow = PorousFabric::Flow;

constexpr double largest_option = 8.0;

/// Whether anything leaks: FLC FAC, or X0 and what stands beside it.
bool leaks(const LeakageFields& f) {
  return f.x0.value != 0.0 || (f.flc.value != 0.0 && f.fac.value != 0.0);
}

/// What FVOPT or OPT says that the card does not have, or nothing is built of: said at `field`.
bool obeys(Builder& b, const deck::Entry& field, const LeakageFields& f) {
  const double option = field.value;
  if (option < 0.0) {
    refuse(b, field, "leakage by the gaps between the threads (FVOPT below 0) is not built",
           "write 1 to 4 with FLC and FAC, or 7 or 8 with a curve of the velocity as FAC");
    return false;
  }
  if (option > largest_option || option != static_cast<int>(option)) {
    refuse(b, field, "there is no such formula of leakage", "write 1, 2, 3, 4, 7 or 8");
    return false;
  }
  if (option == 5.0 || option == 6.0) {
    refuse(b, field, "leakage as through a porous medium is not built: its formula is not public",
           "write 1 to 4 with FLC and FAC, or 7 or 8 with a curve of the velocity as FAC");
    return false;
  }
  if (f.x0.value < 0.0) {
    refuse(b, f.x0, "X0 below 0 is not built", "give X0 to X3 of the leaking area, or 0 with FLC and FAC");
    return false;
  }
  if (option < 7.0) return true;
  if (f.x0.value != 0.0) {
    refuse(b, f.x0, "the leaking area by X0 has no velocity of the gas, which FVOPT 7 and 8 take from FAC",
           "write FVOPT 1 to 4, or X0 0");
    return false;
  }
  if (f.fac.value > 0.0) {
    refuse(b, f.fac, "with FVOPT 7 and 8 the velocity of the gas is a curve over its absolute pressure",
           "write the number of that curve with a minus sign");
    return false;
  }
  return true;
}

bool find_curve_of(Builder& b, const deck::Entry& field, double& value, Index& curve) {
  value = std::max(0.0, field.value);
  const int id = curve_below_zero(field.value);
  if (id == 0) return true;
  curve = b.curves.find(id);
  if (curve == none) {
    refuse(b, field, fmt::format("curve {} is not defined", id));
    return false;
  }
  const Curve& c = b.model.curves[curve];
  if (std::ranges::none_of(c.y, [](double y) { return y < 0.0; })) return true;
  refuse(b, field, "this curve has values below 0", "gas leaks outwards only");
  return false;
}

/// All of it but faces and flow.
bool read_coefficients(Builder& b, const LeakageFields& f, PorousFabric& fabric) {
  bool whole = find_curve_of(b, f.ela, fabric.covered, fabric.covered_curve);
  if (f.x0.value == 0.0)
    return find_curve_of(b, f.flc, fabric.leakage, fabric.leakage_curve) &&
           find_curve_of(b, f.fac, fabric.share, fabric.share_curve) && whole;
  fabric.by_stretch = {f.x0.value, f.x1.value, f.flc.value, f.fac.value};
  if (f.a0ref.value != 0.0) {
    refuse(b, f.a0ref, "the area of a reference geometry is not built", "write 0: the area at the start counts");
    whole = false;
  }
  if (f.moves_curve_numbers && std::min(f.flc.value, f.fac.value) < 0.0) {
    refuse(b, f.flc.value < 0.0 ? f.flc : f.fac,
           "*INCLUDE_TRANSFORM moves numbers of curves in this file, and so what is below 0 here",
           "write this material into a file without IDFOFF");
    whole = false;
  }
  return whole;
}

using Corners = std::array<Index, 4>;
/// The nodes of a face or shell without those that it repeats.
Corners corners_of(Segment s) {
  std::sort(s.begin(), s.end());
  Corners corners;
  corners.fill(none);
  std::unique_copy(s.begin(), s.end(), corners.begin());
  return corners;
}

}  // namespace

void add_leakage(Builder& builder, const LeakageFields& fields, Index material, const deck::Entry& mid) {
  if (fields.fvopt.value < 0.0) {
    obeys(builder, fields.fvopt, fields);
    return;
  }
  if (!leaks(fields)) {
    if (fields.fvopt.value != 0.0)
      fields.fvopt.report(builder.findings, Severity::note, "nothing leaks through this fabric: FLC or FAC is 0");
    return;
  }
  if (fields.fvopt.value != 0.0 && !obeys(builder, fields.fvopt, fields)) return;
  builder.defer(Phase::parts, [fields, material, mid](Builder& b) {
    const Index of = material != none ? material : b.find(b.materials, "material", mid);
    if (of == none) return;
    PorousFabric fabric;
    if (!read_coefficients(b, fields, fabric)) return;
    // *MAT_ADD_AIRBAG_POROSITY_LEAKAGE counts before the fabric's own fields.
    if (material != none && b.leakage.contains(of)) return;
    b.leakage[of] = {std::move(fabric), std::make_shared<LeakageFields>(fields), false};
  });
}

std::vector<PorousFabric> leaking_faces(Builder& b, const std::vector<Segment>& faces, const deck::Entry& option) {
  std::vector<PorousFabric> fabrics;
  if (b.leakage.empty()) return fabrics;
  const Shells& shells = b.model.shells;
  std::map<Corners, Index> material_of;  // of faces that leak
  for (std::size_t e = 0; e < shells.size(); ++e) {
    const Index material = b.model.parts[shells.part[e]].material;
    if (b.leakage.contains(material)) material_of.try_emplace(corners_of(shells.node[e]), material);
  }
  std::map<Index, std::vector<Segment>> faces_of;
  for (const Segment& face : faces)
    if (const auto found = material_of.find(corners_of(face)); found != material_of.end())
      faces_of[found->second].push_back(face);
  for (auto& [material, some] : faces_of) {
    FabricLeakage& leakage = b.leakage.at(material);
    const deck::Entry& field = leakage.fields->fvopt.value != 0.0 ? leakage.fields->fvopt : option;
    const double formula = field.value;
    if (formula == 0.0) continue;
    leakage.used = true;
    if (!obeys(b, field, *leakage.fields)) continue;
    PorousFabric& fabric = fabrics.emplace_back(leakage.fabric);
    fabric.flow = formula <= 2.0 ? Flow::orifice : formula <= 4.0 ? Flow::pressure : Flow::velocity;
    fabric.covered_by_contact = static_cast<int>(formula) % 2 == 0;
    fabric.faces = std::move(some);
  }
  return fabrics;
}

void report_unused_leakage(Builder& b) {
  for (const auto& [material, leakage] : b.leakage)
    if (!leakage.used && leakage.fields->fvopt.value != 0.0)
      leakage.fields->fvopt.report(b.findings, Severity::warning,
                                   "nothing leaks: no *AIRBAG_WANG_NEFSKE has shells of this material among its faces, "
                                   "and of the gases that are "
                                   "built only that one leaks through fabric",
                                   "write *AIRBAG_WANG_NEFSKE, or let the gas out by a vent");
}

}  // namespace nugget::reading
