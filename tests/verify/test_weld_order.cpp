// SPDX-License-Identifier: Apache-2.0
// Welds over sheets that penetrate each other: contact moves the sheets apart first, then the welds are projected onto
// them. And what a free stack of welded sheets must conserve, whichever of the eight projection cases its welds are.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "brick_decks.hpp"
#include "experiment.hpp"
#include "momenta.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

using testing::HasSubstr;

std::string text(const Findings& findings) {
  std::string all;
  for (const Finding& f : findings.all()) all += to_string(f) + '\n';
  return all;
}

// ---- contact first, then ties

/// Two sheets of 3 x 3 shells of 10 mm, t = 1, with their mid-surfaces closer than 1 mm. The lower one is held, the
/// upper one moved by 1 um along x, without turning. A weld of 5 mm, as a beam or as a brick of the same area, stands
/// between the mid-surfaces in the middle.
struct Overlapping {
  double apart = 0.6;
  std::string contact = "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE";
  bool brick = false;
  int ignore = 0;

  static constexpr double shift = 1e-3, diameter = 5.0;
  static WeldData weld() { return {.diameter = diameter, .yield = 1e9}; }

  std::string weld_text() const {
    if (!brick) return weld_part(9, weld()) + beam_between(901, 9, 901, {15, 15, 0}, 902, {15, 15, apart});
    const double h = 0.5 * std::sqrt(weld().area());
    std::string nodes = "*NODE\n";
    int id = 901;
    for (const double z : {0.0, apart})
      for (const auto& [x, y] : {std::pair{-h, -h}, {h, -h}, {h, h}, {-h, h}})
        nodes += node_line(id++, 15 + x, 15 + y, z);
    return brick_part(9, weld()) + nodes + "*ELEMENT_SOLID\n" +
           element_line(901, 9, {901, 902, 903, 904, 905, 906, 907, 908});
  }

  std::string sliding() const {
    const bool single = contact.find("SINGLE") != std::string::npos;
    return "*CONTROL_CONTACT\n" + fields({0.1}) + fields({0, 0, 0, 0, 0, 0, 0, 0}) + "*" + contact + "\n" +
           (single ? fields({0}) : fields({1, 2, 3, 3})) + fields({0}) + fields({1, 1}) +
           (ignore == 0 ? "" : fields({0}) + fields({0}) + fields({1, static_cast<double>(ignore)}));
  }

  std::string deck() const {
    const SheetMesh lower{.first = 1, .part = 1, .corner = {}, .nx = 3, .ny = 3},
        upper{.first = 101, .part = 2, .corner = {0, 0, apart}, .nx = 3, .ny = 3};
    std::string sets = "*SET_NODE_LIST\n" + fields({1}), second = "*SET_NODE_LIST\n" + fields({2});
    for (int first : {0, 8}) {
      for (int n = 1; n <= 8; ++n) sets += fmt::format("{:10d}", first + n);
      for (int n = 1; n <= 8; ++n) second += fmt::format("{:10d}", 100 + first + n);
      sets += '\n';
      second += '\n';
    }
    return "*KEYWORD\n" + termination(4e-5) + sheet_part(1, 1.0) + sheet_part(2, 1.0) + lower.text() + upper.text() +
           weld_text() + weld_contact_to_set(9, {1, 2}) + sliding() + sets + second + "*BOUNDARY_SPC_SET\n" +
           fields({1, 0, 1, 1, 1, 1, 1, 1}) + fields({2, 0, 0, 1, 1, 1, 1, 1}) + "*BOUNDARY_PRESCRIBED_MOTION_SET\n" +
           fields({2, 1, 2, 1, shift}) + curve(1, {{0, 0}, {2e-5, 1}, {1, 1}}) + "*END\n";
  }
};

/// What the supports carry in the end: along x at the sheet that is moved, and in all, which must be nothing.
struct Carried {
  double shear = 0.0;
  Vec3d force, moment;
};
Carried carried(Experiment& run) {
  Carried all;
  run.run([&](const impact::Snapshot& now) {
    all = {};
    const auto add = [&](const auto& reactions) {
      for (const auto& r : reactions) {
        all.force += r.force;
        all.moment += r.moment + cross(vec(now.state.x[r.node]), r.force);
      }
    };
    add(now.components.supports.spc_reactions());
    add(now.components.supports.motion_reactions());
    for (const auto& r : now.components.supports.motion_reactions()) all.shear += r.force.x;
  });
  return all;
}

// Sabotage to be caught: ties before contact (length 0.6, force 2643 N, a couple of 1057 N mm missing, step 0.6 of the
// right one; at 0.04 no tie at all).
TEST(WeldOrder, WeldsAreProjectedOntoTheSheetsThatContactMovedApart) {
  const std::string name = "weld over sheets that contact moves apart";
  for (const bool brick : {false, true})
    for (const char* contact : {"CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", "CONTACT_AUTOMATIC_SINGLE_SURFACE",
                                "CONTACT_AUTOMATIC_NODES_TO_SURFACE"})
      for (const double apart : {0.6, 0.04}) {
        const Overlapping stack{apart, contact, brick};
        Experiment run(stack.deck());
        const std::string what =
            fmt::format("{}, {} apart, {}", brick ? "brick" : "beam", apart, std::string(contact).substr(8));
        ASSERT_EQ(run.ties().welds.size(), 1u);
        EXPECT_TRUE(run.ties().welds[0].tied) << what << '\n' << text(run.findings());
        for (const weld::Projection& p : run.ties().welds[0].ends) EXPECT_EQ(p.projection_case, 4) << what;
        EXPECT_THAT(text(run.findings()),
                    HasSubstr(fmt::format("the sheets penetrated each other by {:.4g}; contact moved", 1.0 - apart)));
        const Carried now = carried(run);
        const WeldData weld = Overlapping::weld();
        // The sheets touch to a thousandth of their thickness.
        expect_reference(name, what + ": length [mm]", run.ties().welds[0].length, 1.0, 1e-3);
        expect_reference(name, what + ": force under 1 um of shear, G A / (t1 + t2) 2 [N]", now.shear,
                         weld.shear_modulus() * weld.area() * Overlapping::shift, 2e-3);
        expect_reference(name, what + ": sum of the supports' forces over that", norm(now.force) / now.shear, 0.0,
                         1e-10, 1.0);
        expect_reference(name, what + ": sum of their moments over force times 1 mm", norm(now.moment) / now.shear, 0.0,
                         1e-9, 1.0);
        if (!brick)
          expect_reference(name, what + ": first step over 0.9 (t1 + t2)/2 / c", run.simulation().first_step(),
                           0.9 / std::sqrt(weld.E / weld.density), 1e-3);
      }
}

// IGNORE = 1 leaves the sheets where they are, and the weld between them as short as they are apart.
TEST(WeldOrder, WithIgnoreTheSheetsStay) {
  Experiment run(Overlapping{.ignore = 1}.deck());
  EXPECT_NEAR(run.ties().welds.at(0).length, 0.6, 1e-12);
  EXPECT_THAT(text(run.findings()),
              HasSubstr("the sheets penetrate each other by 0.4; over shell 5 of part 1, 0 away"));
}

// Sheets in the wrong order, 0.2 apart: contact moves them apart as they lie, and a weld that names its sheets would be
// turned over (case 7). A plain beam holds both, as long as they are apart. Sabotage: a plain beam refused, or its ends
// tied to the sheets that were theirs.
TEST(WeldOrder, CrossedSheetsAreRefusedWhereTheWeldNamesThem) {
  for (const bool named : {true, false}) {
    const SheetMesh first{.first = 1, .part = 1, .corner = {0, 0, 0.6}, .nx = 3, .ny = 3},
        second{.first = 101, .part = 2, .corner = {0, 0, 0.4}, .nx = 3, .ny = 3};
    const std::string parts = named ? fmt::format("{:8d}{:8d}\n", 1, 2) : "";
    Experiment run("*KEYWORD\n" + termination(1e-6) + sheet_part(1, 1.0) + sheet_part(2, 1.0) + first.text() +
                   second.text() + weld_part(9, Overlapping::weld()) + "*NODE\n" + node_line(901, 15, 15, 0) +
                   node_line(902, 15, 15, 1) + (named ? "*ELEMENT_BEAM_PID\n" : "*ELEMENT_BEAM\n") +
                   element_line(901, 9, {901, 902}) + parts + weld_contact_to_set(9, {1, 2}) + Overlapping{}.sliding() +
                   "*END\n");
    const weld::Weld& weld = run.ties().welds.at(0);
    EXPECT_EQ(weld.tied, !named);
    for (const weld::Projection& p : weld.ends) EXPECT_EQ(p.projection_case, named ? 7 : 4);
    EXPECT_NEAR(weld.length, 1.0, 1e-3);  // of the refused one as it is drawn
    if (!named) continue;
    EXPECT_THAT(text(run.findings()), HasSubstr("would turn the weld over or crush it (case 7)"));
  }
}

// ---- free stacks

/// A stack of two or three sheets somewhere in space, at random: thicknesses, meshes, place and direction, velocities
/// of all nodes; welds of one projection case.
class RandomStack {
 public:
  RandomStack(int projection_case, int sheets, unsigned seed) : case_(projection_case), random_(seed) {
    size_ = between(7.0, 12.0);
    const Vec3d a{between(-1, 1), between(-1, 1), between(-1, 1)};
    e_[2] = unit(a);
    e_[0] = unit(cross(e_[2], Vec3d{0.3, -0.5, 0.7}));
    e_[1] = cross(e_[2], e_[0]);
    origin_ = {between(-20, 20), between(-20, 20), between(-20, 20)};
    for (int i = 0; i < sheets; ++i) thickness_.push_back(between(0.7, 1.8));
    if (case_ == 4) contact_ = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + fields({0}) + fields({0}) + fields({1, 1});
    lay_sheets();
    for (int i = 0; i + 1 < sheets; ++i) add_weld(i);
  }

  std::string deck() const {
    std::string ids = "*SET_PART_LIST\n" + fields({1});
    for (int i = 0; i < parts_; ++i) ids += fmt::format("{:10d}", i + 1);
    return "*KEYWORD\n" + termination(1e-4) + sheets_ + weld_part(9, {.diameter = 5.0, .yield = 1e9}) + beams_ +
           "*CONTACT_SPOTWELD\n" + fields({9, 1, 3, 2}) + fields({0}) + fields({1, 1}) + ids + '\n' + contact_ +
           "*INITIAL_VELOCITY_NODE\n" + velocities_ + "*END\n";
  }

 private:
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  Vec3d at_place(double u, double v, double w) const { return origin_ + u * e_[0] + v * e_[1] + w * e_[2]; }
  double touching(int lower) const { return 0.5 * (thickness_[at(lower)] + thickness_[at(lower + 1)]); }

  /// A sheet of 3 x 3 shells at the height w, from u0 on. All sheets have the same mesh in their planes, with nodes
  /// inside moved at random, so that edges and nodes lie above each other.
  void add_sheet(double thickness, double w, double u0, bool turned = false) {
    const int part = ++parts_;
    std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
    const int first = 100 * part;
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 3; ++i) {
        const Vec3d x = at_place(u0 + plan(i, j).x, plan(i, j).y, w);
        nodes += node_line(first + 4 * j + i, x.x, x.y, x.z);
        velocities_ += fields({static_cast<double>(first + 4 * j + i), between(-3e3, 3e3), between(-3e3, 3e3),
                               between(-3e3, 3e3), between(-99, 99), between(-99, 99), between(-99, 99)});
      }
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const int n = first + 4 * j + i;
        shells += turned ? element_line(first + 3 * j + i, part, {n, n + 4, n + 5, n + 1})
                         : element_line(first + 3 * j + i, part, {n, n + 1, n + 5, n + 4});
      }
    sheets_ += sheet_part(part, thickness) + nodes + shells;
  }

  Vec3d plan(int i, int j) const { return plan_[at(4 * j + i)]; }

  void lay_sheets() {
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 3; ++i) {
        const bool inside = i % 3 != 0 && j % 3 != 0;
        const double by = inside ? 0.15 * size_ : 0.0;
        plan_.push_back({i * size_ + between(-by, by), j * size_ + between(-by, by), 0.0});
      }
    height_.push_back(0.0);
    for (std::size_t i = 0; i + 1 < thickness_.size(); ++i) {
      const double share = case_ == 4 ? between(0.3, 0.9) : case_ == 5 ? 12.0 : case_ == 6 ? 2.5 : 1.0;
      height_.push_back(height_.back() + share * touching(static_cast<int>(i)));
    }
    // Sheets that have passed through each other: the upper ones of the weld lie below.
    const bool crossed = case_ == 7 || case_ == 8;
    for (std::size_t i = 0; i < thickness_.size(); ++i)
      add_sheet(thickness_[i], crossed ? height_.back() - height_[i] : height_[i], case_ == 6 && i > 0 ? size_ : 0.0,
                case_ == 8 && i == 0);
    if (case_ == 6) add_sheet(1.0, -0.9, 2.0 * size_);
  }

  /// A point over the middle shell, on one of its edges, on a node, or beside the first sheet.
  Vec3d point() {
    const auto corner = [&](double s, double t) {
      return (1 - s) * (1 - t) * plan(1, 1) + s * (1 - t) * plan(2, 1) + s * t * plan(2, 2) + (1 - s) * t * plan(1, 2);
    };
    switch (case_) {
      case 2: return corner(between(0.1, 0.9), 1.0);
      case 3: return corner(1.0, 1.0);
      case 6: return {3.0 * size_ + between(1.5, 2.5), between(1.2, 1.8) * size_, 0.0};
      default: return corner(between(0.1, 0.9), between(0.1, 0.9));
    }
  }

  void add_weld(int lower) {
    const Vec3d p = point();
    const int id = 901 + 2 * lower;
    const auto off = [&] { return case_ == 7 || case_ == 8 ? 0.0 : between(-0.1, 0.1); };
    const double beside = case_ == 5 ? 3.0 * size_ + 9.0 : 0.0;
    const Vec3d a = at_place(p.x + (lower == 0 ? beside : 0.0), p.y, height_[at(lower)] + off()),
                b = at_place(p.x, p.y, height_[at(lower + 1)] + off());
    const bool named = case_ == 7 || case_ == 8;
    beams_ += "*NODE\n" + node_line(id, a.x, a.y, a.z) + node_line(id + 1, b.x, b.y, b.z) +
              (named ? "*ELEMENT_BEAM_PID\n" : "*ELEMENT_BEAM\n") + element_line(id, 9, {id, id + 1}) +
              (named ? fmt::format("{:8d}{:8d}\n", lower + 1, lower + 2) : "");
  }

  int case_, parts_ = 0;
  std::mt19937 random_;
  double size_ = 0.0;
  Vec3d origin_, e_[3];
  std::vector<double> thickness_, height_;
  std::vector<Vec3d> plan_;
  std::string sheets_, beams_, velocities_, contact_;
};

// Sabotage to be caught: ties before contact (case 4); N2 and N3 exchanged, moments of the weld not handed over (1 to
// 4, 6); a mass left on the tied node.
TEST(WeldStack, KeepsMomentumInEveryProjectionCase) {
  for (int projection_case = 1; projection_case <= 8; ++projection_case) {
    double linear = 0.0, angular = 0.0;
    for (const int sheets : {2, 3})
      for (unsigned seed = 1; seed <= 4; ++seed) {
        Experiment run(
            RandomStack(projection_case, sheets, 100 * seed + static_cast<unsigned>(projection_case)).deck());
        const std::string what = fmt::format("case {}, {} sheets, seed {}", projection_case, sheets, seed);
        EXPECT_EQ(run.ties().welds.at(0).ends[0].projection_case, projection_case) << what << '\n'
                                                                                   << text(run.findings());
        Momenta start;
        const impact::Outcome outcome = run.run([&](const impact::Snapshot& now) {
          const Momenta m = momenta(now);
          if (now.state.cycle == 0) start = m;
          linear = std::max(linear, norm(m.linear - start.linear) / start.linear_scale);
          angular = std::max(angular, norm(m.angular - start.angular) / start.angular_scale);
        });
        EXPECT_EQ(outcome.termination, impact::Termination::normal) << what << ": " << outcome.message;
        EXPECT_GT(run.simulation().state().cycle, 50) << what;
      }
    expect_reference("momentum of welded stacks",
                     fmt::format("case {}, two and three sheets: drift of the linear momentum", projection_case),
                     linear, 0.0, 1e-12, 1.0);
    expect_reference("momentum of welded stacks",
                     fmt::format("case {}, two and three sheets: drift of the angular momentum", projection_case),
                     angular, 0.0, 1e-12, 1.0);
  }
}

}  // namespace
}  // namespace nugget::verify
