// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "app/command.hpp"
#include "app/commands.hpp"
#include "report/picture_file.hpp"

namespace nugget::app {

ExitCode picture(const PictureArguments& arguments) {
  const std::filesystem::path file(arguments.picture);
  try {
    report::PictureOptions options = arguments.options;
    options.shapes = file.extension() == ".svg";
    const std::string drawn = report::model_picture(arguments.directory, options);
    return guarded(file.has_parent_path() ? file.parent_path().string() : ".", [&](const std::filesystem::path&) {
      report::write_picture(file, drawn, options.width);
      return ExitCode::normal;
    });
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "nugget: {}: {}\n", arguments.directory, error.what());
    return ExitCode::wrong_command;
  }
}

}  // namespace nugget::app
