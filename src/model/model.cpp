// SPDX-License-Identifier: Apache-2.0
#include "model/model.hpp"

#include <algorithm>

namespace nugget::model {

double Material::young() const {
  return std::visit([](const auto& l) { return l.E; }, law);
}

double Material::poisson() const {
  return std::visit([](const auto& l) { return l.nu; }, law);
}

Index Model::node_index(int id) const {
  const auto at = std::lower_bound(nodes.id.begin(), nodes.id.end(), id);
  return at == nodes.id.end() || *at != id ? none : static_cast<Index>(at - nodes.id.begin());
}

Index Model::part_index(int id) const {
  const auto at = std::find_if(parts.begin(), parts.end(), [id](const Part& p) { return p.id == id; });
  return at == parts.end() ? none : static_cast<Index>(at - parts.begin());
}

Index Model::curve_index(int id) const {
  const auto at = std::find_if(curves.begin(), curves.end(), [id](const Curve& c) { return c.id == id; });
  return at == curves.end() ? none : static_cast<Index>(at - curves.begin());
}

}  // namespace nugget::model
