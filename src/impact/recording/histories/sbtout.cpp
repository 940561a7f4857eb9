// SPDX-License-Identifier: Apache-2.0
#include "base/index.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

struct BeltRow {
  int id = 0;
  double force = 0.0, length = 0.0;
};
struct RingRow {
  int id = 0;
  double slip = 0.0;
};
struct RetractorRow {
  int id = 0;
  double pull_out = 0.0, force = 0.0;
};
struct SbtoutState {
  double time = 0.0;
  std::vector<BeltRow> belts;
  std::vector<RingRow> rings;
  std::vector<RetractorRow> retractors;
};

void print(output::AsciiFile& file, const SbtoutState& state) {
  file.print("\n time ={:13.4E}\n", output::column(state.time));
  for (const BeltRow& r : state.belts)
    file.print(" belt {:10}  tension ={:13.5E}  length ={:13.5E}\n", r.id, output::column(r.force),
               output::column(r.length));
  for (const RingRow& r : state.rings) file.print(" slip ring {:5}  slip ={:13.5E}\n", r.id, output::column(r.slip));
  for (const RetractorRow& r : state.retractors)
    file.print(" retractor {:5}  pull-out ={:13.5E}  tension ={:13.5E}\n", r.id, output::column(r.pull_out),
               output::column(r.force));
}

const output::HistoryFormat<SbtoutState>& sbtout() {
  static const output::HistoryFormat<SbtoutState> format{
      .branches =
          {{.path = "sbtout/belts",
            .ids = output::ids(&SbtoutState::belts, &BeltRow::id),
            .columns = output::columns(
                &SbtoutState::belts,
                {{"time", &SbtoutState::time, dimension::time, "time"},
                 {"belt_force", &BeltRow::force, dimension::force, "tension of a belt; 0 in a retractor"},
                 {"belt_length", &BeltRow::length, dimension::length, "its unstretched length; 0 in a retractor"}})},
           {.path = "sbtout/sliprings",
            .ids = output::ids(&SbtoutState::rings, &RingRow::id),
            .columns = output::columns(&SbtoutState::rings,
                                       {{"time", &SbtoutState::time, dimension::time, "time"},
                                        {"ring_slip", &RingRow::slip, dimension::length,
                                         "unstretched length that went to the first belt of a slip ring so far"}}),
            .written = [](const SbtoutState& s) { return !s.rings.empty(); }},
           {.path = "sbtout/retractors",
            .ids = output::ids(&SbtoutState::retractors, &RetractorRow::id),
            .columns = output::columns(
                &SbtoutState::retractors,
                {{"time", &SbtoutState::time, dimension::time, "time"},
                 {"retractor_pull_out", &RetractorRow::pull_out, dimension::length,
                  "unstretched length that came out of a retractor so far"},
                 {"retractor_force", &RetractorRow::force, dimension::force, "tension of the belt at it"}}),
            .written = [](const SbtoutState& s) { return !s.retractors.empty(); }}},
      .print = print,
      .tables_apart = true,
  };
  return format;
}

SbtoutState sbtout_state(const Snapshot& now) {
  const model::Belts& model = now.system.model.belts;
  const Belts& belts = now.components.belts;
  SbtoutState s;
  s.time = now.state.time;
  for (std::size_t i = 0; i < model.elements.size(); ++i)
    s.belts.push_back({model.elements[i].id, belts.force(i), belts.is_inside(i) ? 0.0 : belts.unstretched(i)});
  for (std::size_t i = 0; i < model.rings.size(); ++i) s.rings.push_back({model.rings[i].id, belts.slip(i)});
  for (std::size_t i = 0; i < model.retractors.size(); ++i)
    s.retractors.push_back({model.retractors[i].id, belts.pull_out(i), belts.tension(i)});
  return s;
}

}  // namespace

template <>
HistoryFile history<"sbtout">() {
  return make_history(sbtout(), sbtout_state,
                      {.concerns = [](const system::System& system) { return !system.model.belts.empty(); }});
}

}  // namespace nugget::impact
