#include "haptic_station/station/rigs/scene_rig.h"

#include "haptic_station/loop/simulated_rig.h"
#include "haptic_station/station/threads/bill.h"

namespace telepalp::station {
namespace {

constexpr double kRestHeight_m = 0.10;  // height of the hand above the skin at the start

loop::SimulatedRig::Person person_of(const scenes::Scene& scene, const std::optional<tracking::HandTrace>& trace) {
  const Point<HapticBase> skin;  // origin of H: the skin at the image centre, or as the scene defines it
  if (trace) return tracking::RecordedIntention(*trace, scene.haptic_from_tracker, skin, scene.trace_deepest_m);
  return device::ScriptedIntention(device::waypoints(scene.trial), skin);
}

}  // namespace

loop::HapticLoop loop_of(const scenes::Scene& scene, const effects::EffectBank& effects) {
  control::EncounteredController controller(scene.control, effects);
  controller.book_costs_with(&cycles_now);
  return loop::HapticLoop({}, controller);
}

std::unique_ptr<ports::Rig> rig_of(const scenes::Scene& scene, const std::optional<tracking::HandTrace>& trace) {
  const auto wrist = scene.probe ? std::optional(device::SimulatedWristSettings{}) : std::nullopt;
  return std::make_unique<loop::SimulatedRig>(
      loop::SimulatedRig::Settings{
          .device = {}, .hand = {}, .tracker = {}, .wrist = wrist, .rest = {{0.0, kRestHeight_m, 0.0}}},
      person_of(scene, trace));
}

}  // namespace telepalp::station
