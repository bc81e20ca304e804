// The stages of the station's core in virtual time: slow ones, hanging ones, and a scene that is read again.

#include <gtest/gtest.h>

#include "haptic_station/core/collision_stage.h"
#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/loop/tick.h"
#include "tests/haptic_station/core/stream.h"

namespace telepalp::core {
namespace {

using namespace std::chrono_literals;

void offer(SurfaceStage& stage, const ArrivedDepth& message) {
  if (stage.admit(message.depth.payload->size())) stage.arrived(message);
}

/// Runs a stage over a stream in virtual time. Returns the numbers of the images that became surfaces.
std::vector<std::uint64_t> images_built(const std::vector<ArrivedDepth>& stream, Nanoseconds cost, Nanoseconds length) {
  SurfaceStage stage = fast_stage();
  VirtualDriver<SurfaceStage> driver;
  std::vector<std::uint64_t> built;
  std::size_t next = 0;
  for (SessionTime now = kFirstImage; now < kFirstImage + length; now += loop::kTickPeriod) {
    for (; next < stream.size() && stream[next].received <= now; ++next) offer(stage, stream[next]);
    if (const auto result = driver.finished(now); result && result->surface) built.push_back(result->report.sequence());
    driver.begin(
        now, stage, [&](StageStep) { return cost; }, std::nullopt);
  }
  return built;
}

TEST(SurfaceStage, TheSameJobsAndTimesGiveTheSameSurfaces) {
  const auto stream = stream_of(codec::DepthMode::Temporal, 12, 12);
  SurfaceStage one = fast_stage();
  SurfaceStage other = fast_stage();
  for (const ArrivedDepth& message : stream) {
    for (SurfaceStage* stage : {&one, &other}) offer(*stage, message);
    const auto first = run_at_once(one, message.received, std::nullopt);
    const auto second = run_at_once(other, message.received, std::nullopt);
    ASSERT_TRUE(first->surface && second->surface);
    EXPECT_EQ(first->report.SerializeAsString(), second->report.SerializeAsString());
    const Eigen::Vector3d at(0.01, 0.02, 0.88);
    EXPECT_EQ(first->surface->snapshot->evaluate(at, {0.0, 0.0, -1.0}, {}).f_m,
              second->surface->snapshot->evaluate(at, {0.0, 0.0, -1.0}, {}).f_m);
  }
}

TEST(SurfaceStage, AStageSlowerThanTheImagesBuildsTheNewestOfThem) {
  const auto stream = stream_of(codec::DepthMode::Intra, 60, 1);
  const std::vector<std::uint64_t> built = images_built(stream, 80ms, 2s);
  ASSERT_GT(built.size(), 20U);
  for (std::size_t i = 2; i < built.size(); ++i) {
    EXPECT_GE(built[i] - built[i - 1], 2U) << "80 ms are 2.4 images";
    EXPECT_LE(built[i] - built[i - 1], 3U) << "no image waits for the ones before it";
  }
}

TEST(SurfaceStage, AStageThatIsTooSlowChoosesACheaperSettingInVirtualTimeToo) {
  SurfaceStage stage = fast_stage();
  std::string setting;
  for (const ArrivedDepth& message : stream_of(codec::DepthMode::Intra, 30, 1)) {
    offer(stage, message);
    const auto job = stage.take(message.received, std::nullopt);
    const auto slow = [&](StageStep step) { return message.received + (step == StageStep::Done ? 25ms : 0ms); };
    setting = stage.run(*job, slow).report.setting();
  }
  EXPECT_EQ(setting, "fast, nodes every 4 px");
}

TEST(SurfaceStage, ARunThatNeverEndsLetsABoundedNumberOfImagesWait) {
  const auto stream = stream_of(codec::DepthMode::Temporal, 420, 1000);
  SurfaceStage stage = fast_stage();
  VirtualDriver<SurfaceStage> driver;
  SessionTime now = kFirstImage;
  for (const ArrivedDepth& message : stream) {
    now = message.received;
    offer(stage, message);
    EXPECT_FALSE(driver.finished(now));
    driver.begin(
        now, stage, [](StageStep) { return kNever; }, std::nullopt);
  }
  EXPECT_EQ(stage.dropped(), stream.size() - 1) << "the run has its surface, but cannot hand it over";
  driver.drop();
  const auto next = run_at_once(stage, now, std::nullopt);
  EXPECT_EQ(next->report.sequence(), 300U) << "one image in work, and 300 wait; the later ones were refused";
  offer(stage, stream_of(codec::DepthMode::Temporal, 421, 1000).back());
  const auto after = run_at_once(stage, now, std::nullopt);
  EXPECT_FALSE(after->surface);
  EXPECT_TRUE(after->unreadable) << "its reference was refused, so a key frame is requested";
}

TEST(SurfaceStage, AResultThatEndsAfterTheSceneWasReadAgainIsNotHandedOver) {
  const auto stream = stream_of(codec::DepthMode::Intra, 2, 1);
  SurfaceStage before = fast_stage();
  VirtualDriver<SurfaceStage> driver;
  const auto cost = [](StageStep) { return Nanoseconds{8ms}; };
  offer(before, stream[0]);
  driver.begin(stream[0].received, before, cost, std::nullopt);
  SurfaceStage after = fast_stage();  // of the scene that was read again
  driver.drop();
  EXPECT_TRUE(driver.is_idle());
  EXPECT_FALSE(driver.finished(stream[0].received + 8ms)) << "it belongs to the scene before";
  offer(after, stream[1]);
  driver.begin(stream[1].received, after, cost, std::nullopt);
  const auto result = driver.finished(stream[1].received + 8ms);
  ASSERT_TRUE(result && result->surface);
  EXPECT_EQ(result->surface->number, 1U);
  EXPECT_EQ(result->report.sequence(), 1U);
}

loop::TouchableSurface level_surface() {
  SurfaceStage stage{*surface::surface_settings("paper-nanoflann"),
                     [](const DepthImage&, const Intrinsics&) { return Transform<HapticBase, DepthCamera>{}; },
                     {}};
  offer(stage, stream_of(codec::DepthMode::Intra, 1, 1).front());
  return *run_at_once(stage, kFirstImage + 20ms, std::nullopt)->surface;
}

/// Numbers of the planes that the collision detection hands over in a second.
std::size_t planes_in_a_second(Nanoseconds cost) {
  CollisionStage stage;
  VirtualDriver<CollisionStage> driver;
  std::optional<loop::TouchableSurface> newer = level_surface();
  std::size_t planes = 0;
  for (SessionTime now = kFirstImage; now < kFirstImage + 1s; now += loop::kTickPeriod) {
    if (const auto result = driver.finished(now); result && result->plane) planes = result->plane->number;
    if ((now - kFirstImage) % CollisionStage::kPeriod == 0ns)
      driver.begin(
          now, stage, [&](StageStep) { return cost; }, std::exchange(newer, std::nullopt),
          Point<HapticBase>{{0.0, 0.0, 0.895}});
  }
  return planes;
}

TEST(CollisionStage, HandsOverAPlaneInEachPeriod) { EXPECT_EQ(planes_in_a_second(1ms), 100U); }

TEST(CollisionStage, AStageSlowerThanItsPeriodLeavesPeriodsOutAndQueuesNone) {
  EXPECT_EQ(planes_in_a_second(25ms), 33U) << "each run of 25 ms takes the place of three periods";
}

TEST(CollisionStage, ARunThatNeverEndsHandsOverNothing) { EXPECT_EQ(planes_in_a_second(kNever), 0U); }

}  // namespace
}  // namespace telepalp::core
