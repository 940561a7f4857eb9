// SPDX-License-Identifier: Apache-2.0
#include "app/outcome.hpp"

#include <fmt/chrono.h>

#include <ctime>

#include "model/units.hpp"

namespace nugget::app {

ExitCode refuse(const std::filesystem::path& directory, Log& log, const Findings& findings) {
  output::write_findings(directory, findings.all());
  log.add(" E r r o r   t e r m i n a t i o n\n");
  print_findings(findings);
  fmt::print(stderr, "the deck is refused; nothing was run\n");
  return ExitCode::refused;
}

std::string unit_name(const model::Model& model) {
  const auto units = model::units_of(model);
  return units ? std::string(units->name) : std::string();
}

output::Summary::Counts counts(const model::Model& model, const weld::Ties& ties) {
  return {static_cast<long>(model.nodes.size()),     static_cast<long>(model.shells.size()),
          static_cast<long>(model.solids.size()),    static_cast<long>(model.beams.size()),
          static_cast<long>(model.discretes.size()), static_cast<long>(model.parts.size()),
          static_cast<long>(ties.welds.size())};
}

std::string today() {
  return fmt::format("{:%m/%d/%Y}", fmt::localtime(std::time(nullptr)));
}

}  // namespace nugget::app
