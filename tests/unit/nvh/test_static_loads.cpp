// SPDX-License-Identifier: Apache-2.0
#include "nvh/statics/static_loads.hpp"

#include <gtest/gtest.h>

#include "nvh/statics/statics.hpp"

namespace nugget::nvh {
namespace {

/// A kind of load that linear statics has never heard of.
struct Unheard {
  std::string keyword = "LOAD_UNHEARD";
  Place place{"a.k", 12, 0};
};

TEST(StaticLoads, AnUnknownKindIsRefusedByNameAndPlace) {
  Findings findings;
  refuse_unknown(Unheard{}, findings);
  ASSERT_EQ(findings.errors(), 1);
  EXPECT_EQ(findings.all().front().keyword, "*LOAD_UNHEARD");
  EXPECT_EQ(findings.all().front().place.line, 12);
  EXPECT_EQ(findings.all().front().text, "this load is not built in linear statics");
}

TEST(StaticLoads, EveryLoadOfAModelIsVisited) {
  model::Model model;
  model.nodal_loads.resize(1);
  model.pressure_loads.resize(2);
  model.control_volumes.resize(3);
  model.body_loads.resize(4);
  int loads = 0, known = 0;
  Findings findings;
  model::for_each_load(model, [&]<class Load>(const Load& load) {
    ++loads;
    known += KnownInStatics<Load>;
    refuse_unknown(load, findings);
  });
  EXPECT_EQ(loads, 10);
  EXPECT_EQ(known, 10);
  EXPECT_TRUE(findings.all().empty());
}

/// A centrifugal force would act as a base acceleration along its axis.
TEST(StaticLoads, CentrifugalForcesAreRefused) {
  model::Model model;
  model.body_loads.resize(1);
  model.body_loads.front().centrifugal = true;
  Findings findings;
  check_statics(model, findings);
  ASSERT_EQ(findings.errors(), 1);
  EXPECT_EQ(findings.all().front().keyword, "*LOAD_BODY_RX");
}

}  // namespace
}  // namespace nugget::nvh
