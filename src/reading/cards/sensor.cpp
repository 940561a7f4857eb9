// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/index.hpp"
#include "deck/text.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *SENSOR_DEFINE_..., *SENSOR_SWITCH..., *TERMINATION_...: what ends a run before its time.
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
    {&NodeSensorCard::ctype, text("ctype", 10, "COORD place, VEL velocity; ACC and TEMP are not built")},
    text("setopt", 10, "of node sets only"),
};

struct MiscSensorCard {
  int sensid = 0, first = 0;
  std::string mtype;
};
const CardOf<MiscSensorCard> misc_sensor_card{
    {&MiscSensorCard::sensid, id("sensid", IdSpace::other, required, "sensor")},
    {&MiscSensorCard::mtype, text("mtype", 10, "TIME; CURVE: the value of curve I0 at the time; others are not built")},
    {&MiscSensorCard::first, id("i0", IdSpace::function, 0, "of CURVE: the curve")},
};

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
  const auto index = static_cast<Index>(b.model.run_ends.sensors.size());
  b.sensors.add(sensor.id, index, row.place(), row.keyword(), "sensor", b.findings);
  b.model.run_ends.sensors.push_back(std::move(sensor));
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
    sensor.quantity = type == "VEL" ? Sensor::Quantity::velocity : Sensor::Quantity::place;
    const Index index = add_sensor(builder, row, sensor);
    if (type != "VEL" && type != "COORD")
      leave_fault(builder, index, row[&NodeSensorCard::ctype], "of nodes COORD and VEL are measured");
    if (row->vid != 0 && row->node2 != 0)
      leave_fault(builder, index, row[&NodeSensorCard::vid],
                  "along a vector only one node is measured: which of two is taken from the other is not documented");
    builder.defer(Phase::conditions, [row, index](Builder& b) {
      Sensor& of = b.model.run_ends.sensors[at(index)];
      of.node = {b.node(row[&NodeSensorCard::node1]), row->node2 == 0 ? none : b.node(row[&NodeSensorCard::node2])};
      if (row->vid == 0) return;
      if (const Vec3d* vector = b.vector(row[&NodeSensorCard::vid]); vector != nullptr && norm(*vector) > 0.0)
        of.direction = unit(*vector);
    });
  }
}

void read_misc_sensor(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(misc_sensor_card);
    const std::string type = deck::upper(row->mtype);
    Sensor sensor;
    sensor.id = row->sensid;
    if (type == "CURVE") sensor.quantity = Sensor::Quantity::curve;
    const Index index = add_sensor(builder, row, sensor);
    if (type == "CURVE")
      builder.defer(Phase::conditions, [row, index](Builder& b) {
        b.model.run_ends.sensors[at(index)].curve = b.curve(row[&MiscSensorCard::first]);
      });
    else if (type != "TIME")
      leave_fault(builder, index, row[&MiscSensorCard::mtype], "TIME and CURVE are measured");
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
      const Sensor::Calculation how = b.model.run_ends.sensors[at(index)].calculation;
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
        b.model.run_ends.sensors[at(index)].terms.push_back({other, id < 0});
      }
      if (b.model.run_ends.sensors[at(index)].terms.empty())
        leave_fault(b, index, row[at(&MathSensorCard::sens, 0)], "names no sensor");
    });
  }
}

// ---- switches

struct SwitchCard {
  int switid = 0, sensid = 0, filtrid = 0;
  std::string type, logic;
  double value = 0, timwin = 0, tdelay = 0;
};
const CardOf<SwitchCard> switch_card{
    {&SwitchCard::switid, id("switid", IdSpace::other, required, "switch")},
    {&SwitchCard::type, text("type", 10, "SENSOR (default); TIME: on after the time VALUE")},
    {&SwitchCard::sensid, id("sensid", IdSpace::other, 0, "sensor")},
    {&SwitchCard::logic, text("logic", 10, "LT (default) on below VALUE, GT above")},
    {&SwitchCard::value, real("value", dimension::number, 0, any_value, "bound, in the unit of what is measured")},
    {&SwitchCard::filtrid, id("filtrid", IdSpace::define, 0, "*DEFINE_FILTER: not built")},
    {&SwitchCard::timwin,
     real("timwin", dimension::time, 0, at_least(0), "so long the condition must hold without a break")},
    {&SwitchCard::tdelay, real("tdelay", dimension::time, 0, any_value, "delay: not built")},
};

struct LogicCard {
  int switid = 0;
  std::array<int, 7> swit{};
};
const CardOf<LogicCard> logic_card = [] {
  CardOf<LogicCard> card{{&LogicCard::switid, id("switid", IdSpace::other, required, "switch")}};
  constexpr std::array<std::string_view, 7> names{"swit1", "swit2", "swit3", "swit4", "swit5", "swit6", "swit7"};
  for (std::size_t i = 0; i < names.size(); ++i)
    card.add({at(&LogicCard::swit, i), or_negative(id(names[i], IdSpace::other, i == 0 ? required : 0,
                                                      "switch; from the second on above 0 AND, below 0 OR"),
                                                   IdSpace::other)});
  return card;
}();

Index add_switch(Builder& b, const deck::Row& row, SensorSwitch one) {
  const auto index = static_cast<Index>(b.model.run_ends.switches.size());
  b.sensor_switches.add(one.id, index, row.place(), row.keyword(), "sensor switch", b.findings);
  b.model.run_ends.switches.push_back(std::move(one));
  return index;
}

void read_switch(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(switch_card);
    const std::string type = deck::upper(row->type), logic = deck::upper(row->logic);
    if (!type.empty() && type != "SENSOR" && type != "TIME")
      refuse(builder, row[&SwitchCard::type], "expected SENSOR or TIME");
    if (!logic.empty() && logic != "LT" && logic != "GT") refuse(builder, row[&SwitchCard::logic], "expected LT or GT");
    refuse_nonzero(builder, row[&SwitchCard::filtrid], "filtered sensors are not built",
                   "leave it 0 and give a time TIMWIN");
    refuse_nonzero(builder, row[&SwitchCard::tdelay], "a delay is not built", "give a time TIMWIN");
    if (block.transform != nullptr && (block.transform->length != 1.0 || block.transform->time != 1.0))
      refuse(builder, row[&SwitchCard::value], "its unit is that of the sensor, which FCTLEN and FCTTIM do not know",
             "write the switch in the main file");
    SensorSwitch one;
    one.id = row->switid;
    one.kind = type == "TIME" ? SensorSwitch::Kind::time : SensorSwitch::Kind::sensor;
    one.above = logic == "GT";
    one.value = row->value;
    one.window = row->timwin;
    const Index index = add_switch(builder, row, one);
    if (one.kind == SensorSwitch::Kind::sensor)
      builder.defer(Phase::conditions, [row, index](Builder& b) {
        const Index sensor = b.sensors.find(row->sensid);
        if (sensor == none)
          return refuse(b, row[&SwitchCard::sensid], "no sensor that is built has this id",
                        "*SENSOR_DEFINE_NODE, _MISC (TIME, CURVE) and _CALC-MATH are built");
        b.model.run_ends.switches[at(index)].sensor = sensor;
      });
  }
}

void read_logic(Builder& builder, const Block& block, const Options& options) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(logic_card);
    SensorSwitch one;
    one.id = row->switid;
    one.kind = SensorSwitch::Kind::logic;
    const Index index = add_switch(builder, row, one);
    builder.defer(Phase::conditions, [row, index](Builder& b) {
      for (std::size_t i = 0; i < row->swit.size(); ++i) {
        if (row->swit[i] == 0) continue;
        const Index other = b.sensor_switches.find(std::abs(row->swit[i]));
        if (other == none)
          return refuse(b, row[at(&LogicCard::swit, i)],
                        fmt::format("switch {} is not defined", std::abs(row->swit[i])), "define it");
        b.model.run_ends.switches[at(index)].terms.push_back({other, row->swit[i] < 0});
      }
    });
  }
}

// ---- ends

struct EndCard {
  int target = 0, stop = 0;
  double maxc = 0, minc = 0;
};
CardOf<EndCard> end_card(const FieldOf<EndCard>& target, int most, std::string_view stop) {
  return {target,
          {&EndCard::stop, integer("stop", required, between(1, most), stop)},
          {&EndCard::maxc, real("maxc", dimension::length, 1e21, any_value, "the run ends above this")},
          {&EndCard::minc, real("minc", dimension::length, -1e21, any_value, "and below this")}};
}
const CardOf<EndCard> node_end_card = end_card({&EndCard::target, id("nid", IdSpace::node, required, "node")}, 4,
                                               "of its coordinates 1 x, 2 y, 3 z; 4, contact: not built");
const CardOf<EndCard> body_end_card =
    end_card({&EndCard::target, id("pid", IdSpace::part, required, "part of a rigid body")}, 4,
             "of its displacement 1 x, 2 y, 3 z, 4 the whole");

template <bool body>
void read_end(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(body ? body_end_card : node_end_card);
    if (!body && row->stop == 4)
      refuse(builder, row[&EndCard::stop], "an end by contact is not built", "give a coordinate");
    if (row->stop < 4) warn_of_global_axis(builder, block, row[&EndCard::stop]);
    builder.defer(Phase::conditions, [row](Builder& b) {
      RunEnd end;
      end.kind = body ? RunEnd::Kind::body : RunEnd::Kind::node;
      end.axis = row->stop - 1;
      end.most = row->maxc;
      end.least = row->minc;
      end.place = row.place();
      if constexpr (body)
        end.body = find_body(b, row[&EndCard::target]);
      else
        end.node = b.node(row[&EndCard::target]);
      if (end.body != none || end.node != none) b.model.run_ends.ends.push_back(end);
    });
  }
}

struct SensorEndCard {
  std::array<int, 8> swid{};
};
const CardOf<SensorEndCard> sensor_end_card = [] {
  CardOf<SensorEndCard> card;
  constexpr std::array<std::string_view, 8> names{"swid1", "swid2", "swid3", "swid4",
                                                  "swid5", "swid6", "swid7", "swid8"};
  for (std::size_t i = 0; i < names.size(); ++i)
    card.add({at(&SensorEndCard::swid, i), id(names[i], IdSpace::other, i == 0 ? required : 0,
                                              "sensor switch; the run ends when one of them is on")});
  return card;
}();

/// Refuses what a sensor that a switch asks for does not measure, and sensors and switches that ask for themselves.
class Asked {
 public:
  Asked(Builder& b, const deck::Entry& field) : b_(b), field_(field) {}

  void of_switch(Index index, int depth = 0) {
    const SensorSwitch& one = b_.model.run_ends.switches[at(index)];
    if (depth > deepest) return refuse_circle(fmt::format("switch {}", one.id));
    if (one.kind == SensorSwitch::Kind::sensor && one.sensor != none) of_sensor(one.sensor, 0);
    for (const SensorSwitch::Term& term : one.terms) of_switch(term.of, depth + 1);
  }

 private:
  static constexpr int deepest = 20;

  void of_sensor(Index index, int depth) {
    const Sensor& sensor = b_.model.run_ends.sensors[at(index)];
    if (depth > deepest) return refuse_circle(fmt::format("sensor {}", sensor.id));
    if (const auto fault = b_.sensor_faults.find(index); fault != b_.sensor_faults.end()) {
      const auto [field, text] = fault->second;
      b_.sensor_faults.erase(fault);
      refuse(b_, field, text, "end the run by something else");
    }
    for (const Sensor::Term& term : sensor.terms) of_sensor(term.sensor, depth + 1);
  }
  void refuse_circle(const std::string& what) {
    if (!refused_) refuse(b_, field_, what + " depends on itself", "break the circle");
    refused_ = true;
  }

  Builder& b_;
  deck::Entry field_;
  bool refused_ = false;
};

void read_sensor_end(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(sensor_end_card);
    builder.defer(Phase::checks, [row](Builder& b) {
      for (std::size_t i = 0; i < row->swid.size(); ++i) {
        if (row->swid[i] == 0) continue;
        const deck::Entry field = row[at(&SensorEndCard::swid, i)];
        RunEnd end;
        end.kind = RunEnd::Kind::sensor;
        end.of_switch = b.sensor_switches.find(row->swid[i]);
        end.place = row.place();
        if (end.of_switch == none) {
          refuse(b, field, "no sensor switch has this id", "define it by *SENSOR_SWITCH");
          continue;
        }
        Asked(b, field).of_switch(end.of_switch);
        b.model.run_ends.ends.push_back(end);
      }
    });
  }
}

}  // namespace

std::vector<Keyword> sensor_keywords() {
  const std::vector<std::string_view> title{"TITLE"};
  return {
      {.name = "SENSOR_DEFINE_NODE", .options = title, .layout = {{"", &node_sensor_card}}, .read = read_node_sensor},
      {.name = "SENSOR_DEFINE_MISC", .options = title, .layout = {{"", &misc_sensor_card}}, .read = read_misc_sensor},
      {.name = "SENSOR_DEFINE_CALC-MATH",
       .options = title,
       .layout = {{"", &math_sensor_card}},
       .read = read_math_sensor},
      {.name = "SENSOR_SWITCH", .options = title, .layout = {{"", &switch_card}}, .read = read_switch},
      {.name = "SENSOR_SWITCH_CALC-LOGIC", .options = title, .layout = {{"", &logic_card}}, .read = read_logic},
      {.name = "TERMINATION_NODE", .layout = {{"", &node_end_card}}, .read = read_end<false>},
      {.name = "TERMINATION_BODY", .layout = {{"", &body_end_card}}, .read = read_end<true>},
      {.name = "TERMINATION_SENSOR", .layout = {{"", &sensor_end_card}}, .read = read_sensor_end},
  };
}

}  // namespace nugget::reading
