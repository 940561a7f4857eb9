// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/tie_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "kernel/law/cohesive_bond.hpp"
#include "model/bond.hpp"
#include "weld/tie/inferred_welds.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

std::string move_or_widen(double distance, double tolerance, bool faces_sheet = true) {
  if (!std::isfinite(distance)) return "put the sheet's part on the reference side (SURFB) of the contact";
  // So far off, or beside it, it is hardly this sheet that is meant, and such a reach would tie other welds to wrong
  // ones.
  if (!faces_sheet || distance > 2.0 * tolerance)
    return "move the weld to its sheet, or put the sheet that is meant on the reference side (SURFB) of the contact";
  const double thickness = 1.05 * distance / 1.2;
  return fmt::format("move the weld to its sheet, or give SAST = SBST = {:.3g} in the contact (tolerance {:.3g})",
                     -thickness, 1.2 * thickness);
}

std::string shares(const model::Model& model, const Tie& tie) {
  return fmt::format("{} tied to {}", name_node(model, tie.node), name_segment(model, tie.shell, tie.part));
}

/// The body that carries all nodes of the segment, or none.
Index body_of_segment(const Tie& tie, const Surroundings& around) {
  const Index body = around.rigid_body[tie.segment[0]];
  for (Index n : tie.segment)
    if (around.rigid_body[n] != body) return none;
  return body;
}

void note_rigid_sheets(const model::Model& model, const Surroundings& around, std::vector<Tie>& ties,
                       Findings& findings) {
  std::set<std::pair<Index, Index>> reported;  // body, part
  for (Tie& tie : ties) {
    tie.rigid_body = body_of_segment(tie, around);
    if (tie.rigid_body == none || tie.spring) continue;
    const Index part = tie.part;
    if (!reported.insert({tie.rigid_body, part}).second) continue;
    const model::Contact& contact = model.contacts[tie.contact];
    findings.note(
        contact.place, name_contact(contact),
        fmt::format("{} belongs to {}, which no tie may constrain again: nodes tied to it become extra nodes of it, "
                    "first {}",
                    part == none ? "a segment" : fmt::format("part {}", model.parts[part].id),
                    name_body(model.rigid_bodies[tie.rigid_body]), name_node(model, tie.node)),
        "nothing is to be done");
  }
}

void warn_of_constrained_segments(const model::Model& model, const Surroundings& around, const std::vector<Tie>& ties,
                                  const std::vector<Index>& tie_of, Findings& findings) {
  for (const Tie& tie : ties) {
    if (tie.rigid_body != none || tie.spring) continue;
    const model::Contact& contact = model.contacts[tie.contact];
    for (const Index n : carriers(tie)) {
      if (tie_of[n] != none) {
        const Tie& other = ties[tie_of[n]];
        findings.warning(
            contact.place, name_contact(contact),
            fmt::format("{}: its segment's node {} is itself tied by {} to {}", shares(model, tie), model.nodes.id[n],
                        name_contact(model.contacts[other.contact]), name_segment(model, other.shell, other.part)),
            "the load goes on through both ties; to avoid the chain, keep tied edges and welds apart");
      } else if (around.rigid_body[n] != none) {
        findings.warning(contact.place, name_contact(contact),
                         fmt::format("{}: its segment's node {} belongs to {}", shares(model, tie), model.nodes.id[n],
                                     name_body(model.rigid_bodies[around.rigid_body[n]])),
                         "the load goes on into the body; to avoid it, weld one element further away");
      }
    }
  }
}

/// What a constraint must leave alone: nodes that supports, motions, interpolations or rivets hold.
std::vector<char> held_otherwise(const model::Model& model) {
  std::vector<char> held(model.nodes.size(), 0);
  for (const model::SinglePointConstraint& spc : model.spcs) held[spc.node] = 1;
  for (const model::PrescribedMotion& motion : model.motions)
    if (motion.target == model::PrescribedMotion::Target::nodes)
      for (const Index n : motion.nodes) held[n] = 1;
  for (const model::Interpolation& interpolation : model.interpolations) held[interpolation.node] = 1;
  for (const model::HangingNode& hanging : model.hanging_nodes) held[hanging.node] = 1;
  for (const model::RigidWeld& weld : model.rigid_welds)
    for (const Index n : weld.nodes) held[n] = 1;
  return held;
}

/// Ties by springs become ties by constraint where nothing stands against one (docs/decisions/0061): an explicit step
/// allows no spring at a light node that is as stiff as what it ties. SFSA below 1 asks for a soft spring, and gets it.
void constrain_what_springs_stand_for(const model::Model& model, const Surroundings& around, std::vector<Tie>& ties) {
  const std::vector<char> held = held_otherwise(model);
  std::vector<char> tied(model.nodes.size(), 0);
  for (const Tie& tie : ties) tied[tie.node] = 1;
  for (Tie& tie : ties) {
    if (!tie.spring || !(model.contacts[tie.contact].stiffness_scale_a >= 1.0)) continue;
    bool free = !held[tie.node] && around.rigid_body[tie.node] == none;
    for (const Index n : carriers(tie)) free = free && !tied[n] && around.rigid_body[n] == none;
    tie.spring = !free;
  }
}

/// IPBACK: springs take the place of constraints to segments that are constrained themselves.
void fall_back_on_springs(const model::Model& model, const Surroundings& around, std::vector<Tie>& ties,
                          std::vector<Index>& tie_of, Findings& findings) {
  std::vector<int> count(model.contacts.size(), 0);
  for (Tie& tie : ties) {
    if (!model.contacts[tie.contact].penalty_fallback) continue;
    for (const Index n : carriers(tie)) tie.spring |= tie_of[n] != none || around.rigid_body[n] != none;
    if (!tie.spring) continue;
    tie_of[tie.node] = none;
    ++count[tie.contact];
  }
  for (std::size_t c = 0; c < count.size(); ++c)
    if (count[c] > 0 && !model.contacts[c].tie_by_springs())
      findings.note(
          model.contacts[c].place, name_contact(model.contacts[c]),
          fmt::format("{} nodes or their segments are constrained already; springs hold them (IPBACK)", count[c]));
}

/// Takes away the ties whose segments are tied to nothing, again and again; what is left goes round in a circle.
void refuse_circles(const model::Model& model, const std::vector<Tie>& ties, const std::vector<Index>& tie_of,
                    Findings& findings) {
  std::vector<std::vector<Index>> behind(ties.size());
  std::vector<int> waits_for(ties.size(), 0);
  for (std::size_t t = 0; t < ties.size(); ++t)
    for (const Index n : carriers(ties[t])) {
      const Index ahead = tie_of[n];
      if (ahead == none || ties[t].spring) continue;
      behind[ahead].push_back(static_cast<Index>(t));
      ++waits_for[t];
    }
  std::vector<Index> free;
  for (std::size_t t = 0; t < ties.size(); ++t)
    if (waits_for[t] == 0) free.push_back(static_cast<Index>(t));
  for (std::size_t i = 0; i < free.size(); ++i)
    for (Index t : behind[free[i]])
      if (--waits_for[t] == 0) free.push_back(t);
  if (free.size() == ties.size()) return;
  const auto first = std::find_if(waits_for.begin(), waits_for.end(), [](int count) { return count > 0; });
  const Tie& tie = ties[first - waits_for.begin()];
  const model::Contact& contact = model.contacts[tie.contact];
  findings.error(
      contact.place, name_contact(contact),
      fmt::format("{} ties depend on each other in a circle, first {}", ties.size() - free.size(), shares(model, tie)),
      "let no part stand on both sides of the contact, and no two contacts tie two parts to each other");
}

void report_end(const model::Model& model, const Weld& weld, const Projection& p, Findings& findings) {
  const std::string text = fmt::format("{}: {}: {}", name_weld(weld), name_node(model, p.node), p.reason);
  const std::string keyword = keyword_of(weld);
  switch (p.projection_case) {
    case 4:
      findings.warning(weld.place, keyword, fmt::format("{}, moved {:.4g}", text, p.tie.moved),
                       "move the sheets apart to half the sum of their thicknesses");
      return;
    case 5:
      findings.warning(weld.place, keyword, text + ", not tied",
                       p.only_sheet_taken && !std::isfinite(p.distance)
                           ? "put the other sheet's part on the reference side (SURFB) of the contact"
                           : move_or_widen(p.distance, p.tolerance, p.faces_sheet));
      return;
    case 6:
      findings.warning(weld.place, keyword, fmt::format("{}, moved {:.4g}", text, p.tie.moved),
                       "see whether that is the sheet meant; if not, move the weld");
      return;
    case 7:
    case 8:
      findings.warning(weld.place, keyword,
                       fmt::format("{} (case {}{}), not tied", text, p.projection_case,
                                   p.projection_case == 8 ? ", normals outward" : ""),
                       "the sheets cross here: separate them, or swap the ends of the weld");
      return;
    default: return;
  }
}

/// Nodes that turn with nothing but adhesive between shells.
std::vector<char> turned_by_adhesive(const model::Model& model, const Surroundings& around) {
  std::vector<char> by_adhesive(around.rotates.size(), 0);
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    if (model::bond_between_shells(model, e))
      for (const Index n : model.solids.node[e])
        if (around.shell[n] == none) by_adhesive[n] = 1;
  return by_adhesive;
}

/// Nodes that could turn their segment but hand over translations only.
void report_hinges(const model::Model& model, const Surroundings& around, const std::vector<Tie>& ties,
                   Findings& findings) {
  struct Hinges {
    int count = 0;
    const Tie* first = nullptr;
  };
  const std::vector<char> by_adhesive = turned_by_adhesive(model, around);
  std::vector<Hinges> of_welds(model.contacts.size()), of_adhesive(of_welds), of_others(of_welds);
  for (const Tie& tie : ties) {
    if (tie.rotations || tie.rigid_body != none || !around.rotates[tie.node]) continue;
    Hinges& h = (around.of_weld[tie.node] ? of_welds : by_adhesive[tie.node] ? of_adhesive : of_others)[tie.contact];
    if (h.count++ == 0) h.first = &tie;
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const model::Contact& contact = model.contacts[c];
    const auto text = [&](const Hinges& h) {
      return fmt::format(
          "{} nodes with rotations are tied by translations only, as by hinges: no moment is handed "
          "over; first {}",
          h.count, shares(model, *h.first));
    };
    if (of_welds[c].count > 0)
      findings.warning(contact.place, name_contact(contact), text(of_welds[c]),
                       "tie weld beams to shells with *CONTACT_SPOTWELD; bricks as welds need no rotations");
    if (of_adhesive[c].count > 0)
      findings.warning(contact.place, name_contact(contact),
                       text(of_adhesive[c]) + ": adhesive of ELFORM 20 turns away from shear, which finds no hold",
                       "tie it with *CONTACT_TIED_SHELL_EDGE_TO_SURFACE, or write ELFORM 19");
    if (of_others[c].count > 0)
      findings.note(contact.place, name_contact(contact), text(of_others[c]),
                    "*CONTACT_TIED_SHELL_EDGE_TO_SURFACE hands moments over to shells, ..._TO_SOLID to bricks");
  }
}

/// Adhesive tied by springs, whose light nodes allow soft ones only; and bricks whose thickness is another one since
/// the ties have moved their nodes.
void report_tied_adhesive(const model::Model& model, const std::vector<Vec3d>& x, const std::vector<Tie>& ties,
                          Findings& findings) {
  std::vector<const Tie*> tie_of(model.nodes.size(), nullptr);
  for (const Tie& tie : ties) tie_of[tie.node] = &tie;
  struct AdhesiveOfContact {
    int sprung = 0, bricks = 0;
    double before = 0.0, after = 0.0;  // thickness of the first brick
    bool matters = false;
  };
  std::vector<AdhesiveOfContact> of_contact(model.contacts.size());
  std::vector<char> seen(model.nodes.size(), 0);
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    const kernel::CohesiveBond* bond = model::bond_of(model, model.parts[model.solids.part[e]]);
    if (bond == nullptr) continue;
    Vec3d before{}, after{};  // from face to face
    const Tie* moved = nullptr;
    for (std::size_t i = 0; i < 8; ++i) {
      const Index n = model.solids.node[e][i];
      const Tie* tie = tie_of[n];
      const double side = i < 4 ? -0.25 : 0.25;
      before += side * model.nodes.x[n];
      after += side * x[n];
      if (tie && tie->moved > 0.0) moved = tie;
      if (tie && tie->spring && !std::exchange(seen[n], 1)) ++of_contact[tie->contact].sprung;
    }
    if (moved == nullptr || std::abs(norm(after) - norm(before)) <= 0.1 * std::max(norm(after), norm(before))) continue;
    AdhesiveOfContact& t = of_contact[moved->contact];
    if (t.bricks++ == 0) t.before = norm(before), t.after = norm(after);
    t.matters = t.matters || (bond->yields() && bond->glue.thickness == 0.0);
  }
  for (std::size_t c = 0; c < of_contact.size(); ++c) {
    const model::Contact& contact = model.contacts[c];
    const AdhesiveOfContact& t = of_contact[c];
    if (t.sprung > 0)
      findings.warning(
          contact.place, name_contact(contact),
          fmt::format("{} nodes of adhesive are tied by springs: those that such light nodes and their time step allow "
                      "are softer than the bond, of whose stiffness an eighth to a third is left in impact",
                      t.sprung),
          "tie it by constraint: the form without _OFFSET, or _CONSTRAINED_OFFSET to keep its thickness");
    if (t.bricks == 0) continue;
    const std::string text = fmt::format(
        "{} bricks of adhesive have another thickness since their nodes were moved onto "
        "the mid-surfaces, the first {:.3g} in place of {:.3g}",
        t.bricks, t.after, t.before);
    if (t.matters)
      findings.warning(contact.place, name_contact(contact), text + ": EN = EMOD/THICK and ET follow it",
                       "give THICK of *MAT_240 or BTHK of *MAT_169, or tie with _CONSTRAINED_OFFSET");
    else
      findings.note(contact.place, name_contact(contact), text, "_CONSTRAINED_OFFSET keeps it");
  }
}

void report_untied_welds(const model::Model& model, const std::vector<const Weld*>& untied, Findings& findings) {
  if (untied.empty()) return;
  const std::string first =
      untied.size() == 1 ? fmt::format("{} is not tied", name_weld(*untied.front()))
                         : fmt::format("{} welds are not tied, first {}", untied.size(), name_weld(*untied.front()));
  const int spotstp = model.control.untied_weld;
  const auto add = [&](Severity severity, std::string text, std::string remedy) {
    Finding finding;
    finding.severity = severity;
    finding.place = model.control.untied_weld_place;
    if (finding.place.file.empty()) finding.place.file = model.deck;
    finding.keyword = "*CONTROL_CONTACT";
    finding.field = "spotstp";
    finding.value = std::to_string(spotstp);
    finding.text = std::move(text);
    finding.remedy = std::move(remedy);
    findings.add(std::move(finding));
  };
  if (spotstp == 1)
    add(Severity::error, first,
        "the warnings on the welds say why; SPOTSTP = 2 would delete such welds, 0 and 3 keep them");
  else if (spotstp == 2)
    add(Severity::warning, first + (untied.size() == 1 ? "; it is deleted" : "; they are deleted"),
        "the warnings on the welds say why");
  else
    add(Severity::warning,
        first + (untied.size() == 1 ? "; it is kept, with free ends" : "; they are kept, with free ends"),
        "the warnings on the welds say why; free ends carry no load and may fly off: SPOTSTP = 2 deletes such welds");
}

/// What is only taken for a weld, as its part or its material is missing, and is held by nothing: no word on its ends
/// helps before the deck has that part.
bool may_be_none(const model::Model& model, const Weld& weld) {
  return is_inferred(model, weld) &&
         std::none_of(weld.ends.begin(), weld.ends.end(), [](const Projection& p) { return p.tied; });
}

bool untracked(const Projection& p) {
  return p.projection_case == 0 && !p.tied;
}

/// Weld nodes that no contact tracks: a few are named, many are one finding a part.
void report_untracked_welds(const model::Model& model, const Ties& ties, Findings& findings) {
  constexpr std::size_t few = 3;
  std::size_t count = 0;
  std::map<Index, std::vector<const Weld*>> by_part;
  for (const Weld& weld : ties.welds) {
    if (std::none_of(weld.ends.begin(), weld.ends.end(), untracked) || may_be_none(model, weld)) continue;
    by_part[weld.part].push_back(&weld);
    ++count;
  }
  const auto is_tie = [](const model::Contact& contact) { return contact.tie(); };
  const bool any_tie = std::any_of(model.contacts.begin(), model.contacts.end(), is_tie);
  const std::string remedy =
      any_tie ? "put the weld's part on the tracked side (SURFA) of a *CONTACT_SPOTWELD"
              : "add a *CONTACT_SPOTWELD: SURFA the parts of the welds, SURFB the parts of the sheets";
  for (const auto& [part, welds] : by_part) {
    const Weld& first = *welds.front();
    if (count > few) {
      findings.warning(first.place, keyword_of(first),
                       fmt::format("{} {} of part {}, first {}, with no hold: {}", welds.size(),
                                   welds.size() == 1 ? "weld" : "welds", model.parts[part].id, name_weld(first),
                                   any_tie ? "no contact tracks their nodes" : "the deck has no tie contact"),
                       remedy);
      continue;
    }
    for (const Weld* weld : welds)
      for (const Projection& p : weld->ends)
        if (untracked(p))
          findings.warning(weld->place, keyword_of(*weld),
                           fmt::format("{}: {}: {}", name_weld(*weld), name_node(model, p.node), p.reason), remedy);
  }
}

std::string count_of(int nodes) {
  return fmt::format("{} node{} tied", nodes, nodes == 1 ? "" : "s");
}

void note_distances(const model::Model& model, const Ties& ties, Findings& findings) {
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    if (model.contacts[c].ties_what_touches()) continue;  // has a note of its own
    int count = 0, moved = 0, springs = 0;
    const Tie* farthest = nullptr;
    for (const Tie& tie : ties.ties) {
      if (tie.contact != static_cast<Index>(c)) continue;
      ++count;
      moved += tie.moved > 0.0;
      springs += tie.spring;
      if (!farthest || tie.gap > farthest->gap) farthest = &tie;
    }
    if (!farthest) continue;
    std::string text = count_of(count);
    if (springs > 0) text += springs == count ? " by springs" : fmt::format(" ({} by springs)", springs);
    if (springs < count && model.contacts[c].tie_by_springs())
      text += springs > 0 ? ", the others by the constraint that springs stand for"
                          : " by the constraint that springs stand for";
    if (moved > 0)
      text += fmt::format(", {} of them moved onto the mid-surface, at most by {:.4g} ({})", moved, farthest->moved,
                          name_node(model, farthest->node));
    else if (farthest->gap > 0.0)
      text += fmt::format(", none of them moved; the largest gap kept is {:.4g} ({})", farthest->gap,
                          name_node(model, farthest->node));
    else
      text += ", none of them moved";
    findings.note(model.contacts[c].place, name_contact(model.contacts[c]), text);
  }
}

/// A beam and a brick may have one number. Tables, pictures and options call a weld by its number alone.
void note_common_numbers(const Ties& ties, Findings& findings) {
  std::unordered_map<int, const Weld*> first_of;
  std::size_t common = 0;
  const Weld* example = nullptr;
  for (const Weld& weld : ties.welds) {
    // of other rigid welds and of rivets reading has warned
    if (weld.kind == Weld::Kind::rigid && weld.rigid != Weld::Rigid::nodal_body) continue;
    if (const auto [first, is_new] = first_of.emplace(weld.id, &weld); !is_new) {
      ++common;
      if (!example) example = &weld;
    }
  }
  if (!example) return;
  findings.note(
      example->place, keyword_of(*example),
      fmt::format("{} weld{} the number of another one: {} and {}{}. Tables, pictures and options call both weld {}",
                  common, common == 1 ? " has" : "s have", name_weld(*first_of.at(example->id)), name_weld(*example),
                  common == 1 ? "" : ", ...", example->id));
}

}  // namespace

std::string name_body(const model::RigidBody& body) {
  switch (body.origin) {
    case model::RigidBody::Origin::part: return fmt::format("rigid part {}", body.id);
    case model::RigidBody::Origin::nodal: return fmt::format("nodal rigid body {}", body.id);
    case model::RigidBody::Origin::weld: return fmt::format("generalized weld {}", body.id);
  }
  return {};
}

std::string name_segment(const model::Model& model, Index shell, Index part) {
  if (shell == none)
    return part == none ? "a segment of no element" : fmt::format("a face of part {}", model.parts[part].id);
  return fmt::format("shell {} of part {}", model.shells.id[shell], model.parts[model.shells.part[shell]].id);
}

std::vector<Index> carriers(const Tie& tie) {
  if (tie.by_area()) return tie.disc.nodes;
  std::vector<Index> nodes;
  for (int corner = 0; corner < 4; ++corner)
    if (std::abs(tie.weight[corner]) > no_weight) nodes.push_back(tie.segment[corner]);
  return nodes;
}

std::string describe(const model::Model& model, const Tie& tie) {
  const auto id = [&](int corner) { return model.nodes.id[tie.segment[corner]]; };
  std::string text =
      fmt::format("node {} on segment {} {} {} {} ({}), xi {:.6f} eta {:.6f}, moved {:.4g}", model.nodes.id[tie.node],
                  id(0), id(1), id(2), id(3), name_segment(model, tie.shell, tie.part), tie.xi, tie.eta, tie.moved);
  if (tie.moved == 0.0 && tie.gap > 0.0) text += fmt::format(", gap {:.4g} kept", tie.gap);
  if (tie.spring) text += ", by springs";
  if (!tie.rotations) text += ", translations only";
  if (tie.by_area())
    text += fmt::format(", by area: {} nodes under a disc of radius {:.4g}", tie.disc.nodes.size(), tie.disc.radius);
  return text;
}

std::string name_node(const model::Model& model, Index node) {
  const Vec3d& x = model.nodes.x[node];
  return fmt::format("node {} at ({:.6g}, {:.6g}, {:.6g})", model.nodes.id[node], x.x, x.y, x.z);
}

std::string name_contact(const model::Contact& contact) {
  std::string name = contact.keyword.starts_with('*') ? contact.keyword : '*' + contact.keyword;
  if (contact.id != 0) name += fmt::format(" {}", contact.id);
  return name;
}

void report_what_is_not_built(const model::Model& model, const model::Contact& contact,
                              const std::vector<ReferenceSegment>& segments, Findings& findings) {
  if (contact.birth > 0.0)
    findings.error(contact.place, name_contact(contact),
                   fmt::format("birth time {:.4g}: a tie of rotations that begins later is not built", contact.birth),
                   "leave BT blank, or tie translations alone (*CONTACT_TIED_NODES_TO_SURFACE); DT, the end of a tie, "
                   "is obeyed");
  std::set<Index> reported;
  for (const ReferenceSegment& s : segments) {
    const bool off_its_nodes = s.shell != none && std::abs(model.shells.offset(s.shell)) > 0.0;  // not: not a number
    if (!off_its_nodes || !reported.insert(s.part).second) continue;
    findings.warning(
        contact.place, name_contact(contact),
        fmt::format("the mid-surface of part {} lies {:.4g} off its nodes; ties go to the surface of the nodes",
                    model.parts[s.part].id, std::abs(model.shells.offset(s.shell))),
        "LS-DYNA does the same unless CNTCO is set; move the nodes into the mid-surface if that matters");
  }
}

void report_empty_side(const model::Contact& contact, bool reference_side, Findings& findings) {
  findings.warning(contact.place, name_contact(contact),
                   reference_side ? "the reference side (SURFB) has no shells or bricks: nothing is tied"
                                  : "the tracked side (SURFA) has no free nodes: nothing is tied",
                   reference_side ? "name the parts of the sheets" : "name the parts or nodes of the welds");
}

void report_rigid_tracked_nodes(const model::Model& model, const model::Contact& contact, const Surroundings& around,
                                const std::vector<Index>& nodes, Findings& findings) {
  if (nodes.empty()) return;
  findings.warning(
      contact.place, name_contact(contact),
      fmt::format("{} tracked nodes belong to rigid bodies and stay with them, untied; first {}, of {}", nodes.size(),
                  name_node(model, nodes.front()), name_body(model.rigid_bodies[around.rigid_body[nodes.front()]])),
      contact.kind == model::Contact::Kind::spotweld ? "take them off the tracked side (SURFA)"
                                                     : "take them off the tracked side (SURFA), make it the side of "
                                                       "the deformable sheet, or use the _OFFSET form, "
                                                       "whose springs hold bodies");
}

void report_second_tie(const model::Model& model, Index node, Index first, Index second, Findings& findings) {
  const model::Contact& contact = model.contacts[second];
  findings.warning(contact.place, name_contact(contact),
                   fmt::format("{} is in reach, but {} has tied it already: the first tie holds",
                               name_node(model, node), name_contact(model.contacts[first])),
                   "let one contact track the node and name both sheets in it");
}

void report_untied_nodes(const model::Model& model, const model::Contact& contact, const std::vector<Index>& nodes,
                         double distance, double tolerance, Findings& findings) {
  findings.warning(
      contact.place, name_contact(contact),
      fmt::format("{} tracked nodes without a weld found no segment in reach, first {}: the closest is {:.4g} away, "
                  "tolerance {:.4g}",
                  nodes.size(), name_node(model, nodes.front()), distance, tolerance),
      move_or_widen(distance, tolerance));
}

void check_segments(const model::Model& model, const Surroundings& around, const std::vector<Vec3d>& x,
                    std::vector<Tie>& ties, Findings& findings) {
  constrain_what_springs_stand_for(model, around, ties);
  std::vector<Index> tie_of(model.nodes.size(), none);
  for (std::size_t t = 0; t < ties.size(); ++t)
    if (!ties[t].spring) tie_of[ties[t].node] = static_cast<Index>(t);
  fall_back_on_springs(model, around, ties, tie_of, findings);
  report_hinges(model, around, ties, findings);
  report_tied_adhesive(model, x, ties, findings);
  note_rigid_sheets(model, around, ties, findings);
  warn_of_constrained_segments(model, around, ties, tie_of, findings);
  refuse_circles(model, ties, tie_of, findings);
}

/// A weld beam whose two nodes end in one place has no direction and no stable step: a run would end in its first
/// cycle.
static void refuse_beam_without_length(const Weld& weld, Findings& findings) {
  constexpr double nothing = 1e-9;  // of the diameter
  if (weld.kind != Weld::Kind::beam || weld.deleted || !(weld.length <= nothing * weld.diameter)) return;
  findings.error(weld.place, keyword_of(weld),
                 fmt::format("{} has no length where its nodes {} at the start, and so no time step", name_weld(weld),
                             weld.length_before > weld.length ? "have been moved to" : "stand"),
                 "give its nodes places of their own on two sheets; SPOTSTP = 2 deletes welds that are not tied");
}

void report_welds(const model::Model& model, const Ties& ties, Findings& findings) {
  std::vector<const Weld*> untied;
  for (const Weld& weld : ties.welds) {
    if (may_be_none(model, weld)) continue;
    for (const Projection& p : weld.ends) report_end(model, weld, p, findings);
    refuse_beam_without_length(weld, findings);
    const auto tracked = [](const Projection& p) { return p.projection_case != 0; };
    if (!weld.tied && std::any_of(weld.ends.begin(), weld.ends.end(), tracked)) untied.push_back(&weld);
  }
  report_untracked_welds(model, ties, findings);
  report_untied_welds(model, untied, findings);
  note_distances(model, ties, findings);
  note_common_numbers(ties, findings);
}

}  // namespace nugget::weld
