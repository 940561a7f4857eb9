// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "base/index.hpp"
#include "kernel/element/resultant_beam.hpp"
#include "kernel/element/truss.hpp"
#include "kernel/element/weld_beam.hpp"
#include "kernel/law/elastic_constants.hpp"
#include "model/model.hpp"
#include "system/beam.hpp"
#include "system/element_group.hpp"
#include "system/imposed_stress.hpp"

// Beams of the structure as BatchGroup wants them; see there. Spot-weld and discrete beams have files of their own.
namespace nugget::system {

/// ELFORM 1.
template <class Law>
struct IntegratedBeamElement {
  static constexpr int corners = 2;
  static constexpr bool rotational = true;
  using Layout = BeamLayout<kernel::WeldBeamLayout>;
  template <class R>
  using Motion = kernel::NodalMotion<R, 2>;
  using Places = std::array<Vec3d, 2>;

  kernel::WeldBeamProperties beam;
  kernel::LawKernel<Law> law;
  double nu;
  const model::Beams& beams;
  const std::vector<Vec3d>& x;  ///< by model node

  kernel::WeldBeamLayout layout() const { return kernel::weld_beam_layout(beam, law); }
  int state_size() const { return layout().size(); }
  int layers() const { return beam.fibres.count; }
  void start(double* state, int lane, model::Index e, const Places& place) const {
    kernel::start_weld_beam(layout(), place[0], place[1], beams.side(at(e), x), state, native_width, lane);
  }
  kernel::NodalMass nodal_mass(const Places& place) const {
    return kernel::weld_beam_nodal_mass(beam, norm(place[1] - place[0]), beam.density, nu);
  }
  double mass(model::Index, const Places& place) const { return 2.0 * nodal_mass(place).mass; }
  double nodal_inertia(model::Index, const Places& place) const { return nodal_mass(place).inertia; }

  template <class R>
  kernel::NodalForces<R, 2> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::weld_beam_cycle(beam, law, motion, dt, state);
  }
  /// Stress of a section point: rr in the first place, rs and rt in the fourth and the sixth.
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int k, const Places&) const {
    const int at = layout().fibre(k);
    const double strain = kernel::LawKernel<Law>::has_plastic_strain ? field(layout().history_of(k)) : 0.0;
    return {{field(at), 0.0, 0.0, field(at + 1), 0.0, field(at + 2)}, strain};
  }
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    for (int k = 0; k < layers(); ++k) change_fibre_point(field, put, layout().fibre(k), change);
  }
  template <class Field>
  double thickness(const Field& field) const {
    return field(Layout::length);
  }
  template <class Field>
  std::array<double, 8> resultants(const Field& field) const {
    return beam_resultants<Layout>(field);
  }
};

/// ELFORM 2.
struct ResultantBeamElement {
  static constexpr int corners = 2;
  static constexpr bool rotational = true;
  using Layout = BeamLayout<kernel::ResultantBeamLayout>;
  template <class R>
  using Motion = kernel::NodalMotion<R, 2>;
  using Places = std::array<Vec3d, 2>;

  kernel::ResultantBeamProperties beam;
  kernel::ElasticConstants elastic;
  const model::Beams& beams;
  const std::vector<Vec3d>& x;  ///< by model node

  int state_size() const { return Layout::count; }
  int layers() const { return 0; }
  void start(double* state, int lane, model::Index e, const Places& place) const {
    kernel::start_resultant_beam(place[0], place[1], beams.side(at(e), x), state, native_width, lane);
  }
  kernel::NodalMass nodal_mass(const Places& place) const {
    return kernel::resultant_beam_nodal_mass(beam, norm(place[1] - place[0]));
  }
  double mass(model::Index, const Places& place) const { return 2.0 * nodal_mass(place).mass; }
  double nodal_inertia(model::Index, const Places& place) const { return nodal_mass(place).inertia; }

  template <class R>
  kernel::NodalForces<R, 2> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::resultant_beam_cycle(beam, elastic.E, elastic.shear, motion, dt, state);
  }
  /// Its forces follow from places, not from rates: the derivative is taken with respect to these; see BatchGroup.
  template <class Field>
  void stiffness(const Field& field, const Places& place, std::span<double> k) const {
    using D = Dual<12>;
    kernel::NodalMotion<D, 2> motion;
    for (std::size_t a = 0; a < 2; ++a) {
      const int first = static_cast<int>(6 * a);
      motion.x[a] = {D::variable(place[a].x, first), D::variable(place[a].y, first + 1),
                     D::variable(place[a].z, first + 2)};
      motion.w[a] = {D::variable(0.0, first + 3), D::variable(0.0, first + 4), D::variable(0.0, first + 5)};
    }
    std::array<double, Layout::count> state{};
    for (int i = 0; i < Layout::count; ++i) state[i] = field(i);
    const auto out = kernel::resultant_beam_cycle(beam, elastic.E, elastic.shear, motion, 1.0, state.data());
    std::size_t row = 0;
    const auto put = [&](const Vec3<D>& f) {
      for (const D* c : {&f.x, &f.y, &f.z}) {
        for (std::size_t j = 0; j < 12; ++j) k[12 * row + j] = c->d[j];
        ++row;
      }
    };
    for (std::size_t a = 0; a < 2; ++a) {
      put(out.f[a]);
      put(out.m[a]);
    }
  }
  template <class Field>
  ElementGroup::Layer layer(const Field&, int, const Places&) const {
    return {};
  }
  template <class Field>
  double thickness(const Field& field) const {
    return field(Layout::length);
  }
  template <class Field>
  std::array<double, 8> resultants(const Field& field) const {
    return beam_resultants<Layout>(field);
  }
};

/// ELFORM 3.
template <class Law>
struct TrussElement {
  static constexpr int corners = 2;
  static constexpr bool rotational = false;
  using Layout = BeamLayout<kernel::TrussLayout>;
  template <class R>
  using Motion = kernel::NodalMotion<R, 2>;
  using Places = std::array<Vec3d, 2>;

  double area, density, mass_per_length;
  kernel::LawKernel<Law> law;

  int state_size() const { return Layout::history + law.fibre_history(); }
  int layers() const { return 1; }
  void start(double* state, int lane, model::Index, const Places& place) const {
    for (int i = 0; i < state_size(); ++i) state[i * native_width + lane] = 0.0;
    state[Layout::alive * native_width + lane] = state[Layout::density_scale * native_width + lane] = 1.0;
    state[Layout::length * native_width + lane] = norm(place[1] - place[0]);
  }
  double mass(model::Index, const Places& place) const {
    return (density * area + mass_per_length) * norm(place[1] - place[0]);
  }
  double nodal_inertia(model::Index, const Places&) const { return 0.0; }

  template <class R>
  kernel::NodalForces<R, 2> cycle(const Motion<R>& motion, double dt, double* state) const {
    return kernel::truss_cycle(area, density, law, motion, dt, state);
  }
  template <class Field>
  ElementGroup::Layer layer(const Field& field, int, const Places&) const {
    const double strain = kernel::LawKernel<Law>::has_plastic_strain ? field(Layout::history) : 0.0;
    return {{field(Layout::stress), 0.0, 0.0, 0.0, 0.0, 0.0}, strain};
  }
  template <class Field, class Put, class Change>
  void change_stresses(const Field& field, const Put& put, const Change& change) const {
    change_fibre_point(field, put, Layout::stress, change);
  }
  template <class Field>
  double thickness(const Field& field) const {
    return field(Layout::length);
  }
  template <class Field>
  std::array<double, 8> resultants(const Field& field) const {
    return {field(Layout::force)};
  }
};

}  // namespace nugget::system
