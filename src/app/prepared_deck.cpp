// SPDX-License-Identifier: Apache-2.0
#include "app/prepared_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "app/clock.hpp"
#include "app/dropped_welds.hpp"
#include "app/refused_welds.hpp"
#include "app/weld_drop_runs.hpp"
#include "base/checksum.hpp"
#include "deck/checksum.hpp"
#include "impact/contact/initial_penetrations.hpp"
#include "model/units.hpp"
#include "reading/build.hpp"
#include "weld/failure/missing_data.hpp"
#include "weld/failure/user_library.hpp"
#include "weld/placement/coarsening.hpp"
#include "weld/tie/cut_sections.hpp"
#include "weld/tie/inferred_welds.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::app {
namespace {

output::WeldReport weld_report(const model::Model& model, const std::vector<Vec3d>& x, const weld::Weld& w,
                               const weld::Report& audit) {
  output::WeldReport r;
  r.id = w.id;
  r.kind = weld::to_string(w.kind);
  r.part = w.part == model::none ? 0 : model.parts[w.part].id;
  for (model::Index sheet : w.sheets)
    if (sheet != model::none) r.sheets.push_back(model.parts[sheet].id);
  r.middle = 0.5 * (weld::face_centre(w, 0, x) + weld::face_centre(w, 1, x));
  r.diameter = w.diameter;
  r.length = w.length;
  r.tied = w.tied;
  for (const weld::Projection& p : w.ends) {
    output::WeldProjection out;
    out.node = model.nodes.id[p.node];
    if (p.tied && p.projection_case != 0)
      for (model::Index n : p.tie.segment) out.segment.push_back(model.nodes.id[n]);
    out.xi = p.tie.xi;
    out.eta = p.tie.eta;
    out.moved = p.tie.moved;
    out.case_number = p.projection_case;
    out.reason = p.reason;
    r.projections.push_back(std::move(out));
  }
  for (std::size_t c = 0; c < weld::checks().size(); ++c)
    if (const std::string_view column = weld::checks()[c].column; !column.empty())
      r.audit.emplace_back(column, audit.values.empty() ? std::numeric_limits<double>::quiet_NaN() : audit.values[c]);
  r.audit.emplace_back("time_step", audit.cost.time_step);
  r.audit.emplace_back("mass", audit.cost.mass);
  r.audit.emplace_back("mass_by_dt", audit.cost.mass_by_dt);
  r.audit.emplace_back("mass_by_dt2ms", audit.cost.mass_by_dt2ms);
  if (w.deleted) r.remarks.emplace_back("deleted, as it is not tied (SPOTSTP = 2)");
  if (weld::is_inferred(model, w)) r.remarks.emplace_back("its part has no material: taken for a weld");
  if (w.kind == weld::Weld::Kind::connector)
    r.remarks.push_back(fmt::format("{} of *{}", w.interpolated ? "weld" : "discrete beam",
                                    model.materials[model.parts[w.part].material].keyword));
  for (const weld::Remark& remark : audit.remarks)
    r.remarks.push_back(fmt::format("{}: {}", remark.check->name, remark.text));
  return r;
}

std::string file_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A library that no weld asks for is hardly meant.
void note_unused_library(const model::Model& model, Findings& findings) {
  const auto asks = [](const model::WeldLaw& law) { return law.user() && law.function == model::none; };
  if (std::ranges::none_of(model.weld_laws, asks))
    findings.warning({model.weld_library->path, 0, 0}, "--weld-law", "no weld of the deck asks for the library",
                     "give *MAT_SPOTWELD_DAMAGE-FAILURE with OPT 2, 12 or 22 and FVAL blank");
}

/// Ties with the nodes at the places `x`.
void tie_and_audit(PreparedDeck& p, std::vector<Vec3d> x, Findings& findings) {
  Clock clock;
  p.ties = weld::tie(p.model, std::move(x), findings);
  weld::cut_sections(p.model, p.ties, findings);
  p.tie_seconds = clock.seconds();
  p.audit = weld::audit(p.model, p.ties, findings);
  for (std::size_t i = 0; i < p.ties.welds.size(); ++i)
    p.welds.push_back(weld_report(p.model, p.ties.x, p.ties.welds[i], p.audit[i]));
  p.audit_seconds = clock.seconds();
  p.is_tied = true;
}

/// *CONTROL_COARSEN: the deck is read once more, with four shells merged to one where nothing stands against it.
void coarsen(PreparedDeck& p, const deck::Deck& deck, bool skip_unsupported, Findings& findings) {
  Findings told, again;  // what was found in the deck has been said
  const model::Coarsening merged = weld::coarsening_of(p.model, weld::tie(p.model, told));
  const std::size_t shells = p.model.shells.size();
  p.model = reading::build(deck, again, skip_unsupported, p.model.weld_library, &merged);
  for (const Finding& f : again.all())
    if (f.severity == Severity::error) findings.add(f);
  findings.note(
      p.model.coarsen.place, "*CONTROL_COARSEN",
      fmt::format("{} shells became {}: {} times four to one; {} nodes are gone, {} are hanging nodes on the side of a "
                  "merged shell",
                  shells, p.model.shells.size(), merged.merged.size(), merged.removed_nodes.size(),
                  merged.hanging.size()));
}

/// Units that were given and are none of the deck's make every number that has one wrong.
void warn_of_other_units(const model::Model& model, Findings& findings) {
  const auto seen = model::recognise_units(model);
  if (model.units.empty() || !seen || seen->name == model.units) return;
  findings.warning({model.deck, 0}, "",
                   fmt::format("--units \"{}\", but density and Young's modulus are those of a metal in \"{}\"",
                               model.units, seen->name),
                   "leave --units out, or look at RO and E of the materials");
}

void check_end_time(const model::Model& model, Findings& findings) {
  const bool response = model.frequency_response || model.steady_state;
  const bool timeless = model.implicit.active && (model.implicit.modes != 0 || response);
  const model::Control& control = model.control;
  if (timeless || control.end_time > 0.0) return;
  const Place& place = control.end_time_place;
  // One that is given, but cannot be read or is out of its range, is refused as that.
  const auto refuses_it = [&place](const Finding& f) {
    return f.severity == Severity::error && place.line > 0 && f.place.file == place.file &&
           f.place.line == place.line && f.place.column == place.column;
  };
  if (std::ranges::any_of(findings.all(), refuses_it)) return;
  findings.error(place.line > 0 ? place : Place{model.deck, 0, 0}, "*CONTROL_TERMINATION", "no end time is given",
                 "give ENDTIM, the time up to which is to be computed");
}

}  // namespace

PreparedDeck::PreparedDeck() = default;
PreparedDeck::PreparedDeck(const PreparedDeck&) = default;
PreparedDeck::PreparedDeck(PreparedDeck&&) noexcept = default;
PreparedDeck& PreparedDeck::operator=(const PreparedDeck& other) {
  return *this = PreparedDeck(other);
}
PreparedDeck& PreparedDeck::operator=(PreparedDeck&&) noexcept = default;
PreparedDeck::~PreparedDeck() = default;

PreparedDeck prepare(const RunArguments& arguments, Findings& findings, EndTime end_time,
                     const WorkTogether& together) {
  PreparedDeck p;
  Clock clock;
  std::optional<deck::Deck> text = deck::read(arguments.deck, findings, arguments.load_case);
  const deck::Deck& deck = *text;
  p.has_text = deck.bytes > 0;
  p.deck_checksum = deck::checksum(deck);
  for (const std::string& file : deck.files)
    p.files.push_back(std::filesystem::absolute(file).lexically_normal().string());
  if (findings.errors() > 0 && deck.blocks.empty()) return p;  // nothing was read; no more is to be said about it
  std::shared_ptr<const model::WeldLibrary> library;
  if (!arguments.weld_law.empty()) {
    library = weld::failure::open_library(arguments.weld_law, findings);
    p.deck_checksum = checksum(file_bytes(arguments.weld_law), p.deck_checksum);
  }
  p.model = reading::build(deck, findings, arguments.skip_unsupported, library);
  if (end_time == EndTime::needed) check_end_time(p.model, findings);
  if (p.model.coarsen.on && findings.errors() == 0) coarsen(p, deck, arguments.skip_unsupported, findings);
  text.reset();  // what follows takes as much
  if (library) note_unused_library(p.model, findings);
  p.model.units = arguments.units;
  warn_of_other_units(p.model, findings);
  if (arguments.subcycle && !p.model.control.subcycling.on())
    p.model.control.subcycling.ratio = model::Subcycling::usual;
  p.model.control.single_precision = arguments.precision == "single";
  if (arguments.weld_tie == "area") p.model.control.weld_tie = model::WeldTie::area;
  if (arguments.weld_tie == "joint") p.model.control.weld_tie = model::WeldTie::joint;
  p.read_seconds = clock.seconds();
  if (findings.errors() == 0 && p.model.nodes.size() == 0)
    findings.error({p.model.deck, 0, 0}, "", "there are no nodes: nothing can move",
                   "include the mesh; a run that was interrupted goes on with --resume, without a deck of its own");
  if (findings.errors() > 0) return p;
  std::vector<Vec3d> x;
  const auto resolve = [&](Ranks* ranks) { x = impact::resolve_initial_penetrations(p.model, findings, ranks); };
  if (together)
    together(p, resolve);
  else
    resolve(nullptr);
  p.penetration_seconds = clock.seconds();
  tie_and_audit(p, std::move(x), findings);
  if (!arguments.drop_weld.empty() && !drops_each(arguments.drop_weld)) drop_welds(p, arguments.drop_weld, findings);
  return p;
}

void warn_of_response_in_explicit_run(const model::Model& model, Findings& findings) {
  if (model.implicit.active || (!model.frequency_response && !model.steady_state)) return;
  const auto asks = [](const model::KeywordUse& use) {
    return use.keyword.starts_with("FREQUENCY_DOMAIN_FRF") || use.keyword.starts_with("FREQUENCY_DOMAIN_SSD");
  };
  for (const model::KeywordUse& use : model.keyword_uses)
    if (asks(use))
      findings.warning(use.first, '*' + use.keyword,
                       "no frequency response: the run is explicit, since IMFLAG of *CONTROL_IMPLICIT_GENERAL is not 1",
                       "write IMFLAG 1, or use `nugget frf`");
}

std::string report_refused_welds(PreparedDeck& p, Findings& findings) {
  std::vector<std::string> left_out;
  if (!p.is_tied) {
    left_out = leave_out_broken_ties(p.model);
    Findings found;
    tie_and_audit(p, p.model.nodes.x, found);  // a model with errors is none to set contacts up in
    weld::failure::report_missing_data(p.model, p.ties, found);
    const bool contact_is_refused = !refused_contact(findings).empty();
    for (Finding finding : found.all()) {
      if (contact_is_refused && finding.text.ends_with(": no contact tracks it"))
        continue;  // it may have been that one
      // A weld without a hold may follow from what was refused before: the errors are those.
      finding.severity = std::min(finding.severity, Severity::warning);
      findings.add(std::move(finding));
    }
  }
  return summarize_refused_welds(p.model, p.ties, left_out, findings);
}

}  // namespace nugget::app
