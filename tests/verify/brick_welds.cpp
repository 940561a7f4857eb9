// SPDX-License-Identifier: Apache-2.0
// Welds of bricks: of the validation suite, resultants against the reactions of the supports, axes
// under rotation, failure against its closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "brick_decks.hpp"
#include "experiment.hpp"

namespace nugget::verify {
namespace {

using weld::Resultants;

constexpr double side = 5.317361;  // sqrt of the section of weld W1, d = 6
constexpr double step = 1e-7;      // below the stable step of all welds here

WeldData strong() {
  WeldData w;
  w.yield = 1e6;
  return w;
}

/// A deck of the prism, run with a constant step.
std::string deck_of(const Prism& prism, const WeldData& weld, const HourglassData& hourglass, int cycles,
                    const std::string& conditions) {
  return "*KEYWORD\n" + termination(cycles * step, 0.9, 0.0, 90) + curve(90, {{0.0, step}, {1.0, step}}) +
         brick_part(1, weld, hourglass) + prism.text() + conditions + "*END\n";
}

/// The bottom face stands, the top face moves as it is told to, all in all three directions.
class Clamped {
 public:
  Clamped(const Prism& prism, const WeldData& weld, const Motion& motion, int cycles,
          const HourglassData& hourglass = {}, int points = 60)
      : prism_(prism),
        run_(deck_of(
            prism, weld, hourglass, cycles,
            held(prism.bottom(), {1, 1, 1}) + moved(prism, prism.top(), {1, 1, 1}, motion, cycles * step, points))) {
    run_.run([&](const impact::Snapshot& now) {
      const weld::History& h = run_.history(now, run_.ties().welds[0].id);
      if (h.failed()) {
        failed_ = true;
        return;
      }
      last_ = h.resultants();
      failure_ = h.failure_value();
      load_ = *now.welds.brick_load(0);
      reaction_ = moment_ = {};
      Vec3d centre;
      for (int n : prism_.bottom()) centre += (1.0 / prism_.count()) * run_.position(now, n);
      for (const auto& r : now.supports.spc_reactions()) {
        reaction_ += r.force;
        moment_ += cross(vec(now.state.x[static_cast<std::size_t>(r.node)]) - centre, r.force);
      }
    });
  }
  const Resultants& last() const { return last_; }  ///< before failure
  const weld::BrickSection::Load& load() const { return load_; }
  Vec3d reaction() const { return reaction_; }
  Vec3d moment() const { return moment_; }  ///< of the reactions about the centre of the bottom face
  bool failed() const { return failed_; }
  double failure() const { return failure_; }  ///< the last value below 1
  Experiment& experiment() { return run_; }

 private:
  Prism prism_;
  Experiment run_;
  bool failed_ = false;
  Resultants last_;
  double failure_ = 0.0;
  weld::BrickSection::Load load_;
  Vec3d reaction_, moment_;
};

/// N/u of a prism that is pulled by the full top face, laterally free but for what holds it in its place.
double free_stiffness(const Prism& prism, const WeldData& weld, double pull) {
  const int cycles = 6000;
  const auto corner = [&](int i) { return prism.node(0, i); };
  const int n = static_cast<int>(std::lround(std::sqrt(prism.count()))) - 1;
  const Motion up = [=](const Vec3d&, double s) { return Vec3d{0, 0, pull * smooth(s)}; };
  Experiment run(deck_of(prism, weld, {}, cycles,
                         held(prism.bottom(), {0, 0, 1}) + held({corner(0)}, {1, 1, 0}) + held({corner(n)}, {0, 1, 0}) +
                             moved(prism, prism.top(), {0, 0, 1}, up, cycles * step, 60)));
  double force = 0.0;
  run.run([&](const impact::Snapshot& now) { force = run.weld(now, run.ties().welds[0].id).axial; });
  return force / pull;
}

// Sabotage to be caught: plane strain left in the free weld; forces of one face only counted twice; the radius for the
// diameter.
TEST(BrickWeld, A20AxialStiffness) {
  const WeldData w = strong();
  const Prism prism = square_prism(side, w.length);
  const double pull = 1e-4;
  expect_reference("A-20", "N/u, lateral faces free [N/mm]", free_stiffness(prism, w, pull), 3.9584e6, 2e-3);
  Clamped clamped(
      prism, w,
      [=](const Vec3d&, double s) {
        return Vec3d{0, 0, pull * smooth(s)};
      },
      3000);
  expect_reference("A-20", "N/u, lateral motion blocked [N/mm]", clamped.last().axial / pull, 5.32862e6, 2e-3);
  expect_reference("A-20", "equivalent diameter [mm]", clamped.experiment().ties().welds[0].diameter, 6.0, 2e-3);
}

}  // namespace
}  // namespace nugget::verify
