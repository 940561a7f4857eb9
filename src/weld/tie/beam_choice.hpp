// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "weld/tie/reference.hpp"

namespace nugget::weld {

/// What a weld's end is tied to: a place on a sheet.
struct PlaceOnPart {
  Index part = none;
  Vec3d point, normal;  ///< of the shell there; zero where there is none
};

PlaceOnPart place_of(const Candidate& candidate, const std::vector<Vec3d>& x);

/// The best of an end's candidates that is not on the sheet of the other end: on another part, or on another layer of
/// that part, as where a section of one part is closed by its own welds. `axis`: from the other end to this one. Null
/// if there is none.
const Candidate* best_beside(const std::vector<Candidate>& offers, const PlaceOnPart& other, const Vec3d& axis,
                             const std::vector<Vec3d>& x);

/// The candidates of both ends, on two sheets: of two on the same sheet the farther end takes its next best; if that
/// would turn the weld over and the other way round would not, the nearer one does. Null for an end without a sheet.
/// `axis`: from the first end to the second; `x`: places of all nodes [length].
std::array<const Candidate*, 2> choose_two_sheets(const std::array<const std::vector<Candidate>*, 2>& offers,
                                                  const Vec3d& axis, const std::vector<Vec3d>& x);

}  // namespace nugget::weld
