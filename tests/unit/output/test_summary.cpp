// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "output/summary.hpp"
#include "unit/output/scratch.hpp"

namespace nugget::output {
namespace {

using Json = nlohmann::ordered_json;

WeldReport sample_weld() {
  WeldReport w;
  w.id = 17;
  w.kind = "beam";
  w.part = 5;
  w.sheets = {1, 2};
  w.middle = {10.0, 20.5, -3.0};
  w.diameter = 6.0;
  w.length = 1.5;
  w.tied = true;
  w.projections = {{101, {1, 2, 3, 4}, 0.25, -0.5, 0.1, 1, ""},
                   {102, {}, 0.0, 0.0, 0.0, 8, "no \"sheet\", none in reach"}};
  w.added_mass = 1e-9;
  w.failed = true;
  w.failure_time = 0.1;
  w.failure_mode = "resultant";
  w.peak = {8000.0, 1.0 / 3.0, 0.0, std::nan(""), 8000.5};
  w.peak_failure = 1.02, w.peak_failure_time = 0.1;
  w.last = {8000.0, 500.0, 60.0, 7.0, 2.5, 1.02, "axial force 1, shear force 0.02"};
  w.energy = 42.5;
  w.passed = -12.5, w.most_passed = -20.0;
  w.course_interval = 0.001, w.failure_course = {0.25, 1.02};
  w.remarks = {"edge", "pitch"};
  return w;
}

std::vector<std::string> keys(const Json& json) {
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  return names;
}

// Welds are written one by one: the text is that of the whole object.
TEST(Summary, IsWrittenAsOneObject) {
  Scratch scratch;
  for (const std::size_t welds : {0u, 1u, 3u}) {
    Summary s;
    s.title = "lines\n  \"weld\": []";
    s.welds.assign(welds, sample_weld());
    write_summary(scratch.path(), s);
    const std::string text = content(scratch / "summary.json");
    const Json json = Json::parse(text);
    EXPECT_EQ(json["weld"].size(), welds);
    EXPECT_EQ(json.dump(2) + "\n", text);
  }
}

TEST(Summary, HasTheKeysOfTheContractInItsOrder) {
  Scratch scratch;
  Summary s;
  s.welds = {sample_weld()};
  s.modes = {{1, 12.5, {1, 2, 3, 4, 5, 6}, {}}};
  s.seconds.phases = {{"elements", 0.5}, {"contact", 0.25}};
  write_summary(scratch.path(), s);
  const Json json = Json::parse(content(scratch / "summary.json"));
  using Names = std::vector<std::string>;
  EXPECT_EQ(keys(json), (Names{"version",
                               "deck",
                               "termination",
                               "message",
                               "title",
                               "date",
                               "files",
                               "units",
                               "nodes",
                               "elements",
                               "parts",
                               "welds",
                               "cycles",
                               "time",
                               "time_step",
                               "mass",
                               "energy",
                               "seconds",
                               "ns_per_element_cycle",
                               "peak_memory_mb",
                               "threads",
                               "lanes",
                               "precision",
                               "ranks",
                               "weld",
                               "modes"}));
  EXPECT_EQ(keys(json["elements"]), (Names{"shell", "solid", "beam", "discrete"}));
  EXPECT_EQ(keys(json["time_step"]), (Names{"first", "smallest", "controlling"}));
  EXPECT_EQ(keys(json["mass"]), (Names{"physical", "added", "added_to_welds"}));
  EXPECT_EQ(keys(json["energy"]),
            (Names{"kinetic", "internal", "hourglass", "contact", "damping", "external", "eroded", "step_change",
                   "initial", "ratio", "ratio_without_step_change", "bulk_viscosity", "contact_springs",
                   "contact_friction", "contact_damping", "contact_lost"}));
  EXPECT_EQ(keys(json["seconds"]), (Names{"read", "setup", "solve", "output", "phases"}));
  EXPECT_EQ(keys(json["seconds"]["phases"]), (Names{"elements", "contact"}));
  EXPECT_EQ(keys(json["weld"][0]), (Names{"id", "kind", "part", "parts", "diameter", "length", "tied", "projection",
                                          "added_mass", "failed", "failure_time", "failure_mode", "peak", "remarks"}));
  EXPECT_EQ(keys(json["weld"][0]["projection"][0]), (Names{"node", "segment", "xi", "eta", "moved", "case", "reason"}));
  EXPECT_EQ(keys(json["weld"][0]["peak"]), (Names{"axial", "shear", "bending", "torsion", "force"}));
  EXPECT_EQ(keys(json["modes"][0]), (Names{"mode", "frequency_hz", "participation", "effective_mass"}));
}

TEST(Summary, KeepsEveryDigitAndNullsWhatIsNoNumber) {
  Scratch scratch;
  Summary s;
  s.time = 0.1 + 0.2;
  s.energy.kinetic = HUGE_VAL;
  s.message = "Latin-1 \xe4";  // not UTF-8
  s.welds = {sample_weld(), WeldReport{}};
  write_summary(scratch.path(), s);
  const Json json = Json::parse(content(scratch / "summary.json"));
  EXPECT_EQ(json["time"].get<double>(), 0.1 + 0.2);
  EXPECT_TRUE(json["energy"]["kinetic"].is_null());
  EXPECT_EQ(json["weld"][0]["peak"]["shear"].get<double>(), 1.0 / 3.0);
  EXPECT_TRUE(json["weld"][0]["peak"]["torsion"].is_null());
  EXPECT_EQ(json["weld"][0]["failure_time"].get<double>(), 0.1);
  EXPECT_TRUE(json["weld"][1]["failure_time"].is_null());
  EXPECT_TRUE(json["weld"][1]["projection"].is_array());
}

TEST(Findings, AreAListOfTheirFields) {
  Scratch scratch;
  Finding f;
  f.severity = Severity::warning;
  f.place.file = "car.k", f.place.line = 12, f.place.column = 31;
  f.keyword = "*MAT_024", f.field = "pr", f.value = "0.7";
  f.text = "Poisson's ratio, expected 0 to 0.5", f.remedy = "correct it";
  write_findings(scratch.path(), {f});
  EXPECT_EQ(Json::parse(content(scratch / "findings.json")),
            Json::parse(R"([{"severity": "warning", "file": "car.k", "line": 12, "column": 31, "keyword": "*MAT_024",
                             "field": "pr", "value": "0.7", "text": "Poisson's ratio, expected 0 to 0.5",
                             "remedy": "correct it"}])"));
  write_findings(scratch.path(), {});
  EXPECT_EQ(content(scratch / "findings.json"), "[]\n");
}

TEST(WeldsCsv, HasARowForEachWeld) {
  Scratch scratch;
  write_welds(scratch.path(), {sample_weld()});
  EXPECT_EQ(
      content(scratch / "welds.csv"),
      "id,kind,part,sheet1,sheet2,x,y,z,diameter,length,tied,failed,failure_time,failure_mode,peak_axial,peak_shear,"
      "peak_bending,peak_torsion,peak_force,peak_failure,peak_failure_time,last_axial,last_shear,last_bending,"
      "last_torsion,last_force,last_strain_rate,last_failure,last_terms,last_bending_1,last_bending_2,damage,energy,"
      "energy_passed,most_energy_passed,failure_interval,failure_course,added_mass,remarks,node1,"
      "case1,moved1,xi1,eta1,segment1,reason1,node2,case2,moved2,xi2,eta2,segment2,reason2\n"
      "17,beam,5,1,2,10,20.5,-3,6,1.5,yes,yes,0.1,resultant,8000,0.3333333333333333,0,,8000.5,1.02,0.1,8000,500,60,7,"
      "8015.609770940699,2.5,1.02,"
      "\"axial force 1, shear force 0.02\",,,,42.5,-12.5,-20,0.001,0.25 1.02,1e-09,edge; pitch,101,1,0.1,0.25,-0.5,1 2 "
      "3 4,,102,8,0,0,0,,"
      "\"no \"\"sheet\"\", none in reach\"\n");
}

TEST(WeldsCsv, LosesNoNodeOfABrickWeld) {
  Scratch scratch;
  WeldReport brick = sample_weld();
  brick.projections.resize(8);
  write_welds(scratch.path(), {brick, sample_weld()});
  std::istringstream lines(content(scratch / "welds.csv"));
  std::string head, first, second;
  std::getline(lines, head), std::getline(lines, first), std::getline(lines, second);
  EXPECT_THAT(head, testing::EndsWith(",reason8"));
  const auto commas = [](const std::string& s) { return std::count(s.begin(), s.end(), ','); };
  EXPECT_EQ(commas(first), commas(head) + 2);  // two more inside the quoted reason and the quoted terms
  EXPECT_EQ(commas(second), commas(head) + 2);
}

}  // namespace
}  // namespace nugget::output
