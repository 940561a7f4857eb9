// SPDX-License-Identifier: Apache-2.0
#include "weld/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "weld/inspection.hpp"
#include "weld/tally.hpp"
#include "weld/welds.hpp"

namespace nugget::weld {
namespace {

std::string part_name(const Inspection& in, Index part) {
  return fmt::format("part {}", in.model().parts[part].id);
}

/// The usual nugget is 5 sqrt(t) of the thinner sheet, in millimetres.
std::string look_at_diameter(const Inspection& in, const Weld& weld) {
  constexpr double least = 0.8, most = 1.5;
  if (!in.millimetres() || weld.diameter == 0.0) return {};
  const auto t1 = in.sheet_thickness(weld, 0), t2 = in.sheet_thickness(weld, 1);
  if (!t1 || !t2) return {};
  const double usual = 5.0 * std::sqrt(std::min(*t1, *t2));
  const double ratio = weld.diameter / usual;
  if (ratio >= least && ratio <= most) return {};
  return fmt::format("diameter {:.3g}, usual for sheets of {:.3g} and {:.3g} is {:.3g}", weld.diameter, *t1, *t2,
                     usual);
}

std::string look_for_two_sheets(const Inspection& in, const Weld& weld) {
  const auto [first, second] = weld.sheets;
  if (first == none && second == none) return {};  // told as an untied weld
  if (first == second) return fmt::format("both ends on {}", part_name(in, first));
  if (first == none || second == none)
    return fmt::format("on one sheet only, {}", part_name(in, first == none ? second : first));
  return {};
}

std::string look_for_twins(const Inspection& in, const Weld& weld) {
  constexpr double share = 0.1;
  const Weld* twin = in.twin(weld, share * weld.diameter);
  return twin ? fmt::format("at the same place as {}", name_weld(*twin)) : std::string{};
}

std::string look_at_element_size(const Inspection& in, const Weld& weld) {
  constexpr double most = 2.0;
  if (weld.diameter == 0.0) return {};
  for (int end = 0; end < 2; ++end)
    if (const auto size = in.element_size(weld, end); size && *size > most * weld.diameter)
      return fmt::format("tied to an element of size {:.3g}, {:.2g} times its diameter", *size, *size / weld.diameter);
  return {};
}

std::string look_at_length(const Inspection&, const Weld& weld) {
  constexpr double share = 1e-6;
  if (weld.kind == Weld::Kind::rigid || weld.length > share * weld.diameter) return {};
  return fmt::format("length {:.3g} after projection", weld.length);
}

std::string look_at_angle(const Inspection& in, const Weld& weld) {
  constexpr double most = 10.0;
  for (int end = 0; end < 2; ++end)
    if (const auto angle = in.angle_to_normal(weld, end); angle && *angle > most)
      return fmt::format("its axis is {:.1f} degrees off the normal of {}", *angle,
                         end == 0 ? "its first sheet" : "its second sheet");
  return {};
}

std::string look_at_border(const Inspection& in, const Weld& weld) {
  if (weld.diameter == 0.0) return {};
  for (int end = 0; end < 2; ++end)
    if (const auto distance = in.distance_to_border(weld, end, weld.diameter); distance && *distance < weld.diameter)
      return fmt::format("{:.3g} from the free edge of {}, less than its diameter {:.3g}", *distance,
                         part_name(in, weld.sheets[end]), weld.diameter);
  return {};
}

constexpr std::array<Check, 7> all_checks{{
    {"sheets", "the two ends are on two different sheets", "see why the other end is not tied", look_for_two_sheets},
    {"length", "a weld has a length", "check the sheets' distance, or give the weld nodes apart from each other",
     look_at_length},
    {"twin", "there is one weld at a place", "delete one of the two", look_for_twins},
    {"diameter", "the diameter is 0.8 to 1.5 times 5 sqrt(t) of the thinner sheet [mm]",
     "check TS1 and TS2 of the section, and the sheets' thicknesses", look_at_diameter},
    {"angle", "the axis is within 10 degrees of the sheets' normals", "put the two weld nodes above each other",
     look_at_angle},
    {"edge", "a weld is at least its diameter away from the free edge of its sheets", "check the place of the weld",
     look_at_border},
    {"mesh", "elements at a weld are no larger than twice its diameter",
     "refine to the diameter, or move the weld close to a node of the sheet", look_at_element_size},
}};

/// Time step and mass of a weld as the deck gives it.
struct Inertia {
  double time_step = std::numeric_limits<double>::infinity();
  double mass = 0.0;
};

Inertia beam_inertia(const model::Model& model, const Weld& weld, const model::Material& material,
                     const kernel::Spotweld& law) {
  const model::SectionBeam& section = model.beam_sections[model.parts[weld.part].section];
  double area = 0.0;
  for (int end = 0; end < 2; ++end)
    area +=
        0.125 * std::numbers::pi * (section.outer[end] * section.outer[end] - section.inner[end] * section.inner[end]);
  return {weld.length / std::sqrt(law.E / material.density),
          (material.density * area + section.extra_mass) * weld.length};
}

Inertia brick_inertia(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld,
                      const model::Material& material, const kernel::Spotweld& law) {
  const double volume = 0.25 * std::numbers::pi * weld.diameter * weld.diameter * weld.length;
  double largest = 0.0;
  for (const auto& pair : opposite_faces(model.solids.node[weld.element]))
    for (const auto& face : pair)
      largest = std::max(largest, 0.5 * norm(cross(x[face[2]] - x[face[0]], x[face[3]] - x[face[1]])));
  const double E = std::abs(law.E), nu = law.nu;
  const double speed = std::sqrt(E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu) * material.density));
  return {largest > 0.0 ? volume / largest / speed : 0.0, material.density * volume};
}

Inertia inertia(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld) {
  if (weld.kind == Weld::Kind::rigid) return {};
  const model::Material& material = model.materials[model.parts[weld.part].material];
  const auto& law = std::get<kernel::Spotweld>(material.law);
  return weld.kind == Weld::Kind::beam ? beam_inertia(model, weld, material, law)
                                       : brick_inertia(model, x, weld, material, law);
}

/// Mass times the factor that lifts a time step to `wanted`, less the mass; step goes with sqrt(density).
double mass_to_reach(double wanted, double step, double mass) {
  return step > 0.0 && step < wanted ? mass * ((wanted / step) * (wanted / step) - 1.0) : 0.0;
}

void price(const model::Model& model, const std::vector<Vec3d>& x, const Weld& weld, Report& report) {
  const Inertia own = inertia(model, x, weld);
  report.time_step = own.time_step;
  report.mass = own.mass;
  if (weld.kind == Weld::Kind::rigid) return;
  const double dt = std::get<kernel::Spotweld>(model.materials[model.parts[weld.part].material].law).mass_step;
  report.mass_by_dt = mass_to_reach(dt, own.time_step, own.mass);
  const double target = std::abs(model.control.mass_step * model.control.step_scale);
  report.mass_by_dt2ms = mass_to_reach(target, std::max(own.time_step, dt), own.mass + report.mass_by_dt);
}

}  // namespace

std::span<const Check> checks() {
  return all_checks;
}

std::vector<Report> audit(const model::Model& model, const Ties& ties, Findings& findings) {
  const Inspection inspection(model, ties);
  std::vector<Report> reports(ties.welds.size());
  Tally tally(findings);
  for (std::size_t w = 0; w < ties.welds.size(); ++w) {
    const Weld& weld = ties.welds[w];
    if (weld.deleted) continue;
    price(model, ties.x, weld, reports[w]);
    for (const Check& check : all_checks) {
      std::string text = check.look(inspection, weld);
      if (text.empty()) continue;
      const std::string rule = fmt::format("{} (expected: {})", text, check.rule);
      tally.warning(fmt::format("welds with a remark on '{}'", check.name), weld.place, keyword_of(weld),
                    name_weld(weld) + ": " + rule, std::string(check.remedy));
      reports[w].remarks.push_back({check.name, std::move(text)});
    }
  }
  tally.close();
  return reports;
}

}  // namespace nugget::weld
