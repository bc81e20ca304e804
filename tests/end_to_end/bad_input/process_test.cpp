// What goes wrong around the programs: a frozen peer, a device that gives no number, a wall clock that is stepped.

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "tests/end_to_end/bad_input/running_session.h"
#include "tests/haptic_station/device/protocol/fake_udp_device.h"
#include "where.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;

TEST(BadInput36, AFrozenServerReleasesTheForceAndTheSessionComesBack) {
  RunningSession session;
  const Felt frozen = session.during([&] {
    session.server().signal(SIGSTOP);
    std::this_thread::sleep_for(2s);
    session.server().signal(SIGCONT);
  });
  EXPECT_GT(frozen.longest_without_surface_s, 1.5) << "the server was frozen";
  EXPECT_GT(frozen.released, 0u) << "an old surface gives no force";
  std::this_thread::sleep_for(6s);  // more than the watchdog of a connection
  session.expect_undisturbed_by([] { std::this_thread::sleep_for(1s); });
}

TEST(BadInput36, AFrozenStationLosesItsPlaceAndAsksForItAgain) {
  RunningSession session;
  session.station().signal(SIGSTOP);
  EXPECT_TRUE(comes(session.file("server.log"), "nothing heard for 5 s", 12s)) << text_of(session.file("server.log"));
  EXPECT_TRUE(comes(session.file("audit.log"), "event=gave-touch who=doctor anna", 12s)) << session.audit();
  session.station().signal(SIGCONT);
  std::this_thread::sleep_for(5s);
  session.expect_undisturbed_by([] { std::this_thread::sleep_for(1s); });
}

TEST(BadInput10, ADevicePoseThatIsNaNGetsNoForceAndLatchesAFault) {
  using Fault = device::FakeUdpDevice::Fault;
  device::FakeUdpDevice device;
  server::Site site;
  const support::TemporaryFolder folder;
  const auto log = folder.path() / "station.log";
  support::ChildProcess server(TELEPALP_BINARY_DIR "/bin/telepalp-server",
                               {"--port", "0", "--ready-file", (folder.path() / "ready").string()},
                               folder.path() / "server.log");
  const auto port = support::await_ready(folder.path() / "ready", "port");
  ASSERT_TRUE(port);
  support::ChildProcess station(
      TELEPALP_BINARY_DIR "/bin/telepalp-station",
      {"--connect", "127.0.0.1:" + *port, "--device", "udp:127.0.0.1:" + std::to_string(device.port()), "--tracker",
       "held", "--control", (folder.path() / "control").string(), "--state-dir", (folder.path() / "state").string()},
      log);
  ASSERT_TRUE(comes(log, "ticking at 2 kHz", 20s)) << text_of(log);
  device.fault = Fault::NaN;
  EXPECT_TRUE(comes(log, "fault: ", 10s)) << text_of(log);
  std::this_thread::sleep_for(200ms);
  EXPECT_EQ(device.force_y, 0.0);
  device.fault = Fault::None;
  std::this_thread::sleep_for(500ms);
  EXPECT_EQ(device.force_y, 0.0) << "the fault stays until an operator re-arms the station";
}

}  // namespace
}  // namespace telepalp::bad_input
