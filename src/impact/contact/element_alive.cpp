// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/element_alive.hpp"

namespace nugget::impact {

ElementAlive::ElementAlive(const model::Model& model)
    : alive_(model.shells.size() + model.solids.size() + model.beams.size(), 1) {}

int ElementAlive::place(const model::Model& model, model::ElementKind kind, model::Index element) {
  std::size_t first = 0;
  if (kind != model::ElementKind::shell) first += model.shells.size();
  if (kind == model::ElementKind::beam) first += model.solids.size();
  return static_cast<int>(first) + element;
}

ElementAlive::Deletions ElementAlive::update(const system::System& system) {
  int deletions = 0, of_shells = 0, of_faces = 0;
  for (const auto& group : system.groups) {
    deletions += group->deletions;
    if (group->kind == model::ElementKind::shell) of_shells += group->deletions;
    if (group->kind == model::ElementKind::shell || group->kind == model::ElementKind::solid)
      of_faces += group->deletions;
  }
  const Deletions news{deletions != deletions_, of_shells != shell_deletions_, of_faces != face_deletions_};
  deletions_ = deletions;
  shell_deletions_ = of_shells;
  face_deletions_ = of_faces;
  if (!news.any) return news;
  for (const auto& group : system.groups) {
    if (group->kind == model::ElementKind::discrete) continue;  // springs are on no surface
    for (std::size_t e = 0; e < group->size(); ++e)
      if (!group->alive(e)) alive_[place(system.model, group->kind, group->element[e])] = 0;
  }
  return news;
}

void ElementAlive::archive(Archive& a) {
  a(alive_, deletions_, shell_deletions_, face_deletions_);
}

}  // namespace nugget::impact
