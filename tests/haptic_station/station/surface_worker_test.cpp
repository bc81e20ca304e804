#include "haptic_station/station/threads/surface_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

constexpr int kWidth = 160;
constexpr int kHeight = 120;
const Intrinsics kCamera{.width = kWidth, .height = kHeight, .fx = 130, .fy = 130, .cx = 79.5, .cy = 59.5};

/// A flat patient that moves one millimetre towards the camera with each frame.
DepthImage plane(int number) {
  return {.width = kWidth,
          .height = kHeight,
          .unit_m = 0.001,
          .samples = std::vector<std::uint16_t>(kWidth * kHeight, static_cast<std::uint16_t>(900 - number))};
}

wire::Message message_of(int number, codec::EncodedDepth encoded) {
  msg::DepthImage image;
  const SessionTime captured = session_time(1'000'000'000) + number * 33ms;
  image.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(captured)));
  image.set_sequence(static_cast<std::uint64_t>(number));
  image.set_width(kWidth);
  image.set_height(kHeight);
  image.set_unit_m(0.001);
  image.set_data(std::move(encoded.bytes));
  return wire::make_message(wire::kCameraDepth, captured, image, encoded.key_frame);
}

/// A worker with the list of its answers, for which a test can wait.
class Bench {
 public:
  /// `held`: the worker waits at its first frame until go_on() is called.
  explicit Bench(bool held = false) {
    if (!held) go_on();
  }
  void go_on() { may_go_on_.set_value(); }
  void offer(const wire::Message& message) {
    worker_.offer({.depth = message, .camera = kCamera, .received = message.published});
  }
  /// Waits until `count` frames have led to a report or an error.
  bool answered(std::size_t count) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 10s, [&] { return reports_.size() + errors_.size() >= count; });
  }
  bool asked(std::size_t count) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 10s, [&] { return wanted_.size() >= count; });
  }
  std::vector<msg::SurfaceReport> reports() {
    const std::scoped_lock lock(mutex_);
    return reports_;
  }
  std::vector<Error> errors() {
    const std::scoped_lock lock(mutex_);
    return errors_;
  }
  std::vector<SessionTime> wanted() {
    const std::scoped_lock lock(mutex_);
    return wanted_;
  }
  std::atomic<std::int64_t> now_ns{2'000'000'000};  // the session clock
  LatestValue<loop::TouchableSurface> surfaces;
  LatestValue<Point<HapticBase>> device;

 private:
  template <class Value>
  void keep(std::vector<Value>& list, const Value& value) {
    {
      const std::scoped_lock lock(mutex_);
      list.push_back(value);
    }
    changed_.notify_all();
  }

  std::promise<void> may_go_on_;
  std::shared_future<void> goes_on_ = may_go_on_.get_future().share();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<msg::SurfaceReport> reports_;
  std::vector<Error> errors_;
  std::vector<SessionTime> wanted_;
  SurfaceWorker worker_{
      *surface::surface_settings("fast"),
      [this](const DepthImage&, const Intrinsics&) {
        goes_on_.wait();
        return Transform<HapticBase, DepthCamera>{};
      },
      {.now = [this] { return session_time(now_ns); },
       .on_report = [this](const msg::SurfaceReport& report) { keep(reports_, report); },
       .on_bad_frame = [this](const Error& error) { keep(errors_, error); },
       .request_key_frame = [this](const wire::Message& message) { keep(wanted_, message.published); }},
      surfaces,
      device,
      effects::EffectBank()};
};

std::vector<wire::Message> stream_of(codec::DepthMode mode, int frames, int key_every) {
  codec::DepthEncoder encoder({.mode = mode, .key_every = key_every});
  std::vector<wire::Message> messages;
  for (int i = 0; i < frames; ++i) messages.push_back(message_of(i, encoder.encode(plane(i))));
  return messages;
}

TEST(SurfaceWorker, EveryFrameOfATemporalStreamBecomesASurfaceThatNamesItsMode) {
  Bench bench;
  const auto stream = stream_of(codec::DepthMode::Temporal, 6, 12);
  for (std::size_t i = 0; i < stream.size(); ++i) {
    bench.offer(stream[i]);
    ASSERT_TRUE(bench.answered(i + 1));
  }
  ASSERT_EQ(bench.reports().size(), stream.size());
  EXPECT_EQ(bench.reports().back().depth_mode(), "temporal");
  EXPECT_TRUE(bench.wanted().empty());
}

TEST(SurfaceWorker, FramesThatPileUpAreDecodedIfANewerOneNeedsThem) {
  Bench bench;
  const auto stream = stream_of(codec::DepthMode::Temporal, 10, 1000);
  for (const wire::Message& message : stream) bench.offer(message);
  ASSERT_TRUE(bench.answered(1));
  for (int tries = 0; tries < 1000 && bench.reports().back().sequence() != 9; ++tries) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(bench.reports().back().sequence(), 9u);
  EXPECT_TRUE(bench.errors().empty());
}

TEST(SurfaceWorker, NoFrameIsLostToTheDecoderWhileTheWorkerIsBusyForSeconds) {
  Bench bench(true);
  const auto stream = stream_of(codec::DepthMode::Temporal, 101, 1000);
  for (std::size_t i = 0; i < 100; ++i) bench.offer(stream[i]);
  bench.go_on();
  const auto waits_for = [&](std::uint64_t number) {
    for (int tries = 0; tries < 10'000; ++tries, std::this_thread::sleep_for(1ms))
      if (const auto reports = bench.reports(); !reports.empty() && reports.back().sequence() == number) return true;
    return false;
  };
  EXPECT_TRUE(waits_for(99)) << "the newest of the waiting frames becomes the surface";
  bench.offer(stream[100]);
  EXPECT_TRUE(waits_for(100)) << "and can be the reference of the next one";
  EXPECT_TRUE(bench.errors().empty());
  EXPECT_TRUE(bench.wanted().empty());
}

TEST(SurfaceWorker, AMissingReferenceKeepsTheLastSurfaceAndAsksOnceForAKeyFrame) {
  Bench bench;
  const auto stream = stream_of(codec::DepthMode::Temporal, 9, 8);
  bench.offer(stream[0]);
  ASSERT_TRUE(bench.answered(1));
  ASSERT_TRUE(bench.surfaces.take());
  bench.offer(stream[2]);  // the one before it was lost
  ASSERT_TRUE(bench.asked(1));
  for (int i = 3; i < 8; ++i) bench.offer(stream[static_cast<std::size_t>(i)]);
  EXPECT_FALSE(bench.surfaces.take()) << "no surface was made of what could not be read";
  bench.offer(stream[8]);
  ASSERT_TRUE(bench.answered(3));
  EXPECT_EQ(bench.reports().back().sequence(), 8u);
  EXPECT_EQ(bench.errors().size(), 1u);
  ASSERT_EQ(bench.wanted().size(), 1u);
  EXPECT_EQ(bench.wanted().front(), stream[2].published);
}

wire::Message captured_at(SessionTime captured, wire::Message message) {
  msg::DepthImage image;
  EXPECT_TRUE(image.ParseFromString(*message.payload));
  image.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(captured)));
  return wire::make_message(wire::kCameraDepth, captured, image, message.key_frame);
}

TEST(SurfaceWorker, AfterTheSessionClockStepsBackImagesBecomeSurfacesAgain) {
  Bench bench;
  const auto stream = stream_of(codec::DepthMode::Intra, 4, 1);
  const SessionTime later = session_time(bench.now_ns) + 2h;
  bench.now_ns = to_nanoseconds(later);
  bench.offer(captured_at(later - 10ms, stream[0]));
  ASSERT_TRUE(bench.answered(1));
  const SessionTime back = later - 2h;
  bench.offer(captured_at(back - 40ms, stream[1]));
  ASSERT_TRUE(bench.answered(2));
  ASSERT_EQ(bench.errors().size(), 1U) << "the clock has not stepped yet: the image counts as overtaken";
  bench.now_ns = to_nanoseconds(back);
  bench.offer(captured_at(back - 10ms, stream[2]));
  ASSERT_TRUE(bench.answered(3));
  bench.offer(captured_at(later + 10ms, stream[0]));  // was on its way when the clock stepped
  ASSERT_TRUE(bench.answered(4));
  bench.offer(captured_at(back + 20ms, stream[3]));
  ASSERT_TRUE(bench.answered(5));
  EXPECT_EQ(bench.errors().size(), 1U);
  ASSERT_EQ(bench.reports().size(), 4U);
  EXPECT_EQ(bench.reports().back().sequence(), 3U);
}

TEST(SurfaceWorker, AnImageThatWasOvertakenIsDroppedWhileTheClockRunsOn) {
  Bench bench;
  const auto stream = stream_of(codec::DepthMode::Intra, 3, 1);
  const SessionTime now = session_time(bench.now_ns);
  bench.offer(captured_at(now + 900ms, stream[1]));  // within the error of a poor clock
  ASSERT_TRUE(bench.answered(1));
  bench.offer(captured_at(now + 870ms, stream[0]));
  ASSERT_TRUE(bench.answered(2));
  EXPECT_EQ(bench.reports().size(), 1U);
  EXPECT_EQ(bench.errors().size(), 1U);
}

TEST(SurfaceWorker, ReportsThatDepthIsBoundedWithItsBound) {
  Bench bench;
  wire::Message message = stream_of(codec::DepthMode::Bounded, 1, 12).front();
  msg::DepthImage image;
  ASSERT_TRUE(image.ParseFromString(*message.payload));
  image.mutable_bound()->set_least_m(0.002);
  image.mutable_bound()->set_per_m(0.004);
  bench.offer(wire::make_message(wire::kCameraDepth, message.published, image, message.key_frame));
  ASSERT_TRUE(bench.answered(1));
  ASSERT_EQ(bench.reports().size(), 1u);
  EXPECT_EQ(bench.reports().front().depth_mode(), "bounded");
  EXPECT_EQ(bench.reports().front().depth_bound().least_m(), 0.002);
  EXPECT_EQ(bench.reports().front().depth_bound().per_m(), 0.004);
}

}  // namespace
}  // namespace telepalp::station
