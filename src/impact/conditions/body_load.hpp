// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "impact/conditions/acting_load.hpp"

namespace nugget::impact {

template <>
class ActingLoad<model::BodyLoad> {
 public:
  ActingLoad(const model::BodyLoad& load, const system::System& system);
  /// Its work is booked by node, none of it in `work`.
  void apply(system::State& state, double dt, double& work);
  double work() const;
  void reset_work() { std::fill(work_of_node_.begin(), work_of_node_.end(), 0.0); }
  void carry(system::Carried what, const system::System::Computed& of, system::Parcel& parcel);
  /// Takes the masses that it acts on from the system, of what mass scaling added the share EMSCL.
  void update_masses();
  /// The same after mass scaling that changed the masses of these nodes.
  void update_masses(std::span<const int> changed);
  void archive(Archive& a);

 private:
  double motion(const system::State& state) const;
  void apply_centrifugal(system::State& state, double dt, double omega);
  void apply_to_body(std::size_t k, double mass, double dt, double omega, system::State& state);
  /// By node what mass scaling added and EMSCL leaves without weight [mass].
  class Weightless {
   public:
    void add(std::size_t k, double mass);
    void clear();
    double at(std::size_t k) const { return k < mass_.size() ? mass_[k] : 0.0; }
    const std::vector<int>& ascending();  ///< nodes that have ever had any

   private:
    std::vector<double> mass_;
    std::vector<char> known_;
    std::vector<int> nodes_;
    bool is_sorted_ = true;
  };
  /// As the elements have it.
  void find_weightless();
  /// As it is handed over to the nodes and bodies that others follow.
  void find_weightless_of_all();
  double mass_of_all(std::size_t k) const;
  void load_nodes();
  void load_everything();
  void load_parts();
  void add_points(std::map<int, double>& mass) const;

  const model::BodyLoad& load_;
  const system::System& system_;
  std::vector<int> nodes_;
  std::vector<double> mass_;          ///< of `nodes_` [mass]
  double last_ = 0.0;                 ///< acceleration of the last cycle [length/time^2]
  std::vector<Vec3d> last_force_;     ///< by node of the system, of a centrifugal load [force]
  std::vector<Vec3d> last_moment_;    ///< the same on rigid bodies, about their centres [force length]
  std::vector<double> work_of_node_;  ///< so far [energy]
  Weightless of_elements_, handed_over_;
};

}  // namespace nugget::impact
