#include <gtest/gtest.h>

#include <atomic>
#include <clocale>
#include <cmath>
#include <limits>

#include "haptic_station/device/protocol/haply_device.h"
#include "tests/haptic_station/device/protocol/fake_service.h"

namespace telepalp::device {
namespace {

using Eigen::Vector3d;
using namespace std::chrono_literals;

/// A shortened text of the Inverse service 3.1.
std::string state_text(const std::string& x = "0.05", const std::string& id = "049D") {
  return R"({"inverse3":[{"device_id":")" + id +
         R"(","config":{"type":"inverse3","handedness":"right"},"status":{"calibrated":true,"in_use":false},)" +
         R"("state":{"angular_position":{"a0":1.5,"a1":-2,"a2":3},"body_orientation":{"w":1,"x":0,"y":0,"z":0},)" +
         R"("cursor_position":{"x":)" + x + R"(,"y":-0.17,"z":0.2},)" +
         R"("cursor_velocity":{"x":0.1,"y":0.2,"z":-0.3}}}],"verse_grip":[],"wireless_verse_grip":[]})";
}

TEST(HaplyText, GivesPositionAndVelocityOfTheCursor) {
  const auto read = haply::parse_text(state_text());
  ASSERT_TRUE(read) << to_string(read.error());
  ASSERT_TRUE(read->has_value());
  EXPECT_EQ((*read)->device_id, "049D");
  EXPECT_EQ((*read)->cursor.m, Vector3d(0.05, -0.17, 0.2));
  EXPECT_EQ((*read)->velocity.v, Vector3d(0.1, 0.2, -0.3));
}

TEST(HaplyText, IsRefusedWhenItsNumbersCannotBeRight) {
  for (const char* x :
       {"nan", "NaN", "\"NaN\"", "\"Infinity\"", "1e999", "2.5", "0,05", "\"0,05\"", "null", "{}", "[]"})
    EXPECT_FALSE(haply::parse_text(state_text(x))) << x;
  for (const char* text : {"", "[", "42", "null", "{", R"({"inverse3":5})", R"({"inverse3":[{"device_id":{}}]})",
                           R"({"inverse3":[{"device_id":"a\"b","state":{}}]})"})
    EXPECT_FALSE(haply::parse_text(text)) << text;
  EXPECT_FALSE(haply::parse_text(std::string(haply::kMostTextBytes + 1, ' ')));
  std::string deep = R"({"unknown":)";
  for (int i = 0; i < 5000; ++i) deep += '[';
  EXPECT_FALSE(haply::parse_text(deep));
}

TEST(HaplyText, WithoutTheWantedDeviceIsWellFormedButEmpty) {
  for (const char* text : {"{}", R"({"inverse3":[]})", R"({"session":{"id":3}})"}) {
    const auto read = haply::parse_text(text);
    ASSERT_TRUE(read) << text;
    EXPECT_FALSE(read->has_value()) << text;
  }
  EXPECT_FALSE(haply::parse_text(state_text(), "0001")->has_value());
}

TEST(HaplyText, EveryTruncationIsRefusedOrEmptyButNeverAPosition) {
  const std::string whole = state_text();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto read = haply::parse_text(std::string_view(whole).substr(0, size));
    EXPECT_TRUE(!read || !read->has_value()) << size;
  }
}

std::string text_with_handle(const std::string& orientation, const std::string& kind = "wireless_verse_grip") {
  std::string text = state_text();
  const std::string empty = "\"" + kind + "\":[]";
  return text.replace(text.find(empty), empty.size(),
                      "\"" + kind +
                          R"(":[{"device_id":"61548","state":{"buttons":{"a":false},"hall":3,"orientation":)" +
                          orientation + "}}]");
}

TEST(HaplyText, GivesTheAttitudeOfTheHandle) {
  for (const char* kind : {"verse_grip", "wireless_verse_grip"}) {
    const auto read = haply::parse_text(text_with_handle(R"({"x":0.5,"y":0.5,"z":-0.5,"w":0.5})", kind));
    ASSERT_TRUE(read && *read && (*read)->attitude) << kind;
    EXPECT_EQ((*read)->attitude->coeffs(), Eigen::Vector4d(0.5, 0.5, -0.5, 0.5));
  }
  EXPECT_FALSE((*haply::parse_text(state_text()))->attitude) << "no handle";
  EXPECT_FALSE((*haply::parse_text(text_with_handle(R"({"x":0.5,"y":0.5})")))->attitude) << "half a rotation";
}

TEST(HaplyText, GivesTheButtonsOfTheHandle) {
  const auto pressed = [](const std::string& buttons) {
    std::string text = text_with_handle(R"({"x":0,"y":0,"z":0,"w":1})");
    text.replace(text.find(R"({"a":false})"), 11, buttons);
    return (*haply::parse_text(text))->pressed;
  };
  EXPECT_EQ(pressed(R"({"a":false,"b":false,"c":false})"), false);
  EXPECT_EQ(pressed(R"({"a":true,"b":false,"c":false})"), true);
  EXPECT_EQ(pressed(R"({"b":true})"), true);
  EXPECT_EQ((*haply::parse_text(state_text()))->pressed, std::nullopt) << "no handle";
}

TEST(HaplyFrame, AHandleThatTurnsAboutTheVerticalTurnsAboutYOfH) {
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.3, Vector3d::UnitZ()));
  const Eigen::Quaterniond in_h = haply::in_haptic_axes(turned);
  EXPECT_LT(in_h.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitY()))), 1e-12);
  EXPECT_EQ(haply::in_haptic_axes(Eigen::Quaterniond::Identity()).coeffs(), Eigen::Vector4d(0, 0, 0, 1));
}

TEST(HaplyForce, IsWrittenWithPointsInEveryLocaleAndAsZeroWhenNotFinite) {
  const bool german = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  EXPECT_EQ(haply::force_text("049D", {{1.5, -0.25, 0}}),
            R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"values":)"
            R"({"x":1.500000,"y":-0.250000,"z":0.000000}}}}]})");
  EXPECT_EQ((*haply::parse_text(state_text()))->cursor.m.x(), 0.05);
  std::setlocale(LC_ALL, "C");
  if (!german) GTEST_LOG_(INFO) << "no German locale here: the C locale was tested";
  const std::string bad = haply::force_text("049D", {{std::nan(""), 1, 2}});
  EXPECT_NE(bad.find(R"("x":0.000000,"y":0.000000,"z":0.000000)"), std::string::npos) << bad;
}

TEST(HaplyFrame, ZUpBecomesYUpAndTheOriginIsWhereItWasPut) {
  const auto haptic_from_inverse = haply::haptic_from_inverse({{0.04, -0.17, 0.16}});
  EXPECT_LT((haptic_from_inverse * Point<haply::InverseBase>{{0.04, -0.17, 0.16}}).m.norm(), 1e-15);
  const Vector<HapticBase> up = haptic_from_inverse * Vector<haply::InverseBase>{{0, 0, 1}};
  EXPECT_EQ(up.v, Vector3d(0, 1, 0));
  EXPECT_DOUBLE_EQ(haptic_from_inverse.iso.linear().determinant(), 1.0);
}

class HaplyDeviceTest : public testing::Test {
 protected:
  std::optional<std::string> answer(const std::string& text) {
    std::this_thread::sleep_for(holds.load());
    if (silent || text.find("set_cursor_force") == std::string::npos) return std::nullopt;
    return spoilt ? state_text("NaN") : state_text();
  }
  FakeService make_service(std::uint16_t port = 0, const std::string& greeting = state_text()) {
    return FakeService(
        greeting, [this](const std::string& text) { return answer(text); }, port);
  }
  static HaplyDevice make_device(std::uint16_t port) {
    return HaplyDevice({"127.0.0.1", port, "/"}, middle_of_inverse3(), [](const std::string&) {});
  }
  std::atomic<bool> silent{false};
  std::atomic<bool> spoilt{false};
  std::atomic<std::chrono::milliseconds> holds{0ms};  ///< how long each text waits for its answer
};

TEST_F(HaplyDeviceTest, ReportsItsPositionInHAndGetsTheForceInItsOwnAxes) {
  FakeService service = make_service();
  HaplyDevice device = make_device(service.port());
  ASSERT_TRUE(device.start(5s));
  const ports::DeviceReading reading = device.read();
  EXPECT_LT((reading.at.m - Vector3d(0.01, 0.04, 0.0)).norm(), 1e-12);
  EXPECT_LT((reading.velocity.v - Vector3d(0.1, -0.3, -0.2)).norm(), 1e-12);
  EXPECT_TRUE(soon([&] {
    device.apply({{{0.0, 2.0, 0.0}}}, {}, 0.0005);  // up in H: z of the Inverse
    return service.newest().find(R"("x":0.000000,"y":0.000000,"z":2.000000)") != std::string::npos ||
           service.newest().find(R"("x":0.000000,"y":-0.000000,"z":2.000000)") != std::string::npos;
  })) << service.newest();
  EXPECT_TRUE(soon([&] { return device.read().age_s < 0.02; }));
}

TEST_F(HaplyDeviceTest, MeasuresSixDegreesWithAHandleAndDrivesThree) {
  FakeService service = make_service(0, text_with_handle(R"({"x":0,"y":0,"z":0.6,"w":0.8})"));
  HaplyDevice device = make_device(service.port());
  ASSERT_TRUE(device.start(5s));
  const ports::DeviceReading reading = device.read();
  ASSERT_TRUE(reading.attitude);
  EXPECT_LT((reading.attitude->coeffs() - Eigen::Vector4d(0, 0.6, 0, 0.8)).norm(), 1e-12);
  EXPECT_EQ(reading.power.most_N_m, 0.0);
}

TEST_F(HaplyDeviceTest, AForceThatIsNotRenewedBecomesZero) {
  FakeService service = make_service();
  HaplyDevice device = make_device(service.port());
  ASSERT_TRUE(device.start(5s));
  device.apply({{{3.0, 0.0, 0.0}}}, {}, 0.0005);
  EXPECT_TRUE(soon([&] { return service.newest().find(R"("x":3.000000)") != std::string::npos; }));
  EXPECT_TRUE(soon([&] { return service.newest().find(R"("x":0.000000)") != std::string::npos; }));
}

TEST_F(HaplyDeviceTest, MeasuresTheLoopDelayFromAForceToTheTextThatAnswersIt) {
  FakeService service = make_service();
  HaplyDevice device = make_device(service.port());
  ASSERT_TRUE(device.start(5s));
  const auto next = [&] {
    device.apply({{{1.0, 0.0, 0.0}}}, {}, 0.0005);
    return device.read();
  };
  EXPECT_TRUE(soon([&] { return next().loop_s.has_value(); }));
  const ports::DeviceReading reading = next();
  ASSERT_TRUE(reading.loop_s);
  EXPECT_GE(*reading.loop_s, reading.age_s) << "the force is older than its answer";
  holds = 30ms;
  EXPECT_TRUE(soon([&] { return next().loop_s.value_or(0.0) >= 0.03; })) << "the service holds each force for 30 ms";
  holds = 0ms;
  EXPECT_TRUE(soon([&] { return !device.read().loop_s.has_value(); })) << "a force that is not renewed is no command";
}

TEST_F(HaplyDeviceTest, AgesWhenTheServiceIsSilentAndComesBack) {
  FakeService service = make_service();
  HaplyDevice device = make_device(service.port());
  ASSERT_TRUE(device.start(5s));
  silent = true;
  EXPECT_TRUE(soon([&] { return device.read().age_s > 0.3; }));
  silent = false;
  EXPECT_TRUE(soon([&] { return device.read().age_s < 0.02; })) << "the silent line is made anew";
  EXPECT_GE(service.clients(), 2);
}

TEST_F(HaplyDeviceTest, AgesOnNaNAndGoesOnWhenNumbersAreSoundAgain) {
  FakeService service = make_service();
  HaplyDevice device = make_device(service.port());
  ASSERT_TRUE(device.start(5s));
  spoilt = true;
  EXPECT_TRUE(soon([&] { return device.read().age_s > 0.2 && device.refused() > 10; }));
  EXPECT_TRUE(device.read().at.m.allFinite());
  spoilt = false;
  EXPECT_TRUE(soon([&] { return device.read().age_s < 0.02; }));
  EXPECT_EQ(service.clients(), 1) << "a bad number is no reason to hang up";
}

TEST_F(HaplyDeviceTest, OutlivesADropAndARestartOfTheService) {
  auto service = std::make_unique<FakeService>(state_text(), [this](const std::string& text) { return answer(text); });
  const std::uint16_t port = service->port();
  HaplyDevice device = make_device(port);
  ASSERT_TRUE(device.start(5s));
  service->drop();
  EXPECT_TRUE(soon([&] { return service->clients() == 2 && device.read().age_s < 0.02; }));
  service.reset();
  EXPECT_TRUE(soon([&] { return device.read().age_s > 0.2; }));
  service = std::make_unique<FakeService>(
      state_text(), [this](const std::string& text) { return answer(text); }, port);
  EXPECT_TRUE(soon([&] { return device.read().age_s < 0.02; }));
}

TEST_F(HaplyDeviceTest, SaysWhatIsMissingWhenThereIsNoServiceOrNoDevice) {
  std::uint16_t nobody = 0;
  {
    FakeService gone = make_service();
    nobody = gone.port();
  }
  HaplyDevice alone = make_device(nobody);
  const Result<void> refused = alone.start(300ms);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("ws://127.0.0.1:" + std::to_string(nobody)), std::string::npos);
  EXPECT_NE(refused.error().fix.find("--device simulated"), std::string::npos);
  EXPECT_NE(refused.error().what.find("refused"), std::string::npos) << refused.error().what;

  FakeService empty = make_service(0, R"({"inverse3":[]})");
  HaplyDevice unplugged = make_device(empty.port());
  const Result<void> none = unplugged.start(300ms);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().what.find("no Inverse3"), std::string::npos) << none.error().what;
  EXPECT_TRUE(std::isinf(unplugged.read().age_s));
}

TEST(WebSocketUrl, IsReadWithItsStandardPartsOrRefusedWithAnExample) {
  const WebSocketUrl standard = standard_haply_url();
  const auto url = parse_websocket_url("ws://localhost:123/v6.json", standard, "--device");
  ASSERT_TRUE(url);
  EXPECT_EQ(to_string(*url), "ws://localhost:123/v6.json");
  EXPECT_EQ(to_string(*parse_websocket_url("ws://10.0.0.1", standard, "--device")), "ws://10.0.0.1:10001/");
  EXPECT_EQ(to_string(*parse_websocket_url("ws://[::1]:5/", standard, "--device")), "ws://[::1]:5/");
  for (const char* text : {"", "localhost", "http://a", "ws://", "ws://a:", "ws://a:0", "ws://a:70000", "ws://a:1x",
                           "ws://a b", "ws://a\r\nX: y", "ws://[::1", "ws://:5", "ws://u@h"}) {
    const auto refused = parse_websocket_url(text, standard, "--device");
    ASSERT_FALSE(refused) << text;
    EXPECT_NE(refused.error().fix.find("ws://127.0.0.1:10001/"), std::string::npos);
  }
}

}  // namespace
}  // namespace telepalp::device
