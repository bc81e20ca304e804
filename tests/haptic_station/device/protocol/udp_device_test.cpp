#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "haptic_station/device/protocol/udp_socket_device.h"
#include "haptic_station/device/random.h"
#include "tests/haptic_station/device/protocol/fake_service.h"
#include "tests/haptic_station/device/protocol/fake_udp_device.h"

namespace telepalp::device {
namespace {

using Eigen::Vector3d;
using namespace std::chrono_literals;

udp::Pose pose(std::uint32_t session, std::uint32_t sequence, std::uint64_t us) {
  return {.session = session,
          .sequence = sequence,
          .taken_us = us,
          .heard = 7,
          .faulted = false,
          .end_effector = {{0.01, -0.02, 0.03}},
          .velocity = {{1, 2, 3}}};
}

udp::Command command() {
  return {.session = 1,
          .sequence = 2,
          .sent_us = 3,
          .in_body = true,
          .surface_valid = true,
          .proxy = {{0.1, 0.2, 0.3}},
          .distance_m = -0.01,
          .normal = {{0, 1, 0}},
          .force = {{0, 5, 0}}};
}

TEST(UdpDatagrams, ComeBackAsTheyWere) {
  const auto read = udp::decode_command(udp::encode(command()));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->in_body && read->surface_valid && !read->let_go);
  EXPECT_EQ(read->proxy.m, command().proxy.m);
  EXPECT_EQ(read->distance_m, -0.01);
  EXPECT_EQ(read->force.N, command().force.N);
  const auto up = udp::decode_pose(udp::encode(pose(9, 8, 7)));
  ASSERT_TRUE(up);
  EXPECT_EQ(up->session, 9u);
  EXPECT_EQ(up->heard, 7u);
  EXPECT_EQ(up->velocity.v, Vector3d(1, 2, 3));
}

TEST(UdpDatagrams, AreWhatTheDocumentSays) {
  const auto bytes = udp::encode(command());
  ASSERT_EQ(bytes.size(), 108u);
  const std::string start(reinterpret_cast<const char*>(bytes.data()), 4);
  EXPECT_EQ(start, "TTPD");
  EXPECT_EQ(std::to_integer<int>(bytes[4]), 1);      // version
  EXPECT_EQ(std::to_integer<int>(bytes[6]), 3);      // in body, surface valid
  EXPECT_EQ(std::to_integer<int>(bytes[8]), 1);      // session
  EXPECT_EQ(std::to_integer<int>(bytes[12]), 2);     // sequence
  EXPECT_EQ(std::to_integer<int>(bytes[94]), 0x14);  // force y = 5.0 is 0x4014...
  EXPECT_EQ(std::to_integer<int>(bytes[95]), 0x40);
  const auto up = udp::encode(pose(1, 1, 1));
  ASSERT_EQ(up.size(), 80u);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(up.data()), 4), "TTPU");
}

udp::Pose pose_of_six() {
  udp::Pose up = pose(9, 8, 7);
  up.version = udp::kVersion2;
  up.attitude = Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  up.turning = {{0.1, 0.2, 0.3}};
  up.power = {.most_N = 8.0, .most_N_m = 0.4};
  return up;
}

TEST(UdpDatagrams, OfVersion2CarryAttitudeTorqueAndTheDevicesPower) {
  const auto bytes = udp::encode(pose_of_six());
  ASSERT_EQ(bytes.size(), 152u);
  EXPECT_EQ(std::to_integer<int>(bytes[4]), 2);
  EXPECT_EQ(std::to_integer<int>(bytes[6]), 2) << "attitude measured";
  const auto up = udp::decode_pose(bytes);
  ASSERT_TRUE(up && up->attitude);
  EXPECT_EQ(up->attitude->coeffs(), pose_of_six().attitude->coeffs());
  EXPECT_EQ(up->turning.v, Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(up->power.most_N, 8.0);
  EXPECT_EQ(up->power.most_N_m, 0.4);
  udp::Command down = command();
  down.version = udp::kVersion2;
  down.torque = {{0.01, 0.02, 0.03}};
  const auto read = udp::decode_command(udp::encode(down));
  ASSERT_TRUE(read);
  EXPECT_EQ(udp::encode(down).size(), 132u);
  EXPECT_EQ(read->torque.N_m, down.torque.N_m);
  EXPECT_EQ(read->force.N, down.force.N);
}

TEST(UdpDatagrams, OfVersion2AreRefusedWithTheSizeOfVersion1AndWithAnImpossiblePower) {
  const auto whole = udp::encode(pose_of_six());
  EXPECT_FALSE(udp::decode_pose(std::span(whole).first(80)));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -0.1, 101.0}) {
    udp::Pose up = pose_of_six();
    up.power.most_N = bad;
    EXPECT_FALSE(udp::decode_pose(udp::encode(up))) << bad;
    up = pose_of_six();
    up.power.most_N_m = bad;
    EXPECT_FALSE(udp::decode_pose(udp::encode(up))) << bad;
  }
  udp::Pose glitch = pose_of_six();
  glitch.attitude->x() = std::nan("");
  EXPECT_TRUE(udp::decode_pose(udp::encode(glitch))) << "the haptic loop bridges it, and the position counts";
}

TEST(UdpDatagrams, OfBothVersionsCarryTheButton) {
  for (udp::Pose up : {pose(1, 2, 3), pose_of_six()}) {
    EXPECT_FALSE(udp::decode_pose(udp::encode(up))->pressed);
    up.pressed = true;
    const auto read = udp::decode_pose(udp::encode(up));
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->pressed && !read->faulted);
  }
}

TEST(UdpDatagrams, AnyFlippedBitOrMissingByteIsSeen) {
  const auto whole = udp::encode(pose(1, 2, 3));
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      auto bytes = whole;
      bytes[i] ^= static_cast<std::byte>(1 << bit);
      EXPECT_FALSE(udp::decode_pose(bytes)) << i;
    }
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_FALSE(udp::decode_pose(std::span(whole).first(size)));
  EXPECT_FALSE(udp::decode_command(whole));
}

TEST(UdpDatagrams, AnInvalidPoseIsRefusedAndAnInvalidCommandReleases) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300, -2.1}) {
    udp::Pose up = pose(1, 2, 3);
    up.end_effector.m.y() = bad;
    EXPECT_FALSE(udp::decode_pose(udp::encode(up))) << bad;
    udp::Command down = command();
    down.proxy.m.x() = bad;
    const auto read = udp::decode_command(udp::encode(down));
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->let_go);
    EXPECT_EQ(read->force.N, Vector3d::Zero().eval());
  }
}

TEST(PoseOrder, TakesTheNewestAcrossTheWrapAndNothingTwice) {
  using Verdict = udp::PoseOrder::Verdict;
  udp::PoseOrder order;
  EXPECT_EQ(order.judge(pose(1, 0xffffffff, 10)), Verdict::Newest);
  EXPECT_EQ(order.judge(pose(1, 0, 20)), Verdict::Newest);
  EXPECT_EQ(order.judge(pose(1, 0, 20)), Verdict::Repeated);
  EXPECT_EQ(order.judge(pose(1, 0xffffffff, 10)), Verdict::Repeated);
  EXPECT_EQ(order.judge(pose(1, 1, 20)), Verdict::ClockStands);
  EXPECT_EQ(order.judge(pose(2, 1, 5)), Verdict::Newest) << "the device was started anew";
  EXPECT_EQ(order.judge(pose(1, 50, 90)), Verdict::OldSession) << "a late datagram from before";
}

TEST(UdpDevice, ReportsItsPoseAndGetsProxyDistanceFlagAndForce) {
  FakeUdpDevice fake;
  auto device = UdpDevice::open({"127.0.0.1", fake.port()});
  ASSERT_TRUE(device) << to_string(device.error());
  ASSERT_TRUE((*device)->start(5s));
  EXPECT_EQ((*device)->read().at.m, Vector3d(0.01, -0.02, 0.03));
  ports::SurfaceContact contact;
  contact.distance_m = -0.004;
  contact.valid = true;
  EXPECT_TRUE(soon([&] {
    (*device)->apply({{{0, 2.5, 0}}}, contact, 0.0005);
    return fake.force_y == 2.5 && fake.distance == -0.004;
  }));
}

TEST(UdpDevice, MeasuresTheLoopDelayByTheCommandThatAPoseEchoes) {
  FakeUdpDevice fake;
  auto device = UdpDevice::open({"127.0.0.1", fake.port()});
  ASSERT_TRUE(device) << to_string(device.error());
  ASSERT_TRUE((*device)->start(5s));
  const auto next = [&] {
    (*device)->apply({}, {}, 0.0005);
    return (*device)->read();
  };
  EXPECT_TRUE(soon([&] { return next().loop_s.has_value(); }));
  const ports::DeviceReading reading = (*device)->read();
  ASSERT_TRUE(reading.loop_s);
  EXPECT_GE(*reading.loop_s, reading.age_s) << "the command is older than its echo";
  fake.holds = 30ms;
  EXPECT_TRUE(soon([&] { return next().loop_s.value_or(0.0) >= 0.03; })) << "the device holds each command for 30 ms";
  fake.holds = 0ms;
  fake.misheard = 1U << 20U;
  EXPECT_TRUE(soon([&] { return !next().loop_s.has_value(); })) << "a command that the station never gave";
}

TEST(UdpDevice, SpeaksTheVersionOfTheDeviceAlsoWhenAnotherDeviceTakesItsPlace) {
  FakeUdpDevice fake;
  auto device = UdpDevice::open({"127.0.0.1", fake.port()});
  ASSERT_TRUE(device && (*device)->start(5s));
  const auto hears = [&](std::uint16_t version, double torque_N_m) {
    return soon([&] {
      (void)(*device)->read();
      (*device)->apply({.force = {{0, 2, 0}}, .torque = {{0, 0, 0.125}}}, {}, 0.0005);
      return fake.heard_version == version && fake.torque_z == torque_N_m;
    });
  };
  EXPECT_TRUE(hears(1, 0.0));
  EXPECT_FALSE((*device)->read().attitude);
  EXPECT_EQ((*device)->read().power.most_N_m, 0.0);
  fake.session = 78;
  fake.version = udp::kVersion2;
  EXPECT_TRUE(hears(2, 0.125));
  const ports::DeviceReading six = (*device)->read();
  ASSERT_TRUE(six.attitude);
  EXPECT_NEAR(six.attitude->z(), std::sin(0.25), 1e-12);
  EXPECT_EQ(six.turning.v.z(), 0.25);
  EXPECT_EQ(six.power.most_N_m, 0.5);
  fake.session = 79;
  fake.version = udp::kVersion1;
  EXPECT_TRUE(hears(1, 0.0));
  EXPECT_FALSE((*device)->read().attitude);
}

TEST(UdpDevice, AgesUnderEveryFaultAndComesBack) {
  using Fault = FakeUdpDevice::Fault;
  FakeUdpDevice fake;
  auto device = UdpDevice::open({"localhost", fake.port()});
  ASSERT_TRUE(device && (*device)->start(5s));
  for (const Fault fault : {Fault::Silent, Fault::NaN, Fault::Hung, Fault::MotorsOff, Fault::Garbage}) {
    fake.fault = fault;
    EXPECT_TRUE(soon([&] {
      (*device)->apply({}, {}, 0.0005);
      return (*device)->read().age_s > 0.15;
    })) << static_cast<int>(fault);
    EXPECT_TRUE((*device)->read().at.m.allFinite());
    fake.fault = Fault::None;
    EXPECT_TRUE(soon([&] {
      (*device)->apply({}, {}, 0.0005);
      return (*device)->read().age_s < 0.02;
    })) << static_cast<int>(fault);
  }
  fake.session = 78;
  EXPECT_TRUE(soon([&] {
    (*device)->apply({}, {}, 0.0005);
    return (*device)->read().age_s < 0.02;
  }));
}

TEST(UdpDevice, TellsHowManyDatagramsItRefusedAndWhy) {
  using Fault = FakeUdpDevice::Fault;
  FakeUdpDevice fake;
  auto device = UdpDevice::open({"localhost", fake.port()});
  ASSERT_TRUE(device && (*device)->start(5s));
  EXPECT_FALSE((*device)->new_refusals());
  for (const auto& [fault, why] : {std::pair{Fault::Garbage, "damaged"}, {Fault::Hung, "clock does not advance"}}) {
    fake.fault = fault;
    const std::uint64_t before = (*device)->refused();
    EXPECT_TRUE(soon([&] {
      (*device)->apply({}, {}, 0.0005);
      (void)(*device)->read();
      return (*device)->refused() > before + 10;
    }));
    const std::optional<Error> said = (*device)->new_refusals();
    ASSERT_TRUE(said);
    EXPECT_NE(said->what.find(" datagrams refused; the newest because "), std::string::npos) << said->what;
    EXPECT_NE(said->what.find(why), std::string::npos) << said->what;
    EXPECT_FALSE((*device)->new_refusals()) << "each is told once";
  }
}

TEST(UdpDevice, IsOfThisMachineAloneAndSaysWhenNobodyAnswers) {
  for (const char* host : {"192.168.1.7", "0.0.0.0", "example.org", "8.8.8.8"}) {
    const auto refused = UdpDevice::open({host, 5000});
    ASSERT_FALSE(refused) << host;
    EXPECT_NE(refused.error().fix.find("127.0.0.1"), std::string::npos);
  }
  std::uint16_t nobody = 0;
  {
    FakeUdpDevice gone;
    nobody = gone.port();
  }
  auto device = UdpDevice::open({"127.0.0.1", nobody});
  ASSERT_TRUE(device);
  const Result<void> alone = (*device)->start(100ms);
  ASSERT_FALSE(alone);
  EXPECT_NE(to_string(alone.error()).find("does not answer"), std::string::npos);
  EXPECT_TRUE(std::isinf((*device)->read().age_s));
}

}  // namespace
}  // namespace telepalp::device
