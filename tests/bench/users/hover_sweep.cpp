#include "tests/bench/users/hover_sweep.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/control/phases/phase.h"
#include "haptic_station/core/built_effects.h"
#include "haptic_station/station/rigs/placement.h"
#include "support/program/files/shipped.h"

namespace telepalp::bench {
namespace {

constexpr double kDelay_s = 0.08;     // from exposure to page and station
constexpr int kTicksPerMessage = 20;  // the page sends its hand 100 times a second
constexpr double kMessage_s = kTicksPerMessage * HoverSweep::kTick_s;
constexpr double kHover_m = 0.05, kPressed_m = -0.04, kSinks_m_per_s = 0.1, kRises_m_per_s = 0.25;  // viewer_hand.ts
constexpr double kReach_m = 0.5;  // a station follows no hand beyond it

double across_m(const Eigen::Vector3d& v) { return std::hypot(v.x(), v.z()); }

}  // namespace

Result<std::unique_ptr<HoverSweep>> HoverSweep::make() {
  const Result<std::filesystem::path> file = scenes::find_scene("palpation");
  if (!file) return file.error();
  const Result<scenes::Scene> scene = scenes::read_scene(*file);
  if (!scene) return scene.error();
  constexpr const char* kTorso = "deploy/demo_data/torso/visible_human_torso.ply";
  const std::optional<std::filesystem::path> torso = program::shipped_file(kTorso);
  if (!torso) return Error{.what = "is missing", .where = kTorso, .fix = "run in a checkout of telepalp"};
  const Result<capture::TriangleMesh> mesh = capture::read_mesh(*torso);
  if (!mesh) return mesh.error();
  Result<capture::SyntheticPatient> made = capture::SyntheticPatient::make(*mesh, {});
  if (!made) return made.error();
  const auto patient = std::make_shared<const capture::SyntheticPatient>(std::move(*made));
  const auto placed = station::placed(*scene, patient->depth_of(patient->pose(hand::at_time(0.0)), hand::at_time(0.0)),
                                      patient->settings().camera);
  if (!placed) return Error{.what = "no skin is seen in the middle of the image", .where = "hover", .fix = {}};
  return std::unique_ptr<HoverSweep>(new HoverSweep(*scene, patient, *placed));
}

HoverSweep::HoverSweep(const scenes::Scene& scene, std::shared_ptr<const capture::SyntheticPatient> patient,
                       const Transform<HapticBase, DepthCamera>& haptic_from_camera)
    : patient_(patient),
      haptic_from_camera_(haptic_from_camera),
      feed_({.patient = patient,
             .pose = [patient](double time_s) { return patient->pose(hand::at_time(time_s)); },
             .damage =
                 [this](double captured_s, DepthImage& depth) {
                   images_.push_back({captured_s + kDelay_s, depth});
                   return true;
                 },
             .link = {.one_way_s = kDelay_s, .jitter_s = 0.0, .loss = 0.0},
             .builder = {}}),
      loop_({}, control::EncounteredController(scene.control, core::bank_of(scene.effects))),
      device_({}, {}, {{0.0, 0.10, 0.0}}),
      height_m_(kHover_m) {}

/// Takes the images that have arrived by now: the page and the guided hand see the newest. True: a newer surface came.
bool HoverSweep::see_images() {
  const Point<DepthCamera> device = haptic_from_camera_.inverse() * device_.read().at;
  auto snapshot = feed_.step(time_s(), device);
  const bool is_new = snapshot != nullptr;
  if (is_new) touched_ = {std::move(snapshot), haptic_from_camera_};
  const std::size_t before = images_.size();
  while (images_.size() > 1 && images_[1].arrives_s <= time_s()) images_.pop_front();
  if (images_.size() != before && images_.front().arrives_s <= time_s())
    heights_ = tracking::heights_of(images_.front().depth, patient_->settings().camera, haptic_from_camera_);
  return is_new;
}

/// Where the page puts the hand; nullopt: it knows no skin yet, or the station follows no hand there.
std::optional<Point<HapticBase>> HoverSweep::aim(const Pixel& pointer, bool presses) {
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
  const Point<HapticBase> at = haptic_from_camera_ * Point<DepthCamera>{skin_->m - height_m_ * skin_->m.normalized()};
  return at.m.norm() <= kReach_m ? std::optional(at) : std::nullopt;
}

void HoverSweep::tick(const Pixel& pointer, bool presses) {
  loop::TickIn in{.now = hand::at_time(time_s()), .dt_s = kTick_s, .reading = device_.read(), .rearm = rearm_};
  rearm_ = false;
  const loop::TouchableSurface before = touched_;  // the loop reads it until this tick
  if (see_images()) in.surface = &touched_;
  if (ticks_ % kTicksPerMessage == 0)
    if (const auto wanted = aim(pointer, presses)) {
      wanted_ = *wanted;
      const auto guided = guided_.follow({*wanted, !presses}, in.reading.at, heights_, kMessage_s);
      in.hand = ports::HandSample{.at = in.now, .hand = guided.hand, .wait_at_m = guided.wait_at_m};
      device_.hand_seen(guided.hand);
    }
  const loop::TickOut out = loop_.tick(in);
  device_.apply({out.force, out.torque}, out.contact, kTick_s);
  judge(out);
  ++ticks_;
}

void HoverSweep::judge(const loop::TickOut& out) {
  const Point<HapticBase> device = device_.read().at;
  seen_ = {.contact = control::is_inside(out.control.phase),
           .faulted = out.control.phase == control::Phase::Faulted,
           .from_pointer_m = across_m(device.m - wanted_.m)};
  const Point<DepthCamera> in_camera = haptic_from_camera_.inverse() * device;
  if (const auto depth = feed_.truth(time_s()).signed_distance_m(in_camera)) seen_.true_depth_m = -*depth;
}

}  // namespace telepalp::bench
