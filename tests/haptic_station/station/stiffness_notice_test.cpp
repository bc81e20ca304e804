#include "haptic_station/station/telemetry/stiffness_notice.h"

#include <gtest/gtest.h>

namespace telepalp::station {
namespace {

TEST(StiffnessNotice, SaysTheLimitOnceAndOnlyWhereADelayIsMeasured) {
  StiffnessNotice notice;
  loop::Compensation compensation{.stiffest_shown_N_per_m = 400.0, .effects_N_per_m = 1200.0};
  EXPECT_FALSE(notice.look(compensation)) << "this device echoes no commands";
  compensation.loop_delay_s = 0.001;
  compensation.effects_N_per_m = 300.0;
  EXPECT_FALSE(notice.look(compensation)) << "softer than the limit";
  compensation.effects_N_per_m = 1200.0;
  const auto said = notice.look(compensation);
  ASSERT_TRUE(said);
  for (const char* part :
       {"loop delay is 1.0 ms", "at most 400 N/m", "asks for 1200 N/m", "feels at most 300 N/m", "fix:"})
    EXPECT_NE(said->find(part), std::string::npos) << part << " in " << *said;
  EXPECT_FALSE(notice.look(compensation)) << "once";
}

}  // namespace
}  // namespace telepalp::station
