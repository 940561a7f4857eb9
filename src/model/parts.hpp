// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/curve.hpp"
#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "kernel/contact/friction.hpp"
#include "kernel/element/fibre_rule.hpp"
#include "kernel/law/composed_law.hpp"
#include "kernel/law/discrete_beam.hpp"
#include "kernel/law/elastic.hpp"
#include "kernel/law/laminate.hpp"
#include "kernel/law/null.hpp"
#include "kernel/law/piecewise_linear.hpp"
#include "kernel/law/plastic_kinematic.hpp"
#include "kernel/law/rigid.hpp"
#include "kernel/law/spotweld.hpp"
#include "kernel/law/spring.hpp"

namespace nugget::model {

using Index = int;
inline constexpr Index none = -1;

using Law =
    std::variant<kernel::Elastic, kernel::PlasticKinematic, kernel::PiecewiseLinear, kernel::Null, kernel::Rigid,
                 kernel::Spotweld, kernel::DiscreteBeam, kernel::Spring, kernel::ComposedLaw, kernel::Laminate>;

struct Material {
  int id = 0;
  std::string title;
  std::string keyword;   ///< as in the manual, e.g. `MAT_SPOTWELD`
  double density = 0.0;  ///< [mass/length^3]
  Law law;
  Place place;
  Index weld = none;  ///< of a *MAT_SPOTWELD: in Model::weld_laws

  double young() const;  ///< Young's modulus [stress]
  /// That for the stiffness of contacts.
  double contact_young() const;
  double poisson() const;  ///< Poisson's ratio
};

/// ELFORM of shells without bending, whose nodes have no rotations: 5 of one point in the plane, 9 of 2 x 2.
inline bool is_membrane(int elform) {
  return elform == 5 || elform == 9;
}

struct SectionShell {
  int id = 0;
  int elform = 2;
  double shear_factor = 1.0;
  int layers = 2;            ///< NIP
  bool trapezoidal = false;  ///< QR/IRID = 1
  /// *INTEGRATION_SHELL: places from -1 (bottom) to 1, ascending, and shares of the thickness; empty: another rule.
  std::vector<std::array<double, 2>> rule;
  double thickness = 0.0;  ///< mean of T1..T4 [length]
  double nloc =
      0.0;  ///< reference surface: 1 top, 0 middle, -1 bottom; mid-surface = nodes - nloc*t/2 along the normal
  double extra_mass = 0.0;         ///< MAREA [mass/length^2]
  bool warping_stiffness = false;  ///< ELFORM 10: 2 with BWC = 1
  Place place;
};

/// *SECTION_SOLID, and *SECTION_TSHELL, whose elements are bricks with a bottom and a top.
struct SectionSolid {
  /// What *SECTION_TSHELL says of the way through the thickness.
  struct Thickness {
    int layers = 2;               ///< NIP
    bool trapezoidal = false;     ///< QR = 1
    double shear_factor = 1.0;    ///< SHRF; of a parabola the factor is the parabola's own
    bool parabolic_shear = true;  ///< TSHEAR = 0
  };
  int id = 0;
  int elform = 1;
  std::optional<Thickness> thickness{};  ///< of thick shells
  /// Thick shells of ELFORM 1 and 2: shells on the midway surface, with a stiffness across of their own.
  bool has_laws_of_shells() const { return thickness && (elform == 1 || elform == 2); }
  bool in_swforc = true;  ///< PRINT = 0 of the weld beams that bricks of this section replace
  Place place;
};

struct SectionBeam {
  int id = 0;
  int elform = 1;
  double shear_factor = 1.0;
  int quadrature = 2;             ///< QR
  int cross_section = 0;          ///< CST
  double extra_mass = 0.0;        ///< NSM [mass/length]
  std::array<double, 2> outer{};  ///< TS1, TS2: outer diameters of a weld or tube; of a rectangle (CST = 0) its extent
                                  ///< along s [length]
  std::array<double, 2> inner{};  ///< TT1, TT2: inner diameters; of a rectangle its extent along t [length]
  bool in_swforc = true;          ///< PRINT = 0
  bool torsion = true;            ///< ITOFF = 0
  // Of an integrated beam (ELFORM 1), of a resultant beam (2) and of a truss (3):
  std::array<double, 2> location{};  ///< NSLOC, NTLOC: place of the nodes on the section, -1 to 1 along s and t
  double area = 0.0;                 ///< A, of a shape or rule its own [length^2]
  double shear_area = 0.0;           ///< SA; 0: no shear deformation [length^2]
  double moment_s = 0.0, moment_t = 0.0, torsion_constant = 0.0;  ///< ISS, ITT, J [length^4]
  /// Of an integrated beam: points of a standard cross-section or of the user, in the place of QR and CST.
  std::optional<kernel::SectionPoints> points;
  // Of a discrete beam (ELFORM 6):
  double volume = 0.0;        ///< VOL; its mass is density times that [length^3]
  double inertia = 0.0;       ///< INER [mass length^2]
  double cable_area = 0.0;    ///< CA [length^2]
  double cable_offset = 0.0;  ///< OFFSET: a cable's length at the start less its unstretched one [length]
  int scoor = 0;              ///< SCOOR
  Index system = none;        ///< CID
  Place place;
};

/// *HOURGLASS, or the defaults of *CONTROL_HOURGLASS and *CONTROL_BULK_VISCOSITY.
struct Hourglass {
  int id = 0;
  int type = 0;                                         ///< IHQ; 0: the default of the element
  double membrane = 0.1, bending = 0.1, warping = 0.1;  ///< QM, QB, QW
  double bulk_quadratic = 1.5, bulk_linear = 0.06;      ///< Q1, Q2
  Place place;
};

enum class ElementKind { nothing, shell, solid, beam, discrete };

struct Part {
  int id = 0;
  std::string title;
  ElementKind kind = ElementKind::nothing;  ///< of its elements
  Index section = none;                     ///< in the array of its kind
  Index material = none;
  Index hourglass = none;          ///< none: Control's defaults
  Index rigid_body = none;         ///< of a part with MAT_RIGID
  double contact_thickness = 0.0;  ///< OPTT of *PART_CONTACT (0: none given) [length]
  double contact_scale = 1.0;      ///< SFT
  double stiffness_scale = 1.0;    ///< SSF
  kernel::Friction friction;       ///< FS, FD, DC, VC: of contacts with FS = -1
  double drilling = 0.0;           ///< factor on the usual stiffness of its shells against drilling: DRCPRM; 0: none
  Place place;
};

struct Table {
  int id = 0;
  std::vector<double> value;
  std::vector<Index> curve;
};

/// *DEFINE_COORDINATE_...; the rows of the triad are the local axes.
struct CoordinateSystem {
  /// Of *DEFINE_COORDINATE_NODES.
  struct Nodes {
    Index origin = none, on_axis = none, in_plane = none;
    int axis = 0;  ///< DIR: 0 x, 1 y, 2 z goes through `on_axis`, and the next one lies in the plane
  };
  int id = 0;
  Vec3d origin;
  Frame3d axes;  ///< of time 0
  std::optional<Nodes> nodes{};
  bool turning = false;  ///< FLAG 1: the axes turn with the nodes
};

template <class Member>
struct Set {
  int id = 0;
  std::vector<Member> members;  ///< in the deck's order, each once
  Place place;
  std::array<double, 4> attributes{};  ///< DA1..DA4: what they mean is up to who uses the set
  /// A1..A4 of members that have their own (_COLUMN), with DA1..DA4 where these are 0.
  std::vector<std::pair<Member, std::array<double, 4>>> own_attributes{};

  const std::array<double, 4>& attributes_of(const Member& member) const {
    for (const auto& [who, own] : own_attributes)
      if (who == member) return own;
    return attributes;
  }
};
using Segment = std::array<Index, 4>;        ///< nodes; a triangle repeats its third
using CornerShares = std::array<double, 4>;  ///< of something on a segment

struct Sets {
  std::vector<Set<Index>> nodes, parts, shells, solids, beams;
  std::vector<Set<Index>> branches;  ///< of parts: *SET_PART_TREE
  std::vector<Set<Segment>> segments;
};

/// A body that moves as one. Its mass properties follow from its nodes and elements unless `given`.
struct RigidBody {
  enum class Origin { part, nodal, weld };  ///< MAT_RIGID part, nodal rigid body, rigid weld
  Origin origin = Origin::part;
  int id = 0;  ///< part id, or PID of the nodal rigid body, or weld id
  std::string title;
  std::vector<Index> parts;  ///< MAT_RIGID parts merged into it
  std::vector<Index> nodes;  ///< all nodes that it carries, ascending
  unsigned fixed = 0;        ///< bits 0..2 translations x y z, 3..5 rotations that cannot move
  Frame3d fixed_axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< whose x y z those are (CMO = -1: local ones)
  Frame3d own_axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};    ///< of rbdout, at time 0 (LCO, or two vectors; CID)
  struct Inertia {
    double mass = 0.0;
    Vec3d center;
    std::array<double, 6> inertia{};  ///< Ixx Ixy Ixz Iyy Iyz Izz about `center`, global axes
    Vec3d velocity, spin;
  };
  bool given = false;  ///< *PART_INERTIA or _INERTIA: `inertia` holds
  Inertia inertia;
  Place place;
};

}  // namespace nugget::model
