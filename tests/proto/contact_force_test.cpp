#include "proto/wire/station/contact_force.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "where.h"

namespace telepalp::wire {
namespace {

// tests/clients/viewer/viewer_state_test.mjs compares the page's own code with the same table.
TEST(ContactForce, IsOfThePhasesOfTheTableThatThePageSharesAndOfNoOther) {
  std::ifstream table(TELEPALP_SOURCE_DIR "/tests/proto/golden/contact_phases.tsv");
  std::string header;
  ASSERT_TRUE(std::getline(table, header));
  int phases = 0;
  for (std::string phase, force; table >> phase >> force; ++phases)
    EXPECT_EQ(is_contact(static_cast<msg::Phase>(std::stoi(phase))), force == "contact") << "phase " << phase;
  EXPECT_EQ(phases, msg::Phase_ARRAYSIZE) << "each phase has a row";
}

TEST(ContactForce, IsTheDrivesInAnyPhaseWhileIndexingMovesTheBody) {
  msg::StationState state;
  state.set_phase(msg::PHASE_IN_BODY);
  EXPECT_TRUE(is_contact(state));
  state.set_indexing(true);
  EXPECT_FALSE(is_contact(state));
}

}  // namespace
}  // namespace telepalp::wire
