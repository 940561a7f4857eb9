// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <numbers>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "kernel/element/shell.hpp"
#include "model/axes.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *PART and its forms.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

const Card heading_line{{text("heading", 70, "name of the part")}};

const CardOf<PartCard> part_card{
    {&PartCard::pid, id("pid", IdSpace::part, required, "part id")},
    {&PartCard::secid, id("secid", IdSpace::other, 0, "section; only a part without elements needs none")},
    {&PartCard::mid, id("mid", IdSpace::material, 0, "material; only a part without elements needs none")},
    {&PartCard::eosid,
     id("eosid", IdSpace::material, 0, "*EOS_... of solids of *MAT_JOHNSON_COOK; ignored with other laws")},
    {&PartCard::hgid, id("hgid", IdSpace::other, 0, "*HOURGLASS; 0: *CONTROL_HOURGLASS")},
    integer("grav", 0, any_value, "for gravity initialization only"),
    integer("adpopt", 0, any_value, "adaptive meshing; without *CONTROL_ADAPTIVE no effect"),
    id("tmid", IdSpace::material, 0, "thermal material; no effect on mechanics"),
};

/// What the cards say beside mass, centre, tensor and velocities themselves.
struct InertiaCards : RigidBody::Inertia {
  int ircs = 0, nodeid = 0, cid = 0;
  Vec3d along_x, in_plane;
};
const CardOf<InertiaCards> centre_card{
    {within(&InertiaCards::center, &Vec3d::x),
     real("xc", dimension::length, 0, any_value, "centre of mass x, unless nodeid")},
    {within(&InertiaCards::center, &Vec3d::y), real("yc", dimension::length, 0, any_value, "centre of mass y")},
    {within(&InertiaCards::center, &Vec3d::z), real("zc", dimension::length, 0, any_value, "centre of mass z")},
    {&InertiaCards::mass, real("tm", dimension::mass, required, above_zero(), "mass")},
    {&InertiaCards::ircs,
     integer("ircs", 0, between(0, 1), "axes of the tensor: 0 global, 1 local by the fourth card")},
    {&InertiaCards::nodeid, id("nodeid", IdSpace::node, 0, "node at the centre of mass")},
};

const CardOf<InertiaCards> tensor_card{
    {at(&InertiaCards::inertia, 0),
     real("ixx", dimension::inertia, required, above_zero(), "inertia tensor about the centre, xx")},
    {at(&InertiaCards::inertia, 1), real("ixy", dimension::inertia, 0, any_value, "xy")},
    {at(&InertiaCards::inertia, 2), real("ixz", dimension::inertia, 0, any_value, "xz")},
    {at(&InertiaCards::inertia, 3), real("iyy", dimension::inertia, required, above_zero(), "yy")},
    {at(&InertiaCards::inertia, 4), real("iyz", dimension::inertia, 0, any_value, "yz")},
    {at(&InertiaCards::inertia, 5), real("izz", dimension::inertia, required, above_zero(), "zz")},
};

const CardOf<InertiaCards> velocity_card{
    {within(&InertiaCards::velocity, &Vec3d::x), real("vtx", dimension::velocity, 0, any_value, "initial velocity x")},
    {within(&InertiaCards::velocity, &Vec3d::y), real("vty", dimension::velocity, 0, any_value, "initial velocity y")},
    {within(&InertiaCards::velocity, &Vec3d::z), real("vtz", dimension::velocity, 0, any_value, "initial velocity z")},
    {within(&InertiaCards::spin, &Vec3d::x), real("vrx", dimension::rate, 0, any_value, "initial angular velocity x")},
    {within(&InertiaCards::spin, &Vec3d::y), real("vry", dimension::rate, 0, any_value, "initial angular velocity y")},
    {within(&InertiaCards::spin, &Vec3d::z), real("vrz", dimension::rate, 0, any_value, "initial angular velocity z")},
};

const CardOf<InertiaCards> axes_card{
    {within(&InertiaCards::along_x, &Vec3d::x),
     real("xl", dimension::number, 0, any_value, "local axis x, component x")},
    {within(&InertiaCards::along_x, &Vec3d::y), real("yl", dimension::number, 0, any_value, "component y")},
    {within(&InertiaCards::along_x, &Vec3d::z), real("zl", dimension::number, 0, any_value, "component z")},
    {within(&InertiaCards::in_plane, &Vec3d::x),
     real("xlip", dimension::number, 0, any_value, "vector in the local xy plane, component x")},
    {within(&InertiaCards::in_plane, &Vec3d::y), real("ylip", dimension::number, 0, any_value, "component y")},
    {within(&InertiaCards::in_plane, &Vec3d::z), real("zlip", dimension::number, 0, any_value, "component z")},
    {&InertiaCards::cid, id("cid", IdSpace::define, 0, "coordinate system instead of the vectors")},
};

struct ContactCard : Part {
  int cparm8 = 0;
};
const CardOf<ContactCard> contact_card{
    {within(&ContactCard::friction, &kernel::Friction::static_coefficient),
     real("fs", dimension::number, 0, any_value, "static friction, for contacts with FS = -1")},
    {within(&ContactCard::friction, &kernel::Friction::dynamic_coefficient),
     real("fd", dimension::number, 0, any_value, "dynamic friction, for contacts with FS = -1")},
    {within(&ContactCard::friction, &kernel::Friction::decay),
     real("dc", {0, -1, 1}, 0, any_value, "decay of friction, for contacts with FS = -1")},
    {within(&ContactCard::friction, &kernel::Friction::shear_strength),
     real("vc", dimension::stress, 0, any_value, "viscous friction, for contacts with FS = -1")},
    {&ContactCard::contact_thickness,
     real("optt", dimension::length, 0, at_least(0), "contact thickness; 0: of the shells")},
    {&ContactCard::contact_scale, real("sft", dimension::number, 1, at_least(0), "scale of the contact thickness")},
    {&ContactCard::stiffness_scale, real("ssf", dimension::number, 1, at_least(0), "scale of the contact stiffness")},
    {&ContactCard::cparm8,
     integer("cparm8", 0, any_value, "beams of the part in _GENERAL: of the contact's own CPARM8 alone")},
};

struct CompositeCard : SectionShell {
  int pid = 0, hgid = 0;
};
const CardOf<CompositeCard> composite_card{
    {&CompositeCard::pid, id("pid", IdSpace::part, required, "part id")},
    {&CompositeCard::elform, integer("elform", 0, any_value, "formulation of the shells, as in *SECTION_SHELL")},
    {&CompositeCard::shear_factor, real("shrf", dimension::number, 1, above_zero(),
                                        "shear correction factor; not used with LAMSHT of *CONTROL_SHELL")},
    {&CompositeCard::nloc,
     real("nloc", dimension::number, 0, any_value, "nodes on the top (1), mid (0) or bottom (-1) surface")},
    {&CompositeCard::extra_mass,
     real("marea", dimension::mass_per_area, 0, at_least(0), "non-structural mass per area")},
    {&CompositeCard::hgid, id("hgid", IdSpace::other, 0, "*HOURGLASS; 0: *CONTROL_HOURGLASS")},
    integer("adpopt", 0, any_value, "adaptive meshing; without *CONTROL_ADAPTIVE no effect"),
    integer("thshel", 0, any_value, "thermal shells; no effect on mechanics"),
};

/// Two layers, or with _LONG one.
struct LayersCard {
  std::array<int, 2> mid{};
  std::array<double, 2> thick{}, b{};
  double shrfac = 1.0;
};
const CardOf<LayersCard> layers_card{
    {at(&LayersCard::mid, 0), id("mid1", IdSpace::material, 0, "material of the layer; the first layer is the lowest")},
    {at(&LayersCard::thick, 0),
     real("thick1", dimension::length, 0, at_least(0), "its thickness; the shell's is the sum of all")},
    {at(&LayersCard::b, 0),
     real("b1", dimension::number, 0, any_value, "angle in degrees that turns its material axes about the normal")},
    id("tmid1", IdSpace::material, 0, "thermal material; no effect on mechanics"),
    {at(&LayersCard::mid, 1), id("mid2", IdSpace::material, 0, "material of the layer above it")},
    {at(&LayersCard::thick, 1), real("thick2", dimension::length, 0, at_least(0), "its thickness")},
    {at(&LayersCard::b, 1), real("b2", dimension::number, 0, any_value, "its angle")},
    id("tmid2", IdSpace::material, 0, "thermal material; no effect on mechanics"),
};

const CardOf<LayersCard> long_layer_card{
    {at(&LayersCard::mid, 0), id("mid1", IdSpace::material, 0, "material of the layer; the first layer is the lowest")},
    {at(&LayersCard::thick, 0),
     real("thick1", dimension::length, 0, at_least(0), "its thickness; the shell's is the sum of all")},
    {at(&LayersCard::b, 0),
     real("b1", dimension::number, 0, any_value, "angle in degrees that turns its material axes about the normal")},
    id("tmid1", IdSpace::material, 0, "thermal material; no effect on mechanics"),
    integer("plyid", 0, any_value, "number of the ply for postprocessors; no effect"),
    {&LayersCard::shrfac,
     real("shrfac", dimension::number, 1, above_zero(), "scale of the transverse shear stress that the layer carries")},
};

struct PrintCard {
  int prbf = 0;
};
const CardOf<PrintCard> print_card{
    {&PrintCard::prbf, integer("prbf", 0, any_value, "which listings show the part: not obeyed, all do")},
};

/// The local axes of _INERTIA with IRCS = 1.
bool inertia_axes(Builder& b, const RowOf<InertiaCards>& axes, const Vec3d& x, const Vec3d& in_plane, Frame3d& frame) {
  if (const Index s = b.system(axes[&InertiaCards::cid]); s != none) {
    frame = b.model.systems[s].axes;
    return true;
  }
  const bool found = frame_from(x, in_plane, frame);
  if (!found)
    refuse(b, axes[within(&InertiaCards::along_x, &Vec3d::x)],
           "the two vectors must differ in direction and from zero");
  return found;
}

/// *PART_INERTIA: mass, centre, tensor and velocity of a rigid part.
void read_part_inertia(Builder& b, Cursor& cursor, Index part) {
  InertiaCards cards;
  const auto centre = cursor.read(centre_card, cards);
  cursor.read(tensor_card, cards);
  const auto velocity = cursor.read(velocity_card, cards);
  const bool is_local = cards.ircs == 1;
  const auto axes = is_local ? cursor.read(axes_card, cards) : centre;
  const Block& block = cursor.block();
  const Frame3d own = axes_of_include(block);
  refuse_in_mirror(b, block, centre[&InertiaCards::ircs],
                   "a tensor in local axes is not built in a file that *INCLUDE_TRANSFORM mirrors");
  for (const auto axis : {&Vec3d::x, &Vec3d::y, &Vec3d::z})
    refuse_in_mirror(b, block, velocity[within(&InertiaCards::spin, axis)], turning_in_mirror);
  const Vec3d x = direction(block, cards.along_x), in_plane = direction(block, cards.in_plane);
  RigidBody::Inertia inertia = cards;
  inertia.center = position(block, cards.center);
  inertia.velocity = direction(block, cards.velocity);
  inertia.spin = direction(block, cards.spin);
  // A coordinate system may need nodes, so not before them; rigid bodies are made after.
  b.defer(Phase::sets, [=](Builder& later) {
    RigidBody::Inertia given = inertia;
    // Behind what moves nodes in this phase.
    if (const Index n = later.node(centre[&InertiaCards::nodeid]); n != none)
      later.defer(Phase::sets, [part, n](Builder& last) { last.part_inertia[part].center = last.model.nodes.x[n]; });
    Frame3d frame;
    if (!is_local)
      given.inertia = to_global(given.inertia, own);
    else if (inertia_axes(later, axes, x, in_plane, frame))
      given.inertia = to_global(given.inertia, frame);
    later.part_inertia[part] = given;
    const Index material = later.model.parts[part].material;
    if (material != none && !std::holds_alternative<kernel::Rigid>(later.model.materials[material].law))
      refuse(later, centre[&InertiaCards::mass], "inertia can be given only to parts of *MAT_RIGID", "use *PART");
  });
}

void read_part_contact(Builder& b, Cursor& cursor, Part& part) {
  ContactCard contact{part};
  const auto row = cursor.read(contact_card, contact);
  expect(b, Severity::warning,
         {{row[&ContactCard::cparm8], 0, "not obeyed: CPARM8 of *CONTACT_AUTOMATIC_GENERAL counts alone"}});
  part = contact;
}

/// The layers of *PART_COMPOSITE with their thicknesses as shares. Nothing, and findings, where there are none.
std::vector<LayerCard> read_layers(Builder& b, Cursor& cursor, bool one_a_line) {
  std::vector<LayerCard> layers;
  const Block& block = cursor.block();
  bool blank = false, reported = false;
  const auto take = [&](const RowOf<LayersCard>& row, std::size_t k) {
    const deck::Entry mid = row[at(&LayersCard::mid, k)];
    const bool has_material = row->mid[k] != 0, has_thickness = row->thick[k] > 0.0;
    if (!has_material && !has_thickness) {
      blank = true;
      return;
    }
    if (!has_material || !has_thickness)
      refuse(b, has_material ? row[at(&LayersCard::thick, k)] : mid,
             has_material ? "a layer without a thickness" : "a layer without a material",
             "give each layer both, or leave it blank");
    else if (blank && !reported)
      refuse(b, mid, "a layer above a blank one", "write the layers one after the other");
    reported = reported || blank || !has_material || !has_thickness;
    LayerCard layer{0.0, row->thick[k], mid, LayerCard::Names::material};
    layer.mirrored = is_mirrored(block);
    layer.angle = hand(block) * row->b[k] * (std::numbers::pi / 180.0);
    if (one_a_line) layer.shear_scale = row->shrfac;
    layers.push_back(std::move(layer));
  };
  while (!at_end(cursor)) {
    const auto row = cursor.read(one_a_line ? long_layer_card : layers_card);
    take(row, 0);
    if (!one_a_line) take(row, 1);
  }
  if (layers.empty() && !reported) {
    b.findings.error(block.place, block.starred(), "the part has no layers", "give MID1, THICK1 and so on");
  } else if (layers.size() > at(kernel::most_layers)) {
    b.findings.error(block.place, block.starred(),
                     fmt::format("{} layers; up to {} are built", layers.size(), kernel::most_layers),
                     "join neighbours of the same material");
    reported = true;
  }
  if (reported) layers.clear();
  return layers;
}

/// *PART_COMPOSITE: a part with a section of its own, whose thickness and rule are those of its layers.
void read_composite(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  Part part;
  part.title = cursor.read_text();
  CompositeCard card;
  const auto row = cursor.read(composite_card, card);
  part.id = card.pid;
  part.place = row.place();
  if (options.contains("CONTACT")) read_part_contact(b, cursor, part);
  LayerStack stack{read_layers(b, cursor, options.contains("LONG"))};
  SectionShell section = card;
  section.place = part.place;
  section.layers = static_cast<int>(stack.layers.size());
  for (const LayerCard& layer : stack.layers) section.thickness += layer.share;
  double below = 0.0;
  for (LayerCard& layer : stack.layers) {
    const double thickness = layer.share;
    layer.place = (2.0 * below + thickness) / section.thickness - 1.0;
    layer.share = thickness / section.thickness;
    below += thickness;
    section.rule.push_back({layer.place, layer.share});
  }
  const auto index = static_cast<Index>(b.model.parts.size()), own = static_cast<Index>(b.model.shell_sections.size());
  b.parts.add(part.id, index, part.place, block.starred(), "part", b.findings);
  b.model.parts.push_back(std::move(part));
  b.model.shell_sections.push_back(std::move(section));
  b.shell_formulations.push_back(row[&CompositeCard::elform]);
  b.composite_parts.push_back({index, own, row[&CompositeCard::pid], row[&CompositeCard::hgid]});
  b.layer_stacks[own] = std::move(stack);
}

void read_part(Builder& b, const Block& block, const Options& options) {
  for (const auto* option : {"REPOSITION", "ATTACHMENT_NODES"})
    if (options.contains(option)) {
      b.findings.error(block.place, block.starred(), fmt::format("option {} is not supported", option),
                       "use *PART without it");
      return;
    }
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    Part part;
    part.title = cursor.read_text();
    const auto row = cursor.read(part_card);
    part.id = row->pid;
    part.place = row.place();
    const auto index = static_cast<Index>(b.model.parts.size());
    if (options.contains("INERTIA")) read_part_inertia(b, cursor, index);
    if (options.contains("CONTACT")) read_part_contact(b, cursor, part);
    if (options.contains("PRINT") && cursor.read(print_card)->prbf != 0)
      b.findings.note(part.place, block.starred(), "PRBF is not obeyed: the part is listed in rbdout and matsum");
    b.parts.add(part.id, index, part.place, block.starred(), "part", b.findings);
    b.part_rows.emplace_back(index, row);
    b.model.parts.push_back(std::move(part));
  }
}

}  // namespace

std::vector<Keyword> part_keywords() {
  return {
      {.name = "PART",
       .options = {"INERTIA", "REPOSITION", "CONTACT", "PRINT", "ATTACHMENT_NODES", "TITLE"},  // it has a title anyway
       .layout = {{"", &heading_line},
                  {"", &part_card},
                  {"with _INERTIA", &centre_card},
                  {"with _INERTIA", &tensor_card},
                  {"with _INERTIA", &velocity_card},
                  {"with _INERTIA, if IRCS = 1", &axes_card},
                  {"with _CONTACT", &contact_card},
                  {"with _PRINT", &print_card}},
       .read = read_part},
      {.name = "PART_COMPOSITE",
       .options = {"LONG", "CONTACT"},
       .layout = {{"", &heading_line},
                  {"", &composite_card},
                  {"with _CONTACT", &contact_card},
                  {"for every two layers", &layers_card},
                  {"with _LONG, for every layer", &long_layer_card}},
       .read = read_composite},
  };
}

}  // namespace nugget::reading
