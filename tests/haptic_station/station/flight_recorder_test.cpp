#include "haptic_station/station/faults/flight_recorder.h"

#include <gtest/gtest.h>

#include "messages/station.pb.h"

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

}  // namespace
}  // namespace telepalp::station
