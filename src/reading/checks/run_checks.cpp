// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/law_components.hpp"
#include "model/units.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

/// Do modulus and density look like a structural material in these units? Speed of sound in a bar 300 to 12000 m/s
/// (plastics to ceramics); density from 500 kg/m3 to ten times that of tungsten, since decks carry missing mass there.
bool fits(const Material& m, const Units& u) {
  const double speed = std::sqrt(m.young() / m.density) / u.metre_per_second,
               density = m.density / u.kilogram_per_cubic_metre;
  return speed >= 300.0 && speed <= 12000.0 && density >= 500.0 && density <= 200000.0;
}

/// Whether its modulus and density show the units: those of rubber, foam and the like reach over decades.
bool is_elastic_plastic(const Material& m) {
  const bool is_fluid_or_moved = m.keyword == "MAT_NULL" || std::holds_alternative<kernel::Rigid>(m.law) ||
                                 std::holds_alternative<kernel::Laminate>(m.law);  // its layers' materials are judged
  const auto* law = std::get_if<kernel::ComposedLaw>(&m.law);
  const bool is_rubber = law != nullptr && kernel::LawKernel<kernel::ComposedLaw>(*law).layers_stiffen();
  const bool is_soft = law != nullptr && (is_rubber || !for_shells(*law->components));
  return !is_fluid_or_moved && !is_soft && m.density > 0.0 && m.young() > 0.0;
}

/// Warns of stresses of elements that have none, being rigid. `what`: one of them.
template <class Elements>
void report_rigid(Builder& b, const std::vector<InitialStress>& stresses, const Elements& elements, const char* keyword,
                  const char* what) {
  const auto rigid = [&](const InitialStress& s) {
    const Index part = elements.part[s.element];
    return part != none && b.model.parts[part].rigid_body != none;
  };
  const auto first = std::ranges::find_if(stresses, rigid);
  if (first == stresses.end()) return;
  const auto more = std::ranges::count_if(stresses, rigid) - 1;
  b.findings.warning(first->place, keyword,
                     fmt::format("{} {}{} belongs to a rigid part, and has no stress", what,
                                 elements.id[first->element], more == 0 ? "" : fmt::format(" (and {} more)", more)),
                     "take the stress out, or give the part a material that deforms");
}

}  // namespace

void check_initial_stresses(Builder& b) {
  const InitialState& given = b.model.initial_state;
  report_rigid(b, given.shells, b.model.shells, "*INITIAL_STRESS_SHELL", "shell");
  report_rigid(b, given.solids, b.model.solids, "*INITIAL_STRESS_SOLID", "solid");
}

void check_relaxation(Builder& b) {
  const Model& m = b.model;
  if (!m.control.relaxation.on()) return;
  for (const RigidWall& wall : m.walls)
    if (wall.motion_curve != none || wall.mass > 0.0)
      b.findings.error(wall.place, "*RIGIDWALL", "a wall that moves beside dynamic relaxation is not supported",
                       "hold the wall, or give it as a rigid part with *BOUNDARY_PRESCRIBED_MOTION_RIGID");
  for (const PrescribedMotion& motion : m.motions) {
    if (motion.curve == none || motion.quantity != PrescribedMotion::Quantity::displacement) continue;
    const Curve& curve = m.curves[motion.curve];
    if (curve.in_run && curve.in_relaxation)
      b.findings.error(
          motion.place, "*BOUNDARY_PRESCRIBED_MOTION",
          fmt::format("displacement by curve {} in dynamic relaxation and again in the run (SIDR = 2)", curve.id),
          "give two motions: one with a curve of SIDR 1 up to the end value, one of SIDR 0 that holds it");
  }
}

void check_units(Builder& b) {
  const auto& materials = b.model.materials;
  const auto fitting = [&](const Units& u) {
    return std::count_if(materials.begin(), materials.end(),
                         [&](const Material& m) { return is_elastic_plastic(m) && fits(m, u); });
  };
  const auto usual = unit_systems();
  const auto common = std::max_element(usual.begin(), usual.end(),
                                       [&](const auto& u, const auto& v) { return fitting(u) < fitting(v); });
  for (const Material& m : materials) {
    if (!is_elastic_plastic(m) || fits(m, *common)) continue;
    const double speed = std::sqrt(m.young() / m.density);
    const bool has_common = fitting(*common) > 0;
    b.findings.warning(
        m.place, '*' + m.keyword,
        fmt::format("material {}: sqrt(E/rho) = {:g} with density {:g} {}", m.id, speed, m.density,
                    has_common ? fmt::format("does not fit {}, the units of the other materials", common->description)
                               : "fits no usual system of units"),
        "see that E and density are in the units of the mesh, e.g. mm t s: 210000, 7.85e-9");
  }
}

}  // namespace nugget::reading
