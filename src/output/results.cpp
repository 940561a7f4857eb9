// SPDX-License-Identifier: Apache-2.0
#include "output/results.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "model/history_files.hpp"
#include "output/result_file.hpp"

namespace nugget::output {
namespace {

/// Besides the history files.
constexpr auto names = std::to_array<std::string_view>({"run.log",
                                                        "status.out",
                                                        "status.out.part",
                                                        "d3kil",
                                                        "check.log",
                                                        "summary.json",
                                                        "findings.json",
                                                        "welds.csv",
                                                        "units.csv",
                                                        "report.html",
                                                        "frf.csv",
                                                        "frf_amplitude",
                                                        "frf_angle",
                                                        "frf_real",
                                                        "frf_imag",
                                                        "erp.csv",
                                                        "ERP_abs",
                                                        "ERP_dB",
                                                        "ssd.csv",
                                                        "nodout_ssd",
                                                        "mode_energy.csv",
                                                        "weld_drop.csv",
                                                        "least_welds.csv",
                                                        "mac.csv",
                                                        "d3plot",
                                                        "d3eigv",
                                                        "d3ssd",
                                                        "eigout",
                                                        "binout0000",
                                                        "summary.json.part",
                                                        "findings.json.part",
                                                        "restart",
                                                        "restart.previous",
                                                        "restart.part",
                                                        "welds.csv.part",
                                                        "states.pvd",
                                                        "modes.pvd",
                                                        "welds.pvd",
                                                        "histories.csv",
                                                        "results.h5"});

/// `stem` and two digits or more: the members of a family of state files.
bool is_member(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem)) return false;
  name.remove_prefix(stem.size());
  return name.size() >= 2 && std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// A state, a mode or its welds as `nugget convert --to vtk` and `--vtk` write them: `state0001.vtu`.
bool is_vtu(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  return path.extension() == ".vtu" &&
         (is_member(stem, "state") || is_member(stem, "mode") || is_member(stem, "welds"));
}

bool is_ours(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const auto& histories = model::history_files;
  return std::find(names.begin(), names.end(), name) != names.end() ||
         std::find(histories.begin(), histories.end(), name) != histories.end() || is_member(name, "d3plot") ||
         is_member(name, "d3eigv") || is_member(name, "d3ssd") || is_vtu(path) || name.starts_with("d3ssd_") ||
         name.starts_with("nodout_ssd_");  // of subcases
}

}  // namespace

std::vector<std::filesystem::path> remove_old_results(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> ours;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::filesystem::file_status status = entry->symlink_status();
    const bool file = std::filesystem::is_regular_file(status) || std::filesystem::is_symlink(status);
    if (file && is_ours(entry->path())) ours.push_back(entry->path());
  }
  if (error && error != std::errc::no_such_file_or_directory) throw WriteError(directory, error.message());

  std::sort(ours.begin(), ours.end());
  for (const std::filesystem::path& path : ours)
    if (!std::filesystem::remove(path, error) && error) throw WriteError(path, "cannot be removed: " + error.message());
  return ours;
}

}  // namespace nugget::output
