// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

#include "base/index.hpp"
#include "deck/text.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *SENSOR_DEFINE_...: what is measured in a run.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

// ---- sensors. What is not built of one is said where it is used: many decks define sensors that nothing asks.

struct NodeSensorCard {
  int sensid = 0, node1 = 0, node2 = 0, vid = 0;
  std::string ctype;
};
const CardOf<NodeSensorCard> node_sensor_card{
    {&NodeSensorCard::sensid, id("sensid", IdSpace::other, required, "sensor")},
    {&NodeSensorCard::node1, id("node1", IdSpace::node, required, "node")},
    {&NodeSensorCard::node2, id("node2", IdSpace::node, 0, "node from which the first is seen; 0: none")},
    {&NodeSensorCard::vid,
     id("vid", IdSpace::define, 0, "*DEFINE_VECTOR along which it counts; 0: the amount of the vector")},
    unused(),
    {&NodeSensorCard::ctype, text("ctype", 10, "COORD place, VEL velocity, ACC acceleration; TEMP is not built")},
    text("setopt", 10, "of node sets only"),
};

/// The kind of a sensor, or of what is controlled, stands behind its id: it says what the other fields are.
struct SensorKindCard {
  std::string kind;
};
const CardOf<SensorKindCard> sensor_kind_card{
    unused(), {&SensorKindCard::kind, text("type", 10, "kind")}, unused(), unused(), unused(), unused(), unused(),
    unused()};

struct MiscSensorCard {
  int sensid = 0, i0 = 0, i1 = 0, i4 = 0;
  std::string mtype, word0, i2, i3;
};
const FieldOf<MiscSensorCard> misc_sensid{&MiscSensorCard::sensid, id("sensid", IdSpace::other, required, "sensor")},
    misc_type{&MiscSensorCard::mtype,
              text("mtype", 10, "TIME, CURVE, RIGIDBODY, BNDOUT, JNTSTG, RETRACTOR, SLIPRING; others are not built")};
const CardOf<MiscSensorCard> time_sensor_card{misc_sensid, misc_type},
    any_misc_sensor_card{misc_sensid,
                         misc_type,
                         text("i0", 10, "by MTYPE"),
                         text("i1", 10, "by MTYPE"),
                         text("i2", 10, "by MTYPE"),
                         text("i3", 10, "by MTYPE"),
                         text("i4", 10, "by MTYPE"),
                         text("i5", 10, "by MTYPE")},
    curve_sensor_card{misc_sensid,
                      misc_type,
                      {&MiscSensorCard::i0, id("i0", IdSpace::function, 0, "the curve, as older decks give it")},
                      {&MiscSensorCard::i1, id("i1", IdSpace::function, 0, "the curve")}},
    body_sensor_card{
        misc_sensid,
        misc_type,
        unused(),
        {&MiscSensorCard::i1, id("i1", IdSpace::part, 0, "part of a rigid body, or nodal body")},
        {&MiscSensorCard::i2, text("i2", 10, "TX, TY, TZ translation of its centre, RX, RY, RZ rotation")},
        {&MiscSensorCard::i3, text("i3", 10, "D displacement (TX, TY, TZ), V velocity, A acceleration")},
        {&MiscSensorCard::i4, integer("i4", 0, any_value, "0 global axes; 1, those of the body: not built")}},
    motion_sensor_card{misc_sensid,
                       misc_type,
                       unused(),
                       {&MiscSensorCard::i1,
                        id("i1", IdSpace::other, 0, "*BOUNDARY_PRESCRIBED_MOTION whose work is taken, as in bndout")}},
    stiffness_sensor_card{
        misc_sensid,
        misc_type,
        {&MiscSensorCard::word0, text("i0", 10, "PHI, THETA, PSI [degrees], PHIR, THETAR, PSIR")},
        {&MiscSensorCard::i1, id("i1", IdSpace::other, 0, "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED, as in jntforc")}},
    retractor_sensor_card{misc_sensid,
                          misc_type,
                          {&MiscSensorCard::word0, text("i0", 10, "PULLRATE (default), PULLOUT, FORCE")},
                          {&MiscSensorCard::i1, id("i1", IdSpace::other, 0, "*ELEMENT_SEATBELT_RETRACTOR")}},
    ring_sensor_card{misc_sensid,
                     misc_type,
                     {&MiscSensorCard::word0, text("i0", 10, "SLIP, FSB1, FSB2; WRAP, SKEW, FC and FN are not built")},
                     {&MiscSensorCard::i1, id("i1", IdSpace::other, 0, "*ELEMENT_SEATBELT_SLIPRING")}};

struct ForceSensorCard {
  int sensid = 0, typeid_ = 0, crd = 0;
  std::string ftype, vid;
};
const CardOf<ForceSensorCard> force_sensor_card{
    {&ForceSensorCard::sensid, id("sensid", IdSpace::other, required, "sensor")},
    {&ForceSensorCard::ftype,
     text("ftype", 10, "RWALL, SPC, PRESC-MOT, JOINT, CONTACT: as their history files have it; others are not built")},
    {&ForceSensorCard::typeid_, id("typeid", IdSpace::other, 0, "the wall, support, motion, joint or contact")},
    {&ForceSensorCard::vid, text("vid", 10,
                                 "X, Y, Z component, M amount; XMOMENT, YMOMENT, ZMOMENT, MMOMENT the same of the "
                                 "moment; a number: along this *DEFINE_VECTOR")},
    {&ForceSensorCard::crd, id("crd", IdSpace::define, 0, "coordinate system of the direction; 0: global axes")},
    unused(),
};

struct ElementSensorCard {
  int sensid = 0, elemid = 0;
  std::string etype, comp, ctype, layer;
  double sf = 0, pwr = 0;
};
const CardOf<ElementSensorCard> element_sensor_card{
    {&ElementSensorCard::sensid, id("sensid", IdSpace::other, required, "sensor")},
    {&ElementSensorCard::etype, text("etype", 10, "SOLID, SHELL, BEAM, DISC-ELE, SEATBELT; others are not built")},
    {&ElementSensorCard::elemid, id("elemid", IdSpace::element, 0, "element")},
    {&ElementSensorCard::comp, text("comp", 10,
                                    "of a stress XX YY ZZ XY YZ ZX, VM, HYDR, PRIN1 PRIN2 PRIN3, MAXS; of a beam's "
                                    "force AXIAL, SHEARS, SHEART")},
    {&ElementSensorCard::ctype,
     text("ctype", 10,
          "STRESS of bricks and shells, FORCE of beams, springs and belts, DLEN of springs and belts, FAIL")},
    {&ElementSensorCard::layer, text("layer", 10, "of a shell BOT lowest, TOP highest, or a number as in elout")},
    {&ElementSensorCard::sf, real("sf", dimension::number, 1, any_value, "the value is (SF v)^PWR")},
    {&ElementSensorCard::pwr, real("pwr", dimension::number, 1, any_value, "the same")},
};

struct FunctionSensorCard {
  int sensid = 0, func = 0;
  std::array<int, 6> sens{};
};
const CardOf<FunctionSensorCard> function_sensor_card = [] {
  CardOf<FunctionSensorCard> card{{&FunctionSensorCard::sensid, id("sensid", IdSpace::other, required, "sensor")},
                                  {&FunctionSensorCard::func, id("func", IdSpace::function, 0, "*DEFINE_FUNCTION")}};
  constexpr std::array<std::string_view, 6> names{"sens1", "sens2", "sens3", "sens4", "sens5", "sens6"};
  for (std::size_t i = 0; i < names.size(); ++i)
    card.add({at(&FunctionSensorCard::sens, i),
              or_negative(id(names[i], IdSpace::other, 0,
                             i == 0 ? "sensor that is its first argument; below 0, a number of them: not built"
                                    : "the same of the next argument"),
                          IdSpace::other)});
  return card;
}();

struct MathSensorCard {
  int sensid = 0;
  std::string calc;
  std::array<int, 6> sens{};
};
const CardOf<MathSensorCard> math_sensor_card = [] {
  CardOf<MathSensorCard> card{
      {&MathSensorCard::sensid, id("sensid", IdSpace::other, required, "sensor")},
      {&MathSensorCard::calc, text("calc", 10,
                                   "SUM, ABSSUM, MIN, MAX, MINMAG, MAXMAG, MULTIPLY, SQRE, SQRTSQRE, SQRT of the "
                                   "sensors")}};
  constexpr std::array<std::string_view, 6> names{"sens1", "sens2", "sens3", "sens4", "sens5", "sens6"};
  for (std::size_t i = 0; i < names.size(); ++i)
    card.add({at(&MathSensorCard::sens, i),
              or_negative(id(names[i], IdSpace::other, 0, "sensor; below 0: taken away (SUM), divided by (MULTIPLY)"),
                          IdSpace::other)});
  return card;
}();

Index add_sensor(Builder& b, const deck::Row& row, Sensor sensor) {
  const auto index = static_cast<Index>(b.model.sensors.size());
  b.sensors.add(sensor.id, index, row.place(), row.keyword(), "sensor", b.findings);
  b.model.sensors.push_back(std::move(sensor));
  return index;
}

void leave_fault(Builder& b, Index sensor, const deck::Entry& field, std::string text) {
  b.sensor_faults.emplace(sensor, std::pair{field, std::move(text)});
}

void read_node_sensor(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(node_sensor_card);
    const std::string type = deck::upper(row->ctype);
    Sensor sensor;
    sensor.id = row->sensid;
    sensor.quantity = type == "VEL"   ? Sensor::Quantity::velocity
                      : type == "ACC" ? Sensor::Quantity::acceleration
                                      : Sensor::Quantity::place;
    const Index index = add_sensor(builder, row, sensor);
    if (type != "VEL" && type != "COORD" && type != "ACC")
      leave_fault(builder, index, row[&NodeSensorCard::ctype], "of nodes COORD, VEL and ACC are measured");
    if (row->vid != 0 && row->node2 != 0)
      leave_fault(builder, index, row[&NodeSensorCard::vid],
                  "along a vector only one node is measured: which of two is taken from the other is not documented");
    builder.defer(Phase::conditions, [row, index](Builder& b) {
      Sensor& of = b.model.sensors[at(index)];
      of.node = {b.node(row[&NodeSensorCard::node1]), row->node2 == 0 ? none : b.node(row[&NodeSensorCard::node2])};
      if (row->vid == 0) return;
      if (const Vec3d* vector = b.vector(row[&NodeSensorCard::vid]); vector != nullptr && norm(*vector) > 0.0)
        of.direction = unit(*vector);
    });
  }
}

/// Unit vector of X, Y, Z (the last letter of `word`), or none.
std::optional<Vec3d> axis_of(char letter) {
  if (letter < 'X' || letter > 'Z') return {};
  return Vec3d{letter == 'X' ? 1.0 : 0.0, letter == 'Y' ? 1.0 : 0.0, letter == 'Z' ? 1.0 : 0.0};
}

/// Places in a list of the model of those that have an id.
template <class Item>
std::vector<Index> with_id(const std::vector<Item>& items, int id) {
  std::vector<Index> found;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].id == id) found.push_back(static_cast<Index>(i));
  return found;
}

void leave_body_motion(Builder& builder, const RowOf<MiscSensorCard>& row, Sensor& sensor, Index index) {
  const std::string which = deck::upper(row->i2), kind = deck::upper(row->i3);
  const auto axis = which.size() == 2 ? axis_of(which[1]) : std::nullopt;
  const bool turns = which.starts_with('R');
  if (!axis || (!turns && !which.starts_with('T')))
    return leave_fault(builder, index, row[&MiscSensorCard::i2], "expected TX, TY, TZ, RX, RY or RZ");
  if ((kind != "D" && kind != "V" && kind != "A") || (turns && kind == "D"))
    return leave_fault(builder, index, row[&MiscSensorCard::i3],
                       "expected D (of TX, TY, TZ), V or A: which angles rotations are is not documented");
  if (row->i4 != 0) return leave_fault(builder, index, row[&MiscSensorCard::i4], "axes of the body are not built");
  sensor.direction = *axis;
  using enum Sensor::Quantity;
  sensor.quantity = kind == "D"   ? displacement
                    : kind == "V" ? (turns ? turning : velocity)
                    : turns       ? turning_rate
                                  : acceleration;
  builder.sensor_sources[index] = [row, index](Builder& b) {
    if (row->i1 == 0) return leave_fault(b, index, row[&MiscSensorCard::i1], "names no rigid body");
    b.model.sensors[at(index)].body = find_body(b, row[&MiscSensorCard::i1]);
  };
}

void leave_joint_angle(Builder& builder, const RowOf<MiscSensorCard>& row, Sensor& sensor, Index index) {
  const std::string which = deck::upper(row->word0);
  static const std::map<std::string, std::pair<std::size_t, bool>> readings{
      {"PHI", {0, false}}, {"THETA", {1, false}}, {"PSI", {2, false}}, {"IPSI", {2, false}},
      {"PHIR", {0, true}}, {"THETAR", {1, true}}, {"PSIR", {2, true}}};
  const auto found = readings.find(which);
  if (found == readings.end())
    return leave_fault(builder, index, row[&MiscSensorCard::word0], "expected PHI, THETA, PSI, PHIR, THETAR or PSIR");
  sensor.quantity = Sensor::Quantity::joint_stiffness;
  sensor.axis = found->second.first;
  sensor.rate = found->second.second;
  builder.sensor_sources[index] = [row, index](Builder& b) {
    for (const Index i : with_id(b.model.joint_stiffnesses, row->i1))
      if (b.model.joint_stiffnesses[i].rotational) b.model.sensors[at(index)].sources = {i};
    if (b.model.sensors[at(index)].sources.empty())
      leave_fault(b, index, row[&MiscSensorCard::i1], "no *CONSTRAINED_JOINT_STIFFNESS_GENERALIZED has this id");
  };
}

void leave_belt_device(Builder& builder, const RowOf<MiscSensorCard>& row, Sensor& sensor, Index index, bool ring) {
  using enum Sensor::OfBelt;
  static const std::map<std::string, Sensor::OfBelt> of_ring{
      {"SLIP", slip}, {"FSB1", first_tension}, {"FSB2", second_tension}},
      of_retractor{{"", pull_out_rate}, {"PULLRATE", pull_out_rate}, {"PULLOUT", pull_out}, {"FORCE", reel_tension}};
  const auto& known = ring ? of_ring : of_retractor;
  const auto found = known.find(deck::upper(row->word0));
  if (found == known.end())
    return leave_fault(builder, index, row[&MiscSensorCard::word0],
                       ring ? "expected SLIP, FSB1 or FSB2" : "expected PULLRATE, PULLOUT or FORCE");
  sensor.quantity = Sensor::Quantity::belt;
  sensor.of_belt = found->second;
  builder.sensor_sources[index] = [row, index, ring](Builder& b) {
    b.model.sensors[at(index)].element = (ring ? b.slip_rings : b.retractors).find(row->i1);
    if (b.model.sensors[at(index)].element == none)
      leave_fault(b, index, row[&MiscSensorCard::i1], ring ? "no slip ring has this id" : "no retractor has this id");
  };
}

void read_misc_sensor(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const std::string type = deck::upper(Cursor(cursor).read(sensor_kind_card)->kind);
    const auto row = cursor.read(type == "CURVE"       ? curve_sensor_card
                                 : type == "RIGIDBODY" ? body_sensor_card
                                 : type == "BNDOUT"    ? motion_sensor_card
                                 : type == "JNTSTG"    ? stiffness_sensor_card
                                 : type == "RETRACTOR" ? retractor_sensor_card
                                 : type == "SLIPRING"  ? ring_sensor_card
                                 : type == "TIME"      ? time_sensor_card
                                                       : any_misc_sensor_card);
    Sensor sensor;
    sensor.id = row->sensid;
    if (type == "CURVE") sensor.quantity = Sensor::Quantity::curve;
    if (type == "BNDOUT") sensor.quantity = Sensor::Quantity::work_of_motion;
    const auto index = static_cast<Index>(builder.model.sensors.size());
    if (type == "RIGIDBODY") leave_body_motion(builder, row, sensor, index);
    if (type == "JNTSTG") leave_joint_angle(builder, row, sensor, index);
    const bool of_ring = type == "SLIPRING", of_belt = of_ring || type == "RETRACTOR";
    if (of_belt) leave_belt_device(builder, row, sensor, index, of_ring);
    add_sensor(builder, row, sensor);
    if (type == "CURVE") {
      if ((row->i0 != 0) == (row->i1 != 0))
        leave_fault(builder, index, row[&MiscSensorCard::i1], "expected one curve, in I1 (in I0 of older decks)");
      builder.defer(Phase::conditions, [row, index](Builder& b) {
        b.model.sensors[at(index)].curve = b.curve(row[row->i1 != 0 ? &MiscSensorCard::i1 : &MiscSensorCard::i0]);
      });
    } else if (type == "BNDOUT") {
      builder.sensor_sources[index] = [row, index](Builder& b) {
        b.model.sensors[at(index)].sources = with_id(b.model.motions, row->i1);
        if (row->i1 == 0 || b.model.sensors[at(index)].sources.empty())
          leave_fault(b, index, row[&MiscSensorCard::i1], "no *BOUNDARY_PRESCRIBED_MOTION_..._ID has this id");
      };
    } else if (type != "TIME" && type != "RIGIDBODY" && type != "JNTSTG" && !of_belt) {
      leave_fault(builder, index, row[&MiscSensorCard::mtype],
                  "TIME, CURVE, RIGIDBODY, BNDOUT, JNTSTG, RETRACTOR and SLIPRING are measured");
    }
  }
}

// ---- forces

void find_pushing(Builder& b, const RowOf<ForceSensorCard>& row, Index index) {
  Sensor& sensor = b.model.sensors[at(index)];
  const deck::Entry field = row[&ForceSensorCard::typeid_];
  const int id = row->typeid_;
  using enum Sensor::Pushing;
  switch (sensor.pushing) {
    case wall: sensor.sources = with_id(b.model.walls, id); break;
    case support: sensor.sources = with_id(b.model.spcs, id); break;
    case motion: sensor.sources = with_id(b.model.motions, id); break;
    case joint: sensor.sources = with_id(b.model.joints, id); break;
    case contact:
      for (const Index c : with_id(b.model.contacts, id))
        if (b.model.contacts[c].slides()) sensor.sources = {c};
  }
  if (id <= 0 || sensor.sources.empty())
    return leave_fault(b, index, field,
                       fmt::format("no {} has this id{}", deck::upper(row->ftype),
                                   sensor.pushing == support  ? ", of *BOUNDARY_SPC_..._ID"
                                   : sensor.pushing == motion ? ", of *BOUNDARY_PRESCRIBED_MOTION_..._ID"
                                   : sensor.pushing == contact
                                       ? ", of *CONTACT_..._ID; forces of ties and transducers are not measured"
                                       : ""));
  if (sensor.pushing == support && b.supports_of_bodies.contains(id))
    return leave_fault(b, index, field, "of nodes of rigid bodies the support's force is not known");
  sensor.system = b.turning_or_fixed_system(row[&ForceSensorCard::crd]);
}

void read_force_sensor(Builder& builder, const Block& block, const Options& options) {
  using enum Sensor::Pushing;
  static const std::map<std::string, Sensor::Pushing> kinds{
      {"RWALL", wall}, {"SPC", support}, {"PRESC-MOT", motion}, {"JOINT", joint}, {"CONTACT", contact}};
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(force_sensor_card);
    const std::string type = deck::upper(row->ftype), along = deck::upper(row->vid);
    Sensor sensor;
    sensor.id = row->sensid;
    const bool moment = along.size() == 7 && along.ends_with("MOMENT");
    sensor.quantity = moment ? Sensor::Quantity::moment : Sensor::Quantity::force;
    const char letter = along.size() == 1 || moment ? along[0] : ' ';
    const auto axis = axis_of(letter);
    if (axis) sensor.direction = *axis;
    const auto kind = kinds.find(type);
    if (kind != kinds.end()) sensor.pushing = kind->second;
    const Index index = add_sensor(builder, row, sensor);
    const bool number = !along.empty() && std::ranges::all_of(along, deck::is_digit);
    if (kind == kinds.end())
      leave_fault(builder, index, row[&ForceSensorCard::ftype],
                  "forces of RWALL, SPC, PRESC-MOT, JOINT and CONTACT are measured");
    else if (moment && (type == "RWALL" || type == "CONTACT"))
      leave_fault(builder, index, row[&ForceSensorCard::vid], "walls and contacts have forces only");
    else if (!axis && letter != 'M' && !number)
      leave_fault(builder, index, row[&ForceSensorCard::vid],
                  "expected X, Y, Z, M, XMOMENT, YMOMENT, ZMOMENT, MMOMENT or the number of a vector");
    else if (number && block.transform != nullptr)
      leave_fault(builder, index, row[&ForceSensorCard::vid],
                  "a vector's number here is not transformed with the include: write the sensor in the main file");
    builder.sensor_sources[index] = [row, index, number, along](Builder& b) {
      find_pushing(b, row, index);
      if (!number) return;
      const Index vector = b.vectors.find(std::stoi(along));
      if (vector == none || !(norm(b.vector_list[at(vector)]) > 0.0))
        return leave_fault(b, index, row[&ForceSensorCard::vid], "no *DEFINE_VECTOR of some length has this id");
      b.model.sensors[at(index)].direction = unit(b.vector_list[at(vector)]);
    };
  }
}

// ---- elements

int layers_of(const SectionShell& section) {
  return section.rule.empty() ? section.layers : static_cast<int>(section.rule.size());
}

/// What COMP and CTYPE say; false where such an element does not have it.
bool take_component(Sensor& sensor, const std::string& type, const std::string& component) {
  using enum Sensor::OfElement;
  static const std::map<std::string, std::pair<Sensor::OfElement, std::size_t>> stresses{
      {"XX", {stress, 0}},       {"YY", {stress, 1}},       {"ZZ", {stress, 2}},       {"XY", {stress, 3}},
      {"YZ", {stress, 4}},       {"ZX", {stress, 5}},       {"VM", {von_mises, 0}},    {"HYDR", {hydrostatic, 0}},
      {"PRIN1", {principal, 0}}, {"PRIN2", {principal, 1}}, {"PRIN3", {principal, 2}}, {"MAXS", {shear, 0}}};
  static const std::map<std::string, std::pair<Sensor::OfElement, std::size_t>> forces{
      {"AXIAL", {resultant, 0}}, {"SHEARS", {resultant, 1}}, {"SHEART", {resultant, 2}}};
  const auto take = [&](const auto& names) {
    const auto found = names.find(component);
    if (found == names.end()) return false;
    std::tie(sensor.of_element, sensor.component) = found->second;
    return true;
  };
  if (type == "FAIL") {
    sensor.of_element = failed;
    return true;
  }
  if (sensor.kind == ElementKind::discrete && (type == "FORCE" || type == "DLEN")) {
    sensor.of_element = type == "FORCE" ? force : elongation;
    return true;
  }
  if (sensor.kind == ElementKind::beam) return type == "FORCE" && take(forces);
  return sensor.kind != ElementKind::discrete && type == "STRESS" && take(stresses);
}

void leave_belt(Builder& builder, const RowOf<ElementSensorCard>& row, Sensor sensor) {
  const std::string type = deck::upper(row->ctype);
  sensor.quantity = Sensor::Quantity::belt;
  sensor.of_belt = type == "DLEN" ? Sensor::OfBelt::elongation : Sensor::OfBelt::tension;
  const Index index = add_sensor(builder, row, sensor);
  if (type != "DLEN" && type != "FORCE")
    leave_fault(builder, index, row[&ElementSensorCard::ctype], "of belts FORCE and DLEN are measured");
  builder.sensor_sources[index] = [row, index](Builder& b) {
    b.model.sensors[at(index)].element = b.belts.find(row->elemid);
    if (b.model.sensors[at(index)].element == none)
      leave_fault(b, index, row[&ElementSensorCard::elemid], "no belt has this id");
  };
}

void read_element_sensor(Builder& builder, const Block& block, const Options& options) {
  static const std::map<std::string, std::pair<ElementKind, Ids Builder::*>> kinds{
      {"SOLID", {ElementKind::solid, &Builder::solids}},
      {"SHELL", {ElementKind::shell, &Builder::shells}},
      {"BEAM", {ElementKind::beam, &Builder::beams}},
      {"DISC-ELE", {ElementKind::discrete, &Builder::discretes}}};
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(element_sensor_card);
    const std::string type = deck::upper(row->ctype), layer = deck::upper(row->layer);
    Sensor sensor;
    sensor.id = row->sensid;
    sensor.quantity = Sensor::Quantity::element;
    sensor.scale = row->sf;
    sensor.power = row->pwr;
    if (deck::upper(row->etype) == "SEATBELT") {
      leave_belt(builder, row, sensor);
      continue;
    }
    const auto kind = kinds.find(deck::upper(row->etype));
    if (kind != kinds.end()) sensor.kind = kind->second.first;
    const bool has_it = take_component(sensor, type, deck::upper(row->comp));
    const bool number = !layer.empty() && layer.size() < 4 && std::ranges::all_of(layer, deck::is_digit);
    sensor.layer = number ? std::stoi(layer) : layer == "TOP" ? -1 : 0;
    const Index index = add_sensor(builder, row, sensor);
    if (kind == kinds.end()) {
      leave_fault(builder, index, row[&ElementSensorCard::etype],
                  "of SOLID, SHELL, BEAM, DISC-ELE and SEATBELT is measured");
      continue;
    }
    if (!has_it)
      leave_fault(builder, index, row[&ElementSensorCard::ctype],
                  "STRESS of bricks and shells is measured (COMP XX to ZX, VM, HYDR, PRIN1 to PRIN3, MAXS), FORCE of "
                  "beams (AXIAL, SHEARS, SHEART) and springs, DLEN of springs, FAIL of all");
    if (sensor.kind == ElementKind::shell && type == "STRESS" && !number && !layer.empty() && layer != "BOT" &&
        layer != "TOP")
      leave_fault(builder, index, row[&ElementSensorCard::layer], "expected BOT, TOP or the number of a layer");
    builder.sensor_sources[index] = [row, index, ids = kind->second.second](Builder& b) {
      Sensor& of = b.model.sensors[at(index)];
      of.element = (b.*ids).find(row->elemid);
      if (of.element == none)
        return leave_fault(b, index, row[&ElementSensorCard::elemid],
                           fmt::format("no {} has this id", deck::upper(row->etype)));
      // Where the layer is not there, elout has none either.
      if (of.layer > 0 && of.kind == ElementKind::shell) {
        const Part& part = b.model.parts[b.model.shells.part[of.element]];
        const int layers = part.section == none ? 0 : layers_of(b.model.shell_sections[at(part.section)]);
        if (of.layer > layers)
          leave_fault(b, index, row[&ElementSensorCard::layer], fmt::format("the shell has {} layers", layers));
      }
    };
  }
}

// ---- of other sensors

void read_function_sensor(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(function_sensor_card);
    Sensor sensor;
    sensor.id = row->sensid;
    sensor.quantity = Sensor::Quantity::function;
    const Index index = add_sensor(builder, row, sensor);
    if (row->sens[0] < 0)
      leave_fault(builder, index, row[at(&FunctionSensorCard::sens, 0)],
                  "a number of sensors in further cards is not built: name up to six here");
    builder.sensor_sources[index] = [row, index](Builder& b) {
      Sensor& of = b.model.sensors[at(index)];
      of.function = b.functions.find(row->func);
      if (of.function == none)
        return leave_fault(b, index, row[&FunctionSensorCard::func], "no *DEFINE_FUNCTION has this id");
      for (std::size_t i = 0; i < row->sens.size() && row->sens[i] > 0; ++i) {
        const Index other = b.sensors.find(row->sens[i]);
        if (other == none)
          return leave_fault(b, index, row[at(&FunctionSensorCard::sens, i)],
                             fmt::format("sensor {} is not defined, or of a kind that is not built", row->sens[i]));
        of.terms.push_back({other, false});
      }
      const int wanted = b.model.functions[of.function].formula.arguments();
      if (wanted != static_cast<int>(of.terms.size()))
        leave_fault(b, index, row[&FunctionSensorCard::func],
                    fmt::format("the function takes {} arguments, and {} sensors are named", wanted, of.terms.size()));
    };
  }
}

void read_math_sensor(Builder& builder, const Block& block, const Options& options) {
  using enum Sensor::Calculation;
  static const std::map<std::string, Sensor::Calculation> calculations{
      {"SUM", sum},          {"ABSSUM", sum_of_amounts}, {"MIN", least},
      {"MAX", greatest},     {"MINMAG", least_amount},   {"MAXMAG", greatest_amount},
      {"MULTIPLY", product}, {"SQRE", squares},          {"SQRTSQRE", root_of_squares},
      {"SQRT", roots}};
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(math_sensor_card);
    Sensor sensor;
    sensor.id = row->sensid;
    sensor.quantity = Sensor::Quantity::calculation;
    const auto found = calculations.find(deck::upper(row->calc));
    if (found != calculations.end()) sensor.calculation = found->second;
    const Index index = add_sensor(builder, row, sensor);
    if (found == calculations.end())
      leave_fault(builder, index, row[&MathSensorCard::calc], "this calculation is not built");
    builder.defer(Phase::conditions, [row, index](Builder& b) {
      const Sensor::Calculation how = b.model.sensors[at(index)].calculation;
      for (std::size_t i = 0; i < row->sens.size(); ++i) {
        const int id = row->sens[i];
        if (id == 0) continue;
        const deck::Entry field = row[at(&MathSensorCard::sens, i)];
        if (id < 0 && how != sum && how != product)
          return leave_fault(b, index, field, "a sign has a meaning in SUM and MULTIPLY only");
        const Index other = b.sensors.find(std::abs(id));
        if (other == none)
          return leave_fault(b, index, field,
                             fmt::format("sensor {} is not defined, or of a kind that is not built", std::abs(id)));
        b.model.sensors[at(index)].terms.push_back({other, id < 0});
      }
      if (b.model.sensors[at(index)].terms.empty())
        leave_fault(b, index, row[at(&MathSensorCard::sens, 0)], "names no sensor");
    });
  }
}

}  // namespace

std::vector<Keyword> sensor_define_keywords() {
  const std::vector<std::string_view> title{"TITLE"};
  return {
      {.name = "SENSOR_DEFINE_NODE", .options = title, .layout = {{"", &node_sensor_card}}, .read = read_node_sensor},
      {.name = "SENSOR_DEFINE_MISC",
       .options = title,
       .layout = {{"MTYPE TIME", &time_sensor_card},
                  {"MTYPE CURVE", &curve_sensor_card},
                  {"MTYPE RIGIDBODY", &body_sensor_card},
                  {"MTYPE BNDOUT", &motion_sensor_card},
                  {"MTYPE JNTSTG", &stiffness_sensor_card},
                  {"MTYPE RETRACTOR", &retractor_sensor_card},
                  {"MTYPE SLIPRING", &ring_sensor_card}},
       .read = read_misc_sensor},
      {.name = "SENSOR_DEFINE_FORCE",
       .options = title,
       .layout = {{"", &force_sensor_card}},
       .read = read_force_sensor},
      {.name = "SENSOR_DEFINE_ELEMENT",
       .options = title,
       .layout = {{"", &element_sensor_card}},
       .read = read_element_sensor},
      {.name = "SENSOR_DEFINE_FUNCTION",
       .options = title,
       .layout = {{"", &function_sensor_card}},
       .read = read_function_sensor},
      {.name = "SENSOR_DEFINE_CALC-MATH",
       .options = title,
       .layout = {{"", &math_sensor_card}},
       .read = read_math_sensor},
  };
}

}  // namespace nugget::reading
