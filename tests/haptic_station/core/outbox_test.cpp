// The one place in which a station's samples, reports and faults become messages.

#include "haptic_station/core/outbox/outbox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/core/outbox/tick_messages.h"
#include "proto/wire/topics.h"

namespace telepalp::core {
namespace {

loop::TickSample sample(std::uint64_t tick, msg::Phase phase, float force_N) {
  loop::TickSample out;
  out.tick = tick;
  out.stamp_ns = static_cast<std::int64_t>(tick) * 500'000;
  out.phase = static_cast<std::uint8_t>(phase);
  out.work_us = 10.0F;
  out.force = {0.0F, force_N, 0.0F};
  out.yields_in_s = std::numeric_limits<float>::infinity();  // the motors are cool
  return out;
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

TEST(RunTotals, PhasesAreEnteredOnceAndDweltInByTheTick) {
  RunTotals totals;
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

/// The stamps [ms] of the states among the messages of ticks, in batches of these sizes.
std::vector<double> state_stamps_ms(const std::vector<int>& batches) {
  Outbox outbox;
  std::vector<double> stamps_ms;
  std::uint64_t tick = 0;
  for (const int ticks : batches) {
    std::vector<loop::TickSample> batch;
    for (int i = 0; i < ticks; ++i) batch.push_back(sample(tick++, msg::PHASE_IN_BODY, 1.0F));
    for (const wire::Message& message : outbox.ticks(batch, session_time(static_cast<std::int64_t>(tick) * 500'000))) {
      if (message.topic.name != wire::kStationState.name) continue;
      msg::StationState state;
      EXPECT_TRUE(state.ParseFromString(*message.payload));
      stamps_ms.push_back(1e-6 * static_cast<double>(state.stamp_ns()));
    }
  }
  return stamps_ms;
}

TEST(Outbox, HasAStateForEach10MsHoweverLateItsThreadComes) {
  const std::vector<double> each_10_ms{0, 10, 20, 30, 40, 50, 60, 70, 80, 90};
  EXPECT_EQ(state_stamps_ms({20, 20, 20, 20, 20, 20, 20, 20, 20, 20}), each_10_ms) << "in time";
  EXPECT_EQ(state_stamps_ms({21, 19, 23, 57, 20, 0, 60}), each_10_ms) << "up to 30 ms late";
  EXPECT_EQ(state_stamps_ms({1, 199}), each_10_ms) << "100 ms late";
}

/// The topics of messages, in order.
std::vector<std::string> topics_of(const Outbox::Messages& messages) {
  std::vector<std::string> topics;
  for (const wire::Message& message : messages) topics.emplace_back(message.topic.name);
  return topics;
}

TEST(Outbox, HasAStateAfterTheClockWasSetBack) {
  Outbox outbox;
  std::vector<loop::TickSample> batch;
  for (const std::uint64_t tick : {40'000U, 40'001U, 20U, 21U}) batch.push_back(sample(tick, msg::PHASE_IN_BODY, 1.0F));
  const std::vector<std::string> topics = topics_of(outbox.ticks(batch, session_time(0)));
  EXPECT_EQ(std::ranges::count(topics, std::string(wire::kStationState.name)), 2);
}

TEST(Outbox, APhaseChangeComesBeforeTheTicksAndNoTickGivesNoMessage) {
  Outbox outbox;
  EXPECT_TRUE(outbox.ticks({}, session_time(0)).empty());
  EXPECT_FALSE(outbox.last());
  const std::vector batch{sample(1, msg::PHASE_OUT_BODY, 0.0F), sample(2, msg::PHASE_IN_BODY, 1.0F)};
  EXPECT_EQ(topics_of(outbox.ticks(batch, session_time(0))),
            (std::vector<std::string>{"/station/events", "/station/events", "/station/ticks", "/station/state"}));
  EXPECT_EQ(outbox.last()->tick, 2U);
}

TEST(Outbox, WarnsOfWarmMotorsOnceUntilTheForceIsOneThatTheyHold) {
  Outbox outbox;
  const auto warns = [&](float yields_in_s) {
    loop::TickSample tick = sample(1, msg::PHASE_IN_BODY, 3.0F);
    tick.yields_in_s = yields_in_s;
    int warnings = 0;
    for (const wire::Message& message : outbox.ticks(std::span(&tick, 1), session_time(0))) {
      msg::StationEvent event;
      if (message.topic.name == wire::kStationEvents.name && event.ParseFromString(*message.payload))
        warnings += event.kind() == msg::EVENT_KIND_HEAT ? 1 : 0;
    }
    return warnings;
  };
  constexpr float kNever = std::numeric_limits<float>::infinity();
  EXPECT_EQ(warns(kNever), 0);
  EXPECT_EQ(warns(3.9F), 1);
  EXPECT_EQ(warns(2.0F), 0) << "it was said";
  EXPECT_EQ(warns(5.0F), 0);
  EXPECT_EQ(warns(3.0F), 0) << "the motors were warm all the time";
  EXPECT_EQ(warns(kNever), 0);
  EXPECT_EQ(warns(3.0F), 1);
}

TEST(Outbox, AllMessagesWithAgesStateTheErrorOfTheClock) {
  Outbox outbox;
  outbox.facts().clock_error_s = 0.004;
  msg::SurfaceReport surface;
  msg::StationCompensation compensation;
  msg::StationStats stats;
  EXPECT_TRUE(surface.ParseFromString(*outbox.surface({}, session_time(1)).payload));
  EXPECT_TRUE(compensation.ParseFromString(*outbox.compensation({}, session_time(1)).payload));
  EXPECT_TRUE(stats.ParseFromString(*outbox.totals({}, session_time(1)).payload));
  EXPECT_EQ(surface.clock_error_s(), 0.004);
  EXPECT_EQ(compensation.clock_error_s(), 0.004);
  EXPECT_EQ(stats.clock_error_s(), 0.004);
}

TEST(Outbox, TheTotalsStateTheStationsVersionAndItsCounts) {
  Outbox outbox;
  outbox.facts().software = "telepalp-station 0.1.0, commit 1a2b3c4d";
  outbox.frame_received();
  msg::StationStats stats;
  const Outbox::Counts counts{.deadlines_missed = 3, .ticks_dropped = 5, .frames_dropped = 7};
  EXPECT_TRUE(stats.ParseFromString(*outbox.totals(counts, session_time(1)).payload));
  EXPECT_EQ(stats.software(), "telepalp-station 0.1.0, commit 1a2b3c4d");
  EXPECT_EQ(stats.deadlines_missed(), 3U);
  EXPECT_EQ(stats.telemetry_dropped(), 5U);
  EXPECT_EQ(stats.frames_dropped(), 7U);
  EXPECT_EQ(stats.frames_received(), 1U);
}

TEST(Outbox, AFaultIsOfTheTickInWhichItBegan) {
  loop::TickSample first = sample(200, msg::PHASE_FAULTED, 0.0F);
  first.fault = static_cast<std::uint8_t>(control::FaultCause::DeviceSilent);
  msg::StationEvent event;
  EXPECT_TRUE(event.ParseFromString(*Outbox::fault(first, session_time(1)).payload));
  EXPECT_EQ(event.kind(), msg::EVENT_KIND_FAULT);
  EXPECT_EQ(event.stamp_ns(), 100'000'000U);
  EXPECT_EQ(event.text(), control::name(control::FaultCause::DeviceSilent));
}

TEST(TicksMessage, EveryArrayHasOneEntryForEachTick) {
  const std::vector<loop::TickSample> samples{sample(7, msg::PHASE_IN_BODY, 1), sample(8, msg::PHASE_IN_BODY, 2)};
  const msg::StationTicks ticks = ticks_message(samples);
  EXPECT_EQ(ticks.first_tick(), 7u);
  EXPECT_EQ(ticks.phase_size(), 2);
  EXPECT_EQ(ticks.force_y(1), 2.0F);
  EXPECT_EQ(ticks.distance_m_size(), 2);
  EXPECT_EQ(ticks.device_age_s_size(), 2);
  EXPECT_EQ(ticks.hand_age_s_size(), 2);
  EXPECT_EQ(ticks.surface_age_s_size(), 2);
}

TEST(TicksMessage, ABatchIsCutWhereThePeriodOfALateThreadWasSkippedOrATickIsMissing) {
  std::vector<loop::TickSample> samples;
  for (const std::uint64_t tick : {7U, 8U, 9U, 10U, 12U}) samples.push_back(sample(tick, msg::PHASE_IN_BODY, 1));
  for (std::size_t i = 2; i < samples.size(); ++i)
    samples[i].stamp_ns += 500'000;  // the period before tick 9 was skipped
  samples[3].stamp_ns += 900;        // the session clock is steered
  std::vector<std::pair<std::uint64_t, std::size_t>> runs;
  for (const auto run : unbroken_runs(samples)) runs.emplace_back(run.front().tick, run.size());
  EXPECT_EQ(runs, (std::vector<std::pair<std::uint64_t, std::size_t>>{{7, 2}, {9, 2}, {12, 1}}));
  EXPECT_TRUE(unbroken_runs({}).empty());
}

TEST(TicksMessage, HasTorquesOnlyInABatchWithATorque) {
  std::vector<loop::TickSample> samples{sample(7, msg::PHASE_IN_BODY, 1), sample(8, msg::PHASE_IN_BODY, 2)};
  EXPECT_EQ(ticks_message(samples).torque_z_size(), 0);
  samples[1].torque = {0.0F, 0.0F, 0.125F};
  const msg::StationTicks ticks = ticks_message(samples);
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
}  // namespace telepalp::core
