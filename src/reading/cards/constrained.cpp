// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_...: rigid bodies out of nodes and parts. The cards wait in Builder::body_cards; rigid_bodies.cpp makes
// the bodies.
#include <fmt/format.h>

#include <algorithm>

#include "model/axes.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/rigid_constraint.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

const CardOf<NodalBodyCard> nodal_card{
    {&NodalBodyCard::pid, id("pid", IdSpace::part, required, "number of the body, as of a part")},
    {&NodalBodyCard::cid, id("cid", IdSpace::define, 0, "coordinate system of local motions")},
    {&NodalBodyCard::nsid, id("nsid", IdSpace::set, 0, "node set; 0: the one numbered as the body")},
    {&NodalBodyCard::pnode,
     or_negative(id("pnode", IdSpace::node, 0, "node at which the body is drawn"), IdSpace::node)},
    {&NodalBodyCard::iprt, integer("iprt", 0, between(0, 2), "output in rbdout")},
    integer("drflag", 0, only(0), "released translations: not built"),
    integer("rrflag", 0, only(0), "released rotations: not built"),
};
struct InertiaCard1 {
  double xc = 0, yc = 0, zc = 0, tm = 0;
  int ircs = 0, nodeid = 0;
};
const CardOf<InertiaCard1> inertia_card1{
    {&InertiaCard1::xc, real("xc", dimension::length, 0, any_value, "centre of mass: x")},
    {&InertiaCard1::yc, real("yc", dimension::length, 0, any_value, "y")},
    {&InertiaCard1::zc, real("zc", dimension::length, 0, any_value, "z")},
    {&InertiaCard1::tm, real("tm", dimension::mass, required, above_zero(), "mass")},
    {&InertiaCard1::ircs, integer("ircs", 0, between(0, 1), "1: the tensor is in local axes")},
    {&InertiaCard1::nodeid, id("nodeid", IdSpace::node, 0, "node at the centre of mass, instead of its coordinates")},
};
struct InertiaCard2 {
  double ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0;
};
const CardOf<InertiaCard2> inertia_card2{
    {&InertiaCard2::ixx,
     real("ixx", dimension::inertia, required, at_least(0), "tensor of inertia about the centre: xx")},
    {&InertiaCard2::ixy, real("ixy", dimension::inertia, 0, any_value, "xy")},
    {&InertiaCard2::ixz, real("ixz", dimension::inertia, 0, any_value, "xz")},
    {&InertiaCard2::iyy, real("iyy", dimension::inertia, required, at_least(0), "yy")},
    {&InertiaCard2::iyz, real("iyz", dimension::inertia, 0, any_value, "yz")},
    {&InertiaCard2::izz, real("izz", dimension::inertia, required, at_least(0), "zz")},
};
struct InertiaCard3 {
  double vtx = 0, vty = 0, vtz = 0, vrx = 0, vry = 0, vrz = 0;
};
const CardOf<InertiaCard3> inertia_card3{
    {&InertiaCard3::vtx, real("vtx", dimension::velocity, 0, any_value, "initial velocity along x")},
    {&InertiaCard3::vty, real("vty", dimension::velocity, 0, any_value, "along y")},
    {&InertiaCard3::vtz, real("vtz", dimension::velocity, 0, any_value, "along z")},
    {&InertiaCard3::vrx, real("vrx", dimension::rate, 0, any_value, "initial spin about x")},
    {&InertiaCard3::vry, real("vry", dimension::rate, 0, any_value, "about y")},
    {&InertiaCard3::vrz, real("vrz", dimension::rate, 0, any_value, "about z")},
};
struct InertiaCard4 {
  double xl = 0, yl = 0, zl = 0, xlip = 0, ylip = 0, zlip = 0;
  int cid = 0;
};
const CardOf<InertiaCard4> inertia_card4{
    {&InertiaCard4::xl, real("xl", dimension::number, 0, any_value, "local x axis: x")},
    {&InertiaCard4::yl, real("yl", dimension::number, 0, any_value, "y")},
    {&InertiaCard4::zl, real("zl", dimension::number, 0, any_value, "z")},
    {&InertiaCard4::xlip, real("xlip", dimension::number, 0, any_value, "vector in the local xy plane: x")},
    {&InertiaCard4::ylip, real("ylip", dimension::number, 0, any_value, "y")},
    {&InertiaCard4::zlip, real("zlip", dimension::number, 0, any_value, "z")},
    {&InertiaCard4::cid, id("cid", IdSpace::define, 0, "coordinate system, instead of these")},
};
const CardOf<ExtraNodesCard> extra_node_card{
    {&ExtraNodesCard::pid, id("pid", IdSpace::part, required, "part of *MAT_RIGID")},
    {&ExtraNodesCard::nodes, id("nid", IdSpace::node, required, "node that goes with it")},
    {&ExtraNodesCard::iflag, integer("iflag", 0, any_value, "mass of the node with a given inertia")},
};
const CardOf<ExtraNodesCard> extra_set_card{
    {&ExtraNodesCard::pid, id("pid", IdSpace::part, required, "part of *MAT_RIGID")},
    {&ExtraNodesCard::nodes, id("nsid", IdSpace::set, required, "nodes that go with it")},
    {&ExtraNodesCard::iflag, integer("iflag", 0, any_value, "mass of the nodes with a given inertia")},
};
const CardOf<MergeCard> merge_card{
    {&MergeCard::pidl, id("pidl", IdSpace::part, required, "lead body")},
    {&MergeCard::pidc, id("pidc", IdSpace::part, required, "body that is merged into it")},
    {&MergeCard::iflag, integer("iflag", 0, any_value, "0: a given inertia of the lead body holds for both")},
};
const CardOf<MergeCard> merge_set_card{
    {&MergeCard::pidl, id("pidl", IdSpace::part, required, "lead body")},
    {&MergeCard::pidc, id("pidc", IdSpace::set, required, "set of parts, whose bodies are merged into it")},
    {&MergeCard::iflag, integer("iflag", 0, any_value, "0: a given inertia of the lead body holds for all")},
};
struct SwitchedCard {
  int pid = 0, lrb = 0;
  std::string ptype;
};
CardOf<SwitchedCard> switched_card(IdSpace space) {
  return {
      {&SwitchedCard::pid, id("pid", space, required, "part, or set of parts, that is rigid from the start")},
      {&SwitchedCard::lrb, id("lrb", IdSpace::part, 0, "lead body into which it is merged: not built, 0")},
      {&SwitchedCard::ptype, text("ptype", 10, "PART or PSET: what pid is; blank: PART")},
  };
}
const CardOf<SwitchedCard> switched_part_card = switched_card(IdSpace::part);
const CardOf<SwitchedCard> switched_set_card = switched_card(IdSpace::set);
struct WeldIdCard {
  int wid = 0;
};
const CardOf<WeldIdCard> weld_id_card{
    {&WeldIdCard::wid, id("wid", IdSpace::other, 0, "number of the weld")},
};
constexpr RealField normal_strength =
    real("sn", dimension::force, 0, at_least(0), "normal force at failure; 0: left out");
constexpr RealField weld_shear_strength =
    real("ss", dimension::force, 0, at_least(0), "shear force at failure; 0: left out");
constexpr RealField normal_exponent = real("n", dimension::number, 0, at_least(0), "exponent of the normal force");
constexpr RealField shear_exponent = real("m", dimension::number, 0, at_least(0), "exponent of the shear force");
struct WeldCard1 {
  int nsid = 0, cid = 0, filter = 0;
  double window = 0;
};
const CardOf<WeldCard1> weld_card1{
    {&WeldCard1::nsid,
     id("nsid", IdSpace::set, required, "nodes that are welded together, in their order along the weld")},
    {&WeldCard1::cid,
     id("cid", IdSpace::define, 0, "coordinate system whose z is the normal direction; 0: first node to last")},
    {&WeldCard1::filter,
     integer("filter", 0, at_least(0), "force vectors that are averaged for failure; up to 1: none")},
    {&WeldCard1::window,
     real("window", dimension::time, 0, at_least(0), "time window of that average; 0: all FILTER vectors")},
    integer("npr", 0, any_value, "pairs of nodes for output"),
    integer("nprt", 0, any_value, "output in rbdout"),
};
struct StrengthCard {
  double tfail = 0, epsf = 0, sn = 0, ss = 0, n = 0, m = 0;
  int n1 = 0, n2 = 0;
  double tf = 0, ep = 0;
};
const CardOf<StrengthCard> weld_card2{
    {&StrengthCard::tfail, real("tfail", dimension::time, forever, at_least(0), "time of failure")},
    {&StrengthCard::epsf,
     real("epsf", dimension::number, 0, at_least(0), "plastic strain of the adjoining elements at failure; 0: none")},
    {&StrengthCard::sn, normal_strength},
    {&StrengthCard::ss, weld_shear_strength},
    {&StrengthCard::n, normal_exponent},
    {&StrengthCard::m, shear_exponent},
};
const CardOf<StrengthCard> spotweld_card{
    {&StrengthCard::n1, id("n1", IdSpace::node, required, "node 1")},
    {&StrengthCard::n2, id("n2", IdSpace::node, required, "node 2, at another place")},
    {&StrengthCard::sn, normal_strength},
    {&StrengthCard::ss, weld_shear_strength},
    {&StrengthCard::n, normal_exponent},
    {&StrengthCard::m, shear_exponent},
    {&StrengthCard::tf, real("tf", dimension::time, forever, at_least(0), "time of failure")},
    {&StrengthCard::ep,
     real("ep", dimension::number, forever, at_least(0), "plastic strain of the adjoining elements at failure")},
};
struct SpotweldFilterCard {
  int nf = 0;
  double tw = 0;
};
const CardOf<SpotweldFilterCard> spotweld_filter_card{
    {&SpotweldFilterCard::nf,
     integer("nf", 0, at_least(0), "force vectors that are averaged for failure; up to 1: none")},
    {&SpotweldFilterCard::tw,
     real("tw", dimension::time, 0, at_least(0), "time window of that average; 0: all NF vectors")},
};
struct RivetCard {
  int n1 = 0, n2 = 0;
  double tf = 0;
};
const CardOf<RivetCard> rivet_card{
    {&RivetCard::n1, id("n1", IdSpace::node, required, "node 1")},
    {&RivetCard::n2, id("n2", IdSpace::node, required, "node 2, at another place")},
    {&RivetCard::tf, real("tf", dimension::time, forever, at_least(0), "time of failure; 0: none")},
};

struct InterpolationCard1 {
  int icid = 0, dnid = 0, ddof = 0, ityp = 0;
};
const CardOf<InterpolationCard1> interpolation_card1{
    {&InterpolationCard1::icid, id("icid", IdSpace::other, 0, "number of the interpolation")},
    {&InterpolationCard1::dnid, id("dnid", IdSpace::node, required, "dependent node")},
    {&InterpolationCard1::ddof,
     integer("ddof", 123456, between(123, 123456), "its dependent degrees of freedom: 123456, or 123 (translations)")},
    unused(),
    {&InterpolationCard1::ityp, integer("ityp", 0, between(0, 1), "INID is 0 a node, 1 a node set")},
    integer("idnsw", 1, only(1), "switch of the explicit solution"),
    integer("fgm", 0, any_value, "output of the weights, no effect"),
};
/// The name space of INID depends on ITYP of the first card.
struct IndependentCard {
  int inid = 0, idof = 0;
  double twghtx = 0, twghty = 0, twghtz = 0, rwghtx = 0, rwghty = 0, rwghtz = 0;
};
CardOf<IndependentCard> independent_card(IdSpace space) {
  return {
      {&IndependentCard::inid, within_range(id("inid", space, required, "independent node, or set"), at_least(1))},
      {&IndependentCard::idof, integer("idof", 0, any_value, "its degrees of freedom: 123; rotations are not built")},
      {&IndependentCard::twghtx, real("twghtx", dimension::number, 1, above_zero(), "weight of its translation")},
      {&IndependentCard::twghty,
       real("twghty", dimension::number, 0, at_least(0), "along y; 0: as along x, and nothing else")},
      {&IndependentCard::twghtz,
       real("twghtz", dimension::number, 0, at_least(0), "along z; 0: as along x, and nothing else")},
      {&IndependentCard::rwghtx,
       real("rwghtx", dimension::number, 0, any_value, "weight of its rotation, no effect with IDOF 123")},
      {&IndependentCard::rwghty, real("rwghty", dimension::number, 0, any_value, "the same about y")},
      {&IndependentCard::rwghtz, real("rwghtz", dimension::number, 0, any_value, "the same about z")},
  };
}
const CardOf<IndependentCard> interpolation_node = independent_card(IdSpace::node);
const CardOf<IndependentCard> interpolation_set = independent_card(IdSpace::set);

// ---- nodal rigid bodies

void read_body_spc(Builder& builder, Cursor& cursor, BodyCards::Nodal& body) {
  using Card = RigidConstraintCard;
  const auto row = read_rigid_constraint(builder, cursor);
  if (row->cmo == 1.0) body.fixed = row->fixed_by_codes();
  if (row->cmo == -1.0) body.spc = row;
  for (const deck::Entry& field : {row[&Card::spcnid], row[&Card::xspc], row[&Card::yspc], row[&Card::zspc]})
    refuse_nonzero(builder, field, "a body is held at its centre of mass; another point is not built",
                   "leave it blank");
}

/// The local axes of the tensor as vectors on the card; a coordinate system is looked up when the bodies are made.
void take_axes(Builder& builder, Cursor& cursor, BodyCards::Nodal& body) {
  const auto row = cursor.read(inertia_card4);
  if (row->cid != 0) {
    body.axes = row[&InertiaCard4::cid];
    return;
  }
  Frame3d axes;
  const Block& block = cursor.block();
  if (!frame_from(direction(block, {row->xl, row->yl, row->zl}), direction(block, {row->xlip, row->ylip, row->zlip}),
                  axes))
    return refuse(builder, row[&InertiaCard4::xl], "the two vectors of the local axes are parallel or have no length",
                  "give a local x axis and another vector");
  body.inertia.inertia = to_global(body.inertia.inertia, axes);
}

void read_nodal_inertia(Builder& builder, const Block& block, Cursor& cursor, BodyCards::Nodal& body) {
  body.given = true;
  const auto row1 = cursor.read(inertia_card1);
  body.center_node = row1[&InertiaCard1::nodeid];
  body.inertia.center = position(block, {row1->xc, row1->yc, row1->zc});
  body.inertia.mass = row1->tm;
  const auto row2 = cursor.read(inertia_card2);
  body.inertia.inertia = {row2->ixx, row2->ixy, row2->ixz, row2->iyy, row2->iyz, row2->izz};
  const auto row3 = cursor.read(inertia_card3);
  refuse_in_mirror(builder, block, row1[&InertiaCard1::ircs],
                   "a tensor in local axes is not built in a file that *INCLUDE_TRANSFORM mirrors");
  for (const auto spin : {&InertiaCard3::vrx, &InertiaCard3::vry, &InertiaCard3::vrz})
    refuse_in_mirror(builder, block, row3[spin], turning_in_mirror);
  body.inertia.velocity = direction(block, {row3->vtx, row3->vty, row3->vtz});
  body.inertia.spin = direction(block, {row3->vrx, row3->vry, row3->vrz});
  if (row1->ircs == 1)
    take_axes(builder, cursor, body);
  else
    body.inertia.inertia = to_global(body.inertia.inertia, axes_of_include(block));
}

void read_nodal_body(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    BodyCards::Nodal body;
    body.title = read_title(cursor, options);
    const auto row = cursor.read(nodal_card);
    body.row = row;
    if (row->iprt == 2)
      row[&NodalBodyCard::iprt].report(builder.findings, Severity::warning, "rbdout lists this body all the same");
    if (options.contains("SPC")) read_body_spc(builder, cursor, body);
    if (options.contains("INERTIA")) read_nodal_inertia(builder, block, cursor, body);
    builder.body_cards.nodal.push_back(std::move(body));
  }
}

// ---- others

template <bool set>
void read_extra_nodes(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor))
    builder.body_cards.extra_nodes.push_back({set, cursor.read(set ? extra_set_card : extra_node_card)});
}

template <bool set>
void read_mergers(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) builder.body_cards.merges.push_back({set, cursor.read(set ? merge_set_card : merge_card)});
}

/// Before the rigid bodies are made: from there on the part is one of *MAT_RIGID with its own density and moduli.
void make_rigid(Builder& b, const RowOf<SwitchedCard>& row, Index p) {
  Part& part = b.model.parts[p];
  if (part.material == none) return;
  Material rigid = b.model.materials[part.material];
  if (std::holds_alternative<kernel::Spotweld>(rigid.law) || part.kind == ElementKind::discrete)
    return refuse(b, row[&SwitchedCard::pid],
                  fmt::format("part {} has welds or springs, which cannot be rigid", part.id), "take it out");
  if (std::holds_alternative<kernel::Rigid>(rigid.law)) return;
  rigid.law = kernel::Rigid{rigid.young(), rigid.poisson()};
  rigid.keyword = "MAT_RIGID";
  part.material = static_cast<Index>(b.model.materials.size());
  b.model.materials.push_back(std::move(rigid));
}

void read_switched(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const bool set = cursor.peek().find("PSET") != std::string::npos;
    const auto row = cursor.read(set ? switched_set_card : switched_part_card);
    if (const std::string& type = row->ptype; !set && !type.empty() && type != "PART")
      refuse(builder, row[&SwitchedCard::ptype], "expected PART or PSET", "leave it blank for a part");
    refuse_nonzero(builder, row[&SwitchedCard::lrb], "merging into a lead body here is not built",
                   "use *CONSTRAINED_RIGID_BODIES");
    builder.defer(Phase::sets, [row, set](Builder& b) {
      if (!set) {
        if (const Index part = b.part(row[&SwitchedCard::pid]); part != none) make_rigid(b, row, part);
      } else if (const Set<Index>* parts = b.part_set(row[&SwitchedCard::pid])) {
        for (const Index part : parts->members) make_rigid(b, row, part);
      }
    });
  }
}

// ---- rigid welds

/// SN SS N M. A strength without an exponent would be reached at once.
void take_strength(Builder& builder, const RowOf<StrengthCard>& row, RigidWeld& weld) {
  const auto take = [&](const deck::Entry& force, const deck::Entry& exponent, double& strength, double& power) {
    if (force.value <= 0.0 || force.value >= forever) return;
    strength = force.value;
    power = exponent.value;
    if (!(power > 0.0))
      refuse(builder, exponent, fmt::format("the exponent that goes with {} must be more than 0", force.field),
             "give 1 for a straight and 2 for a round failure curve");
  };
  take(row[&StrengthCard::sn], row[&StrengthCard::n], weld.normal_strength, weld.normal_exponent);
  take(row[&StrengthCard::ss], row[&StrengthCard::m], weld.shear_strength, weld.shear_exponent);
}

/// LS-DYNA's 0 and 1e20 both mean that there is no such failure; ours is 0.
double weld_failure_value(double written) {
  return written >= forever ? 0.0 : written;
}

void read_weld_spot(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    BodyCards::Weld weld;
    weld.weld.kind = RigidWeld::Kind::generalized;
    if (options.contains("ID")) weld.weld.id = cursor.read(weld_id_card)->wid;
    const auto row = cursor.read(weld_card1);
    weld.weld.place = row.place();
    weld.first = row[&WeldCard1::nsid];
    weld.second = row[&WeldCard1::cid];
    weld.weld.filter = row->filter;
    weld.weld.window = row->window;
    const auto failure = cursor.read(weld_card2);
    weld.weld.failure_time = weld_failure_value(failure->tfail);
    weld.weld.failure_strain = weld_failure_value(failure->epsf);
    take_strength(builder, failure, weld.weld);
    builder.body_cards.add(std::move(weld));
  }
}

void read_spotweld(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    BodyCards::Weld weld;
    weld.weld.kind = RigidWeld::Kind::spotweld;
    if (options.contains("ID")) weld.weld.id = cursor.read(weld_id_card)->wid;
    const auto row = cursor.read(spotweld_card);
    weld.weld.place = row.place();
    weld.first = row[&StrengthCard::n1];
    weld.second = row[&StrengthCard::n2];
    weld.weld.failure_time = weld_failure_value(row->tf);
    weld.weld.failure_strain = weld_failure_value(row->ep);
    take_strength(builder, row, weld.weld);
    if (options.contains("FILTERED_FORCE")) {
      const auto filter = cursor.read(spotweld_filter_card);
      weld.weld.filter = filter->nf;
      weld.weld.window = filter->tw;
    }
    builder.body_cards.add(std::move(weld));
  }
}

void make_rivet(Builder& b, const RowOf<RivetCard>& row, int id) {
  RigidWeld rivet;
  rivet.kind = RigidWeld::Kind::rivet;
  rivet.nodes = {b.node(row[&RivetCard::n1]), b.node(row[&RivetCard::n2])};
  rivet.failure_time = weld_failure_value(row->tf);
  rivet.place = row.place();
  rivet.id = id;  // 0: reading/bodies/weld_numbers.hpp
  if (rivet.nodes[0] == none || rivet.nodes[1] == none) return;
  const auto place = [&](std::size_t end) { return b.model.nodes.x[rivet.nodes[end]]; };
  if (norm(place(1) - place(0)) == 0.0)
    return refuse(b, row[&RivetCard::n2], "both nodes are at one place, so the rivet has no direction",
                  "move one of them, or use *CONSTRAINED_GENERALIZED_WELD_SPOT for such nodes");
  b.model.rigid_welds.push_back(std::move(rivet));
}

void read_rivet(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (!at_end(cursor)) {
    const int id = options.contains("ID") ? cursor.read(weld_id_card)->wid : 0;
    const auto row = cursor.read(rivet_card);
    builder.defer(Phase::conditions, [row, id](Builder& later) { make_rivet(later, row, id); });
  }
}

// ---- interpolation

/// The nodes of one row, with their weight.
void take_independent(Builder& b, const RowOf<InterpolationCard1>& head, const RowOf<IndependentCard>& row,
                      Interpolation& out) {
  for (const deck::Entry& weight : {row[&IndependentCard::twghty], row[&IndependentCard::twghtz]})
    if (weight.value != 0.0 && weight.value != row->twghtx)
      refuse(b, weight, "weights that differ between the directions are not built", "leave it blank");
  if (row->idof > 123)
    refuse(b, row[&IndependentCard::idof], "rotations of the independent nodes have no part in this average",
           "write 123");
  if (row->idof == 0)
    for (const deck::Entry& weight :
         {row[&IndependentCard::rwghtx], row[&IndependentCard::rwghty], row[&IndependentCard::rwghtz]})
      refuse_nonzero(b, weight, "rotations of the independent nodes have no part in this average",
                     "write 123 in IDOF, or leave it blank");
  const auto add = [&](Index node) {
    out.independent.push_back(node);
    out.weight.push_back(row->twghtx);
  };
  if (head->ityp == 1) {
    if (const Set<Index>* set = b.node_set(row[&IndependentCard::inid]))
      std::for_each(set->members.begin(), set->members.end(), add);
  } else if (const Index node = b.node(row[&IndependentCard::inid]); node != none) {
    add(node);
  }
}

/// Whether the nodes determine a rotation: they must not lie on a line.
bool on_a_line(const Model& model, const Interpolation& i) {
  Vec3d centre;
  const auto place = [&](std::size_t k) { return model.nodes.x[i.independent[k]]; };
  for (std::size_t k = 0; k < i.weight.size(); ++k) centre += i.weight[k] * place(k);
  double across = 0.0, size = 0.0;
  for (std::size_t k = 0; k < i.weight.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      const Vec3d a = place(k) - centre, b = place(l) - centre;
      across = std::max(across, norm(cross(a, b)));
      size = std::max({size, dot(a, a), dot(b, b)});
    }
  return !(across > 1e-6 * size);
}

void make_interpolation(Builder& b, const RowOf<InterpolationCard1>& head,
                        const std::vector<RowOf<IndependentCard>>& rows) {
  Interpolation out;
  out.id = head->icid;
  out.node = b.node(head[&InterpolationCard1::dnid]);
  out.place = head.place();
  const int ddof = head->ddof;
  out.rotations = ddof == 123456;
  if (ddof != 123 && ddof != 123456)
    refuse(b, head[&InterpolationCard1::ddof],
           "some degrees of freedom of a node cannot be interpolated without the others",
           "write 123456, or 123 for its translations");
  const int errors = b.findings.errors();
  for (const auto& row : rows) take_independent(b, head, row, out);
  if (out.node == none || b.findings.errors() > errors) return;
  double sum = 0.0;
  for (const double w : out.weight) sum += w;
  for (double& w : out.weight) w /= sum;
  if (std::find(out.independent.begin(), out.independent.end(), out.node) != out.independent.end())
    return refuse(b, head[&InterpolationCard1::dnid], "is among its own independent nodes", "take it out of them");
  if (out.weight.size() < 3 || on_a_line(b.model, out))
    return refuse(b, head[&InterpolationCard1::icid], "the independent nodes lie on a line, so they define no rotation",
                  "give three or more that do not");
  b.model.interpolations.push_back(std::move(out));
}

void read_interpolation(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto head = cursor.read(interpolation_card1);
  std::vector<RowOf<IndependentCard>> rows;
  while (!at_end(cursor)) rows.push_back(cursor.read(head->ityp == 1 ? interpolation_set : interpolation_node));
  builder.defer(Phase::conditions, [head, rows](Builder& later) { make_interpolation(later, head, rows); });
}

}  // namespace

std::vector<Keyword> constrained_keywords() {
  const auto refused = [](std::string_view name, std::string_view why) {
    return Keyword{.name = name,
                   .options = {"ID", "TITLE", "LOCAL", "FILTERED_FORCE"},
                   .status = KeywordStatus::refused,
                   .why = why,
                   .read = nullptr};
  };
  return {
      {.name = "CONSTRAINED_NODAL_RIGID_BODY",
       .options = {"SPC", "INERTIA", "TITLE"},
       .layout = {{"with _TITLE", &title_card},
                  {{}, &nodal_card},
                  {"with _SPC, if CMO is 0 or 1", &rigid_constraint_card},
                  {"with _SPC, if CMO is -1", &rigid_constraint_local_card},
                  {"with _INERTIA", &inertia_card1},
                  {"with _INERTIA", &inertia_card2},
                  {"with _INERTIA", &inertia_card3},
                  {"with _INERTIA, if IRCS = 1", &inertia_card4}},
       .read = read_nodal_body},
      {.name = "CONSTRAINED_EXTRA_NODES_NODE", .layout = {{{}, &extra_node_card}}, .read = read_extra_nodes<false>},
      {.name = "CONSTRAINED_EXTRA_NODES_SET", .layout = {{{}, &extra_set_card}}, .read = read_extra_nodes<true>},
      {.name = "CONSTRAINED_RIGID_BODIES", .layout = {{{}, &merge_card}}, .read = read_mergers<false>},
      {.name = "CONSTRAINED_RIGID_BODIES_SET", .layout = {{{}, &merge_set_card}}, .read = read_mergers<true>},
      {.name = "DEFORMABLE_TO_RIGID", .layout = {{{}, &switched_part_card}}, .read = read_switched},
      {.name = "CONSTRAINED_GENERALIZED_WELD_SPOT",
       .options = {"ID"},
       .layout = {{"with _ID", &weld_id_card}, {{}, &weld_card1}, {{}, &weld_card2}},
       .read = read_weld_spot},
      {.name = "CONSTRAINED_INTERPOLATION",
       .layout = {{{}, &interpolation_card1}, {"for each independent node or set", &interpolation_node}},
       .read = read_interpolation},
      {.name = "CONSTRAINED_SPOTWELD",
       .options = {"ID", "FILTERED_FORCE"},
       .layout = {{"with _ID", &weld_id_card}, {{}, &spotweld_card}, {"with _FILTERED_FORCE", &spotweld_filter_card}},
       .read = read_spotweld},
      {.name = "CONSTRAINED_RIVET",
       .options = {"ID"},
       .layout = {{"with _ID", &weld_id_card}, {{}, &rivet_card}},
       .read = read_rivet},

      refused("CONSTRAINED_INTERPOLATION_LOCAL",
              "weights in local axes are not built; give weights that are the same in all directions"),
      refused("CONSTRAINED_TIE_BREAK",
              "edges that are tied along a line until they tear are not built; mesh them node on node and use "
              "*CONSTRAINED_TIED_NODES_FAILURE"),
      refused("CONSTRAINED_NODE_INTERPOLATION", "nodes interpolated between others are not built"),
      refused("CONSTRAINED_LINEAR*", "this form is not built; *CONSTRAINED_LINEAR_GLOBAL and _LOCAL are"),
      refused("CONSTRAINED_SHELL_TO_SOLID",
              "fibres of solid nodes tied to a shell's edge are not built; use *CONTACT_TIED_SHELL_EDGE_TO_SURFACE"),
      refused("CONSTRAINED_BEAM_IN_SOLID", "beams inside solids are not built"),
      refused("CONSTRAINED_LAGRANGE_IN_SOLID", "coupling to fluids is not built"),
      refused("CONSTRAINED_SPR*",
              "this rivet is not built; use *CONSTRAINED_SPR2, or *CONSTRAINED_INTERPOLATION_SPOTWELD (SPR3)"),
      refused("CONSTRAINED_*",
              "this constraint is not built; nodal rigid bodies, extra nodes, merged rigid bodies, spotwelds and "
              "generalized weld spots are"),
  };
}

}  // namespace nugget::reading
