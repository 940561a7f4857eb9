// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace nugget::weld {

/// What a weld is modelled as: one beam of ELFORM 9, so many bricks a layer, or a force law between two sheets.
enum class WeldForm { beam, solid, solid4, solid8, solid16, interpolation };

struct NamedWeldForm {
  std::string_view name;  ///< as users write it
  WeldForm form;
  int bricks;              ///< 0: none
  std::string_view words;  ///< "four bricks"
};

/// All forms, the beam first.
std::span<const NamedWeldForm> weld_forms();
/// Those of elements with a *MAT_SPOTWELD: a beam, bricks.
std::span<const NamedWeldForm> forms_of_elements();

const NamedWeldForm& named(WeldForm form);
/// By its name, or nothing.
std::optional<WeldForm> weld_form(std::string_view name);
/// "beam, solid or solid4", of some forms.
std::string list_names(std::span<const NamedWeldForm> forms, std::string_view before_last);

}  // namespace nugget::weld
