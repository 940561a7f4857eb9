// SPDX-License-Identifier: Apache-2.0
#include "nvh/statics/statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/axis_across.hpp"
#include "base/index.hpp"
#include "kernel/law/law_components.hpp"
#include "model/circular_motion.hpp"
#include "nvh/eigen/modes.hpp"
#include "nvh/matrices/nodal.hpp"
#include "nvh/matrices/resistance.hpp"
#include "nvh/statics/static_loads.hpp"
#include "weld/failure/brick_section.hpp"
#include "weld/failure/failure.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::nvh {
namespace {

double product(const Nodal& a, const Nodal& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t i = 0; i < 6; ++i) sum += a[k][i] * b[k][i];
  return sum;
}

double largest(std::span<const double> v) {
  double most = 0.0;
  for (const double x : v) most = std::max(most, std::abs(x));
  return most;
}

/// Motions that supports prescribe, and those of the nodes that follow them.
Nodal prescribed(const Matrices& m, double time, Findings& findings) {
  const model::Model& model = m.system.model;
  Nodal u(m.system.all_nodes());
  for (const Equations::Support& s : m.equations.supports()) {
    double value = 0.0;
    if (s.moves) {
      const model::PrescribedMotion& motion = model.motions[s.index];
      value = motion.scale * model.curves[motion.curve].clamped(time - motion.birth);
      // The way along the circle, to first order in the angle.
      if (motion.circular) value *= model::place_on_circle(motion, m.system.ties.x[m.system.model_node[s.node]]).radius;
    }
    SixDof& node = u[s.node];
    const double missing = value - dot(s.direction, part_of(node, s.rotation));
    const double share = dot(s.direction, s.taken);
    if (share > 0.0)
      add_to(node, s.rotation, (missing / share) * s.taken);
    else if (s.moves && std::abs(missing) > 1e-9 * std::abs(value))
      findings.error(model.motions[s.index].place, "*BOUNDARY_PRESCRIBED_MOTION",
                     "it drives a node in a direction that an SPC or another motion prescribes otherwise",
                     "take one of them out");
  }
  apply_constraints(m.system, u);
  return u;
}

/// Of a weld beam, by equilibrium from the forces at its second end: moments about its middle. s and t are those with
/// which a run begins: strengths may differ between them.
weld::Resultants of_beam(const Matrices& m, const weld::Weld& weld, const Nodal& u) {
  const system::System::ElementLocation location = m.system.location_of(weld, weld.element);
  const system::ElementGroup& group = *m.system.groups[location.group];
  const std::size_t e = at(location.element);
  const std::vector<double> f = element_force(m, group, e, u);
  const system::ElementNodes node = group.nodes(e);
  const Vec3d line = vec(m.rest.x[node[1]]) - vec(m.rest.x[node[0]]);
  const Vec3d r = unit(line), force{f[6], f[7], f[8]};
  const Vec3d moment = Vec3d{f[9], f[10], f[11]} + cross(0.5 * line, force);
  const Vec3d s = beam_side(r, m.system.model.beams.side(at(weld.element), m.system.ties.x));
  const Vec3d t = cross(r, s);
  return {dot(r, force), dot(s, force), dot(t, force), dot(r, moment), dot(s, moment), dot(t, moment)};
}

weld::Resultants of_bricks(const Matrices& m, const weld::Weld& weld, const Nodal& u, double& area) {
  const weld::BrickSection section(weld, m.system.ties.x);
  std::vector<Vec3d> x, force(section.nodes().size());
  for (const model::Index n : section.nodes()) x.push_back(m.system.ties.x[n]);
  for (const model::Index element : weld.elements) {
    const system::System::ElementLocation location = m.system.location_of(weld, element);
    const system::ElementGroup& group = *m.system.groups[location.group];
    const std::vector<double> f = element_force(m, group, at(location.element), u);
    const system::ElementNodes node = group.nodes(at(location.element));
    for (std::size_t a = 0; a < 8; ++a)
      for (std::size_t i = 0; i < x.size(); ++i)
        if (m.system.node_of[section.nodes()[i]] == node[a]) force[i] += Vec3d{f[3 * a], f[3 * a + 1], f[3 * a + 2]};
  }
  const weld::BrickSection::Shape shape = section.shape(x);
  area = shape.area;
  return section.load(shape, x, force).middle;
}

std::optional<WeldForce> weld_force(const Matrices& m, const weld::Weld& weld, const Nodal& u, Findings& findings) {
  using Kind = weld::Weld::Kind;
  if (weld.kind == Kind::rigid || (weld.kind == Kind::connector && !weld.interpolated) || weld.deleted) return {};
  const system::System::ElementLocation location = m.system.location_of(weld, weld.element);
  if (location.group < 0) return {};
  if (weld.interpolated) {
    const auto none = std::numeric_limits<double>::quiet_NaN();
    if (!(weld.length > 0.0)) return {};  // no axis
    return WeldForce{of_beam(m, weld, u), none};
  }
  const model::Model& model = m.system.model;
  weld::failure::Load load;
  load.time = model.control.end_time;
  load.resultants = weld.of_bricks() ? of_bricks(m, weld, u, load.area) : of_beam(m, weld, u);
  const auto function = weld::failure::make_function(model, weld::law_of(model, weld),
                                                     weld::failure::geometry_of(model, weld), weld.place, findings);
  return WeldForce{load.resultants, (*function)(load).value};
}

/// d3plot and binout hold numbers of single precision: beyond their range they would say infinity, of a solution that
/// ended normally.
void check_range(const Matrices& m, const Statics& s) {
  static constexpr double range = std::numeric_limits<float>::max();
  const auto fits = [](double value) { return std::abs(value) <= range; };  // not a number: no
  const auto refuse = [](const std::string& what) {
    throw Factorization::SolverError{fmt::format(
        "{} is no number that results can hold (at most {:.3g}): see the loads, prescribed motions and stiffnesses of "
        "the deck, and their units",
        what, range)};
  };
  for (std::size_t n = 0; n < m.system.model.nodes.size(); ++n)
    if (!std::ranges::all_of(s.motion[m.system.node_of[n]], fits))
      refuse(fmt::format("the displacement of node {}", m.system.model.nodes.id[n]));
  if (!fits(s.energy) || !fits(s.external)) refuse("the strain energy");
}

/// Where the softest motion of K with a little of M is largest, " (it moves most at node 7, along (0 0 1))", after a
/// few steps of inverse iteration: what moves without stiffness shows there. Empty where it is not found.
std::string place_of_softest_motion(const Matrices& m) {
  try {
    const Factorization shifted(m, small_shift(m));
    Columns x(m.size(), 1);
    for (std::size_t i = 0; i < m.size(); ++i) x.value[i] = 1.0 + 0.5 * std::sin(static_cast<double>(i));
    for (int pass = 0; pass < 3; ++pass) {
      std::vector<double> momentum(m.size());
      m.mass.multiply(x[0], momentum);
      x.value = std::move(momentum);
      shifted.solve(x);
      const double most = largest(x[0]);
      if (!(most > 0.0) || !std::isfinite(most)) return {};
      for (double& v : x.value) v /= most;
    }
    int node = -1;
    Vec3d along{};
    for (std::size_t k = 0; k < m.system.all_nodes(); ++k) {
      const Vec3d u = part_of(m.equations.motion(static_cast<int>(k), x[0]), false);
      if (norm(u) <= norm(along) * (1.0 + 1e-9)) continue;
      along = u;
      node = static_cast<int>(k);
    }
    if (node < 0) return {};
    const Vec3d d = unit(along);
    return fmt::format(" (it moves most at {}, along ({:.3g} {:.3g} {:.3g}))", name_of(m.system, node), d.x, d.y, d.z);
  } catch (const Factorization::SolverError&) {
    return {};
  }
}

/// K = L D L^t; where K is singular, the error says where.
Factorization factor_stiffness(const Matrices& m) {
  try {
    return Factorization(m, 0.0);
  } catch (const Factorization::SolverError& error) {
    if (!error.singular) throw;
    throw Factorization::SolverError{error.text + place_of_softest_motion(m) +
                                     "; hold it (*BOUNDARY_SPC_...), or ask for its modes (NEIG)"};
  }
}

/// What relaxes counts with its stiffness at once: a structure at rest is softer.
void warn_of_relaxation(const model::Model& model, Findings& findings) {
  std::vector<std::string> relaxing;
  for (const model::Material& material : model.materials) {
    const auto* law = std::get_if<kernel::ComposedLaw>(&material.law);
    const auto* spring = std::get_if<kernel::Spring>(&material.law);
    const bool is_viscoelastic =
        law != nullptr && (std::holds_alternative<kernel::Viscoelastic>(law->components->flow) ||
                           std::holds_alternative<kernel::GeneralViscoelastic>(law->components->flow));
    if (is_viscoelastic || (spring != nullptr && std::holds_alternative<kernel::MaxwellSpring>(spring->law)))
      relaxing.push_back(fmt::format("{} (*{})", material.id, material.keyword));
  }
  if (!relaxing.empty())
    findings.warning(
        {model.deck, 0, 0}, "*CONTROL_IMPLICIT_GENERAL",
        fmt::format("material{} {}: linear statics takes the stiffness at once (G0, K0), which relaxes in time",
                    relaxing.size() == 1 ? "" : "s", fmt::join(relaxing, ", ")),
        "for the structure after that time write the long-term stiffness (GI, KI) in its place");
}

}  // namespace

void check_statics(const model::Model& model, Findings& findings) {
  const char* const keyword = "*CONTROL_IMPLICIT_GENERAL";
  const Place deck{model.deck, 0, 0};
  for (const model::PrescribedMotion& motion : model.motions) {
    if (motion.quantity != model::PrescribedMotion::Quantity::displacement)
      findings.error(motion.place, "*BOUNDARY_PRESCRIBED_MOTION",
                     "linear statics takes prescribed displacements; velocities and accelerations are not built",
                     "write VAD 2 with the displacement at ENDTIM");
    if (!motion.drives_until(model.control.end_time))
      findings.error(motion.place, "*BOUNDARY_PRESCRIBED_MOTION",
                     "a motion that is not there from time 0 to ENDTIM is not built in linear statics",
                     "leave BIRTH and DEATH empty, and take out its *SENSOR_CONTROL");
  }
  for (const model::PressureLoad& load : model.pressure_loads)
    if (load.control != model::none)
      findings.error(load.place, "*LOAD_SEGMENT",
                     "a pressure that *SENSOR_CONTROL turns on and off is not built in linear statics",
                     "take out its *SENSOR_CONTROL");
  for (const model::BodyLoad& load : model.body_loads) {
    if (load.centrifugal)
      findings.error(deck, "*LOAD_BODY_RX",
                     "centrifugal forces (*LOAD_BODY_RX, _RY, _RZ) are not built in linear statics",
                     "put nodal forces in their place");
    if (!load.parts.empty() || !load.nodes.empty())
      findings.error(deck, "*LOAD_BODY", "body loads on some parts or nodes only are not built in linear statics",
                     "load all parts, or put nodal forces on these");
  }
  model::for_each_load(model, [&](const auto& load) { refuse_unknown(load, findings); });
  const auto sliding =
      std::count_if(model.contacts.begin(), model.contacts.end(), [](const model::Contact& c) { return c.slides(); });
  if (!model.body_stoppers.empty())
    findings.warning(model.body_stoppers.front().place, "*CONSTRAINED_RIGID_BODY_STOPPERS",
                     "stops of rigid bodies take no part in linear statics", "hold the body by *BOUNDARY_SPC");
  if (sliding > 0 || !model.walls.empty())
    findings.warning(deck, keyword,
                     fmt::format("{} contacts and {} rigid walls take no part in linear statics; ties do", sliding,
                                 model.walls.size()));
  const model::InitialState& initial = model.initial_state;
  if (!initial.shells.empty() || !initial.solids.empty() || !initial.axial_forces.empty() ||
      !initial.section_stresses.empty())
    findings.warning(deck, keyword,
                     "initial stresses load nothing in linear statics: results are what the loads add to them",
                     "put loads in their place where the structure is not in balance with them");
  warn_of_relaxation(model, findings);
  if (!model.initial_velocity.empty() || !model.initial_spin.empty())
    findings.warning(deck, keyword, "initial velocities take no part in linear statics");
  findings.note(deck, keyword, "linear statics: materials are elastic, welds do not fail, geometry is that of time 0");
}

void check_motions(const Matrices& m, Findings& findings) {
  prescribed(m, m.system.model.control.end_time, findings);
}

Statics solve_statics(const Matrices& m, Findings& findings) {
  const double time = m.system.model.control.end_time;
  const Nodal load = static_loads(m, time);
  Statics s;
  s.motion = prescribed(m, time, findings);
  const Nodal driving = internal_forces(m, s.motion).force;

  Columns q(m.size(), 1);
  const auto add_load = [&](const Nodal& f, double factor) {
    for (std::size_t k = 0; k < f.size(); ++k) {
      SixDof scaled = f[k];
      for (double& component : scaled) component *= factor;
      m.equations.add_load(static_cast<int>(k), scaled, q[0]);
    }
  };
  add_load(load, 1.0);
  add_load(driving, -1.0);
  const std::vector<double> right(q.value);
  const double most = largest(right);
  if (m.size() > 0) {
    const Factorization factor = factor_stiffness(m);
    if (factor.negative() > 0)
      throw Factorization::SolverError{fmt::format(
          "the stiffness matrix has {} negative eigenvalues: the structure is not held{}; hold it so that it "
          "cannot move as a rigid body (*BOUNDARY_SPC_..., *MAT_RIGID), or ask for its modes (NEIG)",
          factor.negative(), place_of_softest_motion(m))};
    factor.solve(q);
    s.cost = factor.cost();
  }
  std::vector<double> back(m.size());
  m.stiffness.multiply(q[0], back);
  for (std::size_t i = 0; i < back.size(); ++i) back[i] -= right[i];
  s.residual = most > 0.0 ? largest(back) / most : 0.0;
  if (!(s.residual < 1e-6))
    throw Factorization::SolverError{fmt::format(
        "forces are out of balance by {:.2g} of the largest: something can move without stiffness{}; hold the "
        "structure so that it cannot move as a rigid body",
        s.residual, place_of_softest_motion(m))};

  for (std::size_t k = 0; k < s.motion.size(); ++k) {
    const SixDof more = m.equations.motion(static_cast<int>(k), q[0]);
    for (std::size_t i = 0; i < 6; ++i) s.motion[k][i] += more[i];
  }
  Internal internal = internal_forces(m, s.motion);
  s.part_energy = std::move(internal.part_energy);
  for (const double e : s.part_energy) s.energy += e;
  s.energy += internal.link_energy;
  for (const BodyLink& link : m.links) s.joint.push_back(link.on_second(motion_of(link, s.motion)));
  s.reaction = std::move(internal.force);
  for (std::size_t k = 0; k < load.size(); ++k)
    for (std::size_t i = 0; i < 6; ++i) s.reaction[k][i] -= load[k][i];
  transfer_forces(m.system, s.reaction);
  s.external = 0.5 * product(load, s.motion);
  for (const Equations::Support& support : m.equations.supports()) {
    const double force = dot(support.taken, part_of(s.reaction[support.node], support.rotation));
    s.support_force.push_back(force);
    s.external += 0.5 * force * dot(support.taken, part_of(s.motion[support.node], support.rotation));
  }
  check_range(m, s);
  for (const weld::Weld& weld : m.system.ties.welds) s.weld.push_back(weld_force(m, weld, s.motion, findings));
  return s;
}

}  // namespace nugget::nvh
