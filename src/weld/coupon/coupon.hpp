// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/units.hpp"
#include "weld/placement/placement_deck.hpp"

// Decks of the coupons in which spot welds are tested (docs/manual/coupon.md#the-coupons).
namespace nugget::weld {

enum class CouponKind { lap_shear, coach_peel, cross_tension, ks2 };

/// One test: a coupon and, of KS-2, the angle between the load and the sheets.
struct CouponTest {
  CouponKind kind = CouponKind::lap_shear;
  double angle = 0.0;  ///< [degrees]: 0 shear, 90 tension; that of the grips, also of lap (0), peel and cross (90)

  std::string name() const;   ///< of its deck and its folder: `ks2_45`
  std::string title() const;  ///< `KS-2, 45 degrees`
  int pull() const;           ///< degree of freedom along which the moving grip is driven: 1 x, 3 z
};

/// Lap shear, coach peel, cross tension, KS-2 at 0, 15, ... 90 degrees.
std::vector<CouponTest> coupon_tests();

/// What all coupons of one card have in common; lengths in its units. The weld is one of a *MAT_SPOTWELD, or a card of
/// its own that joins sheets 1 and 2 at the nodes of a set (an interpolation spot weld, a rivet).
struct CouponCard {
  model::Units units;
  std::string included;   ///< name of the card's file as it stands behind *INCLUDE
  int weld_material = 0;  ///< 0: none, the weld is a card of its own
  int weld_section = 0;   ///< a *SECTION_BEAM of the card; 0: it has none
  int weld_nodes = 0;     ///< node set of a weld that is a card of its own; 0: none
  double diameter = 0.0;
  WeldForm form = WeldForm::beam;
  struct Sheet {
    double thickness = 0.0;
    int section = 0, material = 0;  ///< ids in the card; 0: it has none, the coupon writes its own
  };
  std::array<Sheet, 2> sheets;  ///< lower, upper
  int used = 0;                 ///< ids of materials and sections up to this one are the card's
};

// Parts of every coupon.
inline constexpr int coupon_lower = 1, coupon_upper = 2, coupon_weld = 3, coupon_held_grip = 4, coupon_moving_grip = 5;
inline constexpr int coupon_weld_element = 90001;

/// The deck: the card included, sheets, weld, grips as rigid parts, the pull. The weld stands at the origin over the
/// centre of an element; elements are about as large as it. Output: grip force (bndout) and displacement (nodout) at
/// the same times, swforc, d3plot.
std::string write_coupon(const CouponCard& card, const CouponTest& test);

}  // namespace nugget::weld
