// SPDX-License-Identifier: Apache-2.0
// What the ranks of a run agree on (docs/decisions/0101). In one process each of these functions does what it says for
// the process alone.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "base/free_room.hpp"
#include "base/index.hpp"
#include "base/peak_memory.hpp"
#include "impact/simulation/simulation.hpp"
#include "model/bond.hpp"
#include "system/share.hpp"

namespace nugget::impact {
namespace {

using Controlling = system::System::Controlling;
constexpr Controlling nothing_controls{std::numeric_limits<double>::infinity()};

/// What a rank brings to the agreement of a cycle.
struct Wishes {
  Controlling controlling = nothing_controls;
  bool stop = false, restart_file = false, writes_restart_files = false, state = false;
  int not_finite = std::numeric_limits<int>::max();  ///< the first node whose velocity is not a number
};

/// Whether `a` controls the step rather than `b`: the choice of one process, which goes through all elements in order
/// and takes the first of the smallest steps, or the first that is not a number.
bool controls(const Controlling& a, const Controlling& b) {
  if (a.group < 0 || b.group < 0) return b.group < 0 && a.group >= 0;
  const bool a_is_none = a.step != a.step, b_is_none = b.step != b.step;
  if (a_is_none != b_is_none) return a_is_none;
  if (!a_is_none && a.step != b.step) return a.step < b.step;
  return a.group != b.group ? a.group < b.group : a.element < b.element;
}

/// What a balance of energies changes in a run.
struct Balance {
  Energy energy;
  bool diverged = false, unstable = false, gives_energy = false;
  double largest_input = 0.0, physical_mass = 0.0, added_mass = 0.0;
  Recorder::Marks next_marks;
};

/// By node, whether the end of a run (Carried::end) reports of bricks of a weld or an adhesive there. Beams have their
/// length in their state.
std::vector<char> nodes_reported_at_end(const system::System& system) {
  std::vector<char> nodes(system.nodes);
  for (const auto& group : system.groups) {
    if (group->kind == model::ElementKind::beam) continue;
    if (!group->weld && !model::bond_of(system.model, system.model.parts[group->part])) continue;
    for (std::size_t e = 0; e < group->size(); ++e) {
      const system::ElementNodes node = group->nodes(e);
      for (int a = 0; a < group->nodes_per_element; ++a)
        if (node[a] >= 0 && at(node[a]) < nodes.size()) nodes[node[a]] = 1;
    }
  }
  return nodes;
}

}  // namespace

Simulation::ComputedByAll Simulation::computed_by_all() const {
  const model::Model& model = system_.model;
  const model::Control& control = model.control;
  const Components& c = components_;
  ComputedByAll whole;
  const auto add = [&](bool there, const char* name, bool looks_everywhere = false) {
    if (!there) return;
    whole.names.emplace_back(name);
    whole.every_node |= looks_everywhere;
  };
  const auto looks_everywhere = [](const contact::PenaltyContact& contact) { return contact.looks_everywhere(); };
  add(std::ranges::any_of(c.contacts.all(), looks_everywhere), "contact of edges, glue, FTORQ and at porous fabric");
  add(!c.interiors.all().empty(), "interior contact");
  add(!system_.bodies.empty(), "rigid bodies");
  add(!system_.springs.empty(), "ties by springs");
  add(c.welds.joints_need_each_cycle(), "joints of weld bricks and of stacks of welds");
  add(!c.connectors.empty(), "discrete beams");
  add(!c.joints.empty(), "joints");
  add(!c.belts.empty(), "seat belts");
  add(c.rivets.size() != 0, "rivets");
  add(!c.linear_constraints.empty(), "linear equations between nodes");
  add(!model.discretes.empty(), "springs");
  add(!model.accelerometers.empty(), "accelerometers");
  add(!model.control_volumes.empty(), "gas in volumes");
  add(c.damping.looks_everywhere(), "damping of motion relative to a body", true);
  add(control.relaxation.on(), "dynamic relaxation", true);
  add(control.distorted_shells > 1 || control.distorted_full_shells > 1, "deletion of distorted shells", true);
  add(system_.looks_at_neighbours(), "nodal pressures of tetrahedra", true);
  return whole;
}

system::ContactCosts Simulation::contact_costs(Ranks* ranks) {
  system::ContactCosts contact;
  components_.contacts.add_costs(state_.x, contact, ranks);
  return contact;
}

system::Partition Simulation::partition(int ranks, const system::ContactCosts& contact,
                                        system::DeletedElements deleted) {
  std::vector<system::System::ElementLocation> read;
  components_.elements_read([&](system::System::ElementLocation location) { read.push_back(location); });
  std::vector<std::vector<system::System::ElementLocation>> of_one_rank;
  components_.elements_of_one_rank([&](auto list) { of_one_rank.push_back(std::move(list)); });
  return {system_, ranks, read, contact, of_one_rank, std::move(deleted)};
}

// Of all that each rank computes whole, of loads, and those that somebody looks at between results. The
// others are left to the ranks whose elements have them.
std::vector<char> Simulation::followed_by_all() const {
  const model::Model& model = system_.model;
  const Components& c = components_;
  const bool everywhere = computed_by_all().every_node;
  std::vector<char> followed(system_.nodes, everywhere);
  if (everywhere) return followed;
  const auto follow_place = [&](int node) {
    if (at(node) < system_.nodes) followed[node] = 1;  // virtual ones everyone has
  };
  const auto follow = [&](model::Index n) {
    if (n != model::none) followed[system_.node_of[n]] = 1;
  };
  const auto follow_segments = [&](const std::vector<model::Segment>& segments) {
    for (const model::Segment& s : segments) std::ranges::for_each(s, follow);
  };
  for (const system::System::TieSpring& spring : system_.springs) follow_place(spring.node);
  for (std::size_t i = 0; i < c.rivets.size(); ++i) std::ranges::for_each(c.rivets.rivet(i).nodes, follow);
  for (const model::LinearConstraint& equation : model.linear_constraints)
    for (const model::LinearConstraint::Term& term : equation.terms) follow(term.node);
  for (const contact::PenaltyContact& contact : c.contacts.all())
    if (contact.looks_everywhere()) contact.each_node(follow_place);
  for (const contact::InteriorContact& contact : c.interiors.all())
    std::ranges::for_each(contact.nodes(), follow_place);
  for (const model::Belt& belt : model.belts.elements) std::ranges::for_each(belt.node, follow);
  for (const model::SlipRing& ring : model.belts.rings) follow(ring.node);
  for (const model::Retractor& retractor : model.belts.retractors) {
    follow(retractor.node);
    std::ranges::for_each(retractor.inside_nodes, follow);
  }
  for (const model::BeltSensor& sensor : model.belts.sensors) std::ranges::for_each(sensor.node, follow);
  for (const model::Accelerometer& a : model.accelerometers) std::ranges::for_each(a.node, follow);
  for (const model::ControlVolume& volume : model.control_volumes) {
    follow_segments(volume.segments);
    follow_segments(volume.flowing.vent.faces);
  }
  for (const model::NodalLoad& load : model.nodal_loads) {
    std::ranges::for_each(load.nodes, follow);
    std::ranges::for_each(load.follower_nodes, follow);
  }
  for (const model::PressureLoad& load : model.pressure_loads) follow_segments(load.segments);
  for (const model::TractionLoad& load : model.traction_loads) follow_segments(load.segments);
  for (const model::BlastLoad& load : model.blast_loads) follow_segments(load.segments);
  if (!history_nodes_are_shared_out(model))
    for (const model::NamedEntity& node : model.requests.history_nodes) follow(node.index);
  for (const model::Sensor& sensor : model.sensors) {
    std::ranges::for_each(sensor.node, follow);
    using Quantity = model::Sensor::Quantity;
    const auto follow_reactions = [&](const std::vector<Supports::Reaction>& reactions) {
      for (const Supports::Reaction& r : reactions)
        if (std::ranges::binary_search(sensor.sources, r.source)) follow_place(r.node);
    };
    const bool load = sensor.quantity == Quantity::force || sensor.quantity == Quantity::moment;
    if (load && sensor.pushing == model::Sensor::Pushing::support) follow_reactions(c.supports.spc_reactions());
    if (sensor.quantity == Quantity::work_of_motion || (load && sensor.pushing == model::Sensor::Pushing::motion))
      follow_reactions(c.supports.motion_reactions());
  }
  for (const model::RunEnd& end : model.run_ends) follow(end.node);
  for (const model::CoordinateSystem& system : model.systems)
    if (system.nodes)
      for (const model::Index n : {system.nodes->origin, system.nodes->on_axis, system.nodes->in_plane}) follow(n);
  return followed;
}

system::System::Controlling Simulation::controlling_of_all() const {
  const Controlling own = system_.controlling();
  if (ranks_ == nullptr) return own;
  Controlling all = nothing_controls;
  for (const Controlling& of_rank : gather(*ranks_, own))
    if (controls(of_rank, all)) all = of_rank;
  return all;
}

// Only the first rank cuts; what contact costs they all find out, each of a part.
void Simulation::share_out(Ranks& ranks, const Options& options) {
  ranks_ = &ranks;
  traffic_before_ = ranks.traffic();
  cycle_before_ = state_.cycle;
  shared_out_at_ = elapsed();
  std::optional<system::Partition> shares;
  {
    if (!options.restore) contact_costs_now_ = contact_costs(&ranks);
    if (on_first_rank())
      shares.emplace(partition(ranks.count(), contact_costs_now_, std::move(deleted_now_)));
    else
      shares.emplace(system_, ranks.count());
    forget_costs();
  }
  // Contact makes its segments at places of all nodes.
  const std::array<system::Rows*, 4> of_nodes{&state_.v, &state_.w, &state_.f, &state_.m};
  system_.share_out(ranks, std::move(*shares), followed_by_all(), of_nodes);
  components_.contacts.take_share({*system_.share(), state_.x, state_.v});
  system_.share()->forget_others(state_.x);
  if (options.made) options.made();
  find_shown();
  // Here, where there is room for it.
  if (on_first_rank()) shares_ = system_.share()->partition().shares(system_, followed_by_all());
}

void Simulation::find_shown() {
  const model::Model& model = system_.model;
  std::vector<char> nodes(system_.all_nodes());
  const auto add = [&](const system::System::ElementLocation& location) {
    if (location.group < 0) return;
    const system::ElementGroup& group = *system_.groups[location.group];
    shown_.elements.push_back(location);
    shown_.blocks.emplace_back(location.group, at(location.element) / group.block_width());
    const system::ElementNodes of_element = group.nodes(at(location.element));
    for (int a = 0; a < group.nodes_per_element; ++a)
      if (of_element[a] >= 0) nodes[of_element[a]] = 1;
  };
  for (const model::CrossSection& section : model.requests.cross_sections) {
    for (const model::CrossSection::Facet& facet : section.facets) {
      add(system_.location_of(facet.kind, facet.element));
      for (const model::CrossSection::Corner& corner : facet.corners)
        for (const model::Index n : {corner.from, corner.to}) nodes[system_.node_of[n]] = 1;
    }
    for (const model::Index n : section.nodes) nodes[system_.node_of[n]] = 1;
  }
  for (const model::NamedEntity& beam : model.requests.history_beams) {
    const model::Material& material = model.materials[model.parts[model.beams.part[beam.index]].material];
    if (std::holds_alternative<kernel::DiscreteBeam>(material.law)) add(system_.beam_location[beam.index]);
  }
  std::ranges::sort(shown_.blocks);
  shown_.blocks.erase(std::unique(shown_.blocks.begin(), shown_.blocks.end()), shown_.blocks.end());
  for (std::size_t k = 0; k < system_.nodes; ++k)
    if (nodes[k] != 0) shown_.nodes.push_back(static_cast<int>(k));
}

void Simulation::report_ranks() {
  const double seconds = elapsed() - shared_out_at_,
               cycles = std::max(1.0, static_cast<double>(state_.cycle - cycle_before_));
  const Ranks::Traffic now = ranks_->traffic();
  const double waiting = now.waiting - traffic_before_.waiting;
  RankReport own;
  own.messages = static_cast<double>(now.messages - traffic_before_.messages) / cycles;
  own.bytes = static_cast<double>(now.bytes - traffic_before_.bytes) / cycles;
  own.waiting = waiting;
  own.busy = seconds - waiting;
  own.peak_memory = peak_memory();
  for (const auto& group : system_.groups) own.states += group->size() - group->elsewhere();
  for (const contact::PenaltyContact& contact : components_.contacts.all()) own.segments += contact.surface().held();
  rank_reports_ = gather(*ranks_, own);
  if (!on_first_rank()) return;
  for (std::size_t r = 0; r < shares_.size(); ++r) {
    RankReport& report = rank_reports_[r];
    const system::Partition::Share& share = shares_[r];
    report.elements = share.elements;
    report.nodes = share.nodes;
    report.shared_nodes = share.shared_nodes;
    report.neighbours = share.neighbours.size();
    report.cost = share.cost;
    report.contact = share.contact;
  }
}

void Simulation::collect(system::Carried what, bool to_all) {
  std::vector<system::Rows*> rows{&state_.x, &state_.v, &state_.w, &v_before_, &w_before_};
  const bool sums_only = what == system::Carried::energies || what == system::Carried::end;
  // All follow the nodes that histories show, energies are summed up from NodalMotion, and what a restart file has of
  // nodes each rank puts into it.
  if (what == system::Carried::histories || what == system::Carried::restart || sums_only) rows.clear();
  const std::vector<char> placed =
      what == system::Carried::end && ranks_ != nullptr ? nodes_reported_at_end(system_) : std::vector<char>();
  const double share = share_of_interval(state_);
  free_room(motion_of_others_);
  free_room(step_change_of_others_);
  sums_of_ranks_ = {};
  if (sums_only && ranks_ != nullptr) {
    if (on_first_rank()) {
      motion_of_others_.resize(system_.sums_by_rank()->travelling());
      step_change_of_others_.resize(motion_of_others_.size());
    }
    part_nodes_.update(system_, PartNodes::Sums::own);
    sums_of_ranks_ =
        sums_for_first(system_, state_, v_before_, w_before_, part_nodes_, [this](std::size_t begin, std::size_t end) {
          return sum_of_row(begin, end, [this](std::size_t k) { return step_change_before_now(k); });
        });
  }
  if (ranks_ != nullptr) components_.welds.measure(state_);
  if (what == system::Carried::whole) rows = {&state_.x, &state_.v, &state_.w, &state_.f, &state_.m};
  system_.collect(
      what, rows,
      [&](const system::System::Computed& of, system::Parcel& parcel) {
        if (sums_only) sums_of_ranks_.each_of(system_, part_nodes_, of.rank, [&](auto& sum) { parcel(&sum, 1); });
        for (const int k : of.share.reported_by(of.rank)) {
          if (what != system::Carried::results && !sums_only) break;
          if (!placed.empty() && placed[k] != 0) parcel(&state_.x[k], 1);
          if (sums_only && !system_.sums_by_rank()->travels(k)) continue;
          if (sums_only) {
            NodalMotion of_node;
            if (!parcel.reading()) of_node = nodal_motion(state_, v_before_, w_before_, at(k), share);
            parcel(&of_node, 1);
            if (parcel.reading()) motion_of_others_[system_.sums_by_rank()->place_among_travelling(k)] = of_node;
          }
          if (!step_change_of_node_.empty()) {
            double booked = parcel.reading() ? 0.0 : step_change_before_now(at(k));
            parcel(&booked, 1);
            if (parcel.reading() && sums_only)
              step_change_of_others_[system_.sums_by_rank()->place_among_travelling(k)] = booked;
            else if (parcel.reading())
              step_change_of_node_[k] = booked;
          }
        }
        if (what == system::Carried::whole) return;
        components_.for_each([&](auto& component) {
          if constexpr (requires { component.carry(what, of, parcel); }) component.carry(what, of, parcel);
        });
      },
      to_all);
}

void Simulation::collect_shown() {
  if (shown_.elements.empty()) return;
  system_.collect(system::Carried::histories, {}, [&](const system::System::Computed& of, system::Parcel& parcel) {
    for (const auto& [g, b] : shown_.blocks)
      if (of(g, b * system_.groups[g]->block_width()))
        system_.groups[g]->carry(b, b + 1, system::Carried::results, parcel);
    for (const system::System::ElementLocation& e : shown_.elements)
      if (of(e.group, at(e.element))) system_.carry_forces(e, parcel);
    for (const int k : shown_.nodes)
      if (!of.share.everyone_follows(k) && of.share.answering(k) == of.rank)
        for (system::Rows* rows : {&state_.x, &state_.v, &state_.w}) parcel(&(*rows)[k], 1);
  });
}

// What is as large as the model the ranks give piece by piece: the first one says whether it writes any.
void Simulation::write_results(Recorder& recorder, bool last) {
  // Numbers that are none would only spoil files that are good up to here.
  const bool writes = on_first_rank() && !diverged_;
  const bool shows = ranks_ != nullptr && shows_elements(last);
  Recorder::Shared shared;
  if (shows) collect_shown();
  if (ranks_ != nullptr && (shows || history_nodes_are_shared_out(system_.model))) {
    if (writes) shared = recorder.shared_due(state_, last);
    broadcast(*ranks_, shared);
  }
  if (writes) recorder.write(snapshot(), last);
  if (!on_first_rank() && shared.any()) recorder.give(snapshot(), shared);
  if (shows && !last && on_first_rank() && !shown_.elements.empty()) leave_to_others();
}

void Simulation::write_checkpoint_if_due(const Options& options) {
  if (!restart_file_due_) return;
  collect(system::Carried::restart);
  if (options.write_checkpoint) options.write_checkpoint();
  checkpoints_.written(state_.cycle, state_.time, solve_seconds_);
}

void Simulation::leave_to_others() {
  system_.leave_to_others();
  for (system::Rows* rows : {&state_.x, &state_.v, &state_.w, &state_.f, &state_.m, &v_before_, &w_before_})
    system_.share()->forget_others(*rows);
  for (ZeroedVector<double>* numbers : {&step_change_of_node_, &inverse_mass_, &inverse_inertia_})
    system_.share()->forget_others(*numbers);
}

void Simulation::archive_costs(Archive& a) {
  a.section("costs");
  if (!a.reading()) {
    components_.contacts.add_costs_now(contact_costs_now_, ranks_);
    std::ranges::sort(contact_costs_now_.together);
    for (const auto& group : system_.groups) {
      std::vector<char>& deleted = deleted_now_.emplace_back(group->size());
      for (std::size_t e = 0; e < deleted.size(); ++e) deleted[e] = !group->alive(e);
    }
  }
  a(contact_costs_now_.of_node, contact_costs_now_.together, deleted_now_);
  if (!a.reading()) forget_costs();
}

void Simulation::forget_costs() {
  contact_costs_now_ = {};
  free_room(deleted_now_);
}

void Simulation::agree(const Options& options) {
  Wishes own;
  own.stop = interrupted();
  own.writes_restart_files = options.write_checkpoint && !diverged_;
  if (own.writes_restart_files) {
    solve_seconds_ = elapsed();
    own.restart_file = checkpoints_.due(options.checkpoints, state_.cycle, state_.time, solve_seconds_);
  }
  own.state = state_asked_;
  if (state_.cycle % 50 == 0) own.not_finite = first_not_finite();
  controlling_ = system_.controlling();
  if (ranks_ != nullptr) {
    own.controlling = controlling_;
    Wishes all;
    for (const Wishes& w : gather(*ranks_, own)) {
      if (controls(w.controlling, all.controlling)) all.controlling = w.controlling;
      all.stop |= w.stop;
      all.restart_file |= w.restart_file;
      all.writes_restart_files |= w.writes_restart_files;
      all.state |= w.state;
      all.not_finite = std::min(all.not_finite, w.not_finite);
    }
    if (all.stop && !own.stop) interrupt("a signal to another rank");
    if (all.state)
      next_marks_.any = next_marks_.of_elements = next_marks_.of_energies = -std::numeric_limits<double>::infinity();
    own = all;
    controlling_ = own.controlling;
  }
  stop_requested_ = own.stop;
  restart_file_due_ = own.restart_file || (own.stop && own.writes_restart_files);
  state_asked_ = false;
  not_finite_ = own.not_finite == std::numeric_limits<int>::max() ? -1 : own.not_finite;
}

int Simulation::first_not_finite() const {
  std::atomic<int> first{std::numeric_limits<int>::max()};
  system_.for_each_node(2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < std::min(end, system_.nodes); ++k) {
      const Row& v = state_.v[k];
      if (std::isfinite(v.x + v.y + v.z)) continue;
      const int node = static_cast<int>(k);
      for (int now = first; node < now && !first.compare_exchange_weak(now, node);) {
      }
      return;
    }
  });
  return first;
}

bool Simulation::results_due(Recorder& recorder) const {
  if (on_first_rank()) return recorder.due(state_);
  return state_.time + state_.dt > next_marks_.any + 1e-9 * state_.dt;
}

bool Simulation::shows_elements(bool last) const {
  return elements_due() || (last && next_marks_.elements);
}

bool Simulation::elements_due() const {
  return state_.time + state_.dt > next_marks_.of_elements + 1e-9 * state_.dt;
}

bool Simulation::balance_due(Recorder& recorder) const {
  const model::Control& control = system_.model.control;
  // Limits of energy and mass are watched with whatever is written.
  if (control.energy_limit > 0.0 || control.added_mass_limit < model::Control{}.added_mass_limit) return true;
  if (on_first_rank()) return recorder.energies_due(state_);
  return state_.time + state_.dt > next_marks_.of_energies + 1e-9 * state_.dt;
}

/// No energy is beyond what the result files hold while no velocity is anywhere near.
bool Simulation::runs_away() const {
  constexpr double far = 1e12;
  std::atomic<bool> found{false};
  system_.for_each_node(4096, [&](std::size_t begin, std::size_t end) {
    bool bounded = true;  // and a number
    for (std::size_t k = begin; k < end; ++k)
      for (const Row* r : {&state_.v[k], &state_.w[k]})
        bounded = bounded && std::abs(r->x) < far && std::abs(r->y) < far && std::abs(r->z) < far;
    if (!bounded) found = true;
  });
  if (ranks_ == nullptr) return found;
  const std::vector<char> of_all = gather(*ranks_, static_cast<char>(found));
  return std::ranges::count(of_all, 0) != std::ssize(of_all);
}

void Simulation::pass_on_balance(const Recorder& recorder) {
  if (ranks_ == nullptr) return;
  Balance balance{energy_,        diverged_,        unstable_,     gives_energy_,
                  largest_input_, masses_.physical, masses_.added, recorder.next_marks()};
  broadcast(*ranks_, balance);
  energy_ = balance.energy;
  diverged_ = balance.diverged;
  unstable_ = balance.unstable;
  gives_energy_ = balance.gives_energy;
  largest_input_ = balance.largest_input;
  masses_.physical = balance.physical_mass;
  masses_.added = balance.added_mass;
  next_marks_ = balance.next_marks;
}

}  // namespace nugget::impact
