#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "haptic_station/tracking/protocol/leap_tracker.h"
#include "tests/haptic_station/device/protocol/fake_service.h"

namespace telepalp::tracking {
namespace {

using device::FakeService;
using device::soon;
using Eigen::Vector3d;
using namespace std::chrono_literals;

constexpr const char* kHello = R"({"serviceVersion":"2.3.1+33747", "version":6})";

/// A hand in a text of the service, with unused fields.
std::string hand_text(int id, const std::string& x_mm) {
  return R"({"armBasis":[[1,0,0],[0,1,0],[0,0,1]],"confidence":0.98,"direction":[0,0,-1],"grabStrength":0,"id":)" +
         std::to_string(id) + R"(,"palmNormal":[0,-1,0],"palmPosition":[)" + x_mm +
         R"(,185.083,12.2664],"palmVelocity":[34.1,30.4,-5.8],"r":[[1,0,0],[0,1,0],[0,0,1]],"s":1.2,"type":"right"})";
}

std::string frame_text(std::int64_t us, const std::string& hands) {
  return R"({"currentFrameRate":113.2,"devices":[],"gestures":[],"hands":[)" + hands +
         R"(],"id":139225,"interactionBox":{"center":[0,200,0],"size":[235,235,147]},"pointables":[],)" +
         R"("r":[[1,0,0],[0,1,0],[0,0,1]],"s":1,"t":[0,0,0],"timestamp":)" + std::to_string(us) + "}";
}

TEST(LeapText, ReadsVersionFramesAndOtherTexts) {
  const auto hello = leap::parse_text(kHello);
  ASSERT_TRUE(hello) << to_string(hello.error());
  EXPECT_EQ(std::get<leap::Hello>(*hello).version, 6u);
  EXPECT_EQ(std::get<leap::Hello>(*hello).service_version, "2.3.1+33747");
  const auto frame = leap::parse_text(frame_text(12439534551, hand_text(12, "70.998")));
  ASSERT_TRUE(frame) << to_string(frame.error());
  const auto& seen = std::get<leap::Frame>(*frame);
  EXPECT_EQ(seen.timestamp_us, 12439534551);
  ASSERT_EQ(seen.hands.size(), 1u);
  EXPECT_EQ(seen.hands[0].id, 12);
  EXPECT_LT((seen.hands[0].palm.m - Vector3d(0.070998, 0.185083, 0.0122664)).norm(), 1e-12);
  EXPECT_LT((seen.hands[0].velocity.v - Vector3d(0.0341, 0.0304, -0.0058)).norm(), 1e-12);
  ASSERT_TRUE(seen.hands[0].attitude);
  EXPECT_LT((*seen.hands[0].attitude * Vector3d::UnitZ() - Vector3d::UnitY()).norm(), 1e-12) << "the back is up";
  EXPECT_LT((*seen.hands[0].attitude * Vector3d::UnitY() + Vector3d::UnitZ()).norm(), 1e-12) << "fingers ahead";
  const auto event = leap::parse_text(R"({"event":{"state":{"attached":true,"id":"x"},"type":"deviceEvent"}})");
  ASSERT_TRUE(event);
  EXPECT_TRUE(std::holds_alternative<leap::Other>(*event));
}

TEST(LeapText, LeavesOutHandsWhoseNumbersCannotBeRight) {
  for (const char* x : {"\"NaN\"", "\"-Infinity\"", "1e300", "70,998", "10001", "1, 2", "null"}) {
    const auto read = leap::parse_text(frame_text(1, hand_text(12, x) + "," + hand_text(13, "5")));
    if (!read) continue;  // the whole text may be refused, too
    const auto& frame = std::get<leap::Frame>(*read);
    ASSERT_EQ(frame.hands.size(), 1u) << x;
    EXPECT_EQ(frame.hands[0].id, 13) << x;
    EXPECT_EQ(frame.refused, 1u) << x;
  }
}

TEST(LeapText, AHandWhoseDirectionsSayNothingHasNoAttitude) {
  for (const char* text : {R"("direction":[0,0,-1])", R"("direction":[0,0,0],"palmNormal":[0,-1,0])",
                           R"("direction":[0,0,-9],"palmNormal":[0,-1,0])", R"("direction":[0],"palmNormal":[0,-1,0])",
                           R"("direction":[0,-1,0],"palmNormal":[0,-1,0])"}) {
    const auto read = leap::parse_text(frame_text(1, R"({"id":1,"palmPosition":[1,2,3],)" + std::string(text) + "}"));
    ASSERT_TRUE(read) << text;
    ASSERT_EQ(std::get<leap::Frame>(*read).hands.size(), 1u) << text;
    EXPECT_FALSE(std::get<leap::Frame>(*read).hands[0].attitude) << text;
  }
}

TEST(LeapText, IsRefusedWhenItIsNoFrame) {
  for (const char* text : {"", "{", "[]", "NaN", R"({"timestamp":-5})", R"({"timestamp":1e30})", R"({"timestamp":"x"})",
                           R"({"timestamp":1,"hands":[{"palmPosition":[NaN,1,2]}]})", R"({"version":"six"})"})
    EXPECT_FALSE(leap::parse_text(text)) << text;
  EXPECT_FALSE(leap::parse_text(std::string(leap::kMostTextBytes + 1, ' ')));
  std::string many = hand_text(0, "1");
  for (int i = 1; i < 17; ++i) many += "," + hand_text(i, "1");
  EXPECT_FALSE(leap::parse_text(frame_text(1, many)));
}

leap::Hand hand(std::int64_t id, double x, double speed = 0.0) {
  return {.id = id, .palm = {{x, 0.2, 0}}, .velocity = {{speed, 0, 0}}};
}

TEST(FollowedHand, KeepsItsHandBesideAnotherOne) {
  FollowedHand followed;
  EXPECT_EQ(followed.choose(0.00, std::array{hand(1, 0.0), hand(2, 0.1)})->id, 1);
  EXPECT_EQ(followed.choose(0.01, std::array{hand(2, 0.1), hand(1, 0.0)})->id, 1) << "order says nothing";
}

TEST(FollowedHand, ANewIdAtTheSamePlaceIsTheSameHand) {
  FollowedHand followed;
  (void)followed.choose(0.00, std::array{hand(1, 0.0, 1.0)});
  EXPECT_FALSE(followed.choose(0.01, {}));
  const auto found = followed.choose(0.05, std::array{hand(7, 0.05, 1.0)});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, 7);
}

TEST(FollowedHand, AnotherHandIsFollowedOnlyAfterAWhile) {
  FollowedHand followed;
  (void)followed.choose(0.0, std::array{hand(1, 0.0)});
  EXPECT_FALSE(followed.choose(0.1, std::array{hand(2, 0.2)}));
  EXPECT_FALSE(followed.choose(0.3, std::array{hand(2, 0.2)}));
  EXPECT_TRUE(followed.choose(0.31, std::array{hand(2, 0.2)}));
}

TEST(FollowedHand, SwappedIdsDoNotMakeTheHandJump) {
  FollowedHand followed;
  (void)followed.choose(0.00, std::array{hand(1, 0.0), hand(2, 0.2)});
  const auto seen = followed.choose(0.01, std::array{hand(2, 0.001), hand(1, 0.2)});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->palm.m.x(), 0.001, 1e-12);
}

TEST(FollowedHand, StartsAnewWhenTheServicesClockDoes) {
  FollowedHand followed;
  (void)followed.choose(5000.0, std::array{hand(40, 0.0)});
  EXPECT_TRUE(followed.choose(0.01, std::array{hand(1, 0.3)}));
}

TEST(ClockEnvelope, TakesTheDelayOfTheFastestDeliveryAndForgetsAJump) {
  ClockEnvelope clock;
  for (int i = 0; i < 1000; ++i) {
    const auto theirs = 10ms * i;
    const auto delay = i % 7 == 0 ? 1ms : 15ms;
    const auto at = clock.map(theirs, theirs + 100s + delay);
    EXPECT_LE(at, theirs + 100s + delay);
    if (i > 0) {
      EXPECT_NEAR(std::chrono::duration<double>(at - theirs).count(), 100.001, 0.0001);
    }
  }
  EXPECT_EQ(clock.map(5ms, 200s), 200s) << "a service that was started anew begins anew";
}

class LeapTrackerTest : public testing::Test {
 protected:
  static std::unique_ptr<FakeService> make_service(const char* hello = kHello, std::uint16_t port = 0) {
    return std::make_unique<FakeService>(
        hello, [](const std::string&) { return std::nullopt; }, port);
  }
  static LeapTracker make_tracker(std::uint16_t port) {
    Transform<HapticBase, HandTracker> haptic_from_tracker;
    haptic_from_tracker.iso.linear() = Vector3d(1, -1, -1).asDiagonal();
    return LeapTracker({"127.0.0.1", port, "/v6.json"}, haptic_from_tracker, [](const std::string&) {});
  }
  std::optional<ports::HandSample> next(LeapTracker& tracker) {
    std::optional<ports::HandSample> sample;
    (void)soon([&] { return (sample = tracker.sample(session_now(), {})).has_value(); });
    return sample;
  }
  static SessionTime session_now() {
    return SessionTime{std::chrono::steady_clock::now().time_since_epoch() - 1000s};  // another session
  }
};

TEST_F(LeapTrackerTest, GivesEachHandOnceInHAtTheTrackersTime) {
  const auto service = make_service();
  LeapTracker tracker = make_tracker(service->port());
  ASSERT_TRUE(tracker.start(5s));
  EXPECT_FALSE(tracker.sample(session_now(), {}));
  const SessionTime before = session_now();
  service->say(frame_text(1'000'000, hand_text(12, "70")));
  const auto sample = next(tracker);
  ASSERT_TRUE(sample);
  EXPECT_LT((sample->hand.m - Vector3d(0.070, -0.185083, -0.0122664)).norm(), 1e-12);
  ASSERT_TRUE(sample->attitude);
  EXPECT_LT((*sample->attitude * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-12) << "the fingers, in H";
  EXPECT_GE(sample->at, before - 1ms);
  EXPECT_LE(sample->at, session_now());
  EXPECT_FALSE(tracker.sample(session_now(), {})) << "given once";
  EXPECT_TRUE(soon([&] { return !service->heard().empty(); }));
  EXPECT_EQ(service->heard().front(), R"({"background":true})");
}

TEST_F(LeapTrackerTest, SpacesABurstAsTheServiceSawItNotAsItCame) {
  const auto service = make_service();
  LeapTracker tracker = make_tracker(service->port());
  ASSERT_TRUE(tracker.start(5s));
  service->say(frame_text(1'000'000, hand_text(12, "70")));
  const auto first = next(tracker);
  ASSERT_TRUE(first);
  std::this_thread::sleep_for(100ms);  // the connection is blocked
  service->say(frame_text(1'010'000, hand_text(12, "71")));
  const auto late = next(tracker);
  ASSERT_TRUE(late);
  EXPECT_NEAR(to_seconds(late->at - first->at), 0.010, 0.002);
}

TEST_F(LeapTrackerTest, SurvivesNaNWrongLocaleDropAndRestart) {
  auto service = make_service();
  const std::uint16_t port = service->port();
  LeapTracker tracker = make_tracker(port);
  ASSERT_TRUE(tracker.start(5s));
  service->say(frame_text(1'000'000, hand_text(12, "NaN")));
  service->say(frame_text(1'010'000, hand_text(12, "70,5")));
  service->say("{");
  EXPECT_TRUE(soon([&] { return tracker.refused() == 3; })) << tracker.refused();
  EXPECT_FALSE(tracker.sample(session_now(), {}));
  service->say(frame_text(1'020'000, hand_text(12, "70")));
  EXPECT_TRUE(next(tracker));
  service->drop();
  EXPECT_TRUE(soon([&] { return service->clients() == 2; }));
  service->say(frame_text(1'500'000, hand_text(12, "72")));
  EXPECT_TRUE(next(tracker));
  service.reset();
  service = make_service(kHello, port);
  EXPECT_TRUE(soon([&] { return service->clients() == 1; }));
  service->say(frame_text(5, hand_text(1, "72")));
  EXPECT_TRUE(next(tracker)) << "its clock began anew";
}

TEST_F(LeapTrackerTest, SaysWhatIsMissing) {
  std::uint16_t nobody = 0;
  nobody = make_service()->port();
  LeapTracker alone = make_tracker(nobody);
  const Result<void> refused = alone.start(300ms);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("/v6.json"), std::string::npos);
  EXPECT_NE(refused.error().fix.find("--tracker simulated"), std::string::npos);

  const auto old = make_service(R"({"serviceVersion":"1.0","version":1})");
  LeapTracker with_old = make_tracker(old->port());
  const Result<void> version = with_old.start(300ms);
  ASSERT_FALSE(version);
  EXPECT_NE(version.error().what.find("version 1 of the Leap protocol, not version 6"), std::string::npos)
      << version.error().what;
}

}  // namespace
}  // namespace telepalp::tracking
