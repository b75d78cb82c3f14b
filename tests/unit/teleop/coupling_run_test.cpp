// The bench's run of a coupling: what a run that diverges counts as.
#include "app/bench/parts/coupling_run.h"

#include <gtest/gtest.h>

namespace fyd::bench {
namespace {

TEST(CouplingRun, OneThatDivergesHasNotComeToRestTogether) {
  CouplingRun run;
  run.hand_kg = 1e-6;  // on 300 N/m, in steps of 0.1 ms: grows without end from the first motion
  std::vector<CouplingRow> rows;
  const CouplingFigures out = simulate(run, teleop::CouplingChoice::spring, &rows);
  ASSERT_LT(rows.size(), 11'000U) << "it was given up before the second press";
  EXPECT_GE(out.rest_difference_mm, 1e4);
  EXPECT_GE(out.oscillation_mm, 1e4);
  EXPECT_TRUE(out.unstable);
  EXPECT_FALSE(out.good());
}

TEST(CouplingRun, OneThatDoesNotTellsHowFarApartTheDevicesRest) {
  CouplingRun run;
  run.loss = 0.0;
  std::vector<CouplingRow> rows;
  const CouplingFigures out = simulate(run, teleop::CouplingChoice::model, &rows);
  ASSERT_EQ(rows.size(), 15'000U);
  EXPECT_NEAR(out.rest_difference_mm, 1e3 * std::abs(rows[10'990].hand_m - rows[10'990].far_m), 1e-9);
  EXPECT_TRUE(out.good());
}

}  // namespace
}  // namespace fyd::bench
