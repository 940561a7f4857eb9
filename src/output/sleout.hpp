// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/ascii.hpp"

namespace nugget::output {

/// Energy of one contact: minus the work of its forces on the nodes of either side.
struct SleoutRow {
  int contact = 0;                        ///< user id
  double tracked = 0.0, reference = 0.0;  ///< LS-DYNA's slave and master side [energy]
  bool single_surface = false;            ///< it has no second side
  double friction = 0.0;                  ///< what of it friction has taken [energy]
};

struct SleoutState {
  double time = 0.0;
  long cycle = 0;
  std::vector<SleoutRow> rows;  ///< the same contacts in the same order in every state

  double total_tracked() const;
  double total_reference() const;
  double total_friction() const;
};

/// The ASCII file `sleout`; the legend holds the titles of *CONTACT_..._TITLE.
class Sleout {
 public:
  Sleout(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend = {});
  void write(const SleoutState& state);
  void archive(Archive& a) { a(file_); }

 private:
  AsciiFile file_;
};

}  // namespace nugget::output
