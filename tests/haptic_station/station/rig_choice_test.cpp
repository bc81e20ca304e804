#include "haptic_station/station/rigs/rig_choice.h"

#include <gtest/gtest.h>

#include <fstream>

#include "haptic_station/station/rigs/calibrated_scene.h"
#include "tests/haptic_station/device/protocol/fake_service.h"

namespace telepalp::station {
namespace {

using device::FakeService;
using device::soon;
using Eigen::Vector3d;

constexpr const char* kState =
    R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0.04,"y":-0.17,"z":0.19},)"
    R"("cursor_velocity":{"x":0,"y":0,"z":0}}}]})";

SessionTime now() { return SessionTime{std::chrono::steady_clock::now().time_since_epoch()}; }

TEST(RigChoice, LeavesTheSimulatedRigToTheStation) {
  const Result<RigChoice> choice = read_rig_choice("simulated", "simulated");
  ASSERT_TRUE(choice);
  const auto rig = connect_rig(*choice, {});
  ASSERT_TRUE(rig);
  EXPECT_EQ(rig->rig, nullptr);
}

TEST(RigChoice, RefusesWhatCannotWorkTogetherAndSaysWhatCan) {
  struct Case {
    const char* device;
    const char* tracker;
    const char* says;
  };
  for (const Case& c :
       {Case{"haply", "simulated", "--tracker held"}, Case{"simulated", "held", "--tracker simulated, leap"},
        Case{"falcon", "leap", "simulated|haply"}, Case{"haply", "kinect", "simulated|held"},
        Case{"udp:", "held", "simulated|haply"}, Case{"udp:localhost", "held", "--device udp"},
        Case{"haply:wss://x", "held", "ws://127.0.0.1:10001/"}, Case{"haply", "browser", "--device simulated"},
        Case{"simulated", "browser:1", "browser"}}) {
    const Result<RigChoice> choice = read_rig_choice(c.device, c.tracker);
    ASSERT_FALSE(choice) << c.device << " " << c.tracker;
    EXPECT_NE(to_string(choice.error()).find(c.says), std::string::npos) << to_string(choice.error());
  }
}

TEST(ConnectedRig, AHeldHaplyIsDeviceAndHandAndItsForceComesOut) {
  FakeService service(kState, [](const std::string&) { return std::optional<std::string>(kState); });
  const auto choice = read_rig_choice("haply:ws://127.0.0.1:" + std::to_string(service.port()), "held");
  ASSERT_TRUE(choice);
  auto rig = connect_rig(*choice, {});
  ASSERT_TRUE(rig) << to_string(rig.error());
  std::optional<ports::HandSample> hand;
  EXPECT_TRUE(soon([&] { return (hand = rig->rig->hand(now())).has_value(); }));
  EXPECT_LT((hand->hand.m - Vector3d(0, 0.03, 0)).norm(), 1e-12);
  EXPECT_LT((rig->rig->read().at.m - Vector3d(0, 0.03, 0)).norm(), 1e-12);
  EXPECT_TRUE(soon([&] {
    rig->rig->apply({{{0, 1.25, 0}}}, {}, 0.0005);
    return service.newest().find(R"("z":1.250000)") != std::string::npos;
  })) << service.newest();
}

TEST(ConnectedRig, ATrackedHandPushesTheSimulatedDevice) {
  FakeService service(R"({"serviceVersion":"2.3.1","version":6})",
                      [](const std::string&) { return std::optional<std::string>(); });
  const auto choice =
      read_rig_choice("simulated", "leap:ws://127.0.0.1:" + std::to_string(service.port()) + "/v6.json");
  ASSERT_TRUE(choice);
  auto rig = connect_rig(*choice, {});
  ASSERT_TRUE(rig) << to_string(rig.error());
  EXPECT_GT(rig->rig->read().at.m.y(), 0.05) << "it rests well above where the hand will be";
  service.say(R"({"timestamp":1000000,"hands":[{"id":1,"palmPosition":[0,20,0],"palmVelocity":[0,0,0]}]})");
  std::optional<ports::HandSample> hand;
  ASSERT_TRUE(soon([&] { return (hand = rig->rig->hand(now())).has_value(); }));
  EXPECT_NEAR(hand->hand.m.y(), 0.02, 1e-12);
  for (int tick = 0; tick < 4000; ++tick) rig->rig->apply({{{0, 0.5, 0}}}, {}, 0.0005);
  EXPECT_NEAR(rig->rig->read().at.m.y(), 0.02, 0.005) << "the hand presses it down, against the motors";
  EXPECT_FALSE(rig->rig->hand(now())) << "each sample once: the watchdog sees a silent tracker";
}

TEST(CalibratedScene, TakesTheMeasuredTransformsAndNoLongerCentresTheCamera) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "rig_choice.calibration.textproto";
  std::ofstream(file) << "haptic_from_camera { transform { translation_m { x: 0.5 } } }";
  scenes::Scene scene;
  scene.center_on_surface = true;
  scene.haptic_from_tracker.iso.translation() = Vector3d(1, 2, 3);
  const Result<scenes::Scene> measured = calibrated(scene, file);
  ASSERT_TRUE(measured) << to_string(measured.error());
  EXPECT_EQ(measured->haptic_from_camera.iso.translation(), Vector3d(0.5, 0, 0));
  EXPECT_EQ(measured->haptic_from_tracker.iso.translation(), Vector3d(1, 2, 3)) << "what was not measured stays";
  EXPECT_FALSE(measured->center_on_surface);
  EXPECT_FALSE(calibrated(scene, "/nowhere.calibration.textproto"));
}

}  // namespace
}  // namespace telepalp::station
