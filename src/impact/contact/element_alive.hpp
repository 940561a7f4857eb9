// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Which elements are active, in one array: shells first, then bricks, then beams, each in the order of the model.
class ElementAlive {
 public:
  explicit ElementAlive(const model::Model& model);
  /// Where an element stands.
  static int place(const model::Model& model, model::ElementKind kind, model::Index element);

  struct Deletions {
    bool any = false, shells = false, faces = false;  ///< faces: shells or bricks
  };
  /// Takes over which elements are deleted, and says whether any was since the last call.
  Deletions update(const system::System& system);
  std::span<const unsigned char> all() const { return alive_; }
  /// No shell and no brick is deleted.
  bool faces_are_whole() const { return face_deletions_ == 0; }

  void archive(Archive& a);

 private:
  std::vector<unsigned char> alive_;
  int deletions_ = 0, shell_deletions_ = 0, face_deletions_ = 0;
};

}  // namespace nugget::impact
