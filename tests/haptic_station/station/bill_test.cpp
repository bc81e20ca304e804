// The bill of a scene: the whole station, with and without each effect.

#include "haptic_station/station/bill/scene_bill.h"

#include <gtest/gtest.h>
#include <algorithm>

#include <array>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/station/bill/receiving.h"
#include "haptic_station/station/bill/thread_time.h"
#include "haptic_station/surface/build/mark_tracker.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "tests/support/no_heap_scope.h"
#include "where.h"

namespace telepalp::station {
namespace {

using Eigen::Vector3d;

std::filesystem::path scene_file(const std::string& name) {
  return TELEPALP_SOURCE_DIR "/haptic_station/scenes/" + name + ".scene.textproto";
}

scenes::Scene scene_named(const std::string& name) {
  Result<scenes::Scene> scene = scenes::read_scene(scene_file(name));
  EXPECT_TRUE(scene.ok()) << to_string(scene.error());
  return std::move(scene).value();
}

/// The scene without its effects, but for the first `kept` of them, and without probe.
scenes::Scene cut(const std::string& name, std::size_t kept) {
  scenes::Scene scene = scene_named(name);
  scene.probe.reset();
  scene.effects.resize(kept);
  return scene;
}

effects::EffectBank effects_of(const scenes::Scene& scene) { return core::bank_of(scene.effects); }

const SeenBody& body() {
  static const SeenBody kBody;
  return kBody;
}
const BodyStream& stream() {
  static const BodyStream kStream(body(), 5.0);
  return kStream;
}

std::map<std::string, Published> published_by(const scenes::Scene& scene) {
  BilledStation station(scene, {}, stream());
  StationCost cost;
  station.run(3.0, cost);
  return station.published();
}

TEST(SeenBody, TheTrueSkinIsWhereTheImagesShowIt) {
  for (const double time_s : {0.0, 2.1, 3.7}) {
    const DepthImage depth = body().depth_at(time_s);
    const Intrinsics& k = body().camera();
    double off_m = 0.0;
    int count = 0;
    for (int row = 60; row < 420; row += 3)
      for (int column = 250; column < 390; column += 3, ++count) {
        const double z = depth.at(column, row) * depth.unit_m;
        off_m += z - body().z_m((column - k.cx) / k.fx * z, (row - k.cy) / k.fy * z, time_s);
      }
    EXPECT_NEAR(off_m / count, 0.0, 1e-4) << time_s;
  }
  EXPECT_GT(body().risen_m(0.05, 2.1), 0.002) << "the body must move, or its motion is not tested";
}

TEST(SeenBody, ItsSurfaceIsADistance) {
  const TrueBody truth(body(), 2.1, BodyStream::kBegin);
  const Vector3d outside(0.10, 0.02, 0.80);
  const surface::FieldSample at = truth.evaluate(outside, Vector3d::Zero(), {});
  const surface::FieldSample foot = truth.evaluate(outside - at.f_m * at.normal, Vector3d::Zero(), {});
  EXPECT_GT(at.f_m, 0.005);
  EXPECT_LT(at.normal.z(), -0.5) << "outwards is towards the camera";
  EXPECT_NEAR(foot.f_m, 0.0, 0.05 * at.f_m);
}

TEST(Bill, StationsInVirtualTimeDoTheSameTwice) {
  const scenes::Scene scene = scene_named("palpation");
  auto once = published_by(scene);
  auto twice = published_by(scene);
  // The surface reports name the setting, and a processor that other programs keep busy makes a station choose a faster
  // one.
  for (auto* published : {&once, &twice}) published->at(std::string(wire::kStationSurface.name)).bytes = 0;
  EXPECT_EQ(once, twice);
}

TEST(Bill, AnEffectThatTheSceneDoesNotNamePublishesNothing) {
  const auto with = published_by(scene_named("ribs-ultrasound"));
  const auto without = published_by(cut("ribs-ultrasound", 1));
  const auto never = published_by(cut("skin_sliding", 1));
  ASSERT_TRUE(with.contains(std::string(wire::kStationUltrasound.name)));
  ASSERT_TRUE(with.contains(std::string(wire::kStationInside.name)));
  ASSERT_EQ(without.size(), never.size());
  for (const auto& [topic, messages] : never) EXPECT_TRUE(without.contains(topic)) << topic;
  EXPECT_FALSE(without.contains(std::string(wire::kStationUltrasound.name)));
  EXPECT_FALSE(without.contains(std::string(wire::kStationInside.name)));
  const std::string placements(wire::kStationCompensation.name);
  EXPECT_EQ(with.at(placements).messages, without.at(placements).messages);
  EXPECT_LT(without.at(placements).bytes, with.at(placements).bytes) << "an object's place is sent only if it is there";
}

/// Bytes and calls of the heap in which a builder makes the surfaces of the images from `first` on.
test::HeapUse heap_of(surface::SurfaceBuilder& builder, int first, int count) {
  (void)body();  // made before the counting begins
  const test::HeapUse before = test::heap_use();
  for (int i = first; i < first + count; ++i) {
    const double time_s = i / SeenBody::kFrames_per_s;
    const surface::Reach reach{{{0.0, 0.0, 0.8}}, surface::kReach_m};
    EXPECT_NE(builder.add(body().depth_at(time_s), body().camera(), BodyStream::kBegin + from_seconds(time_s), reach),
              nullptr);
  }
  return test::heap_use() - before;
}

TEST(Bill, AnObjectThatTheSceneDoesNotNameTakesNoMemory) {
  if (!test::NoHeapScope::works()) GTEST_SKIP() << "a sanitizer owns malloc";
  const Transform<DepthCamera, HapticBase> camera_from_haptic = scene_named("palpation").haptic_from_camera.inverse();
  surface::SurfaceBuilder never{surface::SurfaceSettings{}};
  surface::SurfaceBuilder without{surface::SurfaceSettings{}};
  surface::SurfaceBuilder with{surface::SurfaceSettings{}};
  without.watch(loop::mark_lines(effects_of(cut("palpation", 1)), camera_from_haptic));
  with.watch(loop::mark_lines(effects_of(scene_named("palpation")), camera_from_haptic));
  EXPECT_EQ(heap_of(without, 0, 20), heap_of(never, 0, 20));
  EXPECT_GT(heap_of(with, 0, 20).bytes, heap_of(never, 20, 20).bytes);
}

/// The least processor time [ns] of `work`, of 30 runs: other programs only make a run longer.
template <class Work>
double least_ns(const Work& work) {
  double least = 1e12;
  for (int i = 0; i < 30; ++i) {
    const std::int64_t before = thread_ns();
    work();
    least = std::min(least, static_cast<double>(thread_ns() - before));
  }
  return least;
}

/// The least processor time of a tick [ns] with each of the banks, their runs in turn: a slow moment meets all of them.
std::array<double, 3> ticks_ns(std::array<effects::EffectBank, 3> banks) {
  effects::EffectInput in;
  in.device = {{0.0, -0.035, 0.0}};
  in.contact = {.proxy = {}, .normal = {Vector3d::UnitY()}, .distance_m = -0.035, .in_body = true, .valid = true};
  for (effects::EffectBank& bank : banks) bank.begin(in);
  constexpr int kTicks = 2000;
  std::array<double, 3> least{1e12, 1e12, 1e12};
  for (int run = 0; run < 50; ++run)
    for (std::size_t i = 0; i < banks.size(); ++i) {
      const std::int64_t before = thread_ns();
      for (int tick = 0; tick < kTicks; ++tick) (void)banks[i].step(in, 0.0005, 10.0);
      least[i] = std::min(least[i], static_cast<double>(thread_ns() - before) / kTicks);
    }
  return least;
}

TEST(Bill, AnEffectThatTheSceneDoesNotNameTakesNoTimeInATick) {
  const auto [none, skin, both] = ticks_ns(
      {effects_of(cut("palpation", 0)), effects_of(cut("palpation", 1)), effects_of(scene_named("palpation"))});
  EXPECT_LT(none, 0.5 * skin);
  EXPECT_LT(skin, 0.5 * both) << "the skin alone, without the liver";
}

TEST(Bill, AnObjectThatTheSceneDoesNotNameTakesNoTimeAtTheSurface) {
  const surface::DepthField field = [] {
    surface::DepthField made;
    surface::to_depth_field(body().depth_at(0.5), made);
    return made;
  }();
  const Transform<DepthCamera, HapticBase> camera_from_haptic = scene_named("palpation").haptic_from_camera.inverse();
  const auto image_ns = [&](const effects::EffectBank& effects) {
    surface::MarkTracker marks;
    marks.watch(loop::mark_lines(effects, camera_from_haptic));
    for (int i = 0; i < 20; ++i) marks.add(field, field, body().camera(), 1.0 / SeenBody::kFrames_per_s);
    return least_ns([&] { marks.add(field, field, body().camera(), 1.0 / SeenBody::kFrames_per_s); });
  };
  const double with = image_ns(effects_of(scene_named("palpation")));
  EXPECT_GT(with, 50e3) << "an object costs the registration of its patch of skin";
  EXPECT_LT(image_ns(effects_of(cut("palpation", 1))), 0.02 * with);
}

TEST(Bill, HoldsWhatAnEffectCostsOutsideTheTick) {
  const scenes::Scene scene = scene_named("ribs-ultrasound");
  Result<SceneBill> bill = bill_of(scene, scene_file("ribs-ultrasound"), 3.0);
  const auto share = [&](std::size_t price, Part part) {
    return bill->prices[price].share[static_cast<std::size_t>(part)];
  };
  // A price is the difference of two runs, so other programs may change it; they seldom do twice.
  if (bill.ok() && bill->prices.size() == 5u && share(1, Part::Surface) < 0.5)
    bill = bill_of(scene, scene_file("ribs-ultrasound"), 3.0);
  ASSERT_TRUE(bill.ok()) << to_string(bill.error());
  ASSERT_EQ(bill->prices.size(), 5u);  // skin, ribs, liver, the probe, all of them
  EXPECT_GT(share(1, Part::Surface), 0.5) << "the marks of the ribs: tenths of a millisecond an image";
  EXPECT_GT(share(3, Part::Inside), 1.0) << "the probe's image";
  EXPECT_GT(bill->prices.back().total_share, 3.0 * share(1, Part::Loop)) << "the tick is the smaller part of the price";
  EXPECT_GT(bill->start_ms, 1.0) << "the surfaces of the layers";
}

/// A step that follows another at once finds its data in the caches and needs no waking; a station's steps do not.
TEST(Bill, IsThatOfAStationInRealTime) {
  const scenes::Scene scene = scene_named("skin");
  const Result<SceneBill> bill = bill_of(scene, scene_file("skin"), 2.0, Detail::Together);
  ASSERT_TRUE(bill.ok()) << to_string(bill.error());
  EXPECT_GT(bill->live.share(Part::Loop), 3.0 * bill->whole.share(Part::Loop)) << "the waking of the thread";
  EXPECT_EQ(bill->live.steps[static_cast<std::size_t>(Part::Surface)].total(),
            bill->whole.steps[static_cast<std::size_t>(Part::Surface)].total())
      << "both see the same images";
  EXPECT_DOUBLE_EQ(bill->share(), bill->live.share() + bill->receiving_share());
}

TEST(Bill, ReceivingAnImageCostsMoreTheMoreBytesItHas) {
  const std::span images = std::span(stream().images).first(20);
  std::vector<wire::Message> halves(images.begin(), images.end());
  for (wire::Message& half : halves)
    half.payload = std::make_shared<const std::string>(half.payload->substr(0, half.payload->size() / 2));
  double whole_us = receiving_us(images), half_us = receiving_us(halves);
  for (int again = 0; again < 2; ++again) {  // other programs only add time
    whole_us = std::min(whole_us, receiving_us(images));
    half_us = std::min(half_us, receiving_us(halves));
  }
  EXPECT_GT(whole_us, 20.0) << "some 70 datagrams are read and decrypted";
  EXPECT_LT(half_us, 0.8 * whole_us);
}

TEST(Bill, TheErrorIsThatOfAMovingHandOnAMovingPatient) {
  const scenes::Scene scene = scene_named("ribs-ultrasound");
  const auto errors = errors_in_motion(scene, {}, scene_file("ribs-ultrasound"), body(), 5.0);
  ASSERT_TRUE(errors.ok()) << to_string(errors.error());
  const MovingError& ribs = (*errors)[1];
  ASSERT_GT(ribs.ticks, 500u);
  EXPECT_GT(ribs.p99_N / ribs.stiffness_N_per_m, 1e-5) << "at rest it is 1 um";
  EXPECT_LT(ribs.p50_N / ribs.stiffness_N_per_m, 3e-3);
}

TEST(Bill, FrictionIsPricedOnTheSkinThatItNeeds) {
  const scenes::Scene scene = scene_named("friction");
  const auto errors = errors_in_motion(scene, {}, scene_file("friction"), body(), 3.0);
  ASSERT_TRUE(errors.ok()) << to_string(errors.error());
  EXPECT_EQ(errors->size(), scene.effects.size());
}

TEST(Bill, OnAModelTheSkinIsFeltWithoutError) {
  const scenes::Scene scene = scene_named("model");
  const Result<SceneParts> parts = read_parts(scene, scene_file("model"), true);
  ASSERT_TRUE(parts.ok()) << to_string(parts.error());
  const auto errors = errors_in_motion(scene, *parts, scene_file("model"), body(), 4.0);
  ASSERT_TRUE(errors.ok()) << to_string(errors.error());
  ASSERT_GT(errors->front().ticks, 500u);
  EXPECT_EQ(errors->front().p99_N, 0.0);
}

}  // namespace
}  // namespace telepalp::station
