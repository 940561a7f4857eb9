// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "model/axes.hpp"
#include "model/cards/families.hpp"
#include "model/cards/reading.hpp"

// *PART and its forms.
namespace nugget::model {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card heading_line{{text("heading", 70, "name of the part")}};

const Card part_card{{
    id("pid", IdSpace::part, required, "part id"),
    id("secid", IdSpace::other, 0, "section; only a part without elements needs none"),
    id("mid", IdSpace::material, 0, "material; only a part without elements needs none"),
    id("eosid", IdSpace::material, 0, "*EOS_... of solids of *MAT_JOHNSON_COOK; ignored with other laws"),
    id("hgid", IdSpace::other, 0, "*HOURGLASS; 0: *CONTROL_HOURGLASS"),
    integer("grav", 0, any_value, "for gravity initialization only"),
    integer("adpopt", 0, any_value, "adaptive meshing; without *CONTROL_ADAPTIVE no effect"),
    id("tmid", IdSpace::material, 0, "thermal material; no effect on mechanics"),
}};

const Card centre_card{{
    real("xc", dimension::length, 0, any_value, "centre of mass x, unless nodeid"),
    real("yc", dimension::length, 0, any_value, "centre of mass y"),
    real("zc", dimension::length, 0, any_value, "centre of mass z"),
    real("tm", dimension::mass, required, above_zero(), "mass"),
    integer("ircs", 0, between(0, 1), "axes of the tensor: 0 global, 1 local by the fourth card"),
    id("nodeid", IdSpace::node, 0, "node at the centre of mass"),
}};

const Card tensor_card{{
    real("ixx", dimension::inertia, required, above_zero(), "inertia tensor about the centre, xx"),
    real("ixy", dimension::inertia, 0, any_value, "xy"),
    real("ixz", dimension::inertia, 0, any_value, "xz"),
    real("iyy", dimension::inertia, required, above_zero(), "yy"),
    real("iyz", dimension::inertia, 0, any_value, "yz"),
    real("izz", dimension::inertia, required, above_zero(), "zz"),
}};

const Card velocity_card{{
    real("vtx", dimension::velocity, 0, any_value, "initial velocity x"),
    real("vty", dimension::velocity, 0, any_value, "initial velocity y"),
    real("vtz", dimension::velocity, 0, any_value, "initial velocity z"),
    real("vrx", dimension::rate, 0, any_value, "initial angular velocity x"),
    real("vry", dimension::rate, 0, any_value, "initial angular velocity y"),
    real("vrz", dimension::rate, 0, any_value, "initial angular velocity z"),
}};

const Card axes_card{{
    real("xl", dimension::number, 0, any_value, "local axis x, component x"),
    real("yl", dimension::number, 0, any_value, "component y"),
    real("zl", dimension::number, 0, any_value, "component z"),
    real("xlip", dimension::number, 0, any_value, "vector in the local xy plane, component x"),
    real("ylip", dimension::number, 0, any_value, "component y"),
    real("zlip", dimension::number, 0, any_value, "component z"),
    id("cid", IdSpace::define, 0, "coordinate system instead of the vectors"),
}};

const Card contact_card{{
    real("fs", dimension::number, 0, any_value, "static friction, for contacts with FS = -1"),
    real("fd", dimension::number, 0, any_value, "dynamic friction, for contacts with FS = -1"),
    real("dc", {0, -1, 1}, 0, any_value, "decay of friction, for contacts with FS = -1"),
    real("vc", dimension::stress, 0, any_value, "viscous friction, for contacts with FS = -1"),
    real("optt", dimension::length, 0, at_least(0), "contact thickness; 0: of the shells"),
    real("sft", dimension::number, 1, at_least(0), "scale of the contact thickness"),
    real("ssf", dimension::number, 1, at_least(0), "scale of the contact stiffness"),
    integer("cparm8", 0, any_value, "beams of the part in _GENERAL: of the contact's own CPARM8 alone"),
}};

const Card print_card{{integer("prbf", 0, any_value, "which listings show the part: not obeyed, all do")}};

/// The local axes of _INERTIA with IRCS = 1.
bool inertia_axes(Builder& b, const Row& row, const Vec3d& x, const Vec3d& in_plane, Frame3d& frame) {
  if (const Index s = b.system(row, "cid"); s != none) {
    frame = b.model.systems[static_cast<std::size_t>(s)].axes;
    return true;
  }
  const bool found = frame_from(x, in_plane, frame);
  if (!found) refuse(b, row, "xl", "the two vectors must differ in direction and from zero");
  return found;
}

/// *PART_INERTIA: mass, centre, tensor and velocity of a rigid part.
void read_inertia(Builder& b, Cursor& cursor, Index part) {
  const Row centre = cursor.read(centre_card);
  const Row tensor = cursor.read(tensor_card);
  const Row velocity = cursor.read(velocity_card);
  const bool is_local = centre.integer("ircs") == 1;
  const Row axes = is_local ? cursor.read(axes_card) : centre;
  const Block& block = cursor.block();
  const Frame3d own = axes_of_include(block);
  Vec3d x, in_plane;
  if (is_local) {
    x = direction(block, axes, "xl", "yl", "zl");
    in_plane = direction(block, axes, "xlip", "ylip", "zlip");
  }
  const Vec3d place = position(block, centre, "xc", "yc", "zc"),
              translation = direction(block, velocity, "vtx", "vty", "vtz"),
              rotation = direction(block, velocity, "vrx", "vry", "vrz");
  // A coordinate system may need nodes, so not before them; rigid bodies are made after.
  b.later(Phase::sets, [=](Builder& later) {
    RigidBody::Inertia given;
    given.mass = centre.real("tm");
    given.center = place;
    // Behind what moves nodes in this phase.
    if (const Index n = later.node(centre, "nodeid"); n != none)
      later.later(Phase::sets, [part, n](Builder& last) {
        last.part_inertia[part].center = last.model.nodes.x[static_cast<std::size_t>(n)];
      });
    given.inertia = {tensor.real("ixx"), tensor.real("ixy"), tensor.real("ixz"),
                     tensor.real("iyy"), tensor.real("iyz"), tensor.real("izz")};
    Frame3d frame;
    if (!is_local)
      given.inertia = to_global(given.inertia, own);
    else if (inertia_axes(later, axes, x, in_plane, frame))
      given.inertia = to_global(given.inertia, frame);
    given.velocity = translation;
    given.spin = rotation;
    later.part_inertia[part] = given;
    const Index material = later.model.parts[static_cast<std::size_t>(part)].material;
    if (material != none &&
        !std::holds_alternative<kernel::Rigid>(later.model.materials[static_cast<std::size_t>(material)].law))
      refuse(later, centre, "tm", "inertia can be given only to parts of *MAT_RIGID", "use *PART");
  });
}

void read_contact(Builder& b, Cursor& cursor, Part& part) {
  const Row row = cursor.read(contact_card);
  expect(b, row, Severity::warning, {{"cparm8", 0, "not obeyed: CPARM8 of *CONTACT_AUTOMATIC_GENERAL counts alone"}});
  part.contact_thickness = row.real("optt");
  part.contact_scale = row.real("sft");
  part.stiffness_scale = row.real("ssf");
  part.friction = {row.real("fs"), row.real("fd"), row.real("dc"), row.real("vc")};
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
    const Row row = cursor.read(part_card);
    part.id = row.integer("pid");
    part.place = row.place();
    const auto index = static_cast<Index>(b.model.parts.size());
    if (options.contains("INERTIA")) read_inertia(b, cursor, index);
    if (options.contains("CONTACT")) read_contact(b, cursor, part);
    if (options.contains("PRINT") && cursor.read(print_card).integer("prbf") != 0)
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
       .options = {"INERTIA", "REPOSITION", "CONTACT", "PRINT", "ATTACHMENT_NODES"},
       .layout = {{"", &heading_line},
                  {"", &part_card},
                  {"with _INERTIA", &centre_card},
                  {"with _INERTIA", &tensor_card},
                  {"with _INERTIA", &velocity_card},
                  {"with _INERTIA, if IRCS = 1", &axes_card},
                  {"with _CONTACT", &contact_card},
                  {"with _PRINT", &print_card}},
       .read = read_part},
  };
}

}  // namespace nugget::model
