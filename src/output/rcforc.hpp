// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

namespace nugget::output {

enum class ContactSide { tracked = 0, reference = 1 };  ///< LS-DYNA's slave and master (binout: rcforc/metadata/side)

/// Resultant force on one side of a contact, in global axes.
struct RcforcRow {
  int contact = 0;  ///< user id
  ContactSide side = ContactSide::tracked;
  Vec3d force;        ///< [force]
  double mass = 0.0;  ///< of the nodes on this side [mass]; histories.cpp leaves it 0
};

struct RcforcState {
  double time = 0.0;
  std::vector<RcforcRow> rows;  ///< the same sides in the same order in every state
};

/// The ASCII file `rcforc`; the legend holds the titles of *CONTACT_..._TITLE.
class Rcforc {
 public:
  Rcforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend = {});
  void write(const RcforcState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
