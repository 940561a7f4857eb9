// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Which elements live, in one array: shells first, then bricks, then beams, each in the order of the model.
class ElementAlive {
 public:
  explicit ElementAlive(const model::Model& model);
  /// Where an element stands.
  static int place(const model::Model& model, model::ElementKind kind, model::Index element);

  struct Deaths {
    bool any = false, shells = false;
  };
  /// Takes over who has died, and says whether somebody has since the last call.
  Deaths update(const system::System& system);
  std::span<const unsigned char> all() const { return alive_; }

  void archive(Archive& a);

 private:
  std::vector<unsigned char> alive_;
  int deaths_ = 0, shell_deaths_ = 0;
};

}  // namespace nugget::impact
