// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "system/system.hpp"

namespace nugget::nvh {

inline constexpr Vec3d global_axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Translation x y z and rotation about x y z of one node, or force and moment on it; global axes.
using SixDof = std::array<double, 6>;

/// The unknowns q of a linear analysis and how every node moves with them, u = T q. What supports hold (also in local
/// axes), what rigid bodies and ties make dependent, and rotations that no element knows are no unknowns: they are
/// eliminated exactly, by the same constraint map as in impact.
class Equations {
 public:
  /// SPCs and held rigid bodies; the directions of prescribed motions are held as well. SPCs that end or begin during
  /// the run count if they are in force at time 0, and a warning says so.
  Equations(const system::System& system, Findings& findings);

  int size() const { return size_; }
  std::size_t nodes() const { return (start_.size() - 1) / 6; }  ///< of the system, virtual ones included

  /// One direction of a node that is held or driven. Those of a node stand in the order SPC, rigid body, motion; each
  /// takes away what those before it have left.
  struct Support {
    enum class Source { spc, body, motion };
    Source source = Source::spc;
    std::size_t index = 0;  ///< in Model::spcs, System::bodies or Model::motions
    int node = 0;
    bool rotation = false;
    Vec3d direction;     ///< that was asked for, unit
    Vec3d taken;         ///< unit, normal to those taken before; zero: nothing was left to take
    bool moves = false;  ///< along a prescribed motion; else it stands still
  };
  const std::vector<Support>& supports() const { return supports_; }

  /// Takes unknowns out: those marked stay zero, the others are counted anew.
  void constrain(const std::vector<char>& marked);

  /// Unknowns of one node, `count` of them from `first` on, in other directions, the columns of `basis` (row-major,
  /// orthonormal). Those from `kept` on stay zero.
  struct Turned {
    int first = 0, count = 0, kept = 0;
    std::array<double, 9> basis{};
  };
  /// Puts such directions in the place of these unknowns, which stand in ascending order, and counts anew.
  void turn(std::span<const Turned> blocks);

  struct Term {
    int equation;
    double factor;
  };
  /// How component i (0..5) of a system node moves: sum of factor times unknown. Empty: it does not.
  std::span<const Term> terms(int node, int i) const {
    const std::size_t k = 6 * at(node) + at(i);
    return {terms_.data() + start_[k], start_[k + 1] - start_[k]};
  }
  /// Node whose unknown an equation is (a virtual node for a rigid body's).
  int node_of(int equation) const { return owner_[equation]; }
  bool is_rotation(int equation) const { return rotation_[equation] != 0; }

  /// Motion of a node.
  SixDof motion(int node, std::span<const double> q) const;
  /// Adds T^t of a load on a node to `f`.
  void add_load(int node, const SixDof& load, std::span<double> f) const;

 private:
  int size_ = 0;
  std::vector<std::size_t> start_;  ///< 6 a node
  std::vector<Term> terms_;
  std::vector<int> owner_;
  std::vector<char> rotation_;  ///< by unknown
  std::vector<Support> supports_;
};

}  // namespace nugget::nvh
