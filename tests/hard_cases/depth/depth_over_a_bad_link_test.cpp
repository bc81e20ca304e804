// Predicted depth frames through the real encoder, hub and decoder, over a bad link.

#include <gtest/gtest.h>

#include <functional>

#include "codec/depth_stream.h"
#include "proto/wire/key_frame_request.h"
#include "server/hub/hub.h"
#include "tests/codec/depth_frames.h"

namespace telepalp {
namespace {

constexpr int kFrames = 240;  // eight seconds
constexpr Nanoseconds kPeriod{33'333'333};

DepthImage frame(int number) { return codec::kinect_like(64, 48, static_cast<unsigned>(number), number / 8); }

SessionTime time_of(int number) { return session_time(1'000'000'000) + number * kPeriod; }

int number_of(const wire::Message& message) { return static_cast<int>((message.published - time_of(0)) / kPeriod); }

/// A subscriber that takes frames from the hub at some times, loses some of them, and requests a key frame when it
/// cannot decode.
struct Watcher {
  std::function<bool(int)> takes;  ///< true: it takes the waiting messages at the time of that frame
  std::function<bool(int)> loses;  ///< true: that frame is lost after the hub
  hub::SubscriberId id = 0;
  codec::DepthDecoder decoder{};
  wire::KeyFrameRequest request{};
  int shown = 0;
  int unreadable = 0;
  int longest_gap = 0;  ///< longest gap between two decoded frames, in frames
  int last_shown = -1;
};

struct Site {
  hub::Hub hub;
  codec::DepthEncoder encoder;
  wire::KeyFramePacing pacing;
  int keys = 0;

  explicit Site(codec::DepthMode mode) : encoder({.mode = mode, .key_every = 12}) {
    hub.on_key_frame_request([this](std::string_view) { pacing.requested = true; });
  }

  void capture(int number) {
    if (wire::key_frame_is_due(pacing)) encoder.request_key_frame();
    codec::EncodedDepth coded = encoder.encode(frame(number));
    const bool is_key = coded.key_frame;
    pacing = wire::after_encoding(pacing, is_key);
    keys += is_key ? 1 : 0;
    hub.publish(
        {wire::kCameraDepth, time_of(number), std::make_shared<const std::string>(std::move(coded.bytes)), 0, is_key});
  }

  void join(Watcher& watcher) {
    watcher.id = hub.join("watcher", "", [] {});
    hub.subscribe(watcher.id, {"/camera/depth"});
  }

  void serve(Watcher& watcher, int now, const std::vector<DepthImage>& truth) {
    if (watcher.id == 0 || !watcher.takes(now)) return;
    while (const auto message = hub.next(watcher.id)) {
      const int number = number_of(*message);
      if (watcher.loses(number)) continue;
      const Result<DepthImage> depth = watcher.decoder.decode(codec::bytes_of(*message->payload));
      if (!depth) {
        ++watcher.unreadable;
        if (watcher.request.failed(time_of(now))) hub.request_key_frame(watcher.id, message->topic, message->published);
        continue;
      }
      watcher.request.succeeded();
      ++watcher.shown;
      watcher.longest_gap = std::max(watcher.longest_gap, number - watcher.last_shown);
      watcher.last_shown = number;
      ASSERT_EQ(depth->samples, truth[static_cast<std::size_t>(number)].samples) << number;
    }
  }
};

struct BadLink {
  std::string name;
  int joins_at;
  std::function<bool(int)> takes;
  std::function<bool(int)> loses;
  int least_shown;
  int longest_gap;
  int most_unreadable;
  friend std::ostream& operator<<(std::ostream& out, const BadLink& link) { return out << link.name; }
};

bool always(int) { return true; }
bool never(int) { return false; }

std::vector<BadLink> bad_links() {
  return {
      {"nothing is wrong", 0, always, never, kFrames, 1, 0},
      {"joins mid-group", 17, always, never, kFrames - 17 - 4, 22, 0},
      {"a key frame is lost", 0, always, [](int i) { return i == 24; }, kFrames - 6, 6, 2},
      {"every key frame of the schedule is lost", 0, always, [](int i) { return i > 0 && i % 12 == 0; }, kFrames - 50,
       6, 25},
      {"one dependent frame is lost", 0, always, [](int i) { return i == 30; }, kFrames - 6, 6, 2},
      {"every second frame is lost", 0, always, [](int i) { return i % 2 == 1; }, kFrames / 4 - 5, 5, kFrames / 4 + 5},
      {"a burst of ten is lost", 0, always, [](int i) { return i >= 50 && i < 60; }, kFrames - 12, 12, 2},
      {"takes at every second frame only", 0, [](int i) { return i % 2 == 1; }, never, kFrames, 1, 0},
      {"takes at every third frame only", 0, [](int i) { return i % 3 == 2; }, never, 2 * kFrames / 3 - 10, 4, 0},
      {"is stuck for a second", 0, [](int i) { return i < 60 || i >= 90; }, never, kFrames - 35, 31, 0},
  };
}

class DepthOverABadLink : public testing::TestWithParam<BadLink> {};

TEST_P(DepthOverABadLink, IsRightOrAbsentAndComesBackByItselfWhileOthersSeeEveryFrame) {
  const BadLink& link = GetParam();
  Site site(codec::DepthMode::Temporal);
  std::vector<DepthImage> truth;
  Watcher bad{.takes = link.takes, .loses = link.loses};
  Watcher good{.takes = always, .loses = never};
  site.join(good);
  for (int i = 0; i < kFrames; ++i) {
    if (i == link.joins_at) site.join(bad);
    truth.push_back(frame(i));
    site.capture(i);
    site.serve(good, i, truth);
    site.serve(bad, i, truth);
  }
  EXPECT_GE(bad.shown, link.least_shown);
  EXPECT_LE(bad.longest_gap, link.longest_gap);
  EXPECT_LE(bad.unreadable, link.most_unreadable);
  EXPECT_EQ(good.shown, kFrames);
  EXPECT_EQ(good.unreadable, 0);
  EXPECT_LE(site.keys, kFrames / wire::kMinKeyFrameDistance) << "nobody can make every frame a key frame";
}

INSTANTIATE_TEST_SUITE_P(All, DepthOverABadLink, testing::ValuesIn(bad_links()),
                         [](const testing::TestParamInfo<BadLink>& tested) {
                           std::string name = tested.param.name;
                           for (char& letter : name)
                             if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
                           return name;
                         });

TEST(DepthOverABadLink, TwoWhoJoinMidGroupSeeFromOneKeyFrameThatIsMadeForBoth) {
  Site site(codec::DepthMode::Temporal);
  std::vector<DepthImage> truth;
  Watcher first{.takes = always, .loses = never};
  Watcher second{.takes = always, .loses = never};
  for (int i = 0; i < 12; ++i) {
    if (i == 2) site.join(first);
    if (i == 3) site.join(second);
    truth.push_back(frame(i));
    site.capture(i);
    site.serve(first, i, truth);
    site.serve(second, i, truth);
  }
  EXPECT_EQ(site.keys, 2) << "the first frame, and one for those who joined";
  EXPECT_EQ(first.shown, 8);
  EXPECT_EQ(second.shown, 8);
  EXPECT_EQ(first.unreadable + second.unreadable, 0);
}

}  // namespace
}  // namespace telepalp
