#include "clients/mixed/scene/desk_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "clients/mixed/scene/ray_bodies.h"
#include "clients/mixed/scene/soft_texture.h"
#include "support/program/parallel.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;

struct Surface {
  Body body;
  Label label = Label::Background;
  Paint paint;
};

Body box(const Vector3d& centre, const Vector3d& half, double about_z_rad) {
  return Body::box(Eigen::Translation3d(centre) * Eigen::AngleAxisd(about_z_rad, Vector3d::UnitZ()), half);
}

void add_background(std::vector<Surface>& all, bool pages) {
  const auto add = [&](const Body& body, const Vector3d& color, double scale_m, bool printed) {
    all.push_back({body, Label::Background, {color, scale_m, printed && pages}});
  };
  add(box({0.0, 0.1, -0.02}, {0.9, 0.7, 0.02}, 0.0), {168, 122, 82}, 0.06, true);    // desk
  add(box({0.0, 0.82, 0.7}, {1.4, 0.02, 1.5}, 0.0), {178, 184, 176}, 0.15, true);    // back wall
  add(box({-1.1, 0.0, 0.7}, {0.02, 0.85, 1.5}, 0.0), {150, 160, 178}, 0.2, false);   // left wall
  add(box({1.4, 0.0, 0.7}, {0.02, 0.85, 1.5}, 0.0), {172, 160, 150}, 0.2, false);    // right wall
  add(box({0.0, -0.9, -0.72}, {3.0, 3.0, 0.01}, 0.0), {96, 92, 90}, 0.3, false);     // floor
  add(box({-0.32, 0.3, 0.04}, {0.1, 0.07, 0.04}, 0.4), {60, 96, 150}, 0.03, false);  // books and boxes
  add(box({0.3, 0.34, 0.06}, {0.05, 0.05, 0.06}, 0.2), {150, 60, 56}, 0.03, false);
  add(box({0.05, 0.42, 0.09}, {0.12, 0.04, 0.09}, -0.2), {74, 128, 84}, 0.04, false);
  add(box({0.38, 0.08, 0.015}, {0.09, 0.12, 0.015}, 0.6), {190, 176, 120}, 0.05, false);
  add(box({-0.4, 0.02, 0.01}, {0.1, 0.14, 0.01}, -0.3), {206, 204, 196}, 0.05, true);
  add(box({-0.12, 0.5, 0.05}, {0.05, 0.05, 0.05}, 0.8), {128, 84, 140}, 0.03, false);
}

void add_device(std::vector<Surface>& all, const StandingDevice& device) {
  const std::vector<Eigen::Isometry3d> frames = base_from_frames(device.model, device.joints_rad);
  const Eigen::Isometry3d& world = device.world_from_haptic.iso;
  const std::array<Vector3d, 2> paints{Vector3d(58, 60, 66), Vector3d(108, 112, 118)};
  for (std::size_t i = 0; i < device.model.prisms.size(); ++i) {
    const Prism& prism = device.model.prisms[i];
    const Eigen::Isometry3d world_from_prism = world * frames[prism.frame] * Eigen::Translation3d(prism.centre_m);
    all.push_back({Body::box(world_from_prism, prism.half_m), Label::Device, {paints[i % 2], 0.02, false, 0.3}});
  }
  const Cone& handle = device.model.handle;
  all.push_back({Body::cone(world * frames.back() * handle.from_m, world * frames.back() * handle.to_m,
                            handle.from_radius_m, handle.to_radius_m),
                 Label::Device,
                 {Vector3d(44, 48, 92), 0.02, false, 0.3}});
}

/// Palm and forearm as capsules, and four fingers and a thumb that end at the handle.
void add_hand(std::vector<Surface>& all, const HoldingHand& hand) {
  const Paint paint{Vector3d(hand.color[0], hand.color[1], hand.color[2]), 0.012, false, 0.35};
  const Vector3d along = hand.handle.v.normalized();
  const Vector3d out = (hand.arm.v - 0.3 * along * hand.arm.v.dot(along)).normalized();
  const Vector3d side = along.cross(out).normalized();
  const Vector3d palm = hand.grip.m + 0.045 * out;
  const auto capsule = [&](const Vector3d& from, const Vector3d& to, double from_radius_m, double to_radius_m) {
    all.push_back({Body::capsule(from, to, from_radius_m, to_radius_m), Label::Hand, paint});
  };
  capsule(palm, palm + 0.06 * out, 0.03, 0.034);
  capsule(palm + 0.06 * out, palm + 0.42 * hand.arm.v.normalized(), 0.03, 0.042);
  for (int finger = 0; finger < 4; ++finger) {
    const Vector3d knuckle = palm + side * (0.03 - 0.018 * finger) + 0.015 * along;
    const Vector3d middle = hand.grip.m + side * (0.024 - 0.012 * finger) + along * (0.03 - 0.014 * finger);
    capsule(knuckle, middle, 0.011, 0.009);
    capsule(middle, hand.grip.m + along * (0.012 - 0.014 * finger) - 0.006 * side, 0.009, 0.007);
  }
  capsule(palm - 0.03 * side, hand.grip.m - 0.012 * side - 0.01 * along, 0.013, 0.009);
}

std::uint8_t level(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

}  // namespace

Mask RenderedDesk::mask(Label label) const {
  Mask mask(color.width, color.height);
  for (std::size_t i = 0; i < labels.size(); ++i) mask.on[i] = labels[i] == label ? 1 : 0;
  return mask;
}

RenderedDesk render(const DeskScene& scene, const View& view, int threads) {
  std::vector<Surface> surfaces;
  add_background(surfaces, scene.printed_pages);
  if (scene.device) add_device(surfaces, *scene.device);
  for (const HoldingHand& hand : scene.hands) add_hand(surfaces, hand);
  const Intrinsics& lens = view.intrinsics;
  const std::size_t pixels = static_cast<std::size_t>(lens.width) * static_cast<std::size_t>(lens.height);
  RenderedDesk out{{lens.width, lens.height, std::vector<std::uint8_t>(3 * pixels)},
                   {lens.width, lens.height, 1e-4, std::vector<std::uint16_t>(pixels)},
                   std::vector<Label>(pixels, Label::Background)};
  program::for_each_parallel(lens.height, threads, [&](int y) {
    for (int x = 0; x < lens.width; ++x) {
      const Vector3d eye_ray((x - lens.cx) / lens.fx, (y - lens.cy) / lens.fy, 1.0);
      const Ray ray{view.world_from_eye.iso.translation(), view.world_from_eye.iso.linear() * eye_ray};
      Hit nearest;
      const Surface* seen = nullptr;
      for (const Surface& surface : surfaces)
        if (surface.body.meets(ray, nearest)) seen = &surface;
      if (seen == nullptr) continue;
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(lens.width) + static_cast<std::size_t>(x);
      const Vector3d at = ray.from + nearest.along * ray.to;
      const Vector3d color = scene.light * painted(seen->paint, at, nearest.normal);
      for (std::size_t c = 0; c < 3; ++c) out.color.rgb[3 * pixel + c] = level(color[static_cast<Eigen::Index>(c)]);
      out.labels[pixel] = seen->label;
      out.depth.samples[pixel] = static_cast<std::uint16_t>(std::min(nearest.along * 1e4, 65535.0));
    }
  });
  return out;
}

Transform<World, Eye> looking_at(const Point<World>& eye, const Point<World>& target) {
  const Vector3d forward = (target.m - eye.m).normalized();
  const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
  Transform<World, Eye> pose;
  pose.iso.linear() << right, forward.cross(right), forward;
  pose.iso.translation() = eye.m;
  return pose;
}

std::vector<View> head_views(const Intrinsics& lens, int count, double radius_m, double cone_rad, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const Vector3d middle(0.0, -0.62, 0.62);
  std::vector<View> views;
  while (static_cast<int>(views.size()) < count) {
    const Vector3d off(unit(random), unit(random), unit(random));
    const Vector3d eye = middle + radius_m * off;
    if (off.norm() > 1.0 || eye.z() < 0.12) continue;
    const Vector3d desk(0.0, 0.12, 0.05);
    const double aim_rad = 0.5 * cone_rad * unit(random) * 0.4, about_rad = std::numbers::pi * unit(random);
    const Vector3d forward = (desk - eye).normalized(), across = forward.unitOrthogonal();
    const Vector3d aim = Eigen::AngleAxisd(about_rad, forward) * Eigen::AngleAxisd(aim_rad, across) * forward;
    views.push_back({lens, looking_at({eye}, {Vector3d(eye + aim)})});
  }
  return views;
}

}  // namespace telepalp::mixed
