#include <gtest/gtest.h>

#include <random>
#include <string>

#include "server/capture/openni/color_depth_pairing.h"
#include "server/capture/openni/reconnecting_source.h"
#include "server/capture/openni/timestamp_map.h"

namespace telepalp::capture {
namespace {

using std::chrono::microseconds;

constexpr Nanoseconds kMs{1'000'000};
constexpr std::int64_t kSessionStart = 1'700'000'000'000'000'000;

SessionTime at_ms(double ms) { return session_time(kSessionStart) + from_seconds(ms / 1000.0); }

TEST(TimestampMap, SeesThroughTheJitterOfDelivery) {
  TimestampMap map;
  std::mt19937 random{3};
  std::exponential_distribution<double> jitter_ms{1.0 / 4.0};
  constexpr double kLeastDelay_ms = 3.0;
  double worst_ms = 0.0;
  for (int frame = 0; frame < 3000; ++frame) {
    const double exposed_ms = 33.3333 * frame;
    const SessionTime arrival = at_ms(exposed_ms + kLeastDelay_ms + jitter_ms(random));
    const microseconds driver{7'000'000 + static_cast<std::int64_t>(exposed_ms * 1000.0)};
    const double error_ms = to_milliseconds(map.map(driver, arrival) - at_ms(exposed_ms + kLeastDelay_ms));
    if (frame > 60) worst_ms = std::max(worst_ms, std::abs(error_ms));
  }
  EXPECT_LT(worst_ms, 1.5) << "seed 3";
  EXPECT_EQ(map.jumps(), 0u);
}

TEST(TimestampMap, FollowsADriftingOscillatorInBothDirections) {
  for (const double drift : {100e-6, -100e-6}) {
    TimestampMap map;
    double error_ms = 0.0;
    for (int frame = 0; frame < 30 * 600; ++frame) {
      const double exposed_ms = 33.3333 * frame;
      const microseconds driver{static_cast<std::int64_t>(exposed_ms * 1000.0 * (1.0 + drift))};
      error_ms = to_milliseconds(map.map(driver, at_ms(exposed_ms + 3.0)) - at_ms(exposed_ms + 3.0));
    }
    EXPECT_NEAR(error_ms, 0.0, 0.1) << "after ten minutes at a drift of " << drift;
  }
}

TEST(TimestampMap, BeginsAnewWhenTheDriversClockJumpsAndNeverGoesBack) {
  TimestampMap map;
  SessionTime last = map.map(microseconds{0}, at_ms(5.0));
  int frame = 1;
  const auto play = [&](microseconds driver_start, int frames) {
    for (int i = 0; i < frames; ++i, ++frame) {
      const SessionTime arrival = at_ms(33.3 * frame + 5.0);
      const SessionTime mapped = map.map(driver_start + microseconds{33'300 * i}, arrival);
      EXPECT_GT(mapped, last);
      EXPECT_LE(mapped, arrival);
      last = mapped;
    }
  };
  play(microseconds{33'300}, 50);
  play(microseconds{0}, 50);  // the recording starts over
  EXPECT_EQ(map.jumps(), 1u);
  play(microseconds{900'000'000}, 50);  // the device was reset
  EXPECT_EQ(map.jumps(), 2u);
}

TEST(TimestampMap, AnswersInOrderWhenTheDriverRepeatsAStamp) {
  TimestampMap map;
  const SessionTime first = map.map(microseconds{1000}, at_ms(1.0));
  EXPECT_GT(map.map(microseconds{1000}, at_ms(1.0)), first);
}

DepthImage depth_of(std::uint16_t sample) { return {1, 1, 0.001, {sample}}; }
ColorImage color_of(std::uint8_t value) { return {1, 1, {value, value, value}}; }

TEST(ColorDepthPairing, PairsImagesWithEqualDriverStamps) {
  ColorDepthPairing pairing;
  pairing.add_color(microseconds{0}, color_of(1));
  pairing.add_depth(microseconds{33'000}, at_ms(40), depth_of(7));
  EXPECT_FALSE(pairing.take(at_ms(41))) << "the colour of the frame before must not do while its own may come";
  pairing.add_color(microseconds{34'000}, color_of(2));
  const auto pair = pairing.take(at_ms(42));
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->color.rgb.front(), 2);
  EXPECT_EQ(pair->depth.samples.front(), 7);
  EXPECT_FALSE(pairing.take(at_ms(60)));
}

TEST(ColorDepthPairing, DepthDoesNotWaitForeverAndStaleColourIsLeftOut) {
  ColorDepthPairing pairing;
  pairing.add_color(microseconds{0}, color_of(1));
  pairing.add_depth(microseconds{40'000}, at_ms(40), depth_of(7));
  const auto late = pairing.take(at_ms(40) + ColorDepthPairing::kWaitForColor);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->color.rgb.size(), 3u);
  pairing.add_depth(microseconds{900'000}, at_ms(900), depth_of(8));
  const auto alone = pairing.take(at_ms(950));
  ASSERT_TRUE(alone);
  EXPECT_TRUE(alone->color.rgb.empty());
}

TEST(CameraPhase, EveryPairOfPhaseAndEventIsKnown) {
  constexpr std::pair<CameraPhase, const char*> kPhases[] = {{CameraPhase::Waiting, "Waiting"},
                                                             {CameraPhase::Live, "Live"},
                                                             {CameraPhase::Lost, "Lost"},
                                                             {CameraPhase::Ended, "Ended"}};
  constexpr CameraEvent kEvents[] = {CameraEvent::FrameCame, CameraEvent::FellSilent, CameraEvent::WentAway,
                                     CameraEvent::CameBack, CameraEvent::RecordingEnded};
  std::string matrix = "         FrameCame FellSilent WentAway CameBack RecordingEnded\n";
  for (const auto& [phase, name] : kPhases) {
    matrix += std::string(name) + ":";
    for (const CameraEvent event : kEvents)
      matrix += std::string(" ") + kPhases[static_cast<std::size_t>(next(phase, event))].second;
    matrix += "\n";
  }
  EXPECT_EQ(matrix,
            "         FrameCame FellSilent WentAway CameBack RecordingEnded\n"
            "Waiting: Live Lost Lost Waiting Ended\n"
            "Live: Live Lost Lost Live Ended\n"
            "Lost: Lost Lost Lost Waiting Lost\n"
            "Ended: Ended Ended Ended Ended Ended\n");
}

/// A camera with scripted behaviour, on a simulated clock that advances only during waits.
struct Script {
  SessionTime now = at_ms(0);
  bool plugged_in = true;
  bool silent = false;
  bool ended = false;
  int openings = 0;
  int closings = 0;
};

class ScriptedDevice final : public CameraDevice {
 public:
  explicit ScriptedDevice(Script& script) : script_(script) {}
  Result<void> open() override {
    ++script_.openings;
    if (script_.plugged_in) return {};
    return Error{.what = "no camera", .where = "script", .fix = "plug it in"};
  }
  Read read(Nanoseconds patience) override {
    if (!script_.plugged_in) return Gone{"it was unplugged"};
    if (script_.ended) return Ended{};
    if (script_.silent) {
      script_.now += patience;
      return Nothing{};
    }
    script_.now += 33 * kMs;
    Frame frame;
    frame.frame.depth = depth_of(1);
    frame.driver_time = std::chrono::duration_cast<microseconds>(script_.now - at_ms(0));
    frame.arrival = script_.now;
    return frame;
  }
  void close() override { ++script_.closings; }
  std::string describe() const override { return "scripted camera"; }

 private:
  Script& script_;
};

ReconnectingSource source_of(Script& script) {
  return ReconnectingSource{std::make_unique<ScriptedDevice>(script),
                            SourceTime{.now = [&script] { return script.now; },
                                       .sleep = [&script](Nanoseconds span) { script.now += span; }}};
}

TEST(ReconnectingSource, SurvivesBeingUnpluggedAndPluggedInAgain) {
  Script script;
  ReconnectingSource source = source_of(script);
  EXPECT_EQ(source.state(), CaptureState::Waiting);
  ASSERT_TRUE(source.next(100 * kMs));
  EXPECT_EQ(source.state(), CaptureState::Live);

  script.plugged_in = false;
  EXPECT_FALSE(source.next(100 * kMs));
  EXPECT_EQ(source.state(), CaptureState::Lost);
  EXPECT_NE(source.detail().find("unplugged"), std::string::npos);
  EXPECT_NE(source.detail().find("fix: "), std::string::npos);
  EXPECT_EQ(script.closings, 1);

  const SessionTime lost_at = script.now;
  while (script.now < lost_at + 5000 * kMs) EXPECT_FALSE(source.next(100 * kMs));
  EXPECT_GE(script.openings, 4);
  EXPECT_LE(script.openings, 5) << "once a second, not as fast as it is asked";

  script.plugged_in = true;
  std::optional<RgbdFrame> frame;
  for (int i = 0; i < 20 && !frame; ++i) frame = source.next(100 * kMs);
  ASSERT_TRUE(frame);
  EXPECT_EQ(source.state(), CaptureState::Live);
  EXPECT_EQ(frame->sequence, 1u);
  EXPECT_GT(frame->captured, lost_at);
}

TEST(ReconnectingSource, ACameraThatFallsSilentIsLostAfterTwoSeconds) {
  Script script;
  ReconnectingSource source = source_of(script);
  ASSERT_TRUE(source.next(100 * kMs));
  script.silent = true;
  const SessionTime since = script.now;
  while (source.state() != CaptureState::Lost && script.now < since + 10'000 * kMs) (void)source.next(100 * kMs);
  EXPECT_EQ(source.state(), CaptureState::Lost);
  EXPECT_NEAR(to_seconds(script.now - since), 2.1, 0.11);
}

TEST(ReconnectingSource, AnEndedRecordingStaysEndedAndKeepsItsCallerWaiting) {
  Script script;
  ReconnectingSource source = source_of(script);
  script.ended = true;
  EXPECT_FALSE(source.next(100 * kMs));
  EXPECT_EQ(source.state(), CaptureState::Ended);
  const SessionTime before = script.now;
  EXPECT_FALSE(source.next(100 * kMs));
  EXPECT_EQ(script.now - before, 100 * kMs);
  EXPECT_EQ(source.state(), CaptureState::Ended);
}

}  // namespace
}  // namespace telepalp::capture
