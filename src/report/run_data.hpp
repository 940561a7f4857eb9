// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace nugget::report {

/// A row of a table (welds.csv, mode_energy.csv) by column name.
using WeldRow = std::map<std::string, std::string, std::less<>>;

/// One response over frequency, of frf.csv or ssd.csv.
struct ResponseCurve {
  std::string name;                                 ///< e.g. `node 17 z`
  std::string quantity;                             ///< e.g. `acceleration`
  std::vector<double> frequency, amplitude, phase;  ///< phase in degrees; not a number where it is infinite
};

/// What the files of a folder say of the run that left them there.
struct RunData {
  RunData();
  RunData(const RunData&);
  RunData(RunData&&) noexcept;
  RunData& operator=(const RunData&);
  RunData& operator=(RunData&&) noexcept;
  ~RunData();

  nlohmann::json summary;      ///< summary.json
  nlohmann::json findings;     ///< findings.json; an empty list where it is missing
  std::vector<WeldRow> welds;  ///< welds.csv
  std::vector<std::pair<std::string, std::vector<double>>> energies;  ///< of glstat: name, value at each time
  std::vector<double> times;                                          ///< of glstat; empty where there is none
  std::vector<WeldRow> shares;          ///< mode_energy.csv: strain energy of parts and welds by mode
  std::vector<ResponseCurve> frf, ssd;  ///< frf.csv, ssd.csv
  std::vector<ResponseCurve> power;     ///< erp.csv, by panel; without phases
};

/// Reads them. Throws std::runtime_error with the reason where there is no summary.json, or one that cannot be read.
RunData read_run(const std::filesystem::path& directory);

}  // namespace nugget::report
