// SPDX-License-Identifier: Apache-2.0
#include "sheet_joints.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {

std::string moved_sheet(const std::string& joint, const std::function<Vec3d(const Vec3d& x, double s)>& place,
                        double length, double mass) {
  const double l = length;
  std::string deck = "*KEYWORD\n" + termination(1e-3) + "*NODE\n", motions, held = "*BOUNDARY_SPC_NODE\n",
              shells = "*ELEMENT_SHELL\n";
  for (int sheet = 0; sheet < 2; ++sheet) {
    const int part = sheet + 1, first = 10 * sheet + 1;
    for (int k = 0; k < 9; ++k) {
      const Vec3d x{10.0 * (k % 3), 10.0 * (k / 3), 1.5 * sheet};
      deck += node_line(first + k, l * x.x, l * x.y, l * x.z);
      if (sheet == 0) held += fields({1.0 * first + k, 0, 1, 1, 1, 1, 1, 1});
      if (sheet == 1)
        motions += driven(
            first + k,
            [&](double s) {
              const Vec3d u = l * (place(x, s) - x);
              return std::array{u.x, u.y, u.z, 0.0, 0.0, 0.0};
            },
            1e-3, 200, 100 + 6 * k);
    }
    for (int k = 0; k < 4; ++k) {
      const int a = first + k % 2 + 3 * (k / 2);
      shells += element_line(4 * sheet + k + 1, part, {a, a + 1, a + 4, a + 3});
    }
  }
  deck += "*PART\nfirst\n" + fields({1, 1, 1}) + "*PART\nsecond\n" + fields({2, 1, 1}) + "*SECTION_SHELL\n" +
          fields({1, 2, 0.8333, 3}) + fields({1.5 * l, 1.5 * l, 1.5 * l, 1.5 * l}) + "*MAT_ELASTIC\n" +
          fields({1, 7.8e-9 * mass / (l * l * l), 210000.0 * mass / l, 0.3}) +
          node_line(99, l * joint_spot.x, l * joint_spot.y, l * joint_spot.z).insert(0, "*NODE\n") + shells + held +
          motions + "*SET_NODE_LIST\n" + fields({7}) + fields({99}) + joint + "*END\n";
  return deck;
}

double JointNow::shear() const {
  return std::hypot(r[1], r[2]);
}

double JointNow::moment(double lever) const {
  return std::hypot(r[4] + lever * r[2], r[5] - lever * r[1]);
}

std::vector<JointNow> follow_joint(Experiment& run) {
  std::vector<JointNow> seen;
  run.run([&](const impact::Snapshot& now) {
    const auto location = now.system.beam_location.at(0);
    const system::ElementGroup& group = *now.system.groups[location.group];
    const auto e = at(location.element);
    seen.push_back({now.state.time / 1e-3, group.resultants(e), group.alive(e), group.internal_energy(e)});
  });
  return seen;
}

const JointNow& at_share(const std::vector<JointNow>& seen, double s) {
  return *std::min_element(seen.begin(), seen.end(),
                           [s](const auto& a, const auto& b) { return std::abs(a.s - s) < std::abs(b.s - s); });
}

}  // namespace nugget::verify
