// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>

#include "experiment.hpp"

// Deck text of small models with weld beams. Units mm, t, s, N, MPa.
namespace nugget::verify {

/// Weld W1 (docs/verification/cases.md) and its variations.
struct WeldData {
  double diameter = 6.0, length = 1.5;
  double E = 210000.0, nu = 0.3, density = 7.8e-9, yield = 400.0, hardening = 1000.0;
  double mass_step = 0.0, failure_time = 0.0, failure_strain = 0.0;
  std::array<double, 6> strength{};  ///< NRR NRS NRT MRR MSS MTT
  int filter = 0, quadrature = 2;
  // Of bricks (brick_decks.hpp) only.
  int option = 0;               ///< OPT; 1: `strength` begins with SIGAX SIGTAU
  double true_thickness = 0.0;  ///< TRUE_T

  double area() const;
  double second_moment() const;  ///< I; the polar one is 2 I
  double shear_modulus() const { return E / (2.0 * (1.0 + nu)); }
  double axial_stiffness() const { return E * area() / length; }
  double shear_stiffness() const { return shear_modulus() * area() / length; }
  double torsion_stiffness() const { return 2.0 * shear_modulus() * second_moment() / length; }
  double bending_stiffness() const { return E * second_moment() / length; }
};

/// *PART, *SECTION_BEAM and *MAT_SPOTWELD, all with the number `part`.
std::string weld_part(int part, const WeldData& weld);
/// *PART, *SECTION_SHELL and *MAT_ELASTIC of steel A, all with the number `part`.
std::string sheet_part(int part, double thickness);
/// *CONTACT_SPOTWELD of the welds of `weld_part` to the shells of `sheet_part`, with SAST and SBST.
std::string weld_contact(int weld_part, int sheet_part, double sast = 0.0, double sbst = 0.0);
/// The same to all shells of the parts in set 1.
std::string weld_contact_to_set(int weld_part, std::initializer_list<int> sheet_parts);

/// A flat sheet of nx times ny shells: *NODE and *ELEMENT_SHELL. Node (i, j) has the id first + j (nx + 1) + i; shells
/// count from `first` on.
struct SheetMesh {
  int first = 1, part = 1;
  Vec3d corner;
  int nx = 1, ny = 1;
  Vec3d along{10, 0, 0}, across{0, 10, 0};  ///< edges of a shell
  int node(int i, int j) const { return first + j * (nx + 1) + i; }
  std::string text() const;
};

/// A weld beam and its two nodes.
std::string beam_between(int element, int part, int n1, const Vec3d& x1, int n2, const Vec3d& x2);
std::string fixed(std::initializer_list<int> nodes);  ///< *BOUNDARY_SPC_NODE in all six degrees of freedom
std::string termination(double end_time, double step_scale = 0.9, double mass_step = 0.0, int step_curve = 0);

/// Displacements and rotation angles of a node over s = 0..1.
using Path = std::function<std::array<double, 6>(double s)>;
/// *BOUNDARY_PRESCRIBED_MOTION_NODE in all six degrees of freedom, with curves from `first_curve` on, in `points`
/// pieces.
std::string driven(int node, const Path& path, double duration, int points, int first_curve, double start = 0.0);

}  // namespace nugget::verify
