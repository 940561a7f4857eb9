// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

// The passes over the whole model that stand between reading the cards and a finished model.
namespace nugget::reading {

/// Phase::mesh. Sorts nodes and elements by id, looks up their nodes and parts, links each part to section, material
/// and hourglass, and gives each shell its thickness and offset. An element whose node or part is missing is left out.
void make_mesh(Builder& builder);

/// Part of it: a part all of whose solids are numbered inside out is a mirrored mesh; its solids are turned.
void turn_parts_inside_out(Builder& builder);

/// Part of it: springs and dampers, before the parts are linked to their sections.
void make_discretes(Builder& builder);

/// First of Phase::sets, when laws and criteria of erosion are whole. Gives parts of shells whose layers have materials
/// of their own, and with LAMSHT of *CONTROL_SHELL all whose layers are given by cards, a material that is made of
/// those of their layers (kernel::Laminate).
void make_layers(Builder& builder);

/// First of Phase::bodies: seat belts give their masses to their nodes.
void weigh_belts(Builder& builder);

/// Phase::sets. Works out the members of all sets, whichever order they refer to each other in.
void resolve_sets(Builder& builder);

// Phase::checks.
void check_bonds(
    Builder& builder);  ///< shapes of cohesive bricks, and what their parts are asked to do that they cannot
void check_mesh(Builder& builder);               ///< shapes of elements, free nodes
void report_doubled_elements(Builder& builder);  ///< part of it: elements with the part and the nodes of others
void check_thick_shells(Builder& builder);       ///< sections, laws and hourglass control that thick shells do not have
void check_parts(Builder& builder);  ///< parts without elements; sections, laws and hourglass that do not go together
/// What CMO of *MAT_RIGID or a nodal rigid body's SPC holds and a prescribed motion drives: the motion counts.
void release_driven_bodies(Builder& builder);
void check_tied_nodes(Builder& builder);  ///< sets of nodes that stay tied until they tear become groups at a place
void check_relaxation(Builder& builder);  ///< what dynamic relaxation cannot hold still
void check_initial_stresses(Builder& builder);    ///< of rigid elements
void check_units(Builder& builder);               ///< do modulus and density fit a usual system of units?
void check_initial_velocities(Builder& builder);  ///< elements between moving nodes and standing ones

}  // namespace nugget::reading
