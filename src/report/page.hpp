// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace nugget::report {

/// One HTML page about a run: how it ended and what to look at, the welds with a result each (failed first, then by
/// their largest failure value), histories, checks, findings. Everything is in the page: it opens without a network.
/// `packed` is what the viewer is given (page_data); without it, or in a program without viewer, the page stands still.
/// `pictures`, SVG documents of the model, are shown where scripts do not run or there is no WebGL; `forces`, HTML,
/// where scripts do not run.
std::string page(const RunData& run, const std::string& packed = {}, const std::vector<std::string>& pictures = {},
                 const std::string& forces = {});

/// A page of that look around `body`, which is HTML.
std::string html_page(const std::string& title, const std::string& body);

/// Reads the results in a folder and writes report.html beside them. Throws std::runtime_error where there are none,
/// and output::WriteError where it cannot be written.
void write_report(const std::filesystem::path& directory);

}  // namespace nugget::report
