// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "reading/bodies/rigid_bodies.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONSTRAINED_RIGID_BODY_STOPPERS.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct StopperCards {
  int pid = 0, lcmax = 0, lcmin = 0, psidmx = 0, psidmn = 0, lcvmnx = 0, dir = 0, vid = 0;
  double tb = 0, td = 0;
};
constexpr IntegerField bound(std::string_view name, std::string_view meaning) {
  return or_negative(id(name, IdSpace::function, 0, meaning), IdSpace::function);
}
const CardOf<StopperCards> stopper_card{
    {&StopperCards::pid, id("pid", IdSpace::part, required, "part of a rigid body")},
    {&StopperCards::lcmax, bound("lcmax",
                                 "curve over time: the greatest coordinate of its centre; below 0: the "
                                 "greatest displacement; 0: none")},
    {&StopperCards::lcmin, bound("lcmin", "the same of the least")},
    {&StopperCards::psidmx, id("psidmx", IdSpace::set, 0, "part set that stops with it: not built")},
    {&StopperCards::psidmn, id("psidmn", IdSpace::set, 0, "part set that stops with it: not built")},
    {&StopperCards::lcvmnx, id("lcvmnx", IdSpace::function, 0, "curve over time: the greatest speed; 0: none")},
    {&StopperCards::dir, integer("dir", required, between(1, 8),
                                 "direction 1 x, 2 y, 3 z, 4 the vector VID; rotation about 5 x, 6 y, 7 z, 8 VID")},
    {&StopperCards::vid, id("vid", IdSpace::define, 0, "*DEFINE_VECTOR of DIR 4 and 8")},
};
const CardOf<StopperCards> stopper_times_card{
    {&StopperCards::tb, real("tb", dimension::time, 0, at_least(0), "it acts from this time on")},
    {&StopperCards::td, real("td", dimension::time, 1e21, at_least(0), "up to this time")},
    unused(),
    real("stiff", dimension::number, 0, any_value, "of implicit runs: no effect"),
};

void add_stopper(Builder& b, const RowOf<StopperCards>& row, const RowOf<StopperCards>& times, Vec3d direction) {
  BodyStopper stop;
  stop.place = row.place();
  stop.body = find_body(b, row[&StopperCards::pid]);
  stop.birth = times->tb;
  stop.death = death_time(times->td);
  stop.rotation = row->dir > 4;
  if (row->dir == 4 || row->dir == 8) {
    const Vec3d* vector = row->vid == 0 ? nullptr : b.vector(row[&StopperCards::vid]);
    if (vector == nullptr || !(norm(*vector) > 0.0))
      return refuse(b, row[&StopperCards::vid], fmt::format("DIR {} needs a vector", row->dir),
                    "name a *DEFINE_VECTOR");
    direction = unit(*vector);
  }
  stop.direction = direction;
  bool known = true;
  const auto curve = [&](const deck::Entry& field) {
    if (field.value == 0.0) return none;
    const Index found = b.curves.find(std::abs(field.integer()));
    if (found == none) {
      refuse(b, field, fmt::format("curve {} is not defined", std::abs(field.integer())), "define it");
      known = false;
    }
    return found;
  };
  stop.most = {curve(row[&StopperCards::lcmax]), row->lcmax < 0};
  stop.least = {curve(row[&StopperCards::lcmin]), row->lcmin < 0};
  stop.fastest = curve(row[&StopperCards::lcvmnx]);
  if (!known || stop.body == none) return;
  if (stop.most.curve == none && stop.least.curve == none && stop.fastest == none)
    row[&StopperCards::lcmax].report(b.findings, Severity::warning, "no bound is given: it stops nothing",
                                     "give LCMAX, LCMIN or LCVMNX");
  else
    b.model.body_stoppers.push_back(stop);
}

void read_stoppers(Builder& builder, const Block& block, const Options&) {
  for (Cursor cursor(builder.deck, block, builder.findings); !at_end(cursor);) {
    const auto row = cursor.read(stopper_card);
    const auto times = cursor.read(stopper_times_card);
    for (const auto field : {&StopperCards::psidmx, &StopperCards::psidmn})
      refuse_nonzero(builder, row[field], "bodies that stop with another one are not built",
                     "give each body a stopper of its own");
    if (row->dir % 4 != 0) warn_of_global_axis(builder, block, row[&StopperCards::dir]);
    if (row->dir <= 4 && block.transform && block.transform->matrix != deck::Transform{}.matrix)
      for (const auto field : {&StopperCards::lcmax, &StopperCards::lcmin})
        if (const deck::Entry& curve = row[field]; curve.value > 0.0)
          curve.report(builder.findings, Severity::warning,
                       "bounds by coordinate are those of the main deck: they are not moved or turned with an included "
                       "file",
                       "write them as displacements (the curve's number below 0), or the card in the main file");
    const int along = row->dir > 4 ? row->dir - 4 : row->dir;
    const Vec3d axis{along == 1 ? 1.0 : 0.0, along == 2 ? 1.0 : 0.0, along == 3 ? 1.0 : 0.0};
    builder.defer(Phase::conditions, [=](Builder& b) { add_stopper(b, row, times, axis); });
  }
}

}  // namespace

std::vector<Keyword> stopper_keywords() {
  return {{.name = "CONSTRAINED_RIGID_BODY_STOPPERS",
           .layout = {{"", &stopper_card}, {"", &stopper_times_card}},
           .read = read_stoppers}};
}

}  // namespace nugget::reading
