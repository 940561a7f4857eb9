// SPDX-License-Identifier: Apache-2.0
// Element stiffness out of the batch kernels, against dual numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "deck/deck.hpp"
#include "element_stiffness.hpp"
#include "kernel/element/hexahedron.hpp"
#include "kernel/element/weld_beam.hpp"
#include "kernel/law/elastic_kernel.hpp"
#include "nvh/matrices/linear_model.hpp"
#include "nvh/matrices/matrices.hpp"
#include "one_element.hpp"
#include "reading/build.hpp"

namespace nugget::nvh {
namespace {

/// A distorted brick on nodes 1 to 8 and a slanted weld beam between nodes 9 and 10.
const char* const deck_text = R"(*KEYWORD
*CONTROL_TERMINATION
       1.0
*MAT_ELASTIC
         1   7.85e-9  210000.0       0.3
*SECTION_SOLID
         1         1
*HOURGLASS
         1         6       1.0
*PART
brick
         1         1         1         0         1
*MAT_SPOTWELD
         2   7.85e-9  210000.0       0.3     400.0    1000.0
*SECTION_BEAM
         2         9       1.0       2.0       1.0
       6.0       6.0
*PART
weld
         2         2         2
*NODE
       1             0.0             0.1             0.0
       2             2.1             0.0             0.2
       3             2.0             1.5             0.0
       4            -0.2             1.4             0.1
       5             0.1             0.0             1.0
       6             2.0             0.2             1.1
       7             2.2             1.6             0.9
       8             0.0             1.5             1.2
       9             5.0             0.0             0.0
      10             5.5             0.3             1.4
*ELEMENT_SOLID
       1       1       1       2       3       4       5       6       7       8
*ELEMENT_BEAM
       1       2       9      10
*END
)";

struct Assembled {
  Findings findings;
  model::Model model;
  weld::Ties ties;
  model::Model linear;
  system::System system;
  Matrices matrices;

  explicit Assembled(const char* text)
      : model(reading::build(deck::read_text(text, findings), findings)),
        ties(weld::tie(model, findings)),
        linear(linear_model(model, findings)),
        system(linear, ties, findings),
        matrices(system, findings) {}
};

std::vector<double> stiffness(const Assembled& a, const system::ElementGroup& group) {
  const std::size_t n = at(group.nodes_per_element * group.freedoms());
  std::vector<double> k(n * n);
  group.stiffness(0, a.matrices.rest, k);
  return k;
}

void expect_equal(const std::vector<double>& k, const std::vector<double>& reference, double gate) {
  ASSERT_EQ(k.size(), reference.size());
  double largest = 0.0;
  for (const double v : reference) largest = std::max(largest, std::abs(v));
  ASSERT_GT(largest, 0.0);
  for (std::size_t i = 0; i < k.size(); ++i) EXPECT_NEAR(k[i], reference[i], gate * largest) << "entry " << i;
}

constexpr double by_differences_gate = 1e-9;  // round-off of places over `size`

/// Forces over displacements by central differences of whole steps: of a law without memory exact to the square of
/// `size` over the element's length.
template <class Motion, class Cycle>
std::vector<double> by_differences(const Motion& rest, double size, Cycle&& cycle) {
  constexpr bool turns = requires {
    rest.w;
  };
  constexpr std::size_t per_node = turns ? 6 : 3;
  const std::size_t all = per_node * std::size(rest.x);
  double Vec3d::*const axis[3] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};
  std::vector<double> k(all * all);
  for (std::size_t j = 0; j < all; ++j)
    for (const double way : {-size, size}) {
      Motion motion = rest;
      Vec3d* moved = &motion.v[j / per_node];
      if constexpr (turns)
        if (j % 6 > 2) moved = &motion.w[j / 6];
      moved->*axis[j % 3] = way;
      for (std::size_t i = 0; i < std::size(rest.x); ++i) motion.x[i] += motion.v[i];
      const auto out = cycle(motion, 1.0);
      for (std::size_t i = 0; i < all; ++i) {
        const Vec3d* force = &out.f[i / per_node];
        if constexpr (turns)
          if (i % 6 > 2) force = &out.m[i / 6];
        k[all * i + j] += 0.5 * (force->*axis[i % 3]) / way;
      }
    }
  return k;
}

TEST(Stiffness, OfABrickIsTheDerivativeOfItsForces) {
  const Assembled a(deck_text);
  ASSERT_EQ(a.findings.errors(), 0);
  const kernel::LawKernel<kernel::Elastic> law(kernel::Elastic{210000.0, 0.3});
  const kernel::HexahedronProperties brick{7.85e-9, 6, 1.0, 0.0, 0.0};
  std::array<Vec3d, 8> x;
  kernel::SolidMotion<double> rest;
  for (int i = 0; i < 8; ++i) x[i] = rest.x[i] = a.model.nodes.x[i];
  const kernel::HexahedronLayout layout = kernel::hexahedron_layout(law);
  const auto cycle = [&](const kernel::SolidMotion<double>& motion, double step) {
    std::vector<double> state(at(layout.size()));
    kernel::start_hexahedron(layout, x, state.data(), 1, 0);
    return one_element(motion, state, [&](const auto& all, double* store) {
      return kernel::hexahedron_cycle(brick, law, all, step, store);
    });
  };
  const std::vector<double> k = stiffness(a, *a.system.groups[a.system.solid_location[0].group]);
  expect_equal(k, nugget::element_stiffness(rest, cycle), 1e-13);
  expect_equal(k, by_differences(rest, 1e-5, cycle), by_differences_gate);
}

TEST(Stiffness, OfAWeldBeamIsTheDerivativeOfItsForces) {
  const Assembled a(deck_text);
  ASSERT_EQ(a.findings.errors(), 0);
  const kernel::LawKernel<kernel::Elastic> law(kernel::Elastic{210000.0, 0.3});
  kernel::WeldBeamProperties beam;
  beam.density = 7.85e-9;
  beam.fibres = kernel::disc_fibres(6.0, 0.0, 2);
  kernel::NodalMotion<double, 2> rest;
  for (int i = 0; i < 2; ++i) rest.x[i] = a.model.nodes.x[8 + i];
  const kernel::WeldBeamLayout layout = kernel::weld_beam_layout(beam, law);
  const auto cycle = [&](const kernel::NodalMotion<double, 2>& motion, double step) {
    std::vector<double> state(at(layout.size()));
    kernel::start_weld_beam(layout, rest.x[0], rest.x[1], {}, state.data(), 1, 0);
    return one_element(motion, state, [&](const auto& all, double* store) {
      return kernel::weld_beam_cycle(beam, law, all, step, store);
    });
  };
  const std::vector<double> k = stiffness(a, *a.system.groups[a.system.beam_location[0].group]);
  expect_equal(k, nugget::element_stiffness(rest, cycle), 1e-13);
  expect_equal(k, by_differences(rest, 1e-5, cycle), by_differences_gate);
}

// The brick and the beam are free: T^t K T has no force for any rigid motion of either.
TEST(Stiffness, HasNoForceInARigidRotation) {
  const Assembled a(deck_text);
  const Vec3d spin{0.3, -0.5, 0.8};
  std::vector<double> q(a.matrices.size()), f(q.size());
  for (int e = 0; e < a.matrices.equations.size(); ++e) {
    const int node = a.matrices.equations.node_of(e);
    const Vec3d v = cross(spin, vec(a.matrices.rest.x[node]));
    const double u[6] = {v.x, v.y, v.z, spin.x, spin.y, spin.z};
    for (int i = 0; i < 6; ++i)
      for (const Equations::Term& t : a.matrices.equations.terms(node, i))
        if (t.equation == e) q[e] += t.factor * u[i];
  }
  a.matrices.stiffness.multiply(q, f);
  double largest = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) largest = std::max(largest, a.matrices.stiffness.diagonal(i));
  for (const double force : f) EXPECT_NEAR(force, 0.0, 1e-12 * largest);
}

}  // namespace
}  // namespace nugget::nvh
