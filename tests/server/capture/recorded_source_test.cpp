#include "server/capture/pacing/recorded_source.h"

#include <gtest/gtest.h>

namespace telepalp::capture {
namespace {

using namespace std::chrono_literals;

struct Watched {
  int decoded = 0;
  int skipped = 0;
};

/// `count` frames, 1.9 s apart. Those of `damaged` cannot be decoded.
class WatchedFrames final : public RecordedFrames {
 public:
  WatchedFrames(Watched& watched, int count, int damaged = -1) : watched_(watched), count_(count), damaged_(damaged) {}

  std::optional<SessionTime> peek() override {
    return next_ < count_ ? std::optional(SessionTime{1900ms * next_}) : std::nullopt;
  }
  std::optional<RgbdFrame> take() override {
    ++watched_.decoded;
    return next_++ == damaged_ ? std::nullopt : std::optional(RgbdFrame{});
  }
  void skip() override {
    ++watched_.skipped;
    ++next_;
  }
  void rewind() override { next_ = 0; }
  std::string complaint() const override { return {}; }

 private:
  Watched& watched_;
  int count_;
  int damaged_;
  int next_ = 0;
};

std::unique_ptr<CaptureSource> source_of(Watched& watched, int count, const SourceOptions& options, int damaged = -1) {
  return play_recorded(std::make_unique<WatchedFrames>(watched, count, damaged), "test", options);
}

TEST(RecordedSource, DecodesAFrameBeforeItsTimeComes) {
  Watched watched;
  const auto source = source_of(watched, 3, {.clock = wire::SessionClock::anchored_to_wall_clock(), .loop = false});
  ASSERT_TRUE(source->next(5s));
  EXPECT_EQ(watched.decoded, 1);
  EXPECT_FALSE(source->next(0ms)) << "its time is in 1.9 s";
  EXPECT_EQ(watched.decoded, 2);
  EXPECT_FALSE(source->next(0ms));
  EXPECT_EQ(watched.decoded, 2) << "once";
}

TEST(RecordedSource, StampsAFrameWithItsTimeAndNotWithThatOfDecoding) {
  Watched watched;
  const auto source = source_of(watched, 2, {.clock = wire::SessionClock::anchored_to_wall_clock(), .loop = false});
  const auto first = source->next(5s);
  const auto second = source->next(5s);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(second->captured - first->captured, 1900ms);
}

TEST(RecordedSource, PassesOverADamagedFrameAndEndsOnce) {
  Watched watched;
  const auto source = source_of(watched, 3, {.loop = false, .paced = false}, 1);
  EXPECT_TRUE(source->next(0ms));
  EXPECT_TRUE(source->next(0ms));
  EXPECT_FALSE(source->next(0ms));
  EXPECT_EQ(watched.decoded, 3);
  EXPECT_EQ(source->state(), CaptureState::Ended);
}

TEST(RecordedSource, ARecordingWithoutAReadableFrameEndsInsteadOfRepeating) {
  Watched watched;
  const auto source = source_of(watched, 1, {.loop = true, .paced = false}, 0);
  EXPECT_FALSE(source->next(0ms));
  EXPECT_EQ(source->state(), CaptureState::Ended);
}

TEST(RecordedSource, RepeatsItselfWithRisingNumbersAndTimes) {
  Watched watched;
  const auto source = source_of(watched, 2, {.loop = true, .paced = false});
  std::optional<RgbdFrame> last = source->next(0ms);
  for (int i = 1; i < 7; ++i) {
    const auto frame = source->next(0ms);
    ASSERT_TRUE(frame && last);
    EXPECT_EQ(frame->sequence, last->sequence + 1);
    EXPECT_GT(frame->captured, last->captured);
    last = frame;
  }
}

}  // namespace
}  // namespace telepalp::capture
