// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include "base/index.hpp"
#include "model/segments.hpp"
#include "weld/placement/adapt.hpp"

namespace nugget::weld {
namespace {

/// So many corners in lists of nodes make it likely that the list means the sheet and not its border.
constexpr int most_listed = 2;

class Naming {
 public:
  Naming(const model::Model& model, const Ties& ties) : model_(model), ties_(ties), why_(model.shells.size()) {}

  std::vector<std::string> run() {
    for (const model::InitialStress& s : model_.initial_state.shells) say(s.element, "it has initial stress");
    for (const model::InitialStrain& s : model_.initial_state.shell_strains) say(s.shell, "it has initial strain");
    for (Index e = 0; at(e) < model_.shells.angle.size(); ++e)
      if (model_.shells.own_angle(e)) say(e, "it has axes of its own (BETA)");
    for (const Index e : model_.named_shells) say(e, "a card names it");
    for (const model::NamedEntity& e : model_.requests.history_shells) say(e.index, "a card names it");
    for (const Index e : model_.listed_shells) say(e, "a list of shells names it");
    say_segments();
    say_listed_nodes();
    say_loaded();
    say_tied();
    return std::move(why_);
  }

 private:
  void say(Index shell, const char* why) {
    if (why_[shell].empty()) why_[shell] = why;
  }

  void say_segments() {
    std::set<model::Segment> segments;
    const auto take = [&](const std::vector<model::Segment>& list) {
      for (const model::Segment& s : list) segments.insert(model::sorted_corners(s));
    };
    for (const model::Set<model::Segment>& s : model_.sets.segments) take(s.members);
    for (const model::Contact& c : model_.contacts)
      for (const model::Surface* side : {&c.a, &c.b}) take(side->segments);
    if (segments.empty()) return;
    for (Index e = 0; at(e) < model_.shells.size(); ++e)
      if (segments.contains(model::sorted_corners(model_.shells.node[e]))) say(e, "a segment names it");
  }

  void say_listed_nodes() {
    std::vector<char> listed(model_.nodes.size(), 0);
    for (const auto* nodes : {&model_.named_nodes, &model_.listed_nodes})
      for (const Index n : *nodes) listed[n] = 1;
    for (Index e = 0; at(e) < model_.shells.size(); ++e) {
      const auto& corners = model_.shells.node[e];
      if (std::count_if(corners.begin(), corners.end(), [&](Index n) { return listed[n] != 0; }) > most_listed)
        say(e, "lists name its nodes");
    }
  }

  /// A force on each node of a set would be another one in all.
  void say_loaded() {
    std::vector<char> loaded(model_.nodes.size(), 0);
    for (const model::NodalLoad& load : model_.nodal_loads)
      for (const Index n : load.nodes) loaded[n] = 1;
    for (Index e = 0; at(e) < model_.shells.size(); ++e)
      if (std::ranges::all_of(model_.shells.node[e], [&](Index n) { return loaded[n] != 0; }))
        say(e, "a load acts on each of its nodes");
  }

  /// What other ties than those of welds are made to.
  void say_tied() {
    std::vector<char> of_weld(model_.nodes.size(), 0), tied(of_weld);
    for (const Weld& w : ties_.welds)
      for (const Projection& p : w.ends) of_weld[p.node] = 1;
    for (const Tie& t : ties_.ties) {
      if (of_weld[t.node] != 0) continue;
      tied[t.node] = 1;
      if (t.shell != none) say(t.shell, "another tie goes to it");
    }
    for (Index e = 0; at(e) < model_.shells.size(); ++e)
      if (std::ranges::any_of(model_.shells.node[e], [&](Index n) { return tied[n] != 0; }))
        say(e, "another tie holds its nodes");
  }

  const model::Model& model_;
  const Ties& ties_;
  std::vector<std::string> why_;
};

}  // namespace

std::vector<std::string> whole_shells(const model::Model& model, const Ties& ties) {
  return Naming(model, ties).run();
}

}  // namespace nugget::weld
