// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONSTRAINED_JOINT_STIFFNESS_...: layouts as in the LS-DYNA manual, vol. I.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

constexpr Dimension force_per_length{1, 0, -2};

const Card stiffness_card{{
    id("jsid", IdSpace::other, required, "id of the stiffness"),
    id("pida", IdSpace::part, required, "rigid body A: a part or a nodal rigid body"),
    id("pidb", IdSpace::part, required, "rigid body B"),
    id("cida", IdSpace::define, required, "coordinate system of body A"),
    id("cidb", IdSpace::define, 0, "coordinate system of body B; 0: that of A"),
    integer("jid", 0, any_value, "joint; no effect, as friction does not depend on its force"),
    real("rps", dimension::number, 1, any_value, "no effect: for FS and FD only"),
}};

/// Fields of a rotation or translation, by axis.
struct Names {
  std::array<std::string_view, 3> load, damper, stiffness, friction, low, high;
};

const Card rotary_curves_card{{
    id("lcidph", IdSpace::function, 0, "curve: moment over the rotation about x [rad]"),
    id("lcidt", IdSpace::function, 0, "curve: about y"),
    id("lcidps", IdSpace::function, 0, "curve: about z"),
    id("dlcidph", IdSpace::function, 0, "curve: damping moment over the rate about x"),
    id("dlcidt", IdSpace::function, 0, "curve: about y"),
    id("dlcidps", IdSpace::function, 0, "curve: about z"),
}};
const Card rotary_friction_card{{
    real("esph", dimension::moment, 0, at_least(0), "stiffness of friction and stops about x, a radian"),
    real("fmph", dimension::moment, 0, at_least(0), "friction moment about x; 0: none; no curves"),
    real("est", dimension::moment, 0, at_least(0), "stiffness about y"),
    real("fmt", dimension::moment, 0, at_least(0), "friction moment about y"),
    real("esps", dimension::moment, 0, at_least(0), "stiffness about z"),
    real("fmps", dimension::moment, 0, at_least(0), "friction moment about z"),
}};
const Card rotary_stops_card{{
    real("nsaph", dimension::number, 0, any_value,
         "stop angle of negative rotation about x, its size [degrees]; 0: none"),
    real("psaph", dimension::number, 0, any_value, "stop angle of positive rotation about x"),
    real("nsat", dimension::number, 0, any_value, "negative, about y"),
    real("psat", dimension::number, 0, any_value, "positive, about y"),
    real("nsaps", dimension::number, 0, any_value, "negative, about z"),
    real("psaps", dimension::number, 0, any_value, "positive, about z"),
}};
constexpr Names rotary_names{{"lcidph", "lcidt", "lcidps"}, {"dlcidph", "dlcidt", "dlcidps"},
                             {"esph", "est", "esps"},       {"fmph", "fmt", "fmps"},
                             {"nsaph", "nsat", "nsaps"},    {"psaph", "psat", "psaps"}};

const Card sliding_curves_card{{
    id("lcidx", IdSpace::function, 0, "curve: force over the displacement along x"),
    id("lcidy", IdSpace::function, 0, "curve: along y"),
    id("lcidz", IdSpace::function, 0, "curve: along z"),
    id("dlcidx", IdSpace::function, 0, "curve: damping force over the rate along x"),
    id("dlcidy", IdSpace::function, 0, "curve: along y"),
    id("dlcidz", IdSpace::function, 0, "curve: along z"),
}};
const Card sliding_friction_card{{
    real("esx", force_per_length, 0, at_least(0), "stiffness of friction and stops along x"),
    real("ffx", dimension::force, 0, at_least(0), "friction force along x; 0: none; no curves"),
    real("esy", force_per_length, 0, at_least(0), "stiffness along y"),
    real("ffy", dimension::force, 0, at_least(0), "friction force along y"),
    real("esz", force_per_length, 0, at_least(0), "stiffness along z"),
    real("ffz", dimension::force, 0, at_least(0), "friction force along z"),
}};
const Card sliding_stops_card{{
    real("nsdx", dimension::length, 0, any_value, "stop of negative displacement along x, its size; 0: none"),
    real("psdx", dimension::length, 0, any_value, "stop of positive displacement along x"),
    real("nsdy", dimension::length, 0, any_value, "negative, along y"),
    real("psdy", dimension::length, 0, any_value, "positive, along y"),
    real("nsdz", dimension::length, 0, any_value, "negative, along z"),
    real("psdz", dimension::length, 0, any_value, "positive, along z"),
    real("fs", dimension::number, 0, only(0), "friction that depends on the joint's force"),
    real("fd", dimension::number, 0, only(0), "friction that depends on the joint's force"),
}};
constexpr Names sliding_names{{"lcidx", "lcidy", "lcidz"}, {"dlcidx", "dlcidy", "dlcidz"}, {"esx", "esy", "esz"},
                              {"ffx", "ffy", "ffz"},       {"nsdx", "nsdy", "nsdz"},       {"psdx", "psdy", "psdz"}};

struct Cards {
  Row main, curves, friction, stops;
};

Index rigid_body(Builder& b, const Row& row, std::string_view field) {
  const Index body = b.bodies.find(row.integer(field));
  if (body == none)
    refuse(b, row, field, fmt::format("part {} is not a rigid body", row.integer(field)),
           "give a part of *MAT_RIGID or a *CONSTRAINED_NODAL_RIGID_BODY");
  return body;
}

void add_stiffness(Builder& b, const Cards& cards, const Names& names, bool rotational) {
  JointStiffness s;
  s.id = cards.main.integer("jsid");
  s.rotational = rotational;
  s.place = cards.main.place();
  s.body = {rigid_body(b, cards.main, "pida"), rigid_body(b, cards.main, "pidb")};
  const Index a = b.turning_or_fixed_system(cards.main, "cida"), c = b.turning_or_fixed_system(cards.main, "cidb");
  if (s.body[0] == none || s.body[1] == none || a == none) return;
  if (s.body[0] == s.body[1]) return refuse(b, cards.main, "pidb", "both are the same rigid body");
  const Index systems[] = {a, c == none ? a : c};
  for (std::size_t side = 0; side < 2; ++side) {
    const CoordinateSystem& system = b.model.systems[static_cast<std::size_t>(systems[side])];
    s.origin[side] = system.origin;
    s.axes[side] = system.axes;
  }
  const double unit = rotational ? std::numbers::pi / 180.0 : 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    JointStiffness::Freedom& f = s.freedom[i];
    f.load = b.curve(cards.curves, names.load[i]);
    f.damper = b.curve(cards.curves, names.damper[i]);
    f.stiffness = cards.friction.real(names.stiffness[i]);
    f.friction = cards.friction.real(names.friction[i]);
    f.low_stop = unit * std::abs(cards.stops.real(names.low[i]));
    f.high_stop = unit * std::abs(cards.stops.real(names.high[i]));
    if (!(f.stiffness > 0.0) && (f.friction > 0.0 || f.low_stop > 0.0 || f.high_stop > 0.0))
      cards.friction.report(b.findings, Severity::warning, names.stiffness[i],
                            "without a stiffness there is neither friction nor a stop", "give the stiffness");
  }
  b.model.joint_stiffnesses.push_back(std::move(s));
}

void read_stiffness(Builder& b, const Block& block, const Card& curves, const Card& friction, const Card& stops,
                    const Names& names, bool rotational) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const Cards cards{cursor.read(stiffness_card), cursor.read(curves), cursor.read(friction), cursor.read(stops)};
    b.defer(Phase::conditions, [=, &names](Builder& later) { add_stiffness(later, cards, names, rotational); });
  }
}

void read_rotary(Builder& b, const Block& block, const Options&) {
  read_stiffness(b, block, rotary_curves_card, rotary_friction_card, rotary_stops_card, rotary_names, true);
}
void read_sliding(Builder& b, const Block& block, const Options&) {
  read_stiffness(b, block, sliding_curves_card, sliding_friction_card, sliding_stops_card, sliding_names, false);
}

}  // namespace

std::vector<Keyword> joint_stiffness_keywords() {
  return {
      {.name = "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED",
       .layout =
           {{"", &stiffness_card}, {"", &rotary_curves_card}, {"", &rotary_friction_card}, {"", &rotary_stops_card}},
       .read = read_rotary},
      {.name = "CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL",
       .layout =
           {{"", &stiffness_card}, {"", &sliding_curves_card}, {"", &sliding_friction_card}, {"", &sliding_stops_card}},
       .read = read_sliding},
      {.name = "CONSTRAINED_JOINT_STIFFNESS_*",
       .status = KeywordStatus::refused,
       .why = "of the stiffnesses of joints GENERALIZED and TRANSLATIONAL are built"},
  };
}

}  // namespace nugget::reading
