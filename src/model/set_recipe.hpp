// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/finding.hpp"

// A *SET_... as it is written: steps that add and take away. All its forms (LIST, GENERATE, ADD, GENERAL ...) come down
// to these.
namespace nugget::model {

enum class SetKind { node, part, segment, shell, solid, beam };

/// One line of a set.
struct SetStep {
  enum class Action { add, remove, intersect };
  enum class Source {
    all,      ///< everything of the set's kind
    members,  ///< the ids are members (segments: four node ids)
    range,    ///< ids: begin, end, increment; those of them that exist
    parts,    ///< ids are parts: their elements, nodes or segments
    boxes,    ///< ids are boxes
    sets,     ///< ids are sets of `kind`
  };
  Action action = Action::add;
  Source source = Source::members;
  SetKind kind = SetKind::node;             ///< of `sets`
  bool of_shells = true, of_solids = true;  ///< segments of parts and boxes: which elements give faces
  std::vector<int> ids;
  Place place;
};

struct SetRecipe {
  SetKind kind = SetKind::node;
  int id = 0;
  bool collect = false;  ///< _COLLECT: joins others of the same id
  std::string keyword;   ///< with its star
  Place place;
  std::vector<SetStep> steps;
};

}  // namespace nugget::model
