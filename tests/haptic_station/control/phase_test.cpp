#include "haptic_station/control/phases/phase.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "messages/station.pb.h"
#include "where.h"

namespace telepalp::control {
namespace {

constexpr auto kFirstPhase = static_cast<int>(Phase::InBody);

Phase phase_at(std::size_t i) { return static_cast<Phase>(kFirstPhase + static_cast<int>(i)); }

/// The matrix of phases and events: the next phase, `(dwell)` if the transition waits, `.` if the phase stays.
std::string matrix() {
  std::ostringstream out;
  for (std::size_t p = 0; p < kPhaseCount; ++p)
    for (std::size_t e = 0; e < kEventCount; ++e) {
      const Row* row = transition(phase_at(p), static_cast<Event>(e));
      out << name(phase_at(p)) << " | " << name(static_cast<Event>(e)) << " | "
          << (row == nullptr ? "." : name(row->to)) << (row != nullptr && row->waits_for_dwell ? " (dwell)" : "")
          << "\n";
    }
  return out.str();
}

TEST(PhaseTable, EveryPhaseAndEventIsAsTheGoldenMatrixSays) {
  std::ifstream file(TELEPALP_SOURCE_DIR "/tests/haptic_station/control/golden/phase_matrix.txt");
  std::stringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(matrix(), golden.str()) << "if the change is meant, write what this test printed into the golden file";
}

TEST(PhaseTable, NamesEachPairOnce) {
  for (const Row& row : transitions()) EXPECT_EQ(transition(row.from, row.on), &row);
}

TEST(PhaseTable, AFaultIsReachedFromEverywhereAndLeftByAnOperatorAlone) {
  for (std::size_t p = 0; p < kPhaseCount; ++p) {
    if (phase_at(p) != Phase::Faulted) {
      ASSERT_NE(transition(phase_at(p), Event::Fault), nullptr);
    }
  }
  for (std::size_t e = 0; e < kEventCount; ++e)
    EXPECT_EQ(transition(Phase::Faulted, static_cast<Event>(e)) != nullptr, static_cast<Event>(e) == Event::Rearm);
}

TEST(PhaseTable, NumbersEqualThoseOfTheMessages) {
  EXPECT_EQ(static_cast<int>(Phase::InBody), msg::PHASE_IN_BODY);
  EXPECT_EQ(static_cast<int>(Phase::BodyToPlane), msg::PHASE_BODY_TO_PLANE);
  EXPECT_EQ(static_cast<int>(Phase::OutBody), msg::PHASE_OUT_BODY);
  EXPECT_EQ(static_cast<int>(Phase::PlaneToBody), msg::PHASE_PLANE_TO_BODY);
  EXPECT_EQ(static_cast<int>(Phase::ObjectLateral), msg::PHASE_CYLINDER_LATERAL);
  EXPECT_EQ(static_cast<int>(Phase::AroundObject), msg::PHASE_AROUND_CYLINDER);
  EXPECT_EQ(static_cast<int>(Phase::ObjectUpper), msg::PHASE_CYLINDER_UPPER);
  EXPECT_EQ(static_cast<int>(Phase::Released), msg::PHASE_RELEASED);
  EXPECT_EQ(static_cast<int>(Phase::Faulted), msg::PHASE_FAULTED);
}

TEST(PhaseTable, FiguresPlotThePapersNumbers) {
  EXPECT_EQ(plotted_number(Phase::InBody), 0);
  EXPECT_EQ(plotted_number(Phase::BodyToPlane), 1);
  EXPECT_EQ(plotted_number(Phase::OutBody), 2);
  EXPECT_EQ(plotted_number(Phase::PlaneToBody), 3);
  EXPECT_EQ(plotted_number(Phase::ObjectLateral), -1);
  EXPECT_EQ(plotted_number(Phase::AroundObject), -2);
  EXPECT_EQ(plotted_number(Phase::ObjectUpper), -3);
}

}  // namespace
}  // namespace telepalp::control
