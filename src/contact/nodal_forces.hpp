// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/index.hpp"
#include "base/row.hpp"
#include "base/zeroed.hpp"
#include "system/parcel.hpp"

namespace nugget::contact {

/// Room for one more in a list of which there are many: an eighth more at a time, not twice as much.
template <class T>
void make_room(std::vector<T>& list) {
  if (list.size() == list.capacity()) list.reserve(list.size() + std::max<std::size_t>(4, list.size() / 8));
}

/// The nodes of two bodies, by node; those beyond the end of a list are of neither.
struct TwoBodies {
  std::vector<unsigned char> in_a, in_b;

  /// +1 where all nodes of `first` are of the one and all of `second` of the other body, -1 the other way round; 0
  /// where neither is so, or both.
  double sign(std::span<const int> first, std::span<const int> second) const {
    const auto all = [](std::span<const int> nodes, const std::vector<unsigned char>& in) {
      return std::all_of(nodes.begin(), nodes.end(), [&in](int n) {
        const auto k = at(n);
        return k < in.size() && in[k] != 0;
      });
    };
    return (all(first, in_a) && all(second, in_b) ? 1.0 : 0.0) - (all(first, in_b) && all(second, in_a) ? 1.0 : 0.0);
  }
};

/// The forces of a contact on its nodes, in this cycle and in the one before, and the work that they have done. Only
/// nodes that are touched cost anything. The nodes stand in parts of a fixed size, so that several threads can add
/// forces, each to parts of its own; a node's sum has the same bits for any number of threads if the forces on a part
/// are always added in the same order. Work is booked node by node, and summed up by part when somebody asks: so a rank
/// of several need know no other nodes than those that it follows (docs/decisions/0115), and can send the sum of a part
/// (docs/decisions/0146).
class NodalForces {
 public:
  static constexpr int part_size = 1024;  ///< nodes in a part

  NodalForces() = default;
  /// `nodes`: all that may be touched, ascending, each once. `friction`: there may be some.
  NodalForces(std::vector<int> nodes, bool friction);
  /// From now on the work at `node` is booked on side `side` (0, where all begin, or 1).
  void set_side(int node, unsigned char side) { side_[index_[node]] = side; }

  const std::vector<int>& nodes() const { return nodes_; }
  /// Where a node stands in nodes(), of which it is one.
  int place(int node) const { return index_[node]; }
  /// Asks the memory for that.
  void ask_for_place(int node) const { __builtin_prefetch(&index_[node]); }
  std::size_t parts() const { return parts_.size(); }

  /// Adds a force, and what of it is friction.
  void add(int node, const Vec3d& force, const Vec3d& friction = {}) { add_at(index_[node], force, friction); }
  void add_at(int place, const Vec3d& force, const Vec3d& friction) {
    Sum& sum = parts_[place / part_size].now.at(place);
    sum.force += force;
    sum.friction += friction;
  }
  /// Adds to places of one part: `visit(add)` calls add(place, factor, force, friction) for each, of which `factor`
  /// times both is added.
  template <class Visit>
  void add_to_part(std::size_t part, const Visit& visit) {
    Touched& now = parts_[part].now;
    visit([&now](int place, double factor, const Vec3d& force, const Vec3d& friction) {
      Sum& sum = now.at(place);
      sum.force += factor * force;
      sum.friction += factor * friction;
    });
  }
  /// What was now becomes what was before; now there are no forces.
  void next_cycle();
  void add_to(std::span<Row> force) const;
  /// Books the work of the step `dt`, 1/2 (before + now) . v dt with the velocity `v` in the middle of the step.
  void book_work(double dt, std::span<const Row> v);
  /// What the nodes of each side have given so far, minus the work of all forces on them [energy].
  std::array<double, 2> energy_of_sides() const;
  /// What friction has taken, minus its work [energy].
  double friction_energy() const;
  /// Whether a force of this cycle acts on a node, which need not be one of nodes().
  bool acts_on(int node) const {
    const int place = nugget::at(node) < index_.size() ? index_[node] : -1;
    const Sum* sum = place < 0 ? nullptr : parts_[place / part_size].now.find(place);
    return sum != nullptr && dot(sum->force, sum->force) > 0.0;
  }
  /// On a node, which need not be one of nodes() [force].
  Vec3d on(int node) const {
    const int place = nugget::at(node) < index_.size() ? index_[node] : -1;
    const Sum* sum = place < 0 ? nullptr : parts_[place / part_size].now.find(place);
    return sum != nullptr ? sum->force : Vec3d{};
  }
  /// The side of one of nodes().
  unsigned char side(int node) const { return side_[index_[node]]; }
  /// Sum over the nodes that are marked (by node; those beyond its end are not) [force].
  Vec3d sum(std::span<const unsigned char> marked) const;

  // The same for one part, to be called side by side.
  void next_cycle(std::size_t part);
  void add_to(std::size_t part, std::span<Row> force) const;
  void book_work(std::size_t part, double dt, std::span<const Row> v);

  /// A rank of several books the work on nodes that it follows only; `left_out`: the others, by place in nodes().
  void leave_out(std::vector<char> left_out) { left_out_ = std::move(left_out); }
  bool left_out(int place) const { return !left_out_.empty() && left_out_[place]; }
  /// The work at a node, on its way to another rank.
  void carry(int place, system::Parcel& parcel);
  /// What all nodes of a part have given, from a rank that has booked the work on each of them: until work on one of
  /// them arrives, that counts.
  void carry_sum(std::size_t part, system::Parcel& parcel);

  /// `giver`: by place, as in Archive::Holders; empty: all ranks have the same. One takes what it does not leave out.
  void archive(Archive& a, const std::function<int(std::size_t)>& giver = {});

 private:
  static constexpr std::size_t nodes_ahead = 12;  ///< for which rows the memory is asked
  struct Sum {
    Vec3d force, friction;
  };
  /// Forces on those nodes of a part that are touched, in the order in which they were.
  struct Touched {
    std::vector<int> place;
    std::vector<Sum> sum;
    std::vector<unsigned short> slot;  // by place in the part: which of these it is, if it is there; empty: none was

    const Sum* find(int at) const {
      if (slot.empty()) return nullptr;
      const unsigned short here = slot[at % part_size];
      return here < place.size() && place[here] == at ? &sum[here] : nullptr;
    }
    Sum& at(int at) {
      if (slot.empty()) slot.resize(part_size);
      const unsigned short here = slot[at % part_size];
      return here < place.size() && place[here] == at ? sum[here] : add(at);
    }
    [[gnu::noinline]] Sum& add(int at) {
      slot[at % part_size] = static_cast<unsigned short>(place.size());
      make_room(place);
      make_room(sum);
      place.push_back(at);
      return sum.emplace_back();
    }
    void forget() {
      place.clear();
      sum.clear();
    }
  };
  struct Part {
    Touched now, before;
  };
  /// Minus the work on the nodes of a part, by side, and minus that of friction.
  struct Given {
    std::array<double, 2> of_sides{};
    double friction = 0.0;
  };
  Given given(std::size_t part) const;
  void each_part(const std::function<void(std::size_t)>& call) const;

  std::vector<int> nodes_;
  std::vector<int> index_;  // by node: its place in nodes_
  std::vector<unsigned char> side_;
  std::vector<Part> parts_;
  ZeroedVector<double> work_, friction_work_;  // so far, by place; the latter empty where there is no friction
  std::vector<char> left_out_;                 // by place; empty: none
  std::map<std::size_t, Given> of_others_;     // by part: what another rank has summed up
};

}  // namespace nugget::contact
