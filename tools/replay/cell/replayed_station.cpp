#include "tools/replay/cell/replayed_station.h"

#include <utility>

namespace telepalp::replay {
namespace {

constexpr std::uint64_t kTicksPerState = 20;  // 100 Hz
constexpr std::uint64_t kTicksPerTotals = 2000;

std::unique_ptr<ports::Rig> rig_of(const StationSetup& setup, const Scenario& scenario) {
  return setup.recorded != nullptr ? recorded_hand(*setup.recorded)
                                   : scripted_hand(setup.scene, scenario.hand, scenario.seed);
}

}  // namespace

/// Publishes what the station's network thread publishes, at the same rates.
class ReplayedStation::Telemetry {
 public:
  Telemetry(const std::string& scene, Publish publish)
      : publish_(std::move(publish)), publisher_(ticks_, publish_, [](const loop::TickSample&) {}) {
    publisher_.publish_event(kBegin, msg::EVENT_KIND_SCENE, "scene " + scene + ", in virtual time");
  }

  void add(loop::TickSample sample, SessionTime now, const loop::HapticLoop& loop) {
    sample.tick = ticked_++;
    sample.stamp_ns = to_nanoseconds(now);
    (void)ticks_.try_push(sample);  // the ring holds 2 s, and is emptied every 10 ms
    if (ticked_ % kTicksPerState != 0) return;
    publisher_.drain(now);
    loop::Compensation compensation = loop.compensation();
    compensation.stamp_ns = sample.stamp_ns;
    publish_(wire::make_message(wire::kStationCompensation, now, station::compensation_message(compensation)));
    if (ticked_ % kTicksPerTotals == 0) publisher_.publish_totals(now, 0.0, {}, received_ - touched_, false, {});
  }
  void received() {
    ++received_;
    publisher_.frame_received();
  }
  void touchable(const BuiltSurface& built, SessionTime now) {
    ++touched_;
    msg::SurfaceReport report;
    report.set_captured_ns(static_cast<std::uint64_t>(built.times.captured_ns));
    report.set_encoded_ns(static_cast<std::uint64_t>(built.times.encoded_ns));
    report.set_received_ns(static_cast<std::uint64_t>(built.times.received_ns));
    report.set_decoded_ns(static_cast<std::uint64_t>(built.times.decoded_ns));
    report.set_touchable_ns(static_cast<std::uint64_t>(built.times.touchable_ns));
    report.set_sequence(built.times.number);
    report.set_points(built.surface.snapshot->points);
    report.set_index(built.surface.snapshot->index_name);
    report.set_build_ms(1e3 * built.build_s);
    publish_(wire::make_message(wire::kStationSurface, now, report));
  }

 private:
  Publish publish_;
  station::TickRing ticks_;
  station::TelemetryPublisher publisher_;
  std::uint64_t ticked_ = 0;
  std::uint64_t received_ = 0;
  std::uint64_t touched_ = 0;
};

ReplayedStation::ReplayedStation(const StationSetup& setup, const Scenario& scenario, Publish publish)
    : scenario_(scenario),
      rig_(rig_of(setup, scenario)),
      loop_({}, {setup.scene.control, setup.scene.effects}),
      surfaces_(scenario.stages, setup.surface, setup.haptic_from_camera, setup.scene.effects),
      telemetry_(publish ? std::make_unique<Telemetry>(setup.scene.name, std::move(publish)) : nullptr) {}

ReplayedStation::~ReplayedStation() = default;

void ReplayedStation::arrived(ArrivedDepth frame) {
  if (telemetry_) telemetry_->received();
  surfaces_.arrived(std::move(frame));
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
void ReplayedStation::report_touchable(const BuiltSurface& built, SessionTime true_now) {
  if (telemetry_) telemetry_->touchable(built, true_now);
  touchable_ = built.times;
}

TickOutcome ReplayedStation::tick(SessionTime true_now, Stopwatch& watch) {
  const SessionTime now = clock(true_now);
  const Nanoseconds since = true_now - kBegin;
  touchable_.reset();
  std::optional<BuiltSurface> built = surfaces_.step(true_now, device_, watch);
  if (built) report_touchable(*built, true_now);
  TickOutcome out{.at = true_now, .tracker_lost = any_contains(scenario_.faults.tracker_lost, since)};
  watch.sample(Part::Loop, [&] {
    loop::TickIn in{.now = now,
                    .dt_s = to_seconds(kTick),
                    .hand = rig_->hand(now),
                    .reading = rig_->read(),
                    .surface = built ? &built->surface : nullptr};
    if (out.tracker_lost) in.hand.reset();
    device_ = out.device = loop_.in_patient_frame(in.reading.at);
    in.reading = spoiled(in.reading, since);
    out.act = loop_.tick(in);
    rig_->apply(out.act.force, loop_.in_device_frame(out.act.contact), to_seconds(kTick));
  });
  if (built) touched_ = std::move(built->surface.snapshot);  // the loop no longer refers to the last snapshot
  if (telemetry_) watch.sample(Part::Record, [&] { telemetry_->add(out.act.sample, true_now, loop_); });
  return out;
}

}  // namespace telepalp::replay
