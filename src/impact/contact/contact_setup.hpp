// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/interior_contact.hpp"
#include "contact/surface_contact.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The mesh as a contact is set up on it: a system with the nodes' places after tying, or, before anything is tied, the
/// model with its nodes at `places`. Refers to all of them.
struct ContactMesh {
  ContactMesh(const system::System& system);  // NOLINT(google-explicit-constructor): a system is such a mesh
  /// Nodes keep the model's numbers. `thin`: the welds that SPOTHIN goes by.
  ContactMesh(const model::Model& of, const std::vector<Vec3d>& places, const std::vector<weld::Weld>& thin);
  ContactMesh(const ContactMesh&) = delete;
  ContactMesh& operator=(const ContactMesh&) = delete;

  const model::Model& model;
  const std::vector<Vec3d>& x;  ///< by node of the model [length]
  const std::vector<weld::Weld>& welds;
  std::vector<int> node_of;  ///< by node of the model: its number in the contact
  std::size_t nodes;         ///< numbers that there are
};

/// The surfaces and the laws of a penalty contact, from its card and what it names. Shells contribute
/// themselves, bricks their exterior faces; weld elements never contact. Node numbers are the mesh's. `choice`: the
/// setup holds what is chosen, and the outline of the whole; null: all.
contact::SurfaceContactSetup contact_setup(const ContactMesh& mesh, const model::Contact& contact,
                                           const contact::SurfaceChoice* choice = nullptr);

/// Whether nothing that meets the rigid body can move it at any time of the run: each translation and each rotation is
/// fixed or driven. In a contact such a body counts as held, whatever it weighs.
bool is_fully_prescribed(const model::Model& model, model::Index rigid_body);

/// The bricks of an interior contact; none of rigid parts.
std::vector<contact::SqueezedBrick> bricks_of(const system::System& system, const model::InteriorContact& contact);

/// Thickness that the side A or B of a contact sees of a shell or beam of `part` that is `own` thick [length]: SAST or
/// SBST, else OPTT of *PART_CONTACT, else its own times SFT; SFSAT or SFSBT scale the last two, and SAST, SBST in
/// _MORTAR alone (keyword manual, *CONTACT, card 3, and *PART_CONTACT).
double contact_thickness(const model::Contact& contact, const model::Part& part, double own, bool of_a);

/// That of a shell, `x` by node of the model: in single surface contact its own thickness, scaled, is no more than 0.4
/// of its shortest side, but with SSTHK = 1, or where SAST or OPTT give one (lsdyna.ansys.com, "Contact thickness").
double shell_contact_thickness(const model::Model& model, const model::Contact& contact, std::size_t shell, bool of_a,
                               const std::vector<Vec3d>& x);

/// Bulk modulus that a part's contact stiffness is found from, E/(3(1 - 2 nu)) times SSF of *PART_CONTACT [stress].
double bulk_modulus(const model::Model& model, const model::Part& part);

}  // namespace nugget::impact
