#include "tools/replay/cell/replayed_station.h"

#include <utility>

namespace telepalp::replay {
namespace {

constexpr std::uint64_t kTicksPerState = 20;  // 100 Hz
constexpr std::uint64_t kTicksPerTotals = 2000;

std::unique_ptr<ports::Rig> rig_of(const StationSetup& setup, const Scenario& scenario) {
  return setup.recorded != nullptr ? recorded_hand(*setup.recorded)
                                   : scripted_hand(scenario.hand, setup.scene.trial, scenario.seed);
}

}  // namespace

/// Publishes what the station's network thread publishes, at the same rates.
class ReplayedStation::Telemetry {
 public:
  Telemetry(const std::string& scene, Publish publish) : publish_(std::move(publish)) {
    outbox_.facts().clock_error_s = 0.0;
    publish_(outbox_.event(msg::EVENT_KIND_SCENE, "scene " + scene + ", in virtual time", kBegin));
  }

  void add(loop::TickSample sample, SessionTime now, const core::TickStage& stage) {
    sample.tick = ticked_++;
    sample.stamp_ns = to_nanoseconds(now);
    batch_.push_back(sample);
    if (ticked_ % kTicksPerState != 0) return;
    for (wire::Message& message : outbox_.ticks(batch_, now)) publish_(std::move(message));
    batch_.clear();
    loop::Compensation compensation = stage.compensation();
    compensation.stamp_ns = sample.stamp_ns;
    publish_(outbox_.compensation(compensation, now));
    if (ticked_ % kTicksPerTotals == 0) publish_(outbox_.totals({.frames_dropped = received_ - touched_}, now));
  }
  void received() {
    ++received_;
    outbox_.frame_received();
  }
  void touchable(const msg::SurfaceReport& report, SessionTime now) {
    ++touched_;
    publish_(outbox_.surface(report, now));
  }

 private:
  Publish publish_;
  core::Outbox outbox_;
  std::vector<loop::TickSample> batch_;  // not published yet
  std::uint64_t ticked_ = 0;
  std::uint64_t received_ = 0;
  std::uint64_t touched_ = 0;
};

ReplayedStation::ReplayedStation(const StationSetup& setup, const Scenario& scenario, Publish publish)
    : ReplayedStation(setup, scenario, std::move(publish), core::build_effects(setup.scene.effects)) {}

ReplayedStation::ReplayedStation(const StationSetup& setup, const Scenario& scenario, Publish publish,
                                 core::BuiltEffects effects)
    : scenario_(scenario),
      rig_(rig_of(setup, scenario)),
      ticks_(setup.scene.control, effects.bank),
      surfaces_(
          setup.surface, [placed = setup.haptic_from_camera](const DepthImage&, const Intrinsics&) { return placed; },
          effects.bank),
      slow_effects_(std::move(effects.stages)),
      telemetry_(publish ? std::make_unique<Telemetry>(setup.scene.name, std::move(publish)) : nullptr) {
  if (!surface::runs_in_tick(setup.surface)) collision_.emplace();
}

ReplayedStation::~ReplayedStation() = default;

void ReplayedStation::arrived(core::ArrivedDepth frame) {
  if (telemetry_) telemetry_->received();
  if (surfaces_.admit(frame.depth.payload->size())) surfaces_.arrived(std::move(frame));
}

SessionTime ReplayedStation::clock(SessionTime now) const noexcept {
  for (const ClockStep& step : scenario_.faults.clock_steps)
    if (step.when.contains(now - kBegin)) now += step.by;
  return now;
}

ports::DeviceReading ReplayedStation::spoiled(ports::DeviceReading reading, Nanoseconds since) const noexcept {
  for (const EncoderGlitch& glitch : scenario_.faults.glitches)
    if (glitch.when.contains(since)) reading.at.m.array() += glitch.off_m;
  return reading;
}

/// Messages carry `true_now`, so that a wrong clock of the station does not put the messages of a topic out of order.
void ReplayedStation::report(const msg::SurfaceReport& report, SessionTime true_now) {
  if (telemetry_) telemetry_->touchable(report, true_now);
  touchable_ = FrameTimes{.number = static_cast<std::uint32_t>(report.sequence()),
                          .captured_ns = static_cast<std::int64_t>(report.captured_ns()),
                          .encoded_ns = static_cast<std::int64_t>(report.encoded_ns()),
                          .received_ns = static_cast<std::int64_t>(report.received_ns()),
                          .decoded_ns = static_cast<std::int64_t>(report.decoded_ns()),
                          .touchable_ns = static_cast<std::int64_t>(report.touchable_ns())};
}

std::optional<loop::TouchableSurface> ReplayedStation::newer_surface(SessionTime true_now, Stopwatch& watch) {
  if (auto result = surface_driver_.finished(true_now)) {
    if (result->unreadable) key_frame_wanted_ = true;
    if (result->surface) report(result->report, true_now);
    if (!result->surface) ++undecodable_;
    return result->surface;
  }
  Stopwatch::Laps laps(watch);
  const auto cost = [&](core::StageStep step) {
    if (step == core::StageStep::Decoded) laps.end(Part::Decode);
    if (step == core::StageStep::Done) laps.end(Part::Build);
    return scenario_.stages.decode + (step == core::StageStep::Done ? scenario_.stages.build : Nanoseconds{0});
  };
  surface_driver_.begin(true_now, surfaces_, cost, device());
  return std::nullopt;
}

std::optional<loop::TouchableSurface> ReplayedStation::newer_plane(SessionTime true_now) {
  const auto result = collision_driver_.finished(true_now);
  if ((true_now - kBegin) % core::CollisionStage::kPeriod == Nanoseconds{0})
    collision_driver_.begin(
        true_now, *collision_, [&](core::StageStep) { return scenario_.stages.collision; },
        std::exchange(to_collision_, std::nullopt), device());
  return result ? result->plane : std::nullopt;
}

TickOutcome ReplayedStation::tick(SessionTime true_now, Stopwatch& watch) {
  const Nanoseconds since = true_now - kBegin;
  touchable_.reset();
  std::optional<loop::TouchableSurface> newer = newer_surface(true_now, watch);
  if (collision_) {
    if (newer) to_collision_ = std::move(newer);
    newer = newer_plane(true_now);
  }
  if (tool_) slow_effects_.advance(true_now, *tool_, scenario_.stages.effects);
  TickOutcome out{.at = true_now, .tracker_lost = any_contains(scenario_.faults.tracker_lost, since)};
  watch.sample(Part::Loop, [&] {
    out.act = ticks_.run(
        *rig_, {.now = clock(true_now), .dt_s = to_seconds(kTick), .surface = newer ? &*newer : nullptr},
        [&](loop::TickIn& in) {
          if (out.tracker_lost) in.hand.reset();
          out.device = ticks_.in_patient_frame(in.reading.at);
          in.reading = spoiled(in.reading, since);
          tool_ = core::ToolAt{.device = ticks_.in_patient_frame(in.reading.at), .attitude = in.reading.attitude};
        },
        [](const loop::TickIn&, const loop::TickOut&) {});
  });
  if (newer) touched_ = std::move(*newer);  // the loop no longer refers to the last snapshot
  if (telemetry_) watch.sample(Part::Record, [&] { telemetry_->add(out.act.sample, true_now, ticks_); });
  return out;
}

}  // namespace telepalp::replay
