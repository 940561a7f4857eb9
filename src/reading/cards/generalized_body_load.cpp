// SPDX-License-Identifier: Apache-2.0
// *LOAD_BODY_GENERALIZED: base accelerations of a part of the model.
#include <algorithm>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct RegionCard {
  int first = 0, last = 0;  ///< a set is named by the first
  int lcid = 0, drlcid = 0;
};
CardOf<RegionCard> region_card(const FieldOf<RegionCard>& first, const FieldOf<RegionCard>& second) {
  return {
      first,
      second,
      {&RegionCard::lcid,
       within_range(id("lcid", IdSpace::function, required, "curve of the base acceleration over time"), at_least(1))},
      {&RegionCard::drlcid,
       id("drlcid", IdSpace::function, 0, "curve in dynamic relaxation; 0: lcid, if its SIDR is 1 or 2")},
      real("xc", dimension::length, 0, any_value, "centre of rotation, for angular motion"),
      real("yc", dimension::length, 0, any_value, "the same"),
      real("zc", dimension::length, 0, any_value, "the same"),
  };
}
const CardOf<RegionCard> node_range_card =
    region_card({&RegionCard::first, id("n1", IdSpace::node, required, "first node")},
                {&RegionCard::last, id("n2", IdSpace::node, required, "last node: those with ids from n1 to n2")});
const CardOf<RegionCard> node_set_card =
    region_card({&RegionCard::first, id("nsid", IdSpace::set, required, "node set")}, unused());
const CardOf<RegionCard> part_set_card =
    region_card({&RegionCard::first, id("psid", IdSpace::set, required, "part set")}, unused());

struct BodyMotionCard {
  double ax = 0, ay = 0, az = 0;
  int cid = 0;
};
const CardOf<BodyMotionCard> body_motion_card{
    {&BodyMotionCard::ax,
     real("ax", dimension::number, 0, any_value,
          "scale of the curve for the acceleration along x; the base accelerates, so positive pulls against x")},
    {&BodyMotionCard::ay, real("ay", dimension::number, 0, any_value, "along y")},
    {&BodyMotionCard::az, real("az", dimension::number, 0, any_value, "along z")},
    real("omx", dimension::number, 0, only(0), "angular motion about x: not built"),
    real("omy", dimension::number, 0, only(0), "about y: not built"),
    real("omz", dimension::number, 0, only(0), "about z: not built"),
    {&BodyMotionCard::cid, id("cid", IdSpace::define, 0, "coordinate system of these directions; 0: global axes")},
    text("angtyp", 10, "kind of angular motion"),
};

enum class Region { node_range, node_set, part_set };

const CardOf<RegionCard>& card_of(Region region) {
  return region == Region::node_range ? node_range_card : region == Region::node_set ? node_set_card : part_set_card;
}

std::vector<Index> nodes_in_range(Builder& builder, const RowOf<RegionCard>& row) {
  const auto& ids = builder.model.nodes.id;
  std::vector<Index> nodes;
  const auto first = std::lower_bound(ids.begin(), ids.end(), row->first);
  for (auto i = first; i != ids.end() && *i <= row->last; ++i) nodes.push_back(static_cast<Index>(i - ids.begin()));
  if (nodes.empty()) refuse(builder, row[&RegionCard::first], "there is no node from n1 to n2");
  return nodes;
}

/// The set's members; none where it is not defined or empty, which is reported there.
std::vector<Index> members(const Set<Index>* set) {
  return set ? set->members : std::vector<Index>{};
}

void make_load(Builder& b, Region region, const RowOf<RegionCard>& row, const RowOf<BodyMotionCard>& motion,
               const Vec3d& scales) {
  BodyLoad load;
  load.own_parts = true;
  load.direction = unit(scales);
  load.scale = norm(scales);
  load.curve = b.curve(row[&RegionCard::lcid]);
  load.relaxation_curve = b.curve(row[&RegionCard::drlcid]);
  if (const Index system = b.system(motion[&BodyMotionCard::cid]); system != none)
    load.direction = b.model.systems[system].axes.global(load.direction);
  switch (region) {
    case Region::node_range: load.nodes = nodes_in_range(b, row); break;
    case Region::node_set: load.nodes = members(b.node_set(row[&RegionCard::first])); break;
    case Region::part_set: load.parts = members(b.part_set(row[&RegionCard::first])); break;
  }
  if (!load.nodes.empty() || !load.parts.empty()) b.model.body_loads.push_back(std::move(load));
}

template <Region region>
void read_body_load(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const auto row = cursor.read(card_of(region));
    const auto motion = cursor.read(body_motion_card);
    const bool local = motion->cid != 0;
    const Vec3d scales =
        local ? Vec3d{motion->ax, motion->ay, motion->az} : direction(block, {motion->ax, motion->ay, motion->az});
    if (norm(scales) > 0.0)
      builder.defer(Phase::conditions, [=](Builder& b) { make_load(b, region, row, motion, scales); });
    else
      refuse(builder, motion[&BodyMotionCard::ax], "the load has no direction",
             "give the scales of the acceleration's components");
  }
}

template <Region region>
Keyword body_load_keyword(std::string_view name) {
  return {.name = name, .layout = {{{}, &card_of(region)}, {{}, &body_motion_card}}, .read = read_body_load<region>};
}

}  // namespace

std::vector<Keyword> generalized_body_load_keywords() {
  return {
      body_load_keyword<Region::node_range>("LOAD_BODY_GENERALIZED"),
      body_load_keyword<Region::node_set>("LOAD_BODY_GENERALIZED_SET_NODE"),
      body_load_keyword<Region::part_set>("LOAD_BODY_GENERALIZED_SET_PART"),
  };
}

}  // namespace nugget::reading
