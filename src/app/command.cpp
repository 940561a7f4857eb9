// SPDX-License-Identifier: Apache-2.0
#include "app/command.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <thread>

#include "app/finding_list.hpp"
#include "app/load_cases.hpp"
#include "app/run_log.hpp"
#include "base/parallel.hpp"
#include "nvh/matrices/ranks.hpp"
#include "reading/describe.hpp"

namespace nugget::app {

void Log::read() {
  std::ifstream file(path_);
  text_.assign(std::istreambuf_iterator<char>(file), {});
}

void start_log(Log& log, const RunArguments& arguments, const PreparedDeck& p, const Findings& findings) {
  log.add(log_head(NUGGET_VERSION, deck_and_case(arguments), threads(), nvh::ranks()));
  log.add(fmt::format("Files read\n\n {}\n\n", fmt::join(p.files, "\n ")));
  log.add(reading::keyword_use_table(p.model));
  log.add(log_findings(findings));
}

void print_findings(const Findings& findings) {
  for (const std::string& line : list_findings(findings.all())) fmt::print(stderr, "{}\n", line);
  if (findings.errors() + findings.warnings() > 0) fmt::print(stderr, "{}\n", totals(findings));
}

ExitCode refuse_missing(const Findings& findings) {
  print_findings(findings);
  fmt::print(stderr, "nothing was run; no file was changed\n");
  return ExitCode::refused;
}

void use_threads(int asked) {
  const int all = static_cast<int>(std::thread::hardware_concurrency());
  set_threads(asked > 0 ? asked : std::max(1, all));
}

}  // namespace nugget::app
