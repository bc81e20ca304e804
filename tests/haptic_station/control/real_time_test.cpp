#include <gtest/gtest.h>

#include <Eigen/Core>
#include <memory>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/trials/virtual_station.h"
#include "tests/support/no_heap_scope.h"

namespace telepalp {
namespace {

using test::NoHeapScope;

TEST(NoHeapScopeDeathTest, AbortsOnEveryWayToTheHeap) {
  if (!NoHeapScope::works()) GTEST_SKIP() << "a sanitizer owns malloc";
  static volatile int size = 100;
  EXPECT_DEATH(
      {
        const NoHeapScope guard;
        auto owned = std::make_unique<int[]>(static_cast<std::size_t>(size));
        owned[0] = size;
      },
      "malloc used where the heap is forbidden");
  EXPECT_DEATH(
      {
        const NoHeapScope guard;
        Eigen::VectorXd vector = Eigen::VectorXd::Zero(size);
        size = static_cast<int>(vector.size());
      },
      "alloc used where the heap is forbidden");
}

static_assert(
    noexcept(std::declval<control::EncounteredController&>().step(std::declval<const control::ControlInput&>(), 0.0)));
static_assert(noexcept(std::declval<device::SimulatedPair&>().step(std::declval<const Force<HapticBase>&>(),
                                                                   std::declval<const device::Intention&>(), 0.0)));

TEST(EncounteredController, AWholeTrialTouchesNoHeap) {
  if (!NoHeapScope::works()) GTEST_SKIP() << "a sanitizer owns malloc";
  trials::VirtualStationSettings settings;
  (void)settings.effects.add(effects::Skin{});
  (void)settings.effects.add(effects::InnerCylinder({.top_center = {{0.0, -0.03, 0.0}}}));
  (void)settings.effects.add(effects::InnerSphere({.center = {{0.05, -0.05, 0.0}}}));
  trials::VirtualStation station(settings);
  station.place({{0.0, 0.03, 0.0}}, {{0.0, 0.07, 0.0}});
  device::ScriptedIntention person(device::waypoints(device::Trial::FindCylinder), {});
  const device::BreathingPlane skin{.amplitude_m = 0.005};
  int touching = 0;
  {
    const NoHeapScope guard;
    for (int i = 0; i < 20'000; ++i) {
      const auto out = station.step(skin, [&](const device::TrialView& view) { return person.step(view, 0.0005); });
      if (control::is_inside(out.phase)) ++touching;
    }
  }
  EXPECT_GT(touching, 1000);
}

}  // namespace
}  // namespace telepalp
