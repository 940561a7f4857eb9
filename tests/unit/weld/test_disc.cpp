// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/disc.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/weld/assembly.hpp"

namespace nugget::weld {
namespace {

using std::numbers::pi;
using test::Assembly;
using test::text;
using testing::HasSubstr;
using testing::Not;

double sum(const std::array<double, 4>& a) {
  return a[0] + a[1] + a[2] + a[3];
}

// ---- the integrals

// A bilinear function of a rectangle's coordinates is harmonic: its mean over a disc is its value in the middle.
// Sabotage: the arcs' Jacobian without the twist; shares of a side from its middle.
TEST(DiscIntegrals, OfARectangleThatHoldsTheDisc) {
  const Corners k{Vec3d{-3, -2, 0}, {7, -2, 0}, {7, 6, 0}, {-3, 6, 0}};
  const auto w = integrals_over_disc(k, false, 1.7);
  ASSERT_TRUE(w);
  const std::array<double, 4> mean = shape_functions(-0.4, -0.5);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((*w)[i], pi * 1.7 * 1.7 * mean[i], 1e-12);
}

// All of a skewed segment: 1/4 of the integral of (1 + xi xi_k)(1 + eta eta_k)(j0 + j1 xi + j2 eta).
TEST(DiscIntegrals, OfASkewedSegmentInsideTheDisc) {
  const Corners k{Vec3d{-1, -1.2, 0}, {1.5, -0.8, 0}, {1.1, 1.4, 0}, {-0.7, 0.6, 0}};
  const auto w = integrals_over_disc(k, false, 10.0);
  ASSERT_TRUE(w);
  const Vec3d b = 0.25 * (k[1] + k[2] - k[0] - k[3]), c = 0.25 * (k[2] + k[3] - k[0] - k[1]),
              d = 0.25 * (k[0] + k[2] - k[1] - k[3]);
  const double j0 = cross(b, c).z, j1 = cross(b, d).z, j2 = cross(d, c).z;
  const double xi[4] = {-1, 1, 1, -1}, eta[4] = {-1, -1, 1, 1};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR((*w)[i], j0 + (j1 * xi[i] + j2 * eta[i]) / 3.0, 1e-13);
}

TEST(DiscIntegrals, OfSegmentsOverEdgeAndCorner) {
  const Corners above{Vec3d{-5, 0, 0}, {5, 0, 0}, {5, 8, 0}, {-5, 8, 0}};
  const auto half = integrals_over_disc(above, false, 2.0);
  ASSERT_TRUE(half);
  EXPECT_NEAR(sum(*half), 2.0 * pi, 1e-12);
  // The middle of a half disc is 4 R / 3 pi off its straight side.
  EXPECT_NEAR(((*half)[2] + (*half)[3]) * 8.0 / sum(*half), 8.0 / (3.0 * pi), 1e-12);
  const Corners beside{Vec3d{0, 0, 0}, {5, 0, 0}, {5, 8, 0}, {0, 8, 0}};
  EXPECT_NEAR(sum(*integrals_over_disc(beside, false, 2.0)), pi, 1e-12);
  const Corners far{Vec3d{3, 3, 0}, {5, 3, 0}, {5, 8, 0}, {3, 8, 0}};
  EXPECT_EQ(sum(*integrals_over_disc(far, false, 2.0)), 0.0);
}

// Skewed quadrilaterals and triangles, some numbered the other way round, that tile a square about the disc: shape
// functions sum up to 1 and give back the place, so the shares sum up to the area and the places to its middle.
TEST(DiscIntegrals, OfAPatchOfAllShapes) {
  const Vec3d p{0.3, -0.2, 0}, q{-1.1, 0.9, 0}, a{-4, -4, 0}, b{4, -4, 0}, c{4, 4, 0}, d{-4, 4, 0};
  struct Piece {
    Corners corner;
    bool triangle;
  };
  const std::vector<Piece> patch{
      {{a, b, p, q}, false}, {{c, d, q, p}, false}, {{b, p, c, c}, true}, {{d, a, q, q}, true}};
  for (const double radius : {0.2, 1.0, 1.6, 2.9}) {
    double area = 0.0;
    Vec3d moment;
    for (const Piece& piece : patch) {
      const auto w = integrals_over_disc(piece.corner, piece.triangle, radius);
      ASSERT_TRUE(w);
      area += sum(*w);
      for (int i = 0; i < 4; ++i) moment += (*w)[i] * piece.corner[i];
    }
    EXPECT_NEAR(area, pi * radius * radius, 1e-11 * radius * radius) << radius;
    EXPECT_LT(norm(moment), 1e-11 * radius * radius * radius) << radius;
  }
}

TEST(DiscIntegrals, DoNotDependOnTheNumbering) {
  const Corners k{Vec3d{-1, -1.2, 0}, {1.5, -0.8, 0}, {1.1, 1.4, 0}, {-0.7, 0.6, 0}};
  const auto w = *integrals_over_disc(k, false, 1.1);
  const auto other = *integrals_over_disc({k[2], k[1], k[0], k[3]}, false, 1.1);
  for (const auto& [i, j] : {std::pair{0, 2}, {1, 1}, {2, 0}, {3, 3}}) EXPECT_NEAR(w[i], other[j], 1e-14);
}

TEST(DiscIntegrals, NothingOfASegmentThatIsNotConvex) {
  EXPECT_FALSE(integrals_over_disc({Vec3d{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, false, 1.0));
}

// ---- discs on sheets

/// Two sheets of 6 x 6 shells, 1 mm apart, and a weld beam of 5 mm over (x, y).
struct WeldedSheets : Assembly {
  Index lower, upper, welds;
  Findings findings;
  WeldedSheets(double size, double x, double y, double diameter = 5.0)
      : lower(sheet(1.0, {0, 0, 0}, 6, 6, size)), upper(sheet(1.0, {0, 0, 1}, 6, 6, size)), welds(beam_part(diameter)) {
    tie({welds}, {lower, upper});
    beam(welds, {x, y, 0}, {x, y, 1});
    model.control.weld_tie = model::WeldTie::area;
  }
  Ties tied() { return weld::tie(model, findings); }
};

Vec3d centre_of(const Disc& disc, const std::vector<Vec3d>& x) {
  Vec3d centre;
  for (std::size_t k = 0; k < disc.nodes.size(); ++k) centre += disc.weights[k] * x[disc.nodes[k]];
  return centre;
}

// Wherever the weld stands: weights add up to 1, their centre is the weld. Sabotage: the neighbours left out.
TEST(Disc, HasItsCentreUnderTheWeld) {
  for (const double size : {1.0, 2.5, 6.0})
    for (const auto& [u, v] : {std::pair{0.5, 0.5}, {0.0, 0.0}, {0.0, 0.5}, {0.25, 0.4}}) {
      WeldedSheets a(size, (3 + u) * size, (3 + v) * size);
      const Ties ties = a.tied();
      for (const Tie& tie : ties.ties) {
        ASSERT_TRUE(tie.by_area());
        EXPECT_NEAR(tie.disc.radius, std::max(2.5, 0.5 * size), 1e-12);
        double sum = 0.0;
        for (const double w : tie.disc.weights) sum += w;
        EXPECT_NEAR(sum, 1.0, 1e-13);
        EXPECT_NEAR(tie.disc.covered, 1.0, 1e-12);
        EXPECT_LT(norm(centre_of(tie.disc, ties.x) - tie.point), 1e-12 * size);
      }
    }
}

// On a fine mesh the forces reach as far as those of the disc, R, but for what linear shape functions spread a
// quadratic function: h^2/6 in either direction. By segment they reach one element, wherever the disc ends.
TEST(Disc, ReachesAsFarAsTheNugget) {
  WeldedSheets a(1.0, 3.2, 2.9);
  const Ties ties = a.tied();
  const WeldReach hold = reaches(a.model, ties).at(0);
  EXPECT_NEAR(hold.by_area, std::sqrt(6.25 + 2.0 / 3.0) / 2.5, 0.01);
  EXPECT_LT(hold.by_segment, 0.5);
  WeldedSheets coarse(10.0, 35.0, 35.0);
  const Ties one_element = coarse.tied();  // a disc of radius h/2 touches its sides
  EXPECT_NEAR(reaches(coarse.model, one_element).at(0).by_area, 4.0, 1e-9);
  EXPECT_THAT(text(coarse.findings), HasSubstr("elements too large for their nuggets"));
}

TEST(Disc, IsCutOffAtAFreeEdge) {
  WeldedSheets a(2.0, 1.0, 5.0);
  const Ties ties = a.tied();
  const Disc& disc = ties.ties.at(0).disc;
  // What lies beyond a chord at the distance c: R^2 acos(c/R) - c sqrt(R^2 - c^2).
  const double R = 2.5, c = 1.0, cut = R * R * std::acos(c / R) - c * std::sqrt(R * R - c * c);
  EXPECT_NEAR(disc.covered, 1.0 - cut / (pi * R * R), 1e-12);
  const double first_moment = 2.0 / 3.0 * std::pow(R * R - c * c, 1.5);  // of the cut part, towards the edge
  EXPECT_NEAR(centre_of(disc, ties.x).x, 1.0 + first_moment / (pi * R * R - cut), 1e-12);
  EXPECT_THAT(text(a.findings), HasSubstr("2 weld ends are tied to discs of their sheets, 2 of them cut off"));
}

TEST(Disc, GoesOnIntoAnotherPartButNotOverAFold) {
  WeldedSheets flat(2.0, 6.0, 5.0), two_parts(2.0, 6.0, 5.0), folded(2.0, 6.0, 5.0);
  const Index other = two_parts.sheet_part();
  for (Index e = 0; e < 72; ++e)
    if (two_parts.model.nodes.x[two_parts.model.shells.node[e][0]].x > 5.0) two_parts.model.shells.part[e] = other;
  two_parts.model.contacts[0].b.parts.push_back(other);
  for (Vec3d& x : folded.model.nodes.x)
    if (x.x > 6.5) x = {6.0, x.y, x.z + x.x - 6.0};
  EXPECT_EQ(two_parts.tied().ties.at(0).disc.nodes, flat.tied().ties.at(0).disc.nodes);
  const Ties ties = folded.tied();
  EXPECT_NEAR(ties.ties.at(0).disc.covered, 0.5, 1e-12);
}

TEST(Disc, OfAnEndFaceOfBricksIsOne) {
  WeldedSheets a(3.0, 4.0, 4.0);
  const Index bricks = a.solid_part();
  a.brick(bricks, 10.0, 11.0, 0.0, 1.0, 4.0);
  a.model.contacts[0].a.parts.push_back(bricks);
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(1);
  ASSERT_TRUE(weld.of_bricks());
  for (const Projection& p : weld.ends) {
    ASSERT_TRUE(p.tie.by_area());
    EXPECT_NEAR(p.tie.disc.radius, 0.5 * std::sqrt(16.0 * 4.0 / pi), 1e-12);  // of the face's area
    EXPECT_LT(norm(centre_of(p.tie.disc, ties.x) - Vec3d{10.0, 11.0, p.tie.point.z}), 1e-12);
  }
}

TEST(Disc, StaysWithTheSegmentWhereThereIsNone) {
  WeldedSheets no_diameter(3.0, 4.0, 4.0, 0.0), bent(3.0, 10.0, 10.0);
  const Ties ties = no_diameter.tied();
  EXPECT_FALSE(ties.ties.at(0).by_area());
  EXPECT_THAT(text(no_diameter.findings),
              HasSubstr("2 weld ends are not hung on a disc, first of beam weld 1000: it has no "
                        "diameter"));
  bent.model.nodes.x[bent.model.shells.node[21][2]] = {10.0, 10.0, 0.0};  // over the diagonal
  bent.tied();
  EXPECT_THAT(text(bent.findings), HasSubstr("is not convex"));
}

TEST(Disc, IsOffByDefault) {
  WeldedSheets a(3.0, 4.0, 4.0);
  a.model.control.weld_tie = model::WeldTie::segment;
  for (const Tie& tie : a.tied().ties) EXPECT_FALSE(tie.by_area());
  EXPECT_THAT(text(a.findings), Not(HasSubstr("disc")));
}

}  // namespace
}  // namespace nugget::weld
