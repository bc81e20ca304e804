// How often a receiver requests a key frame, and how often the encoder makes one.

#include <gtest/gtest.h>

#include "proto/wire/key_frame_request.h"

namespace telepalp::wire {
namespace {

TEST(KeyFrameRequest, IsSentAtOnceAndAgainOnlyWhileDecodingFails) {
  KeyFrameRequest request;
  const SessionTime start = session_time(1'000'000'000);
  EXPECT_TRUE(request.failed(start));
  EXPECT_FALSE(request.failed(start + std::chrono::milliseconds(33)));
  EXPECT_FALSE(request.failed(start + std::chrono::milliseconds(299)));
  EXPECT_TRUE(request.failed(start + std::chrono::milliseconds(300)));
  request.succeeded();
  EXPECT_TRUE(request.failed(start + std::chrono::milliseconds(333)));
}

TEST(KeyFrameRequest, IsSentAlthoughTheClockGoesBack) {
  KeyFrameRequest request;
  EXPECT_TRUE(request.failed(session_time(5'000'000'000)));
  EXPECT_TRUE(request.failed(session_time(1'000'000'000)));
}

TEST(KeyFramePacing, RequestsAtEveryFrameMakeOneKeyFrameInFour) {
  KeyFramePacing pacing;
  std::string made;
  for (int i = 0; i < 13; ++i) {
    pacing.requested = true;
    const bool is_key = i == 0 || key_frame_is_due(pacing);
    made += is_key ? 'K' : '.';
    pacing = after_encoding(pacing, is_key);
  }
  EXPECT_EQ(made, "K...K...K...K");
}

TEST(KeyFramePacing, ARequestStaysUntilAnyKeyFrameIsEncoded) {
  KeyFramePacing pacing = after_encoding({}, true);
  pacing.requested = true;
  pacing = after_encoding(pacing, false);
  EXPECT_TRUE(pacing.requested);
  pacing = after_encoding(pacing, true);
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(key_frame_is_due(pacing));
    pacing = after_encoding(pacing, false);
  }
}

}  // namespace
}  // namespace telepalp::wire
