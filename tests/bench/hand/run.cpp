#include "tests/bench/hand/run.h"

#include <algorithm>
#include <cmath>

namespace telepalp::bench::hand {
StationSettings with_skin(effects::SkinAnchor anchor, double stiffness_N_per_m) {
  StationSettings settings;
  (void)settings.effects.add(effects::Skin({.law = effects::linear_law(stiffness_N_per_m), .anchor = anchor}));
  return settings;
}

void touch(const capture::TrueSurface& skin, const Transform<HapticBase, DepthCamera>& haptic_from_camera, Tick& tick) {
  const auto foot = skin.closest_to(haptic_from_camera.inverse() * Point<HapticBase>{tick.device_m});
  tick.true_known = foot && foot->on_body;
  if (!foot) return;
  tick.normal = (haptic_from_camera * foot->normal).v;
  tick.true_depth_m = tick.normal.dot((haptic_from_camera * foot->at).m - tick.device_m);
}

BenchStation::BenchStation(const StationSettings& settings,
                           const Transform<HapticBase, DepthCamera>& haptic_from_camera, std::unique_ptr<Person> person)
    : settings_(settings),
      haptic_from_camera_(haptic_from_camera),
      camera_from_haptic_(haptic_from_camera.inverse()),
      person_(std::move(person)),
      ticks_(settings.control, settings.effects, settings.loop),
      tracker_({}, settings.seed),
      before_m_(person_->device().m) {}

void BenchStation::receive(std::shared_ptr<const surface::SurfaceSnapshot> snapshot, double time_s) {
  if (snapshot) arriving_.push_back({time_s + settings_.extra_delay_s, std::move(snapshot)});
}

/// The person, the device and the tracker, with their faults. The person moves after the tick, when the true skin of
/// its instant is known.
class BenchStation::HeldRig final : public ports::Rig {
 public:
  HeldRig(BenchStation& station, double time_s) noexcept : station_(station), time_s_(time_s) {}
  ports::DeviceReading read() noexcept override {
    ports::DeviceReading reading = station_.person_->read();
    station_.settings_.spoil(time_s_, reading);
    return reading;
  }
  std::optional<ports::HandSample> hand(SessionTime now) noexcept override {
    const auto sample = station_.tracker_.sample(time_s_, station_.person_->hand());
    const bool heard = sample && !station_.settings_.tracker_silent(time_s_);
    return heard ? std::optional(ports::HandSample{now, *sample}) : std::nullopt;
  }
  void apply(const Wrench<HapticBase>&, const ports::SurfaceContact&, double) noexcept override {}

 private:
  BenchStation& station_;
  double time_s_;
};

Tick BenchStation::step(double time_s, const capture::TrueSurface& truth) {
  loop::TickIn due{.now = at_time(time_s), .dt_s = kTick_s};
  const loop::TouchableSurface before = touched_;  // the loop refers to it until this tick
  for (; !arriving_.empty() && arriving_.front().at_s <= time_s; arriving_.pop_front()) {
    touched_ = {arriving_.front().snapshot, haptic_from_camera_};
    due.surface = &touched_;
  }
  Tick tick{.time_s = time_s, .device_m = person_->device().m, .hand_m = person_->hand().m};
  tick.moved_m = tick.device_m - before_m_;
  before_m_ = tick.device_m;
  HeldRig rig(*this, time_s);
  const loop::TickOut act = ticks_.run(rig, due);
  tick.force_N = act.force.N;
  tick.control = act.control;
  tick.surface_age_s = act.contact.age_s;
  tick.displayed = act.contact.valid && act.contact.in_body &&
                   (control::is_inside(act.control.phase) || act.control.phase == control::Phase::BodyToPlane);
  touch(truth, haptic_from_camera_, tick);
  person_->apply(act, time_s, kTick_s);
  return tick;
}

void run(Feed& feed, BenchStation& station, double seconds, const std::function<void(const Tick&)>& judge) {
  auto left = static_cast<std::int64_t>(std::llround(seconds / kTick_s));
  if (left <= 0) return;
  run_while(feed, station, [&](const Tick& tick) {
    judge(tick);
    return --left > 0;
  });
}

void run_while(Feed& feed, BenchStation& station, const std::function<bool(const Tick&)>& judge) {
  bool goes_on = true;
  for (std::int64_t i = 0; goes_on; ++i) {
    const double time_s = static_cast<double>(i) * kTick_s;
    station.receive(feed.step(time_s, station.device_camera()), time_s);
    goes_on = judge(station.step(time_s, feed.truth(time_s)));
  }
}

double reaching_m(double time_s, double depth_m) noexcept {
  return 0.06 - (0.06 + depth_m) * eased((time_s - 1.0) / 1.5);
}

double eased(double x) noexcept {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace telepalp::bench::hand
