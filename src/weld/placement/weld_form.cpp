// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/weld_form.hpp"

#include <algorithm>
#include <array>

namespace nugget::weld {
namespace {

constexpr std::array<NamedWeldForm, 6> forms{
    {{"beam", WeldForm::beam, 0, "a beam"},
     {"solid", WeldForm::solid, 1, "one brick"},
     {"solid4", WeldForm::solid4, 4, "four bricks"},
     {"solid8", WeldForm::solid8, 8, "eight bricks"},
     {"solid16", WeldForm::solid16, 16, "16 bricks"},
     {"interpolation", WeldForm::interpolation, 0, "an interpolation spot weld"}}};

}  // namespace

std::span<const NamedWeldForm> weld_forms() {
  return forms;
}

std::span<const NamedWeldForm> forms_of_elements() {
  return weld_forms().first(5);
}

const NamedWeldForm& named(WeldForm form) {
  return *std::ranges::find(forms, form, &NamedWeldForm::form);
}

std::optional<WeldForm> weld_form(std::string_view name) {
  const auto found = std::ranges::find(forms, name, &NamedWeldForm::name);
  return found == forms.end() ? std::nullopt : std::optional(found->form);
}

std::string list_names(std::span<const NamedWeldForm> some, std::string_view before_last) {
  std::string list;
  for (const NamedWeldForm& f : some) {
    if (!list.empty()) list += &f == &some.back() ? before_last : std::string_view(", ");
    list += f.name;
  }
  return list;
}

}  // namespace nugget::weld
