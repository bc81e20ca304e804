#include "haptic_station/station/telemetry/telemetry.h"

#include <gtest/gtest.h>

#include <random>

#include "haptic_station/station/telemetry/image_ages.h"
#include "haptic_station/station/telemetry/telemetry_publisher.h"
#include "haptic_station/station/threads/tick_timer.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

loop::TickSample sample(std::uint64_t tick, msg::Phase phase, float force_N) {
  loop::TickSample out;
  out.tick = tick;
  out.stamp_ns = static_cast<std::int64_t>(tick) * 500'000;
  out.phase = static_cast<std::uint8_t>(phase);
  out.work_us = 10.0F;
  out.force = {0.0F, force_N, 0.0F};
  return out;
}

msg::SurfaceReport touchable_after(std::chrono::milliseconds age, double clock_error_s) {
  msg::SurfaceReport report;
  report.set_captured_ns(1'000'000'000);
  report.set_touchable_ns(1'000'000'000 + static_cast<std::uint64_t>(std::chrono::nanoseconds(age).count()));
  report.set_clock_error_s(clock_error_s);
  return report;
}

TEST(ImageAges, AreToldWithTheLargestErrorBoundOfTheSessionClock) {
  ImageAges ages;
  EXPECT_EQ(ages.in_words(), "") << "no image";
  for (int i = 0; i < 98; ++i) ages.add(touchable_after(60ms, 0.003));
  ages.add(touchable_after(120ms, 0.0032));
  ages.add(touchable_after(120ms, 0.001));
  EXPECT_EQ(ages.in_words(),
            "100 images: their surfaces were touchable 61 ms (median) and 122 ms (99th percentile) after capture; the "
            "error of both is at most 3.2 ms");
}

TEST(ImageAges, AnUnknownClockIsToldAndAnAgeBelowZeroCountsAsZero) {
  ImageAges ages;
  ages.add(touchable_after(-2ms, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(ages.in_words(),
            "1 image: its surface was touchable 0.0 ms (median) and 0.0 ms (99th percentile) after capture; the "
            "error of both is unknown, because the server's clock is not known");
}

TEST(DurationHistogram, EveryQuantileIsWithinThreePercentOfTheSortedValues) {
  std::mt19937_64 random(7);
  std::lognormal_distribution<double> durations(9.0, 1.5);
  DurationHistogram histogram;
  std::vector<std::uint64_t> values;
  for (int i = 0; i < 20'000; ++i) {
    values.push_back(static_cast<std::uint64_t>(durations(random)));
    histogram.add(values.back());
  }
  std::sort(values.begin(), values.end());
  for (const double q : {0.01, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size()))) - 1;
    const auto exact = static_cast<double>(values[rank]);
    EXPECT_NEAR(histogram.quantile_ns(q), exact, 0.033 * exact + 1.0) << "q " << q;
  }
}

TEST(DurationHistogram, AnEmptyOneReturnsZeroAndHugeValuesCountInTheLastBucket) {
  DurationHistogram histogram;
  EXPECT_EQ(histogram.quantile_ns(0.99), 0.0);
  histogram.add(~std::uint64_t{0});
  EXPECT_GT(histogram.quantile_ns(1.0), 4e9);
}

TEST(TickTimer, ADeadlineIsMissedOnlyWhenTheNextOneHasPassed) {
  EXPECT_EQ(deadlines_overtaken(499us, 500us), 0u);
  EXPECT_EQ(deadlines_overtaken(500us, 500us), 1u);
  EXPECT_EQ(deadlines_overtaken(5ms, 500us), 10u);
}

TEST(TickTimer, DeadlinesStayOnTheirGridWhenTicksAreLate) {
  const auto start = TickTimer::Clock::now();
  TickTimer timer(start, 500us);
  for (int i = 0; i < 40; ++i) EXPECT_EQ((timer.wait().deadline - start) % 500us, 0ns);
}

TEST(RunTotals, PhasesAreEnteredOnceAndDweltInByTheTick) {
  RunTotals totals(500'000);
  for (std::uint64_t tick = 0; tick < 2000; ++tick) {
    const bool inside = tick >= 500 && tick < 1500;
    (void)totals.add(sample(tick, inside ? msg::PHASE_IN_BODY : msg::PHASE_OUT_BODY, inside ? 3.5F : 0.0F));
  }
  const msg::StationStats stats = totals.message();
  EXPECT_EQ(stats.ticks(), 2000u);
  EXPECT_DOUBLE_EQ(stats.contact_s(), 0.5);
  EXPECT_DOUBLE_EQ(stats.force_max_n(), 3.5);
  ASSERT_EQ(stats.phases_size(), 2);
  for (const msg::PhaseDwell& dwell : stats.phases()) {
    EXPECT_EQ(dwell.entries(), dwell.phase() == msg::PHASE_OUT_BODY ? 2u : 1u);
    EXPECT_DOUBLE_EQ(dwell.seconds(), 0.5);
  }
  EXPECT_NEAR(stats.tick_us_p50(), 10.0, 0.4);
}

TEST(StateMessage, TellsTheWorkspacesShiftAndWhetherTheBodyMovesPastTheDevice) {
  loop::TickSample tick = sample(1, msg::PHASE_IN_BODY, 1.0F);
  EXPECT_FALSE(state_message(tick).has_workspace_shift()) << "no workspace is indexed";
  EXPECT_FALSE(state_message(tick).indexing());
  tick.indexing = true;
  tick.workspace_shift = {0.0F, 0.0F, 0.25F};
  EXPECT_EQ(state_message(tick).workspace_shift().z(), 0.25);
  EXPECT_TRUE(state_message(tick).indexing());
}

/// The stamps [ms] of the states that are published when the ring is drained after each of these numbers of ticks.
std::vector<double> state_stamps_ms(const std::vector<int>& ticks_per_drain) {
  TickRing ring;
  std::vector<double> stamps_ms;
  TelemetryPublisher publisher(
      ring,
      [&](const wire::Message& message) {
        if (message.topic.name != wire::kStationState.name) return;
        msg::StationState state;
        EXPECT_TRUE(state.ParseFromArray(message.payload->data(), static_cast<int>(message.payload->size())));
        stamps_ms.push_back(1e-6 * static_cast<double>(state.stamp_ns()));
      },
      [](const loop::TickSample&) {});
  std::uint64_t tick = 0;
  for (const int ticks : ticks_per_drain) {
    for (int i = 0; i < ticks; ++i) EXPECT_TRUE(ring.try_push(sample(tick++, msg::PHASE_IN_BODY, 1.0F)));
    publisher.drain(session_time(static_cast<std::int64_t>(tick) * 500'000));
  }
  return stamps_ms;
}

TEST(TelemetryPublisher, PublishesAStateForEach10MsHoweverLateItsThreadComes) {
  const std::vector<double> each_10_ms{0, 10, 20, 30, 40, 50, 60, 70, 80, 90};
  EXPECT_EQ(state_stamps_ms({20, 20, 20, 20, 20, 20, 20, 20, 20, 20}), each_10_ms) << "in time";
  EXPECT_EQ(state_stamps_ms({21, 19, 23, 57, 20, 0, 60}), each_10_ms) << "up to 30 ms late";
  EXPECT_EQ(state_stamps_ms({1, 199}), each_10_ms) << "100 ms late";
}

TEST(TelemetryPublisher, PublishesAStateAfterTheClockWasSetBack) {
  TickRing ring;
  int states = 0;
  TelemetryPublisher publisher(
      ring, [&](const wire::Message& message) { states += message.topic.name == wire::kStationState.name ? 1 : 0; },
      [](const loop::TickSample&) {});
  for (const std::uint64_t tick : {40'000u, 40'001u, 20u, 21u})
    EXPECT_TRUE(ring.try_push(sample(tick, msg::PHASE_IN_BODY, 1.0F)));
  publisher.drain(session_time(0));
  EXPECT_EQ(states, 2);
}

TEST(TelemetryPublisher, TheTotalsStateTheStationsVersion) {
  TickRing ring;
  msg::StationStats stats;
  TelemetryPublisher publisher(
      ring, [&](const wire::Message& message) { EXPECT_TRUE(stats.ParseFromString(*message.payload)); },
      [](const loop::TickSample&) {});
  publisher.set_software("telepalp-station 0.1.0, commit 1a2b3c4d");
  publisher.publish_totals(session_time(1), 0.001, HapticCounts(), 0, true, {});
  EXPECT_EQ(stats.software(), "telepalp-station 0.1.0, commit 1a2b3c4d");
}

TEST(TicksMessage, EveryArrayHasOneEntryForEachTick) {
  const std::vector<loop::TickSample> samples{sample(7, msg::PHASE_IN_BODY, 1), sample(8, msg::PHASE_IN_BODY, 2)};
  const msg::StationTicks ticks = ticks_message(samples, 500'000);
  EXPECT_EQ(ticks.first_tick(), 7u);
  EXPECT_EQ(ticks.phase_size(), 2);
  EXPECT_EQ(ticks.force_y(1), 2.0F);
  EXPECT_EQ(ticks.distance_m_size(), 2);
  EXPECT_EQ(ticks.device_age_s_size(), 2);
  EXPECT_EQ(ticks.hand_age_s_size(), 2);
  EXPECT_EQ(ticks.surface_age_s_size(), 2);
}

TEST(TicksMessage, HasTorquesOnlyInABatchWithATorque) {
  std::vector<loop::TickSample> samples{sample(7, msg::PHASE_IN_BODY, 1), sample(8, msg::PHASE_IN_BODY, 2)};
  EXPECT_EQ(ticks_message(samples, 500'000).torque_z_size(), 0);
  samples[1].torque = {0.0F, 0.0F, 0.125F};
  const msg::StationTicks ticks = ticks_message(samples, 500'000);
  ASSERT_EQ(ticks.torque_z_size(), 2);
  EXPECT_EQ(ticks.torque_z(0), 0.0F);
  EXPECT_EQ(ticks.torque_z(1), 0.125F);
}

TEST(StateMessage, HasTorqueAndAttitudeOnlyOfADeviceThatHasThem) {
  loop::TickSample tick = sample(1, msg::PHASE_IN_BODY, 0.0F);
  EXPECT_FALSE(state_message(tick).has_torque_n_m());
  EXPECT_FALSE(state_message(tick).has_tool_attitude_camera());
  tick.gives_torque = true;
  tick.torque = {0.0F, 0.25F, 0.0F};
  tick.torque_camera = {0.25F, 0.0F, 0.0F};
  tick.tool_attitude_camera = {0.0F, 0.0F, 0.5F, 0.75F};
  EXPECT_EQ(state_message(tick).torque_n_m().y(), 0.25);
  EXPECT_EQ(state_message(tick).torque_camera_n_m().x(), 0.25);
  EXPECT_EQ(state_message(tick).tool_attitude_camera().w(), 0.75);
}

TEST(StateMessage, TellsThatThePatientMovesUnlikeBefore) {
  loop::TickSample tick = sample(1, msg::PHASE_IN_BODY, 0.0F);
  EXPECT_EQ(state_message(tick).unmodelled(), 0.0);
  tick.unmodelled = 0.75F;
  EXPECT_EQ(state_message(tick).unmodelled(), 0.75);
  loop::Compensation compensation;
  compensation.unmodelled = 0.5;
  EXPECT_EQ(compensation_message(compensation).unmodelled(), 0.5);
}

TEST(CompensationMessage, TellsWhereEachObjectInTheBodyIsAndHowWellThatIsKnown) {
  loop::Compensation compensation;
  compensation.objects[2] = {.watched = true,
                             .unseen = false,
                             .slide_unseen = true,
                             .name = "sphere",
                             .moved = {0.0F, 0.01F, 0.0F},
                             .sigma_normal_m = 0.0003F,
                             .sigma_slide_m = 0.004F};
  const msg::StationCompensation message = compensation_message(compensation);
  ASSERT_EQ(message.objects_size(), 1) << "an effect that is no object has no place";
  EXPECT_EQ(message.objects(0).name(), "sphere");
  EXPECT_EQ(message.objects(0).effect(), 2u);
  EXPECT_FALSE(message.objects(0).unseen());
  EXPECT_TRUE(message.objects(0).slide_unseen());
  EXPECT_NEAR(message.objects(0).moved().y(), 0.01, 1e-6);
  EXPECT_NEAR(message.objects(0).sigma_slide_m(), 0.004, 1e-6);
  loop::TickSample tick = sample(1, msg::PHASE_IN_BODY, 0.0F);
  tick.object_slide_unseen = true;
  EXPECT_TRUE(state_message(tick).object_slide_unseen());
  EXPECT_FALSE(state_message(tick).object_unseen());
}

}  // namespace
}  // namespace telepalp::station
