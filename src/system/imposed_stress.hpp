// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/vec3.hpp"

namespace nugget::system {

/// A stress that an element has by decree, whatever its law makes of its strain (preloads).
struct ImposedStress {
  enum class Others {
    none,    ///< the other components are 0
    kept,    ///< they are what the law makes of them
    bending  ///< so are the differences between the points of the element: only the mean is imposed
  };
  std::size_t element;  ///< in its group
  Vec3d normal;         ///< unit direction of the component, in the axes of ElementGroup::layer
  double stress = 0.0;
  Others others = Others::kept;
  double area = 0.0;  ///< of a beam: its mean stress is force over that [length^2]
};

/// Groups whose elements can have stresses imposed.
class TakesStress {
 public:
  virtual bool takes_stress() const = 0;
  /// From the next cycle on, until the next call; by rising element. The forces of a cycle are then those of the
  /// imposed stress exactly, and so is their work.
  virtual void impose(std::vector<ImposedStress> stresses) = 0;

 protected:
  ~TakesStress() = default;
};

// What the kernels' groups share: `change(stress)` of a point whose components stand at `at` in the state.
template <class Field, class Put, class Change>
void change_solid_point(const Field& field, const Put& put, int at, const Change& change) {
  std::array<double, 6> stress;
  for (int i = 0; i < 6; ++i) stress[i] = field(at + i);
  change(stress);
  for (int i = 0; i < 6; ++i) put(at + i, stress[i]);
}
/// Stress rr rs rt, as ElementGroup::layer gives them.
template <class Field, class Put, class Change>
void change_fibre_point(const Field& field, const Put& put, int at, const Change& change) {
  std::array<double, 6> stress{field(at), 0.0, 0.0, field(at + 1), 0.0, field(at + 2)};
  change(stress);
  put(at, stress[0]);
  put(at + 1, stress[3]);
  put(at + 2, stress[5]);
}

}  // namespace nugget::system
