#include "tests/bench/hand/pointer_session.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/core/built_effects.h"
#include "haptic_station/device/hand_driven_device.h"
#include "haptic_station/station/rigs/placement.h"
#include "server/capture/synthetic/source/patient_model.h"

namespace telepalp::bench {
namespace {

using Steady = tracking::ViewerHandTracker::Clock;

constexpr int kTicksPerMessage = 20;  // the page sends its hand 100 times a second
constexpr double kMessage_s = kTicksPerMessage * PointerSession::kTick_s;
// As in clients/viewer/src/touch/viewer_hand.ts.
constexpr double kHover_m = 0.05, kPressed_m = -0.04, kSinks_m_per_s = 0.1, kRises_m_per_s = 0.25;
constexpr double kRest_m = 0.10;  // height of the device at the start
constexpr double kFull = 0.999;   // a force above this share of its limit is saturated

double across_m(const Eigen::Vector3d& v) { return std::hypot(v.x(), v.z()); }

/// In a session in virtual time, session time is the time of the steady clock.
Steady::time_point steady_at(SessionTime at) { return Steady::time_point(at.time_since_epoch()); }

}  // namespace

/// The browser's tracker on the session's virtual clock.
class PointerSession::VirtualTracker final : public ports::Tracker {
 public:
  [[nodiscard]] std::optional<ports::HandSample> sample(SessionTime now,
                                                        const ports::DeviceReading& device) noexcept override {
    return hand.sample_at(now, steady_at(now), device);
  }
  tracking::ViewerHandTracker hand;
};

namespace {

/// The torso of the repository under the whole image of a camera.
Result<std::shared_ptr<const capture::SyntheticPatient>> whole_torso() {
  Result<capture::NamedPatient> named = capture::open_patient({});
  if (!named) return named.error();
  return std::make_shared<const capture::SyntheticPatient>(std::move(named->patient));
}

}  // namespace

Result<std::unique_ptr<PointerSession>> PointerSession::make(const Settings& settings) {
  const Result<std::filesystem::path> file = scenes::find_scene("palpation");
  if (!file) return file.error();
  const Result<scenes::Scene> scene = scenes::read_scene(*file);
  if (!scene) return scene.error();
  auto patient = settings.patient;
  if (!patient) {
    auto made = whole_torso();
    if (!made) return made.error();
    patient = std::move(made).value();
  }
  const auto placed = station::placed(*scene, patient->depth_of(patient->pose(hand::at_time(0.0)), hand::at_time(0.0)),
                                      patient->settings().camera);
  if (!placed)
    return Error{.what = "no skin is seen in the middle of the image", .where = "pointer session", .fix = {}};
  return std::unique_ptr<PointerSession>(new PointerSession(settings, *scene, patient, *placed));
}

PointerSession::PointerSession(const Settings& settings, const scenes::Scene& scene,
                               std::shared_ptr<const capture::SyntheticPatient> patient,
                               const Transform<HapticBase, DepthCamera>& haptic_from_camera)
    : settings_(settings),
      control_(scene.control),
      patient_(patient),
      haptic_from_camera_(haptic_from_camera),
      feed_({.patient = patient,
             .pose = [patient](double time_s) { return patient->pose(hand::at_time(time_s)); },
             .damage =
                 [this](double captured_s, DepthImage& depth) {
                   images_.push_back({captured_s + settings_.path.image_s, depth});
                   return true;
                 },
             .link = {.one_way_s = settings.path.image_s, .jitter_s = 0.0, .loss = 0.0},
             .builder = {}}),
      ticks_stage_(scene.control, core::bank_of(scene.effects)),
      random_(settings.path.seed),
      height_m_(kHover_m) {
  auto tracker = std::make_unique<VirtualTracker>();
  tracker_ = &tracker->hand;
  rig_ = std::make_unique<device::JoinedRig>(
      std::make_unique<device::HandDrivenDevice>(device::SimulatedDeviceSettings{}, device::SimulatedHandSettings{},
                                                 Point<HapticBase>{{0.0, kRest_m, 0.0}}),
      std::move(tracker));
}

/// Takes the images that have arrived by now: the page and the hand's tracker see the newest. True: a newer surface
/// came.
bool PointerSession::see_images() {
  const Point<DepthCamera> device = haptic_from_camera_.inverse() * rig_->read().at;
  auto snapshot = feed_.step(time_s(), device);
  const bool is_new = snapshot != nullptr;
  if (is_new) touched_ = {std::move(snapshot), haptic_from_camera_};
  const std::size_t before = images_.size();
  while (images_.size() > 1 && images_[1].arrives_s <= time_s()) images_.pop_front();
  if (images_.size() != before && images_.front().arrives_s <= time_s())
    tracker_->see(tracking::heights_of(images_.front().depth, patient_->settings().camera, haptic_from_camera_));
  return is_new;
}

/// Where the page puts the hand; nullopt: the page has seen no skin yet.
std::optional<Point<HapticBase>> PointerSession::aim(const Pixel& pointer, bool presses) {
  if (images_.empty() || images_.front().arrives_s > time_s()) return std::nullopt;
  const DepthImage& depth = images_.front().depth;
  const Intrinsics& camera = patient_->settings().camera;
  const int column = std::clamp(static_cast<int>(std::lround(pointer.u)), 0, depth.width - 1);
  const int row = std::clamp(static_cast<int>(std::lround(pointer.v)), 0, depth.height - 1);
  if (const std::uint16_t sample = depth.at(column, row); sample != 0) {
    const double z_m = sample * depth.unit_m;
    skin_ = Point<DepthCamera>{{(column - camera.cx) / camera.fx * z_m, (row - camera.cy) / camera.fy * z_m, z_m}};
  }
  if (!skin_) return std::nullopt;
  height_m_ = std::clamp(height_m_ + (presses ? -kSinks_m_per_s : kRises_m_per_s) * kMessage_s, kPressed_m, kHover_m);
  return haptic_from_camera_ * Point<DepthCamera>{skin_->m - height_m_ * skin_->m.normalized()};
}

void PointerSession::send_hand(const Point<HapticBase>& at, bool hovers) {
  wanted_ = at;
  double arrives_s = time_s() + settings_.path.hand_s + random_.uniform(0.0, settings_.path.jitter_s);
  if (!hands_.empty()) arrives_s = std::max(arrives_s, hands_.back().arrives_s);
  hands_.push_back({time_s(), arrives_s, at, hovers});
}

void PointerSession::deliver_hands() {
  for (; !hands_.empty() && hands_.front().arrives_s <= time_s(); hands_.pop_front()) {
    msg::ViewerHand message;
    message.set_viewer(1);
    message.set_sampled_us(static_cast<std::uint64_t>(1e6 * hands_.front().sent_s));
    message.set_hovers(hands_.front().hovers);
    (void)tracker_->hear(message, hands_.front().at, steady_at(hand::at_time(time_s())));
  }
}

void PointerSession::tick(const Pixel& pointer, bool presses) {
  if (ticks_ % kTicksPerMessage == 0)
    if (const auto wanted = aim(pointer, presses)) send_hand(*wanted, !presses);
  run_tick();
}

void PointerSession::tick_tracked(const Point<HapticBase>& at) {
  if (ticks_ % kTicksPerMessage == 0) send_hand(at, false);
  run_tick();
}

void PointerSession::run_tick() {
  loop::TickIn due{.now = hand::at_time(time_s()), .dt_s = kTick_s, .rearm = rearm_};
  rearm_ = false;
  const loop::TouchableSurface before = touched_;  // kept alive: the loop reads this surface until this tick
  if (see_images()) due.surface = &touched_;
  deliver_hands();
  judge(ticks_stage_.run(*rig_, due));
  ++ticks_;
}

void PointerSession::judge(const loop::TickOut& out) {
  const Point<HapticBase> device = rig_->read().at;
  const control::Phase phase = out.control.phase;
  const double force_N = out.force.N.norm();
  const double limit_N = phase == control::Phase::OutBody ? control_.position.most_N : control_.limits.peak_N;
  seen_ = {.contact = control::is_inside(phase),
           .faulted = phase == control::Phase::Faulted,
           .from_pointer_m = across_m(device.m - wanted_.m),
           .device_m = device.m,
           .force_N = force_N,
           .saturated = force_N > kFull * limit_N};
  const Point<DepthCamera> in_camera = haptic_from_camera_.inverse() * device;
  if (const auto depth = feed_.truth(time_s()).signed_distance_m(in_camera)) seen_.true_depth_m = -*depth;
}

}  // namespace telepalp::bench
