// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <string>

#include "base/index.hpp"
#include "deck/text.hpp"
#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/sensor.hpp"

// *SENSOR_SWITCH..., *TERMINATION_...: switches on what sensors measure, and what ends a run before its time.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;

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
    {&SwitchCard::tdelay, real("tdelay", dimension::time, 0, at_least(0), "it goes on and off so much later")},
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
  const auto index = static_cast<Index>(b.model.sensor_switches.size());
  b.sensor_switches.add(one.id, index, row.place(), row.keyword(), "sensor switch", b.findings);
  b.model.sensor_switches.push_back(std::move(one));
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
    if (block.transform != nullptr && (block.transform->length != 1.0 || block.transform->time != 1.0))
      refuse(builder, row[&SwitchCard::value], "its unit is that of the sensor, which FCTLEN and FCTTIM do not know",
             "write the switch in the main file");
    SensorSwitch one;
    one.id = row->switid;
    one.kind = type == "TIME" ? SensorSwitch::Kind::time : SensorSwitch::Kind::sensor;
    one.above = logic == "GT";
    one.value = row->value;
    one.window = row->timwin;
    one.delay = row->tdelay;
    const Index index = add_switch(builder, row, one);
    if (one.kind == SensorSwitch::Kind::sensor)
      builder.defer(Phase::conditions, [row, index](Builder& b) {
        const Index sensor = b.sensors.find(row->sensid);
        if (sensor == none)
          return refuse(b, row[&SwitchCard::sensid], "no sensor that is built has this id",
                        "*SENSOR_DEFINE_NODE, _FORCE, _ELEMENT, _MISC, _CALC-MATH and _FUNCTION are built");
        b.model.sensor_switches[at(index)].sensor = sensor;
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
        b.model.sensor_switches[at(index)].terms.push_back({other, row->swit[i] < 0});
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
      if (end.body != none || end.node != none) b.model.run_ends.push_back(end);
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
        check_asked_switch(b, field, end.of_switch);
        b.model.run_ends.push_back(end);
      }
    });
  }
}

/// Refuses what a sensor that a switch asks for does not measure, and sensors and switches that ask for themselves.
class Asked {
 public:
  Asked(Builder& b, const deck::Entry& field) : b_(b), field_(field) {}

  void of_switch(Index index, int depth = 0) {
    const SensorSwitch& one = b_.model.sensor_switches[at(index)];
    if (depth > deepest) return refuse_circle(fmt::format("switch {}", one.id));
    if (one.kind == SensorSwitch::Kind::sensor && one.sensor != none) of_sensor(one.sensor, 0);
    for (const SensorSwitch::Term& term : one.terms) of_switch(term.of, depth + 1);
  }

 private:
  static constexpr int deepest = 20;

  void of_sensor(Index index, int depth) {
    if (depth > deepest) return refuse_circle(fmt::format("sensor {}", b_.model.sensors[at(index)].id));
    if (const auto source = b_.sensor_sources.find(index); source != b_.sensor_sources.end()) {
      const auto find = std::move(source->second);
      b_.sensor_sources.erase(source);
      find(b_);
    }
    if (const auto fault = b_.sensor_faults.find(index); fault != b_.sensor_faults.end()) {
      const auto [field, text] = fault->second;
      b_.sensor_faults.erase(fault);
      refuse(b_, field, text, "measure something else");
    }
    for (const Sensor::Term& term : b_.model.sensors[at(index)].terms) of_sensor(term.sensor, depth + 1);
  }
  void refuse_circle(const std::string& what) {
    if (!refused_) refuse(b_, field_, what + " depends on itself", "break the circle");
    refused_ = true;
  }

  Builder& b_;
  deck::Entry field_;
  bool refused_ = false;
};

}  // namespace

void check_asked_switch(Builder& b, const deck::Entry& field, Index of_switch) {
  Asked(b, field).of_switch(of_switch);
}

std::vector<Keyword> sensor_keywords() {
  const std::vector<std::string_view> title{"TITLE"};
  return {
      {.name = "SENSOR_SWITCH", .options = title, .layout = {{"", &switch_card}}, .read = read_switch},
      {.name = "SENSOR_SWITCH_CALC-LOGIC", .options = title, .layout = {{"", &logic_card}}, .read = read_logic},
      {.name = "TERMINATION_NODE", .layout = {{"", &node_end_card}}, .read = read_end<false>},
      {.name = "TERMINATION_BODY", .layout = {{"", &body_end_card}}, .read = read_end<true>},
      {.name = "TERMINATION_SENSOR", .layout = {{"", &sensor_end_card}}, .read = read_sensor_end},
  };
}

}  // namespace nugget::reading
