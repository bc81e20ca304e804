#include "haptic_station/station/faults/flight_recorder.h"

#include <gtest/gtest.h>

#include "haptic_station/control/phases/phase.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "tests/support/child_process.h"

namespace telepalp::station {
namespace {

loop::TickSample sample(std::uint64_t tick, msg::Phase phase = msg::PHASE_OUT_BODY) {
  loop::TickSample out;
  out.tick = tick;
  out.phase = static_cast<std::uint8_t>(phase);
  return out;
}

TEST(FlightRecorder, HoldsTheNewestTicksOldestFirst) {
  FlightRecorder box(4);
  EXPECT_TRUE(box.ticks().empty());
  for (std::uint64_t tick = 0; tick < 3; ++tick) box.add(sample(tick));
  EXPECT_EQ(box.ticks().size(), 3u);
  for (std::uint64_t tick = 3; tick < 10; ++tick) box.add(sample(tick));
  ASSERT_EQ(box.ticks().size(), 4u);
  EXPECT_EQ(box.ticks().front().tick, 6u);
  EXPECT_EQ(box.ticks().back().tick, 9u);
}

TEST(FaultWatch, ReportsAFaultOnceAndReturnsItsTicksHalfASecondLater) {
  FaultWatch watch;
  std::uint64_t tick = 0;
  for (; tick < 100; ++tick) watch.add(sample(tick));
  EXPECT_FALSE(watch.begun());
  watch.add(sample(tick++, msg::PHASE_FAULTED));
  ASSERT_TRUE(watch.begun());
  EXPECT_FALSE(watch.begun());
  for (int i = 0; i < 999; ++i) watch.add(sample(tick++, msg::PHASE_FAULTED));
  EXPECT_FALSE(watch.due(false));
  watch.add(sample(tick++, msg::PHASE_FAULTED));
  const auto ticks = watch.due(false);
  ASSERT_TRUE(ticks);
  EXPECT_EQ(ticks->size(), 1101u);
  EXPECT_FALSE(watch.due(true)) << "once is enough";
}

TEST(FaultWatch, DoesNotWaitWhenTheStationEndsAndSeesTheNextFaultAfterReArming) {
  FaultWatch watch;
  watch.add(sample(0));
  watch.add(sample(1, msg::PHASE_FAULTED));
  EXPECT_TRUE(watch.begun());
  EXPECT_TRUE(watch.due(true));
  watch.add(sample(2, msg::PHASE_RELEASED));
  watch.add(sample(3, msg::PHASE_FAULTED));
  EXPECT_TRUE(watch.begun());
}

/// The texts of the fault events in a session file.
std::vector<std::string> faults_in(const std::filesystem::path& file) {
  std::vector<std::string> faults;
  auto reader = wire::McapReader::open(file);
  EXPECT_TRUE(reader.ok());
  reader->select({.topics = {std::string(wire::kStationEvents.name)}});
  for (auto message = reader->next(); message && *message; message = reader->next()) {
    msg::StationEvent event;
    EXPECT_TRUE(event.ParseFromString(*(*message)->payload));
    if (event.kind() == msg::EVENT_KIND_FAULT) faults.push_back(event.text());
  }
  return faults;
}

TEST(FlightRecord, StatesTheCauseOfEachFaultEvenIfTheOperatorReArmedBeforeItWasWritten) {
  using control::FaultCause;
  FaultWatch watch;
  std::uint64_t tick = 0;
  const auto add = [&](int count, FaultCause cause) {
    for (int i = 0; i < count; ++i, ++tick) {
      loop::TickSample now = sample(tick, cause == FaultCause::None ? msg::PHASE_OUT_BODY : msg::PHASE_FAULTED);
      now.stamp_ns = static_cast<std::int64_t>(1'000'000'000 + 500'000 * tick);
      now.fault = static_cast<std::uint8_t>(cause);
      watch.add(now);
    }
  };
  add(100, FaultCause::None);
  add(200, FaultCause::DeviceSilent);
  add(300, FaultCause::None);  // re-armed
  add(50, FaultCause::HandImplausible);
  add(1000, FaultCause::None);  // re-armed within 0.5 s
  const auto ticks = watch.due(false);
  ASSERT_TRUE(ticks);
  const support::TemporaryFolder folder;
  const auto file = write_flight_record(folder.path(), *ticks, "scene");
  ASSERT_TRUE(file.ok()) << to_string(file.error());
  EXPECT_EQ(faults_in(*file), (std::vector<std::string>{control::name(FaultCause::DeviceSilent),
                                                        control::name(FaultCause::HandImplausible)}));
}

}  // namespace
}  // namespace telepalp::station
