#include "clients/mixed/files/rendered_sequence.h"

#include <cmath>
#include <numbers>
#include <random>

#include "clients/mixed/files/anchor_touches.h"
#include "clients/mixed/files/image_sequence.h"
#include "clients/mixed/scene/desk_props.h"
#include "support/images/image_file.h"
#include "support/program/files/whole_file.h"
#include "support/program/parallel.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

const Intrinsics kLens{640, 480, 594, 594, 319.5, 239.5};
constexpr double kFrame_s = 0.1;  // between two images
constexpr double kAge_s = 0.06;   // of an image when it is drawn

/// Renders what the view shows, writes the image, and returns the file's name with the camera's pose.
Result<PosedImage> taken(const fs::path& folder, const std::string& name, const DeskScene& scene, const View& view) {
  const RenderedDesk desk = render(scene, view, program::processors());
  if (const auto done =
          program::write_whole_file(folder / name, images::encode_png(desk.color), program::Readers::Group);
      !done)
    return done.error();
  return PosedImage{name, view.world_from_eye};
}

std::string numbered(const char* word, int i) {
  char name[40];
  std::snprintf(name, sizeof name, "%s_%03d.png", word, i);
  return name;
}

StandingDevice device_at(double share) {
  return desk_device({0.25 * std::sin(6.0 * share), 0.55, 0.75 + 0.1 * std::sin(9.0 * share), 0.2, -1.2, 0.0});
}

/// The live image number `i`. `share`: its place in the sequence, from 0 to 1.
Result<LiveImage> taken_live(const fs::path& folder, int i, double share) {
  const StandingDevice device = device_at(share);
  const DeskScene scene{.device = device, .hands = {holding_hand(device, Vector3d::Zero())}};
  const Vector3d eye(0.12 * std::sin(2.0 * std::numbers::pi * share), -0.62, 0.6 + 0.03 * std::cos(5.0 * share));
  const View view{kLens, looking_at({eye}, {{0.0, 0.12, 0.08}})};
  Result<PosedImage> image = taken(folder, numbered("live", i), scene, view);
  if (!image) return image.error();
  LiveImage live;
  live.image = std::move(*image);
  live.time_s = kFrame_s * i;
  live.joints_rad = device.joints_rad;
  live.trust = {.markers_seen = share < 0.67, .image_age_s = kAge_s};
  return live;
}

/// The station's states at 100 Hz, from before the first image to after the last one. At the instant of an image,
/// kAge_s before it is drawn, the tool is above the device by the gap of the image's place in the sequence.
std::vector<CouplingEnds> coupled(int frames, double gap_m) {
  std::vector<CouplingEnds> states;
  for (int k = -10; k <= 10 * frames; ++k) {
    const double time_s = 0.01 * k;
    const double share = std::max(0.0, (time_s + kAge_s) / kFrame_s / frames);
    const StandingDevice device = device_at(share);
    const Vector3d at = tip_of(device.model, device.joints_rad);
    const double gap = gap_m * std::sin(std::numbers::pi * std::min(1.0, 2.0 * share));
    states.push_back({SessionTime(from_seconds(time_s)), {at}, {Vector3d(at + gap * Vector3d::UnitY())}});
  }
  return states;
}

std::vector<Click> clicked(const StandingDevice& device) {
  std::mt19937_64 random(33);
  std::normal_distribution<double> normal(0.0, kClickDeviation_m);
  std::uniform_real_distribution<double> share(0.15, 0.85);
  std::vector<Click> clicks;
  for (int place = 0; place < 36; ++place) {
    std::vector<double> q;
    for (const Joint& joint : device.model.joints)
      q.push_back(std::lerp(joint.least_rad, joint.most_rad, share(random)));
    const Vector3d off(normal(random), normal(random), normal(random));
    clicks.push_back({place, {device.world_from_haptic.iso * tip_of(device.model, q) + off}, q});
  }
  return clicks;
}

/// Touches with a finger at three places, twice each, with 1 mm of noise an axis, by a headset whose space is turned
/// and moved against the device.
AnchorTouches touched() {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal(0.0, 1e-3);
  const Eigen::Isometry3d headset_from_haptic =
      Eigen::Translation3d(0.1, 0.9, -0.5) * Eigen::AngleAxisd(0.6, Vector3d::UnitY());
  AnchorTouches touches;
  for (int place = 0; place < 3; ++place)
    for (int repeat = 0; repeat < 2; ++repeat) {
      const double at = 2.0 * std::numbers::pi / 3.0 * place;
      const Point<HapticBase> known{Vector3d(0.12 * std::cos(at), 0.12, 0.12 * std::sin(at))};
      const Vector3d off(normal(random), normal(random), normal(random));
      const Vector3d tip = headset_from_haptic * known.m + off;
      touches.places.push_back({place, known, Eigen::Isometry3d(Eigen::Translation3d(tip))});
    }
  return touches;
}

}  // namespace

Result<void> write_rendered_sequence(const fs::path& folder, int background, int frames, double gap_m,
                                     ProxyKind proxy) {
  if (const auto made = program::make_folder(folder, program::Readers::Group); !made) return made;
  std::vector<PosedImage> images;
  for (const View& view : head_views(kLens, background, 0.5, std::numbers::pi / 2.0, 121)) {
    Result<PosedImage> image = taken(folder, numbered("background", static_cast<int>(images.size())), {}, view);
    if (!image) return image.error();
    images.push_back(std::move(*image));
  }
  std::vector<LiveImage> live;
  for (int i = 0; i < frames; ++i) {
    Result<LiveImage> one = taken_live(folder, i, static_cast<double>(i) / frames);
    if (!one) return one.error();
    live.push_back(std::move(*one));
  }
  const StandingDevice device = device_at(0.0);
  const std::pair<const char*, std::string> tables[] = {
      {"camera.csv", camera_table(kLens)},
      {"background.csv", background_table(images)},
      {"proxy.obj", proxy_obj(proxy == ProxyKind::Planes ? desk_planes() : desk_depths(false, program::processors()))},
      {"device.csv", device_table({device.world_from_haptic, 0.3e-3, 0.002})},
      {"clicks.csv", clicks_table(clicked(device))},
      {"touches.csv", touches_table(touched())},
      {"frames.csv", frames_table(live)},
      {"coupling.csv", coupling_table(coupled(frames, gap_m))}};
  for (const auto& [name, text] : tables)
    if (const auto done = program::write_whole_file(folder / name, text, program::Readers::Group); !done) return done;
  return {};
}

}  // namespace telepalp::mixed
