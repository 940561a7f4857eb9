// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <stdexcept>

#include "app/command.hpp"
#include "app/commands.hpp"
#include "report/run_data.hpp"
#include "report/run_hdf5.hpp"
#include "report/tidy_table.hpp"
#include "report/vtk.hpp"

namespace nugget::app {

const std::vector<std::string>& conversion_names() {
  static const std::vector<std::string> names{"vtk", "csv", "hdf5"};
  return names;
}

ExitCode convert(const ConvertArguments& arguments) {
  const std::filesystem::path directory(arguments.directory);
  try {
    const report::RunData run = report::read_run(directory);
    return guarded(
        arguments.target.empty() ? arguments.directory : arguments.target, [&](const std::filesystem::path& target) {
          if (arguments.to == "csv") {
            const std::size_t rows = report::write_tidy_table(directory, target / "histories.csv", run.summary);
            fmt::print("{}: {} rows\n", (target / "histories.csv").string(), rows);
            return ExitCode::normal;
          }
          if (arguments.to == "hdf5") {
            const std::vector<std::string> groups = report::write_hdf5(directory, target / "results.h5", run);
            fmt::print("{}: {}\n", (target / "results.h5").string(), fmt::join(groups, ", "));
            return ExitCode::normal;
          }
          for (const std::string& file : report::write_vtk(directory, target, run))
            fmt::print("{}\n", (target / file).string());
          return ExitCode::normal;
        });
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "nugget: {}\n", error.what());
    return ExitCode::wrong_command;
  }
}

}  // namespace nugget::app
