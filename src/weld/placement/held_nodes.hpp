// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "weld/tie/sheet_mesh.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Why a node of a sheet keeps its place.
enum class Hold : unsigned char {
  nothing,  ///< it may move
  no_shell,
  text,
  free_edge,
  seam,
  fold,
  other_part,
  other_element,
  thickness,
  initial_state,
  rigid_body,
  named,
  set,
  contact,
  tied,
  weld,
};
/// `on a free edge`, `of a set`.
std::string_view to_string(Hold hold);

/// By node: what holds it, the first that is found. See adapt().
std::vector<Hold> held_nodes(const model::Model& model, const Ties& ties, const SheetMesh& mesh,
                             const std::function<bool(Index node)>& can_move);

}  // namespace nugget::weld
