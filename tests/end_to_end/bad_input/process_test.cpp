// What goes wrong around the programs: a frozen peer, a device that gives no number, a wall clock that is stepped.

#include <gtest/gtest.h>

#include <csignal>
#include <ctime>
#include <fstream>
#include <thread>

#include "tests/end_to_end/bad_input/insider.h"
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
  EXPECT_TRUE(comes(session.file("server.log"), "no message arrived for 5 s", 12s))
      << text_of(session.file("server.log"));
  EXPECT_TRUE(comes(session.file("audit.log"), "event=gave-touch who=doctor anna", 12s)) << session.audit();
  session.station().signal(SIGCONT);
  std::this_thread::sleep_for(5s);
  session.expect_undisturbed_by([] { std::this_thread::sleep_for(1s); });
}

/// The wall clock of programs that are started with environment().
class SteppedWallClock {
 public:
  SteppedWallClock() { step(0s); }
  void step(std::chrono::seconds ahead) const {
    const std::int64_t seconds = ahead.count();
    std::fstream file(file_, std::filesystem::exists(file_) ? std::ios::in | std::ios::out | std::ios::binary
                                                            : std::ios::out | std::ios::binary);
    file.write(reinterpret_cast<const char*>(&seconds), sizeof seconds);
  }
  [[nodiscard]] std::vector<std::string> environment() const {
    return {"LD_PRELOAD=" TELEPALP_BINARY_DIR "/preload/telepalp_stepped_wall_clock.so",
            "TELEPALP_WALL_CLOCK_STEP=" + file_.string()};
  }

 private:
  support::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "step";
};

std::string in_utc(std::chrono::system_clock::time_point at, const char* format) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(at);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  char text[32];
  std::strftime(text, sizeof text, format, &parts);
  return text;
}

TEST(BadInput29, AWallClockThatStepsAnHourForwardAndBackDisturbsNobody) {
  const SteppedWallClock wall;
  RunningSession session({}, wall.environment());
  for (const auto ahead : {3600s, -3600s, 0s})
    session.expect_undisturbed_by([&] {
      wall.step(ahead);
      std::this_thread::sleep_for(2s);
    });
  EXPECT_EQ(text_of(session.file("station.log")).find("link lost"), std::string::npos);
  wall.step(3600s);
  const auto before = std::chrono::system_clock::now() + 1h;
  Insider late(session.port(), session.ring().key("mallory", keys::Role::Viewer));
  late.say(greeting("late"));
  EXPECT_TRUE(comes(session.file("audit.log"), "who=viewer mallory")) << session.audit();
  const auto after = std::chrono::system_clock::now() + 1h;
  const bool stamped = session.audit().find(in_utc(before, "%Y-%m-%dT%H:%M")) != std::string::npos ||
                       session.audit().find(in_utc(after, "%Y-%m-%dT%H:%M")) != std::string::npos;
  EXPECT_TRUE(stamped) << "the server's wall clock is an hour ahead: " << session.audit();
}

TEST(BadInput35, TheServerProgramRefusesToStartWithAnExpiredKeyAndSaysHowToRenewIt) {
  const server::KeyRing ring;
  const auto log = ring.folder.path() / "server.log";
  support::ChildProcess server(TELEPALP_BINARY_DIR "/bin/telepalp-server",
                               {"--port", "0", "--key", ring.server_key(ring.now - std::chrono::days(3)).string()},
                               log);
  EXPECT_EQ(server.wait(20s), 1);
  EXPECT_NE(text_of(log).find("expired"), std::string::npos) << text_of(log);
  EXPECT_NE(text_of(log).find("telepalp-keys renew"), std::string::npos) << text_of(log);
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
  ASSERT_TRUE(comes(log, "control loop runs at 2 kHz", 20s)) << text_of(log);
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
