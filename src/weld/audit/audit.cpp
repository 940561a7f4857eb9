// SPDX-License-Identifier: Apache-2.0
#include "weld/audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "weld/audit/inspection.hpp"
#include "weld/failure/heat_zones.hpp"
#include "weld/tie/tie_findings.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::string part_name(const Inspection& in, Index part) {
  return fmt::format("part {}", in.model().parts[part].id);
}

/// A value that is to be at most (or at least) a limit. `text` says what is wrong; it is asked only then.
template <class Text>
CheckResult at_most(double value, double limit, Text text) {
  CheckResult evaluate{value, value / limit, {}};
  if (evaluate.excess > 1.0) evaluate.text = text();
  return evaluate;
}
template <class Text>
CheckResult at_least(double value, double limit, Text text) {
  CheckResult evaluate{value, value > 0.0 ? limit / value : std::numeric_limits<double>::infinity(), {}};
  if (evaluate.excess > 1.0) evaluate.text = text();
  return evaluate;
}
template <class Text>
CheckResult within(double value, double least, double most, Text text) {
  return value < least ? at_least(value, least, text) : at_most(value, most, text);
}

/// The worse of the two ends, as `measure(end)` gives it; nothing where it gives nothing at both.
template <class Measure>
CheckResult worse_end(Measure measure) {
  const CheckResult first = measure(0), second = measure(1);
  return std::isnan(first.value) || second.excess > first.excess ? second : first;
}

/// Of one part: a section that is closed by its own welds.
bool joins_two_layers(const Inspection& in, const Weld& weld) {
  constexpr double steepest = 30.0;  // degrees to the normal: a weld that lies along its sheet has 90
  const auto across = [&](int end) {
    const auto angle = in.angle_to_normal(weld, end);
    return angle && *angle <= steepest;
  };
  return weld.tied && across(0) && across(1);
}

CheckResult check_two_sheets(const Inspection& in, const Weld& weld) {
  const auto [first, second] = weld.sheets;
  const auto wrong = [](std::string text) { return CheckResult{nothing, 2.0, std::move(text)}; };
  if (first == none && second == none) return {};   // reported as an untied weld
  if (weld.tied && weld.held_by_bricks) return {};  // the bricks between it and the other sheet hold it
  if (first == second && !joins_two_layers(in, weld))
    return wrong(fmt::format("both ends on {}", part_name(in, first)));
  if (first == none || second == none)
    return wrong(fmt::format("on one sheet only, {}", part_name(in, first == none ? second : first)));
  return {};
}

CheckResult check_stack(const Inspection& in, const Weld& weld) {
  constexpr double most = 4.0;
  const auto sheets = static_cast<double>(in.stack(weld).size());
  if (sheets == 0.0) return {};
  return at_most(sheets, most, [&] { return fmt::format("one of a stack of {} sheets", sheets); });
}

CheckResult check_length(const Inspection& in, const Weld& weld) {
  constexpr double shortest = 1e-6, least = 0.3, most = 3.0;
  if (weld.kind == Weld::Kind::rigid || weld.kind == Weld::Kind::connector) return {};
  const auto t = in.thicknesses(weld);
  const double usual = t ? 0.5 * ((*t)[0] + (*t)[1]) : 0.0;
  if (weld.length <= shortest * weld.diameter || usual <= 0.0)
    return at_least(weld.length, shortest * weld.diameter,
                    [&] { return fmt::format("length {:.3g} after projection", weld.length); });
  CheckResult evaluate = within(weld.length / usual, least, most, [&] {
    return fmt::format("length {:.3g} after projection (before: {:.3g}), {:.2g} times (t1 + t2)/2 = {:.3g}",
                       weld.length, weld.length_before, weld.length / usual, usual);
  });
  return evaluate;
}

/// A plain beam that projection pulls out: its sheets lie beyond its ends. Where *ELEMENT_BEAM_PID names the sheets, a
/// weld that they would turn over is refused; here each end is tied to what is closest, whichever sheet is meant.
CheckResult check_stretch(const Inspection& in, const Weld& weld) {
  constexpr double most = 1.5, stub = 0.3;  // of (t1 + t2)/2: a shorter one is a stub, drawn to be pulled out
  const bool plain = weld.kind == Weld::Kind::beam && weld.tied_parts[0] == none && weld.tied_parts[1] == none;
  const auto t = in.thicknesses(weld);
  if (!plain || !weld.tied || !t || weld.length_before < stub * 0.5 * ((*t)[0] + (*t)[1])) return {};
  return at_most(weld.length / weld.length_before, most, [&] {
    return fmt::format("projection moves its ends by {:.3g} and {:.3g} and makes it {:.3g} long, drawn {:.3g}",
                       weld.ends[0].tie.moved, weld.ends[1].tie.moved, weld.length, weld.length_before);
  });
}

CheckResult check_duplicates(const Inspection& in, const Weld& weld) {
  constexpr double share = 0.1;
  const Weld* duplicate = in.duplicate(weld, share * weld.diameter);
  return duplicate ? CheckResult{nothing, 2.0, fmt::format("at the same place as {}", name_weld(*duplicate))}
                   : CheckResult{};
}

CheckResult check_thickness(const Inspection& in, const Weld& weld) {
  constexpr double thinnest = 0.5, thickest = 4.0;  // [mm]
  const auto t = in.thicknesses(weld);
  const auto mm = in.millimetre();
  if (!t || !mm) return {};
  const double thin = (*t)[0] / *mm, thick = (*t)[1] / *mm;
  const CheckResult low =
      at_least(thin, thinnest, [&] { return fmt::format("a sheet of {:.3g} mm: too thin for a weld to form", thin); });
  const CheckResult high =
      at_most(thick, thickest, [&] { return fmt::format("a sheet of {:.3g} mm: too thick for a sound weld", thick); });
  return high.excess > 1.0 && high.excess > low.excess ? high : low;
}

/// The usual nugget is 5 sqrt(t) of the thinner sheet, in millimetres.
CheckResult check_diameter(const Inspection& in, const Weld& weld) {
  constexpr double least = 0.8, most = 1.5;
  const auto t = in.thicknesses(weld);
  const auto mm = in.millimetre();
  if (weld.diameter == 0.0 || !t || !mm) return {};
  const double usual = 5.0 * std::sqrt((*t)[0] / *mm) * *mm;
  return within(weld.diameter / usual, least, most, [&] {
    return fmt::format("diameter {:.3g}, usual for sheets of {:.3g} and {:.3g} is {:.3g}", weld.diameter, (*t)[0],
                       (*t)[1], usual);
  });
}

CheckResult check_angle(const Inspection& in, const Weld& weld) {
  constexpr double most = 10.0;
  return worse_end([&](int end) {
    const auto angle = in.angle_to_normal(weld, end);
    return !angle ? CheckResult{} : at_most(*angle, most, [&] {
      return fmt::format("its axis is {:.1f} degrees off the normal of {}", *angle,
                         end == 0 ? "its first sheet" : "its second sheet");
    });
  });
}

CheckResult check_border(const Inspection& in, const Weld& weld) {
  constexpr double measured = 5.0;  // diameters; the edge of a sheet further away is of no concern
  if (weld.diameter == 0.0) return {};
  return worse_end([&](int end) {
    const auto distance = in.distance_to_border(weld, end, measured * weld.diameter);
    return !distance ? CheckResult{} : at_least(*distance, weld.diameter, [&] {
      return fmt::format("{:.3g} from the free edge of {}, less than its diameter {:.3g}", *distance,
                         part_name(in, weld.sheets[end]), weld.diameter);
    });
  });
}

CheckResult check_flange(const Inspection& in, const Weld& weld) {
  constexpr int least = 3, measured = 12;  // elements; a wider strip is no flange
  return worse_end([&](int end) {
    const auto width = in.flange_width(weld, end, measured);
    return !width ? CheckResult{} : at_least(*width, least, [&] {
      return fmt::format("{} element{} across the flange of {}", *width, *width == 1 ? "" : "s",
                         part_name(in, weld.sheets[end]));
    });
  });
}

CheckResult check_pitch(const Inspection& in, const Weld& weld) {
  constexpr double least = 10.0, measured = 100.0;  // thicknesses
  const auto t = in.thicknesses(weld);
  if (!t) return {};
  const Inspection::Neighbour next = in.neighbour(weld, measured * (*t)[1]);
  return !next.weld ? CheckResult{} : at_least(next.distance / (*t)[1], least, [&] {
    return fmt::format("{:.3g} from {}, {:.2g} thicknesses of {:.3g}", next.distance, name_weld(*next.weld),
                       next.distance / (*t)[1], (*t)[1]);
  });
}

CheckResult check_element_size(const Inspection& in, const Weld& weld) {
  constexpr double most = 2.0;
  if (weld.diameter == 0.0) return {};
  return worse_end([&](int end) {
    const auto size = in.element_size(weld, end);
    return !size ? CheckResult{} : at_most(*size / weld.diameter, most, [&] {
      return fmt::format("tied to an element of size {:.3g}, {:.2g} times its diameter", *size, *size / weld.diameter);
    });
  });
}

CheckResult check_aspect(const Inspection& in, const Weld& weld) {
  constexpr double most = 10.0, most_where_shear_locks = 2.5;
  const auto ratio = in.aspect_ratio(weld);
  if (!ratio) return {};
  const model::Part& part = in.model().parts[weld.part];
  const int elform = part.section == none ? 1 : in.model().solid_sections[part.section].elform;
  return at_most(*ratio, elform == 2 ? most_where_shear_locks : most, [&] {
    return fmt::format("aspect ratio {:.3g} of its brick{}", *ratio,
                       elform == 2 ? ", which locks in shear with ELFORM 2" : "");
  });
}

CheckResult check_step(const Inspection& in, const Weld& weld) {
  const MassScalingCost own = mass_scaling_cost(in.model(), in.x(), weld);
  double of_sheets = std::numeric_limits<double>::infinity();
  for (int end = 0; end < 2; ++end) of_sheets = std::min(of_sheets, in.sheet_step(weld, end).value_or(of_sheets));
  if (std::isinf(own.time_step) || std::isinf(of_sheets)) return {};
  if (in.model().control.mass_step != 0.0) return {own.time_step, 0.0, {}};  // DT2MS gives one step to all elements
  const double dt = own.mass_by_dt > 0.0 ? std::sqrt((own.mass + own.mass_by_dt) / own.mass) : 1.0;
  return at_least(own.time_step * dt, of_sheets, [&] {
    return fmt::format("limits the time step to {:.3g}; the sheets there allow {:.3g}", own.time_step * dt, of_sheets);
  });
}

CheckResult check_added_mass(const Inspection& in, const Weld& weld) {
  constexpr double most = 1.0;  // of the mass of the shells that carry it
  const MassScalingCost own = mass_scaling_cost(in.model(), in.x(), weld);
  const double sheets = in.sheet_mass(weld), added = own.mass_by_dt + own.mass_by_dt2ms;
  if (weld.kind == Weld::Kind::rigid || sheets == 0.0) return {};
  return at_most(added / sheets, most, [&] {
    return fmt::format("mass scaling adds {:.3g}, {:.2g} times the mass of the two shells that carry it", added,
                       added / sheets);
  });
}

constexpr std::array<Check, 15> all_checks{{
    {"sheets", "", "", "the two ends are on two different sheets", "see why the other end is not tied",
     Severity::warning, check_two_sheets},
    {"stack", "sheets of its spot", "stack_sheets", "two, three or four sheets are welded at one spot",
     "see whether all these welds are meant", Severity::warning, check_stack},
    {"length", "length / ((t1+t2)/2)", "length_ratio", "its length is 0.3 to 3 times (t1 + t2)/2",
     "check the gap between the sheets; give the weld nodes apart from each other", Severity::warning, check_length},
    {"stretch", "length / drawn", "stretch", "projection makes a beam no longer than 1.5 times as it is drawn",
     "see whether these are the sheets that are meant, and whether they have passed through each other: "
     "*ELEMENT_BEAM_PID names them",
     Severity::warning, check_stretch},
    {"twin", "", "", "there is one weld at a place", "delete one of the two", Severity::warning, check_duplicates},
    {"thickness", "sheet [mm]", "", "sheets are 0.5 to 4 mm thick", "check the sheet's section, or the units",
     Severity::warning, check_thickness},
    {"diameter", "d / 5 sqrt(t)", "diameter_ratio",
     "the diameter is 0.8 to 1.5 times 5 sqrt(t) of the thinner sheet [mm]",
     "check TS1 and TS2 of the section, and the sheets' thicknesses", Severity::warning, check_diameter},
    {"angle", "degrees to normal", "angle", "the axis is within 10 degrees of the sheets' normals",
     "put the two weld nodes above each other", Severity::warning, check_angle},
    {"edge", "to free edge", "edge_distance", "a weld is at least its diameter away from the free edge of its sheets",
     "check the place of the weld", Severity::warning, check_border, dimension::length},
    {"flange", "elements across", "flange_elements", "a flange is at least three elements wide",
     "mesh the flange with three or more elements across", Severity::warning, check_flange},
    {"pitch", "to next / t", "pitch_ratio", "the next weld is at least ten thicknesses away",
     "see whether both welds are meant", Severity::note, check_pitch},
    {"mesh", "element / d", "element_ratio", "elements at a weld are no larger than twice its diameter",
     "refine to the diameter, or move the weld close to a node of the sheet", Severity::warning, check_element_size},
    {"aspect", "longest / shortest", "aspect_ratio",
     "a brick's longest edge is at most 10 times its shortest, with ELFORM 2 at most 2.5",
     "use ELFORM 1 with hourglass type 6, or more and smaller bricks", Severity::warning, check_aspect},
    {"step", "time step", "", "a weld allows the time step that its sheets allow",
     "give DT in *MAT_SPOTWELD or DT2MS, or a smaller E: nugget check --target-step", Severity::note, check_step,
     dimension::time},
    {"mass", "added / sheets", "added_mass_ratio",
     "mass scaling of a weld adds no more than the mass of the shells that carry it",
     "lower DT or DT2MS, or scale E instead: nugget check --target-step", Severity::note, check_added_mass},
}};

/// Of each check that warns the worst welds, and how many there are more.
void report_remarks(const Ties& ties, const std::vector<Report>& reports, Findings& findings) {
  for (const CheckSummary& found : summarise(reports)) {
    const Check& check = *found.check;
    if (check.severity == Severity::note) continue;  // in the table and in welds.csv
    for (const std::size_t w : found.worst) {
      const Weld& weld = ties.welds[w];
      const std::vector<Remark>& remarks = reports[w].remarks;
      const auto own = std::find_if(remarks.begin(), remarks.end(), [&](const Remark& r) { return r.check == &check; });
      findings.warning(weld.place, keyword_of(weld),
                       fmt::format("{}: {} (expected: {})", name_weld(weld), own->text, check.rule),
                       std::string(check.remedy));
    }
    if (found.remarks > found.worst.size())
      findings.warning({ties.welds[found.worst.front()].place.file, 0, 0}, keyword_of(ties.welds[found.worst.front()]),
                       fmt::format("{} more welds with a remark on '{}'; the worst are named",
                                   found.remarks - found.worst.size(), check.name),
                       "welds.csv has a row for every weld");
  }
}

/// Welds that a penalty contact lists as sliding parts.
void find_sliding_welds(const model::Model& model, Findings& findings) {
  for (const model::Contact& contact : model.contacts) {
    if (contact.tie() || contact.takes_welds) continue;
    std::set<int> parts;
    for (const model::Surface* side : {&contact.a, &contact.b})
      for (Index p = 0; p < static_cast<Index>(model.parts.size()); ++p)
        if (of_weld_material(model, p) && model.parts[p].kind != model::ElementKind::nothing &&
            (side->everything || std::find(side->parts.begin(), side->parts.end(), p) != side->parts.end()))
          parts.insert(model.parts[p].id);
    if (parts.empty()) continue;
    const bool listed = !contact.a.everything && !contact.b.everything;
    const std::string text = fmt::format(
        "the weld part{} {} {} in this sliding contact; welds carry their load through "
        "their ties, and are left out of it here",
        parts.size() == 1 ? "" : "s", fmt::join(parts, ", "), parts.size() == 1 ? "is" : "are");
    const std::string remedy = "exclude weld parts from sliding contacts: another solver may not";
    if (listed)
      findings.warning(contact.place, name_contact(contact), text, remedy);
    else
      findings.note(contact.place, name_contact(contact), text, remedy);
  }
}

/// DT of a weld material beside DT2MS: both are obeyed, but DT = 0 is best (S. Bala's talk).
void find_double_mass_scaling(const model::Model& model, Findings& findings) {
  if (model.control.mass_step == 0.0) return;
  for (const model::Material& material : model.materials) {
    const auto* law = std::get_if<kernel::Spotweld>(&material.law);
    if (law == nullptr || !(law->mass_step > 0.0)) continue;
    const double step = std::abs(model.control.mass_step) * model.control.step_scale;
    const std::string larger =
        law->mass_step < step
            ? fmt::format(
                  "; DT is the smaller one, so that it changes nothing but which mass is reported as added ({:.4g} "
                  "beside {:.4g})",
                  law->mass_step, step)
            : fmt::format("; DT is the larger one and costs mass for which no step is gained ({:.4g} beside {:.4g})",
                          law->mass_step, step);
    findings.add({Severity::warning, material.place, "*" + material.keyword, "dt",
                  fmt::format("{:.6g}", law->mass_step),
                  "DT beside DT2MS: welds are scaled to a step of DT first, which counts as physical mass, then to "
                  "|DT2MS| TSSFAC, which is added mass" +
                      larger,
                  "DT = 0 where DT2MS is used"});
  }
}

/// One *CONTACT_SPOTWELD with all welds and all sheets does what several do, and no node can fall between them.
void find_several_ties(const model::Model& model, Findings& findings) {
  std::vector<const model::Contact*> ties;
  for (const model::Contact& contact : model.contacts)
    if (contact.keyword.find("CONTACT_SPOTWELD") != std::string::npos) ties.push_back(&contact);
  if (ties.size() < 2) return;
  findings.note(ties[1]->place, name_contact(*ties[1]),
                fmt::format("{} *CONTACT_SPOTWELD contacts, first {}; one is enough for all welds", ties.size(),
                            name_contact(*ties[0])),
                "one set of all weld parts as SURFA, one of all sheets as SURFB");
}

}  // namespace

std::span<const Check> checks() {
  return all_checks;
}

std::vector<CheckSummary> summarise(const std::vector<Report>& reports) {
  std::vector<CheckSummary> all;
  for (std::size_t c = 0; c < all_checks.size(); ++c) {
    CheckSummary summary;
    summary.check = &all_checks[c];
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t w = 0; w < reports.size(); ++w) {
      if (reports[w].values.empty()) continue;
      summary.least = std::fmin(summary.least, reports[w].values[c]);
      summary.most = std::fmax(summary.most, reports[w].values[c]);
      for (const Remark& remark : reports[w].remarks)
        if (remark.check == summary.check) order.emplace_back(-remark.excess, w);
    }
    summary.remarks = order.size();
    std::sort(order.begin(), order.end());
    for (const auto& [excess, w] : order)
      if (summary.worst.size() < worst_shown) summary.worst.push_back(w);
    all.push_back(std::move(summary));
  }
  return all;
}

std::vector<Report> audit(const model::Model& model, const Ties& ties, Findings& findings) {
  const Inspection inspection(model, ties);
  std::vector<Report> reports(ties.welds.size());
  for (std::size_t w = 0; w < ties.welds.size(); ++w) {
    const Weld& weld = ties.welds[w];
    if (weld.deleted) continue;
    Report& report = reports[w];
    report.cost = mass_scaling_cost(model, ties.x, weld);
    report.spot = inspection.spot(weld);
    report.stack = inspection.stack(weld);
    for (const Check& check : all_checks) {
      // Seams stand at edges, one behind the other: the rules are those of spots.
      CheckResult evaluate = weld.is_seam() ? CheckResult{} : check.evaluate(inspection, weld);
      report.values.push_back(evaluate.value);
      if (evaluate.remark()) report.remarks.push_back({&check, evaluate.excess, std::move(evaluate.text)});
    }
  }
  report_remarks(ties, reports, findings);
  if (!ties.welds.empty()) find_sliding_welds(model, findings);
  find_several_ties(model, findings);
  find_double_mass_scaling(model, findings);
  note_heat_zones(model, ties, findings);
  return reports;
}

}  // namespace nugget::weld
