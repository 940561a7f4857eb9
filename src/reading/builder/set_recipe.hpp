// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/finding.hpp"

// A *SET_... as it is written: steps that add and take away. All its forms (LIST, GENERATE, ADD, GENERAL ...) come down
// to these.
namespace nugget::reading {

/// A branch (*SET_PART_TREE) is a set of parts with ids of its own.
enum class SetKind { node, part, segment, shell, solid, beam, branch };

/// One line of a set.
struct SetStep {
  enum class Action { add, remove, intersect };
  enum class Source {
    all,      ///< everything of the set's kind
    members,  ///< ids of things of `kind` (segments: four node ids); turned into the set's kind where that is another
    range,    ///< ids: begin, end, increment; those of them that exist
    boxes,    ///< ids are boxes
    sets,     ///< ids are sets of `kind`
  };
  Action action = Action::add;
  Source source = Source::members;
  SetKind kind = SetKind::node;
  bool turned_over = false;  ///< segments of nodes, in a file that is mirrored: they go round the other way
  bool of_shells = true, of_solids = true;  ///< segments: which elements give faces
  std::vector<int> ids;
  Place place;
  std::array<double, 4> attributes{};  ///< A1..A4 of a _COLUMN; 0: those of the set
};

struct SetRecipe {
  SetKind kind = SetKind::node;
  int id = 0;
  bool collect = false;  ///< _COLLECT: joins others of the same id
  std::string keyword;   ///< with its star
  Place place;
  std::vector<SetStep> steps;
  std::array<double, 4> attributes{};  ///< DA1..DA4
};

}  // namespace nugget::reading
