// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "weld_decks.hpp"

// Deck text of welds made of bricks. Units mm, t, s, N, MPa.
namespace nugget::verify {

/// Hourglass control of a part of bricks.
struct HourglassData {
  int type = 6;
  double coefficient = 1.0;
};

/// *PART, *SECTION_SOLID, *MAT_SPOTWELD and *HOURGLASS, all with the number `part`.
std::string brick_part(int part, const WeldData& weld, const HourglassData& hourglass = {});

/// A prism of bricks along z over a cross-section of quads: nodes and *ELEMENT_SOLID from 1 on, part 1.
struct Prism {
  std::vector<std::array<double, 2>> section;  ///< nodes of the cross-section
  std::vector<std::array<int, 4>> quads;       ///< of it, from 0
  std::vector<double> z;                       ///< heights of its layers of nodes

  int count() const { return static_cast<int>(section.size()); }
  int node(int layer, int i) const { return 1 + layer * count() + i; }  ///< user id
  std::vector<int> layer(int k) const;                                  ///< its user ids
  std::vector<int> bottom() const { return layer(0); }
  std::vector<int> top() const { return layer(static_cast<int>(z.size()) - 1); }
  Vec3d place(int id) const;
  std::string text() const;
};
/// Square cross-section of `side` in n times n quads about the axis, one layer of bricks of `length`.
Prism square_prism(double side, double length, int n = 1);

/// *BOUNDARY_SPC_NODE of the translations with a 1 in `held`.
std::string held(const std::vector<int>& nodes, std::array<int, 3> held);

/// Displacement of a point of the deck over s = 0..1.
using Motion = std::function<Vec3d(const Vec3d& x, double s)>;
/// *BOUNDARY_PRESCRIBED_MOTION_NODE of the translations with a 1 in `along` in `points` pieces; curves from
/// `first_curve` on.
std::string moved(const Prism& prism, const std::vector<int>& nodes, std::array<int, 3> along, const Motion& motion,
                  double duration, int points, int first_curve = 100);

/// A ramp from 0 to 1 with smooth ends: it excites no vibration.
double smooth(double s);

}  // namespace nugget::verify
