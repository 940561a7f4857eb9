// SPDX-License-Identifier: Apache-2.0
#include "app/subcycling.hpp"

#include <fmt/format.h>

#include <map>

#include "nvh/matrices/ranks.hpp"

namespace nugget::app {

void make_system(const PreparedDeck& p, std::optional<system::System>& system, Findings& findings,
                 system::System::ElementsStart start) {
  if (!p.is_tied) return;
  system.emplace(p.model, p.ties, findings, system::ElementPeriods{}, start);
  const model::Subcycling& asked = p.model.control.subcycling;
  if (!asked.on() || findings.errors() > 0) return;
  system->compute_at_rest();
  const system::ElementPeriods periods = system::periods_by_step(*system, asked.ratio);
  Findings once_more;  // those of this model have been reported
  system.emplace(p.model, p.ties, once_more, periods, start);
}

void check_subcycling(const impact::Simulation& simulation, Findings& findings) {
  const system::System& system = simulation.system();
  const model::Model& model = system.model;
  const model::Subcycling& asked = model.control.subcycling;
  if (!asked.on()) return;
  const bool by_card = asked.place.line > 0;
  const auto report = [&](Severity severity, const std::string& what, const std::string& remedy) {
    findings.add({severity,
                  by_card ? asked.place : Place{model.deck, 0, 0},
                  by_card ? "*CONTROL_SUBCYCLE" : "",
                  {},
                  {},
                  (by_card ? "" : "--subcycle: ") + what,
                  remedy});
  };
  const auto refuse = [&](const std::string& what, const std::string& why) {
    report(Severity::error, fmt::format("this run has {}, {}", what, why),
           by_card ? "take the card out; DT2MS of *CONTROL_TIMESTEP is another way to longer steps"
                   : "leave the option out; DT2MS of *CONTROL_TIMESTEP is another way to longer steps");
  };
  const impact::Components& acting = simulation.components();
  if (nvh::ranks() > 1) refuse("several ranks", "among which sub-cycling is not shared out");
  if (model.control.relaxation.on()) refuse("a dynamic relaxation", "whose damping goes by the cycles of all elements");
  for (const auto& group : system.groups) {
    if (!group->damped() && !(group->damping_stiffness_ratio > 0.0)) continue;
    refuse(fmt::format("stiffness damping of part {}", model.parts[group->part].id),
           "which acts in each cycle on forces that the elements have not in each");
    break;
  }
  const auto in_each_cycle = [&](bool there_are, const std::string& what) {
    if (there_are && asked.contact_period > 1)
      refuse(what + fmt::format(" and L {}", asked.contact_period),
             "whose forces go by the forces of contact on them in each cycle, and those come at L 1 only");
  };
  if (acting.welds.joints_need_each_cycle())
    refuse("joints of welds of bricks or of stacks of welds", "which share out motions with the forces of each cycle");
  if (!acting.linear_constraints.empty())
    refuse("linear equations between nodes", "which share out the forces of each cycle");
  if (!model.tied_nodes.empty())
    refuse("nodes that are tied until the mesh tears (*CONSTRAINED_TIED_NODES_FAILURE)",
           "at which elements of several periods would meet");
  in_each_cycle(acting.rigid_welds.size() > 0, "rigid welds");
  in_each_cycle(acting.rivets.size() > 0, "rivets");
  in_each_cycle(!acting.joints.empty(), "joints");
  if (!acting.belts.empty()) refuse("seat belts", "which slide by the tensions of each cycle");
  if (findings.errors() > 0) return;
  if (system.period() == 1)
    report(Severity::note, "no element allows twice the step of the run: all have their forces in each cycle",
           "nothing is gained; leave it out");
}

std::vector<output::Summary::Period> element_periods(const system::System& system) {
  std::map<int, std::map<std::string, std::size_t>> count;
  if (!system.model.control.subcycling.on()) return {};
  for (const auto& group : system.groups) count[group->period][std::string(system.kind_name(*group))] += group->size();
  std::vector<output::Summary::Period> periods;
  for (const auto& [cycles, elements] : count) periods.push_back({cycles, elements});
  return periods;
}

std::string log_subcycling(const system::System& system) {
  const std::vector<output::Summary::Period> periods = element_periods(system);
  if (periods.empty()) return {};
  const model::Subcycling& asked = system.model.control.subcycling;
  std::string s = fmt::format("Sub-cycling (K {}, L {})\n\n", asked.ratio, asked.contact_period);
  for (const output::Summary::Period& p : periods) {
    std::string what;
    for (const auto& [kind, elements] : p.elements)
      what += fmt::format("{}{} {}{}", what.empty() ? "" : ", ", elements, kind, elements == 1 ? "" : "s");
    s += fmt::format(" forces {:<17} {}\n", p.cycles == 1 ? "in each cycle" : fmt::format("every {} cycles", p.cycles),
                     what);
  }
  return s + '\n';
}

}  // namespace nugget::app
