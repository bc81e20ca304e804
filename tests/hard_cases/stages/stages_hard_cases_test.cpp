// Stages beside the tick that are slower than their period, never end, or end after their scene was read again: in
// virtual time, and on the station's own thread.

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "haptic_station/core/collision_stage.h"
#include "haptic_station/core/inside/inner_surfaces_stage.h"
#include "haptic_station/core/inside/ultrasound_stage.h"
#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/solids/polish.h"
#include "haptic_station/station/threads/live_driver.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {
namespace {

using namespace std::chrono_literals;
using ::testing::AssertionResult;
using Surfaces = core::InnerSurfacesStage;
using Ultrasound = core::UltrasoundStage;

constexpr SessionTime kBegin{100s};
constexpr Nanoseconds kServed = 10ms;  // how often the network thread asks

std::vector<core::InnerLayer> layers_of(const std::string& polish, int count) {
  const auto solid = std::make_shared<const effects::SolidLayer>(
      effects::SolidLayer{"layer", *solids::build_tree(*solids::parse_polish(polish, "test")), {}});
  std::vector<core::InnerLayer> layers;
  for (int i = 0; i < count; ++i) layers.push_back({solid, static_cast<std::uint32_t>(i)});
  return layers;
}
std::vector<core::InnerLayer> a_ball() { return layers_of("tr 0 -0.03 0 sphere 0.02", 1); }
/// Layers whose surfaces take seconds to make.
std::vector<core::InnerLayer> a_heavy_body() {
  std::string ribs = "torusz 0.1 0.008 ";
  for (int i = 1; i < 24; ++i) ribs = "+ tr 0 0 " + std::to_string(0.02 * i) + " torusz 0.1 0.008 " + ribs;
  return layers_of(ribs, 16);
}

Ultrasound::View probe_in_the_air() { return {}; }

/// Images of the probe in virtual time: when each was begun and handed over.
struct Image {
  SessionTime begun;
  SessionTime handed_over;
};
std::vector<Image> images_in(Nanoseconds length, Nanoseconds cost) {
  Ultrasound stage(a_ball(), {});
  core::VirtualDriver<Ultrasound> driver;
  std::vector<Image> images;
  for (SessionTime now = kBegin; now < kBegin + length; now += kServed) {
    if (auto result = driver.finished(now)) {
      const SessionTime begun = result->begun;
      if (Ultrasound::hand_over(std::move(*result), now)) images.push_back({begun, now});
    }
    driver.begin(
        now, stage, [cost](core::StageStep) { return cost; }, probe_in_the_air());
  }
  return images;
}

AssertionResult in_time() {
  const std::vector<Image> images = images_in(10s, 8ms);
  return all_of({figure("images in 10 s", images.size() == 250, static_cast<double>(images.size()), 1.0, "")});
}

AssertionResult slower_than_its_period() {
  const std::vector<Image> images = images_in(10s, 95ms);
  double oldest_s = 0.0;
  for (const Image& image : images) oldest_s = std::max(oldest_s, to_seconds(image.handed_over - image.begun));
  const auto count = static_cast<double>(images.size());
  return all_of({above("images in 10 s", count, 80.0, 1.0, ""), below("and no more", count, 105.0, 1.0, ""),
                 below("the oldest when it is handed over", oldest_s, 0.1001, 1e3, "ms")});
}

AssertionResult never_ends() {
  Ultrasound ultrasound(a_ball(), {});
  core::VirtualDriver<Ultrasound> hung;
  core::CollisionStage collision;
  core::VirtualDriver<core::CollisionStage> beside;
  int images = 0;
  int runs = 0;
  for (SessionTime now = kBegin; now < kBegin + 10s; now += kServed) {
    images += hung.finished(now) ? 1 : 0;
    hung.begin(
        now, ultrasound, [](core::StageStep) { return core::kNever; }, probe_in_the_air());
    runs += beside.finished(now) ? 1 : 0;
    beside.begin(
        now, collision, [](core::StageStep) { return Nanoseconds{1ms}; }, std::nullopt, Point<HapticBase>{});
  }
  return all_of({figure("images", images == 0, images, 1.0, ""),
                 figure("runs of the collision detection beside it", runs == 999, runs, 1.0, "")});
}

AssertionResult ends_after_the_scene_was_read_again() {
  Surfaces before(layers_of("sphere 0.02", 1));
  Surfaces after(layers_of("sphere 0.04", 1));
  const auto driver = std::make_unique<core::VirtualDriver<Surfaces>>();
  const auto cost = [](core::StageStep) { return Nanoseconds{2s}; };
  driver->begin(kBegin, before, cost);
  driver->drop();  // the scene is read again after 1 s
  const bool dropped = !driver->finished(kBegin + 3s);
  driver->begin(kBegin + 1s, after, cost);
  if (auto made = driver->finished(kBegin + 3s)) (void)after.hand_over(std::move(*made), kBegin + 3s);
  const auto shown = after.placed(kBegin + 3s, {});
  const double radius_m = shown && shown->structures_size() == 1 ? -shown->structures(0).least().x() : 0.0;
  return all_of({{dropped, "the surfaces of the scene before are dropped"},
                 {!before.placed(kBegin + 3s, {}), "and are not shown"},
                 below_m("the ball of the new scene has its radius", std::abs(radius_m - 0.04), 2e-4)});
}

AssertionResult clock_steps_back() {
  Ultrasound stage(a_ball(), {});
  const auto at_once = [&](SessionTime now) { return core::run_at_once(stage, now, probe_in_the_air()); };
  auto old = at_once(kBegin);
  const bool stale = !Ultrasound::hand_over(std::move(*old), kBegin - 50s);
  return all_of({{stale, "the image of the session before is not shown"},
                 {at_once(kBegin - 50s).has_value(), "the next one begins at once"},
                 {!at_once(kBegin - 50s + 30ms).has_value(), "the period holds again"}});
}

/// The owner's thread, with a stage thread whose surfaces take seconds; `hand_overs` counts them.
struct Live {
  boost::asio::io_context owner{1};
  Surfaces stage{a_heavy_body()};
  int hand_overs = 0;
  std::function<SessionTime()> now = [] { return SessionTime{std::chrono::steady_clock::now().time_since_epoch()}; };
  station::StageThread thread{owner, now};
  station::LiveDriver<Surfaces> driver{stage, thread, [this](const Surfaces::Result&) { ++hand_overs; }};
};

AssertionResult stopped_while_it_runs() {
  Live live;
  live.driver.begin(kBegin);
  std::this_thread::sleep_for(200ms);
  const auto asked = std::chrono::steady_clock::now();
  live.thread.end();
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - asked).count();
  (void)live.owner.run_for(10ms);
  return all_of({below("the thread ends after", took_s, 0.5, 1e3, "ms"),
                 {live.hand_overs == 0, "nothing is handed over"},
                 {!live.stage.placed(kBegin, {}), "no surfaces are shown"}});
}

AssertionResult ended_before_its_hand_over() {
  boost::asio::io_context owner{1};
  Surfaces stage(layers_of("sphere 0.02", 1));
  std::atomic<bool> made{false};
  int hand_overs = 0;
  station::StageThread thread(owner, [&made] {
    made = true;  // the stage asks for the time when its result is done
    return kBegin;
  });
  station::LiveDriver<Surfaces> driver(stage, thread, [&](const Surfaces::Result&) { ++hand_overs; });
  driver.begin(kBegin);
  while (!made) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(50ms);  // the result comes into the owner's queue
  thread.end();
  const auto handlers = owner.run_for(10ms);
  return all_of({{hand_overs == 0, "nothing is handed over"}, {handlers == 1, "although the result was in the queue"}});
}

const HardCase kRows[] = {
    {"ultrasound image of 8 ms", "the easy case", "one in each period of 40 ms", in_time},
    {"ultrasound image of 95 ms", "it is slower than its period", "leave periods out, queue nothing",
     slower_than_its_period},
    {"ultrasound image that never ends", "its thread hangs", "no image; the other stages go on", never_ends},
    {"surfaces of the scene before", "they end after the scene was read again", "drop them, make the new ones",
     ends_after_the_scene_was_read_again},
    {"server restarts during an image", "the session clock steps back", "drop it, begin again at once",
     clock_steps_back},
    {"Ctrl-C while surfaces are made", "16 layers take seconds", "end within half a second", stopped_while_it_runs},
    {"Ctrl-C before a hand-over", "the result waits in the owner's queue", "it is never handed over",
     ended_before_its_hand_over},
};

class StagesHardCases : public HardCaseTable {};

TEST_P(StagesHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, StagesHardCases, ::testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
