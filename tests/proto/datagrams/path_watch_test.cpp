#include "proto/wire/datagrams/path_watch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "proto/wire/datagrams/key_frame_repair.h"
#include "where.h"

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

constexpr SessionTime kStart{1h};

TEST(DatagramPhase, EveryPhaseAndEventIsAsTheGoldenMatrixSays) {
  constexpr std::string_view kEvents[] = {"offered", "answered", "silent", "pause over"};
  std::ostringstream matrix;
  for (int phase = 0; phase <= static_cast<int>(DatagramPhase::Blocked); ++phase)
    for (int event = 0; event <= static_cast<int>(DatagramEvent::PauseOver); ++event) {
      const auto from = static_cast<DatagramPhase>(phase);
      const DatagramPhase to = next(from, static_cast<DatagramEvent>(event));
      matrix << name(from) << " | " << kEvents[event] << " | " << (to == from ? "." : name(to)) << "\n";
    }
  std::ifstream file(TELEPALP_SOURCE_DIR "/tests/proto/datagrams/golden/phase_matrix.txt");
  std::stringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(matrix.str(), golden.str()) << "if the change is meant, write what this test printed into the golden file";
}

/// The phases from `from` until `until`, each named once when it begins.
std::string phases(PathWatch& watch, SessionTime from, SessionTime until) {
  std::string seen;
  for (SessionTime now = from; now < until; now += 10ms) {
    const DatagramPhase before = watch.phase();
    watch.step(now);
    if (watch.phase() != before)
      seen += std::string(name(watch.phase())) + "@" + std::to_string((now - kStart) / 10ms * 10) + " ";
  }
  return seen;
}

TEST(PathWatch, WithoutAnAnswerItIsBlockedAndTriedAgainAfterPausesThatGrow) {
  PathWatch watch;
  watch.offered(kStart);
  EXPECT_EQ(phases(watch, kStart, kStart + 20s),
            "blocked@1500 trying@3500 blocked@5000 trying@9000 blocked@10500 trying@18500 ");
}

TEST(PathWatch, APauseIsThirtySecondsAtMost) {
  PathWatch watch;
  watch.offered(kStart);
  (void)phases(watch, kStart, kStart + 10min);
  SessionTime now = kStart + 10min;
  while (watch.phase() != DatagramPhase::Blocked) watch.step(now += 10ms);
  EXPECT_LE(*watch.due() - now, 30s);
}

TEST(PathWatch, AnAnswerMakesItUpAndASecondOfSilenceBlocked) {
  PathWatch watch;
  watch.offered(kStart);
  watch.answered(kStart + 200ms);
  EXPECT_EQ(watch.phase(), DatagramPhase::Up);
  watch.answered(kStart + 900ms);
  EXPECT_EQ(phases(watch, kStart + 900ms, kStart + 3s), "blocked@1900 ");
}

TEST(PathWatch, AnswersAfterABlockedPhaseMakeItUpAtOnce) {
  PathWatch watch;
  watch.offered(kStart);
  (void)phases(watch, kStart, kStart + 2s);
  ASSERT_EQ(watch.phase(), DatagramPhase::Blocked);
  watch.answered(kStart + 2s);
  EXPECT_EQ(watch.phase(), DatagramPhase::Up);
}

TEST(PathWatch, APathThatFlapsIsTriedLessAndLessOftenAndASteadyOneStartsAgain) {
  PathWatch watch;
  watch.offered(kStart);
  SessionTime now = kStart;
  Nanoseconds pause{0};
  for (int flap = 0; flap < 4; ++flap) {
    watch.answered(now);
    while (watch.phase() != DatagramPhase::Blocked) watch.step(now += 10ms);
    EXPECT_GT(*watch.due() - now, pause);
    pause = *watch.due() - now;
  }
  for (const SessionTime steady = now; now < steady + 11s; now += 100ms) watch.answered(now);
  while (watch.phase() != DatagramPhase::Blocked) watch.step(now += 10ms);
  EXPECT_EQ(*watch.due() - now, PathWatch::kFirstPause);
}

TEST(PathWatch, BeforeAnOfferNothingHappens) {
  PathWatch watch;
  watch.answered(kStart);
  EXPECT_EQ(phases(watch, kStart, kStart + 5s), "");
  EXPECT_FALSE(watch.due());
}

TEST(KeyFrameRepair, ARequestIsPassedOnUnlessAKeyFrameIsOnItsWay) {
  KeyFrameRepair repair;
  EXPECT_TRUE(repair.is_due(0, kStart, 100ms));
  repair.key_frame_sent(0, kStart);
  EXPECT_FALSE(repair.is_due(0, kStart + 100ms, 100ms));
  EXPECT_TRUE(repair.is_due(0, kStart + 200ms, 100ms));
  EXPECT_TRUE(repair.is_due(1, kStart, 100ms)) << "channels are repaired each for itself";
}

}  // namespace
}  // namespace telepalp::wire
