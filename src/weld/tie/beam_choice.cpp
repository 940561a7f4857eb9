// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/beam_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nugget::weld {
namespace {

/// Whether two places of one part lie on two layers of it: the line between them runs along the weld, at least over
/// half its length, and within 30 degrees of the normals of both. Two places of one layer never do.
bool on_two_layers(const PlaceOnPart& from, const PlaceOnPart& to, const Vec3d& axis) {
  static const double steep = std::cos(30.0 * std::numbers::pi / 180.0);
  constexpr double least_share = 0.5;
  const Vec3d line = to.point - from.point;
  const double apart = norm(line);
  const auto runs_across = [&](const Vec3d& normal) { return std::abs(dot(normal, line)) >= steep * apart; };
  return dot(line, axis) > 0.0 && apart >= least_share * norm(axis) && runs_across(from.normal) &&
         runs_across(to.normal);
}

}  // namespace

PlaceOnPart place_of(const Candidate& candidate, const std::vector<Vec3d>& x) {
  const model::Segment& n = candidate.segment.node;
  // Opposite faces of a brick are no two layers.
  const Vec3d of_shell = candidate.segment.shell == none ? Vec3d{} : normal({x[n[0]], x[n[1]], x[n[2]], x[n[3]]});
  return {candidate.segment.part, candidate.foot.point, of_shell};
}

const Candidate* best_beside(const std::vector<Candidate>& offers, const PlaceOnPart& other, const Vec3d& axis,
                             const std::vector<Vec3d>& x) {
  const auto beside = [&](const Candidate& c) {
    return other.part == none || c.segment.part != other.part || on_two_layers(other, place_of(c, x), axis);
  };
  const auto found = std::find_if(offers.begin(), offers.end(), beside);
  return found == offers.end() ? nullptr : &*found;
}

std::array<const Candidate*, 2> choose_two_sheets(const std::array<const std::vector<Candidate>*, 2>& offers,
                                                  const Vec3d& axis, const std::vector<Vec3d>& x) {
  using Choice = std::array<const Candidate*, 2>;
  const auto choose = [&](std::size_t first) {
    Choice choice{};
    choice[first] = &offers[first]->front();
    choice[1 - first] =
        best_beside(*offers[1 - first], place_of(*choice[first], x), first == 0 ? axis : -1.0 * axis, x);
    return choice;
  };
  const auto turns_over = [&](const Choice& c) {
    return c[0] && c[1] && dot(c[1]->foot.point - c[0]->foot.point, axis) <= 0.0;
  };
  const std::size_t nearer = offers[0]->front().distance > offers[1]->front().distance ? 1 : 0;
  const Choice choice = choose(nearer);
  if (!turns_over(choice)) return choice;
  const Choice other = choose(1 - nearer);
  return other[0] && other[1] && !turns_over(other) ? other : choice;
}

}  // namespace nugget::weld
