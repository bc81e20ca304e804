#include "haptic_station/station/faults/fault_monitor.h"

#include <gtest/gtest.h>

namespace telepalp::station {
namespace {

loop::TickSample tick_in(msg::Phase phase) {
  loop::TickSample tick;
  tick.phase = static_cast<std::uint8_t>(phase);
  return tick;
}

TEST(FaultMonitor, ReArmsForAPersonAtAnotherComputerOnlyAfterAFault) {
  boost::asio::io_context io;
  TickRing ticks;
  TelemetryPublisher telemetry(
      ticks, [](const wire::Message&) {}, [](const loop::TickSample&) {});
  int rearmed = 0;
  FaultMonitor faults(io, telemetry, {}, {}, "scene",
                      {.now = [] { return session_time(1); }, .rearm = [&] { ++rearmed; }});
  faults.rearm_for("viewer 7");
  EXPECT_EQ(rearmed, 0) << "no tick yet";
  faults.add(tick_in(msg::PHASE_OUT_BODY));
  faults.rearm_for("viewer 7");
  EXPECT_EQ(rearmed, 0) << "no fault";
  faults.add(tick_in(msg::PHASE_FAULTED));
  faults.rearm_for("viewer 7");
  EXPECT_EQ(rearmed, 1);
  faults.add(tick_in(msg::PHASE_RELEASED));
  faults.rearm_for("viewer 7");
  EXPECT_EQ(rearmed, 1) << "a repeated request after the fault has ended";
  faults.stop();
}

}  // namespace
}  // namespace telepalp::station
