// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "base/finding.hpp"
#include "kernel/law/spr2.hpp"
#include "kernel/law/spr3.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// *CONSTRAINED_INTERPOLATION_SPOTWELD or *CONSTRAINED_SPR2 as the card gives it: one weld at each location node. In
/// the finished model each is a discrete beam between two nodes of its own (reading::with_interpolation_spotwelds).
struct InterpolationSpotweld {
  std::string title;
  std::array<std::vector<Index>, 2> sheet;  ///< parts that make up the first and the second sheet
  std::vector<Index> nodes;                 ///< where the welds are
  double thickness = 0.0;                   ///< THICK, of both sheets; nodes reach so far for them [length]
  double radius = 0.0;                      ///< R [length]
  double density = 0.0;                     ///< DENS [mass/length^3]
  int part = 0;  ///< PIDVB without its sign: id of the part of its beams; 0: the next free one
  std::variant<kernel::Spr3, kernel::Spr2> law;
  bool rivets() const { return std::holds_alternative<kernel::Spr2>(law); }
  Place place;
};

}  // namespace nugget::model
