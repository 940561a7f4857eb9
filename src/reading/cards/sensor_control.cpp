// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "deck/text.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/sensor.hpp"

// *SENSOR_CONTROL: what switches turn on and off during a run.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct ControlCard {
  int cntlid = 0, target = 0, timeoff = 0, nrep = 0, sidr = 0;
  std::string type, word;
};
CardOf<ControlCard> control_card(const FieldOf<ControlCard>& target, const FieldOf<ControlCard>& fourth,
                                 const FieldOf<ControlCard>& sixth) {
  return {
      {&ControlCard::cntlid, id("cntlid", IdSpace::other, 0, "number of the control in messages")},
      {&ControlCard::type,
       text("type", 10,
            "what is controlled: PRESC-MOT, SPC, PRESSURE, RWALL, CONTACT, JOINT, BELTRETRA, BELTPRET, ELESET; others "
            "are not built")},
      target,
      fourth,
      {&ControlCard::nrep, integer("nrep", 0, any_value, "-1: behind the last switch the first one again; 0 not")},
      sixth,
      {&ControlCard::sidr, integer("sidr", 0, any_value, "0: switches are looked at in the run only")},
      unused()};
}
const FieldOf<ControlCard> whole_target{&ControlCard::target,
                                        id("typeid", IdSpace::other, required, "its number, of _ID of its keyword")},
    no_offset{&ControlCard::timeoff, integer("timeoff", 0, any_value, "of PRESC-MOT and PRESSURE only")};
const CardOf<ControlCard>
    controlled_whole_card = control_card(whole_target, no_offset, unused()),
    controlled_curve_card = control_card(
        whole_target,
        {&ControlCard::timeoff, integer("timeoff", 0, between(0, 1), "1: the curve begins when it is turned on")},
        unused()),
    controlled_elements_card = control_card(
        {&ControlCard::target, id("typeid", IdSpace::set, 0, "element set; 0: all elements of the kind")},
        {&ControlCard::timeoff, integer("idiscl", 0, any_value, "of ESTYP DISC only")},
        {&ControlCard::word, text("estyp", 10, "elements that are deleted when it is turned off: SOLID, SHELL, BEAM")});

struct SwitchesCard {
  std::string initstt;
  std::array<int, 7> swit{};
};
const CardOf<SwitchesCard> switches_card = [] {
  CardOf<SwitchesCard> card{{&SwitchesCard::initstt, text("initstt", 10, "ON (default), OFF: how it starts")}};
  constexpr std::array<std::string_view, 7> names{"swit1", "swit2", "swit3", "swit4", "swit5", "swit6", "swit7"};
  for (std::size_t i = 0; i < names.size(); ++i)
    card.add({at(&SwitchesCard::swit, i), id(names[i], IdSpace::other, i == 0 ? required : 0,
                                             i == 0 ? "switch that changes how it starts, when it is on"
                                                    : "switch that changes what the one before "
                                                      "left, when it is on after that")});
  return card;
}();

struct ControlKindCard {
  std::string kind;
};
const CardOf<ControlKindCard> control_kind_card{
    unused(), {&ControlKindCard::kind, text("type", 10, "kind")}, unused(), unused(), unused(), unused(), unused(),
    unused()};

/// Both cards of a control, and its place in the model.
struct ControlCards {
  RowOf<ControlCard> row;
  RowOf<SwitchesCard> switches;
  Index index = none;
};

/// How often it may change.
bool changes_once(const SensorControl& control) {
  return control.switches.size() == 1 && !control.repeats;
}

void nothing_controlled(Builder& b, const ControlCards& of, std::string_view what) {
  refuse(b, of.row[&ControlCard::target], fmt::format("no {} has this id", what), "name one that is there");
}

void take_motions(Builder& b, const ControlCards& of) {
  bool any = false;
  const SensorControl& control = b.model.sensor_controls[of.index];
  for (std::size_t i = 0; i < b.model.motions.size(); ++i) {
    PrescribedMotion& motion = b.model.motions[i];
    if (motion.id != of.row->target) continue;
    any = true;
    motion.control = of.index;
    motion.from_switch = of.row->timeoff == 1;
    if (motion.quantity == PrescribedMotion::Quantity::displacement && !motion.from_switch &&
        !(control.starts_on && changes_once(control)))
      refuse(b, of.row[&ControlCard::timeoff],
             "a displacement that is turned on later would begin in the middle of its curve, with a jump",
             "write TIMEOFF 1: the curve begins when it is turned on");
    if (b.motions_of_held_bodies.contains(static_cast<Index>(i)))
      refuse(b, of.row[&ControlCard::target],
             "the body is held in this direction by its constraints, which the motion takes the place of for good",
             "free the body, and hold it by another motion");
  }
  if (!any) nothing_controlled(b, of, "*BOUNDARY_PRESCRIBED_MOTION_..._ID");
}

void take_supports(Builder& b, const ControlCards& of) {
  bool any = false;
  for (SinglePointConstraint& spc : b.model.spcs) {
    if (spc.id != of.row->target) continue;
    any = true;
    spc.control = of.index;
  }
  if (b.supports_of_bodies.contains(of.row->target))
    refuse(b, of.row[&ControlCard::target],
           "it holds nodes of a rigid body, whose constraints are not turned on and off",
           "control a *BOUNDARY_PRESCRIBED_MOTION_RIGID of velocity 0 in its place");
  else if (!any)
    nothing_controlled(b, of, "*BOUNDARY_SPC_..._ID");
}

void take_pressures(Builder& b, const ControlCards& of) {
  bool any = false;
  for (PressureLoad& load : b.model.pressure_loads) {
    if (load.id != of.row->target) continue;
    any = true;
    load.control = of.index;
    load.from_switch = of.row->timeoff == 1;
  }
  if (!any) nothing_controlled(b, of, "*LOAD_SEGMENT_..._ID or *LOAD_SHELL_..._ID");
}

void take_walls(Builder& b, const ControlCards& of) {
  const auto wall = std::ranges::find(b.model.walls, of.row->target, &RigidWall::id);
  if (wall == b.model.walls.end()) return nothing_controlled(b, of, "*RIGIDWALL_...");
  wall->control = of.index;
}

void take_contacts(Builder& b, const ControlCards& of) {
  const auto contact = std::ranges::find(b.model.contacts, of.row->target, &Contact::id);
  if (contact == b.model.contacts.end()) return nothing_controlled(b, of, "*CONTACT_..._ID");
  contact->control = of.index;
  if (!contact->slides() || contact->glue)
    refuse(b, of.row[&ControlCard::target],
           fmt::format("*{} ties, glues or only measures: it is not turned on and off", contact->keyword),
           "give the contact a death time DT");
  if (!changes_once(b.model.sensor_controls[of.index]))
    refuse(b, of.switches[at(&SwitchesCard::swit, 1)], "a contact is turned on or off once, not again",
           "write a contact for each time");
}

void take_joints(Builder& b, const ControlCards& of) {
  const auto joint = std::ranges::find(b.model.joints, of.row->target, &Joint::id);
  if (joint == b.model.joints.end()) return nothing_controlled(b, of, "*CONSTRAINED_JOINT_..._ID");
  joint->control = of.index;
  const SensorControl& control = b.model.sensor_controls[of.index];
  if (!control.starts_on || !changes_once(control))
    refuse(b, of.switches[&SwitchesCard::initstt],
           "a joint is turned off once and for good: one that closes later would snap by what it is open",
           "write ON and one switch");
}

/// One of a list of what acts once, by a sensor or by this.
template <class T>
void take_what_acts_once(Builder& b, const ControlCards& of, std::vector<T>& list, const char* keyword,
                         const char* once) {
  const auto found = std::ranges::find(list, of.row->target, &T::id);
  if (found == list.end()) return nothing_controlled(b, of, keyword);
  found->control = of.index;
  const SensorControl& control = b.model.sensor_controls[of.index];
  if (control.starts_on || !changes_once(control))
    refuse(b, of.switches[&SwitchesCard::initstt], once, "write OFF and one switch");
}

void take_retractors(Builder& b, const ControlCards& of) {
  take_what_acts_once(b, of, b.model.belts.retractors, "*ELEMENT_SEATBELT_RETRACTOR",
                      "a retractor locks once, when it is turned on");
}

void take_pretensioners(Builder& b, const ControlCards& of) {
  take_what_acts_once(b, of, b.model.belts.pretensioners, "*ELEMENT_SEATBELT_PRETENSIONER",
                      "a pretensioner acts once, when it is turned on");
}

/// Where the elements of one kind and their sets are found.
struct ControlledElements {
  ElementKind kind;
  std::string_view what_set;
  Ids Builder::*set_ids;
  std::vector<Set<Index>> Sets::*sets;
};

void take_elements(Builder& b, const ControlCards& of) {
  static const std::map<std::string, ControlledElements> kinds{
      {"SOLID", {ElementKind::solid, "solid set", &Builder::solid_sets, &Sets::solids}},
      {"SHELL", {ElementKind::shell, "shell set", &Builder::shell_sets, &Sets::shells}},
      {"BEAM", {ElementKind::beam, "beam set", &Builder::beam_sets, &Sets::beams}}};
  const SensorControl& control = b.model.sensor_controls[of.index];
  const auto kind = kinds.find(deck::upper(of.row->word));
  if (kind == kinds.end())
    return refuse(b, of.row[&ControlCard::word],
                  "expected SOLID, SHELL or BEAM; springs and thick shells are not built",
                  "name elements of one of these kinds");
  if (!control.starts_on || !changes_once(control))
    return refuse(b, of.switches[&SwitchesCard::initstt], "elements are deleted once and for good, when turned off",
                  "write ON and one switch");
  const auto& parts = kind->second.kind == ElementKind::solid   ? b.model.solids.part
                      : kind->second.kind == ElementKind::shell ? b.model.shells.part
                                                                : b.model.beams.part;
  std::vector<Index> members;
  if (of.row->target == 0) {
    for (std::size_t e = 0; e < parts.size(); ++e) members.push_back(static_cast<Index>(e));
  } else {
    const Index set = b.find(b.*kind->second.set_ids, kind->second.what_set, of.row[&ControlCard::target]);
    if (set == none) return;
    members = (b.model.sets.*kind->second.sets)[at(set)].members;
  }
  const auto is_weld = [&](Index part) {
    const Index material = part == none ? none : b.model.parts[part].material;
    return material != none && std::holds_alternative<kernel::Spotweld>(b.model.materials[material].law);
  };
  for (const Index element : members) {
    if (is_weld(parts[at(element)]))
      return refuse(b, of.row[&ControlCard::target], "it holds elements of spot welds, which switches do not delete",
                    "give welds a time by *DEFINE_ELEMENT_DEATH, or by TF of their material");
    b.model.element_deaths.push_back({kind->second.kind, element, forever, of.index});
  }
}

struct ControlledKind {
  void (*take)(Builder&, const ControlCards&);
  const CardOf<ControlCard>* card;
};
const std::map<std::string, ControlledKind>& controlled_kinds() {
  static const std::map<std::string, ControlledKind> kinds{{"PRESC-MOT", {take_motions, &controlled_curve_card}},
                                                           {"PRESSURE", {take_pressures, &controlled_curve_card}},
                                                           {"SPC", {take_supports, &controlled_whole_card}},
                                                           {"RWALL", {take_walls, &controlled_whole_card}},
                                                           {"CONTACT", {take_contacts, &controlled_whole_card}},
                                                           {"JOINT", {take_joints, &controlled_whole_card}},
                                                           {"BELTRETRA", {take_retractors, &controlled_whole_card}},
                                                           {"BELTPRET", {take_pretensioners, &controlled_whole_card}},
                                                           {"ELESET", {take_elements, &controlled_elements_card}}};
  return kinds;
}

/// What to do in place of a kind that is not built.
std::string_view remedy_of(const std::string& type) {
  static const std::map<std::string, std::string_view> remedies{
      {"AIRBAG", "let the curve of the gas's inflow begin at a time"},
      {"BAGVENTPOP", "give the vent its own pressure or time"},
      {"CNRB", "control a *CONSTRAINED_JOINT_LOCKING between two bodies"},
      {"CONSTRL", "control a *BOUNDARY_SPC_..._ID"},
      {"CURVE", "control the motion (PRESC-MOT) or the pressure (PRESSURE) that has the curve"},
      {"FUNCTION", "control the motion (PRESC-MOT) or the pressure (PRESSURE) that has the curve"},
      {"DEF2RIG", "leave the parts deformable"},
      {"JOINTSTIF", "control a *CONSTRAINED_JOINT_..._ID"},
      {"M PRESSURE", "write *LOAD_SEGMENT_SET_ID and control it (PRESSURE)"},
      {"MPRESSURE", "write *LOAD_SEGMENT_SET_ID and control it (PRESSURE)"},
      {"PRESC-ORI", "control motions of the body's rotations (PRESC-MOT)"},
      {"SPOTWELD", "give the weld a time TF, or loads at failure"}};
  const auto found = remedies.find(type);
  return found == remedies.end() ? "take it out" : found->second;
}

void take(Builder& b, const ControlCards& of) {
  SensorControl& control = b.model.sensor_controls[of.index];
  for (std::size_t i = 0; i < of.switches->swit.size(); ++i) {
    if (of.switches->swit[i] == 0) continue;
    const deck::Entry field = of.switches[at(&SwitchesCard::swit, i)];
    const Index found = b.sensor_switches.find(of.switches->swit[i]);
    if (found == none) {
      refuse(b, field, "no sensor switch has this id", "define it by *SENSOR_SWITCH");
      continue;
    }
    check_asked_switch(b, field, found);
    control.switches.push_back(found);
  }
  controlled_kinds().at(deck::upper(of.row->type)).take(b, of);
}

void read_control(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const std::string type = deck::upper(Cursor(cursor).read(control_kind_card)->kind);
    const auto kind = controlled_kinds().find(type);
    ControlCards of;
    of.row = cursor.read(kind == controlled_kinds().end() ? controlled_whole_card : *kind->second.card);
    of.switches = cursor.read(switches_card);
    if (kind == controlled_kinds().end()) {
      refuse(builder, of.row[&ControlCard::type],
             "this is not turned on and off: PRESC-MOT, SPC, PRESSURE, RWALL, CONTACT, JOINT, BELTRETRA, BELTPRET and "
             "ELESET are",
             remedy_of(type));
      continue;
    }
    if (kind->second.card != &controlled_curve_card)
      refuse_nonzero(builder, of.row[&ControlCard::timeoff], "only curves of PRESC-MOT and PRESSURE begin later",
                     "leave it 0");
    if (of.row->nrep != 0 && of.row->nrep != -1)
      refuse(builder, of.row[&ControlCard::nrep], "editions of the manual differ in how often this is",
             "write out the switches one after the other, or -1 for ever");
    refuse_nonzero(builder, of.row[&ControlCard::sidr], "switches in dynamic relaxation are not built", "leave it 0");
    const std::string start = deck::upper(of.switches->initstt);
    if (!start.empty() && start != "ON" && start != "OFF")
      refuse(builder, of.switches[&SwitchesCard::initstt], "expected ON or OFF");
    of.index = static_cast<Index>(builder.model.sensor_controls.size());
    SensorControl control;
    control.id = of.row->cntlid;
    control.what = of.row->target == 0 ? "elements" : fmt::format("{} {}", type, of.row->target);
    control.starts_on = start != "OFF";
    control.repeats = of.row->nrep == -1;
    control.place = of.row.place();
    builder.model.sensor_controls.push_back(std::move(control));
    // Behind what the conditions and rigid bodies leave for that phase.
    builder.defer(Phase::checks, [of](Builder& b) { b.defer(Phase::checks, [of](Builder& late) { take(late, of); }); });
  }
}

}  // namespace

std::vector<Keyword> sensor_control_keywords() {
  return {{.name = "SENSOR_CONTROL",
           .options = {"TITLE"},
           .layout = {{"PRESC-MOT, PRESSURE", &controlled_curve_card},
                      {"SPC, RWALL, CONTACT, JOINT, BELTRETRA, BELTPRET", &controlled_whole_card},
                      {"ELESET", &controlled_elements_card},
                      {"", &switches_card}},
           .read = read_control}};
}

}  // namespace nugget::reading
