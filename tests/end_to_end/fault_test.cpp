// A fault from an operator's view: the haptic device of the real station falls silent. The station releases, records
// the last ticks, refuses to re-arm while the cause lasts, and gives force again after re-arming.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "tests/haptic_station/device/protocol/fake_udp_device.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using support::ChildProcess;
using Fault = device::FakeUdpDevice::Fault;

const fs::path kPrograms = TELEPALP_BINARY_DIR "/bin";

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

bool hears(const fs::path& log, const std::string& phrase) {
  for (int tenth = 0; tenth < 200; ++tenth) {
    if (text_of(log).find(phrase) != std::string::npos) return true;
    std::this_thread::sleep_for(100ms);
  }
  return false;
}

/// Number of ticks with a device that is silent for longer than its limit of 0.1 s. Checks that none has a force more
/// than 50 ms after the limit.
int ticks_of_silence(wire::McapReader& file) {
  int silent = 0;
  for (auto message = file.next(); message && *message; message = file.next()) {
    if ((*message)->topic.name != wire::kStationTicks.name) continue;
    msg::StationTicks ticks;
    EXPECT_TRUE(ticks.ParseFromString(*(*message)->payload));
    EXPECT_EQ(ticks.device_age_s_size(), ticks.force_y_size());
    for (int i = 0; i < ticks.device_age_s_size(); ++i) {
      if (ticks.device_age_s(i) > 0.1F) ++silent;
      if (ticks.device_age_s(i) > 0.15F) {
        EXPECT_EQ(std::hypot(ticks.force_x(i), ticks.force_y(i), ticks.force_z(i)), 0.0F) << i;
      }
    }
  }
  return silent;
}

class StationFault : public ::testing::Test {
 protected:
  void SetUp() override {
    server_.emplace(kPrograms / "telepalp-server",
                    std::vector<std::string>{"--port", "0", "--ready-file", path("ready").string()},
                    path("server.log"));
    const auto port = support::await_ready(path("ready"), "port");
    ASSERT_TRUE(port);
    station_.emplace(
        kPrograms / "telepalp-station",
        std::vector<std::string>{"--connect", "127.0.0.1:" + *port, "--device",
                                 "udp:127.0.0.1:" + std::to_string(device_.port()), "--tracker", "held", "--control",
                                 path("run/control").string(), "--state-dir", path("state").string()},
        path("station.log"));
    ASSERT_TRUE(hears(path("station.log"), "control loop runs at 2 kHz")) << text_of(path("station.log"));
  }
  [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
  int rearm() {
    ChildProcess command(kPrograms / "telepalp-station", {"rearm", "--control", path("run/control").string()},
                         path("rearm.log"));
    return command.wait(10s).value_or(-1);
  }

  support::TemporaryFolder folder_;
  device::FakeUdpDevice device_;
  std::optional<ChildProcess> server_;
  std::optional<ChildProcess> station_;
};

TEST_F(StationFault, ReleasesRecordsTheTicksAndIsRearmedOnlyWhenTheCauseIsGone) {
  EXPECT_EQ(rearm(), 1);
  EXPECT_NE(text_of(path("rearm.log")).find("there is no fault"), std::string::npos);

  std::this_thread::sleep_for(1s);  // collects ticks for the flight recorder
  device_.fault = Fault::Silent;
  ASSERT_TRUE(hears(path("station.log"), "fault: the haptic device is silent")) << text_of(path("station.log"));
  EXPECT_EQ(rearm(), 1);
  EXPECT_NE(text_of(path("rearm.log")).find("not re-armed: the haptic device is silent"), std::string::npos)
      << text_of(path("rearm.log"));

  ASSERT_TRUE(hears(path("station.log"), "flight recorder: ")) << text_of(path("station.log"));
  const fs::path kept = fs::directory_iterator(path("state"))->path();
  auto file = wire::McapReader::open(kept);
  ASSERT_TRUE(file) << to_string(file.error());
  EXPECT_GT(fs::file_size(kept), 10'000u);
  EXPECT_GT(ticks_of_silence(*file), 500)
      << "the device's age is the reason, and from 50 ms after its limit there is no force";

  device_.fault = Fault::None;
  std::this_thread::sleep_for(200ms);
  EXPECT_EQ(rearm(), 0) << text_of(path("rearm.log")) << text_of(path("station.log"));
  EXPECT_TRUE(hears(path("station.log"), "the station is re-armed by the operator"));

  ChildProcess report(kPrograms / "telepalp-report", {kept.string(), "--out", path("report").string()},
                      path("report.log"));
  EXPECT_EQ(report.wait(60s), 0) << text_of(path("report.log"));
  EXPECT_NE(text_of(path("report/report.html")).find("faulted"), std::string::npos);
}

}  // namespace
}  // namespace telepalp
