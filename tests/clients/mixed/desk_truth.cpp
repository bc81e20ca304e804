#include "tests/clients/mixed/desk_truth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "proto/words/demand.h"
#include "proto/words/numbers/quantile.h"
#include "proto/words/rotation_vector.h"
#include "support/program/parallel.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTurnAnAxis_rad = 0.5 * kDegree / std::numbers::sqrt3;

Vector3d normals(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

/// A random attitude of the device in a random view.
struct Pose {
  StandingDevice device;
  View view;
};

Pose random_pose(const Intrinsics& lens, std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.1, 0.9);
  Pose pose{standing_device(), head_views(lens, 1, 0.4, 0.2, random()).front()};
  for (std::size_t j = 0; j < pose.device.joints_rad.size(); ++j) {
    const Joint& joint = pose.device.model.joints[j];
    pose.device.joints_rad[j] = std::lerp(joint.least_rad, joint.most_rad, share(random));
  }
  return pose;
}

void add_outline_distances(const Mask& mask, const Mask& truth, double m_per_px, std::vector<double>& distances_m) {
  const std::vector<std::uint8_t> distance = distance_outside(truth, 80);
  for (int y = 1; y + 1 < mask.height; ++y)
    for (int x = 1; x + 1 < mask.width; ++x)
      if (mask.at(x, y) && !(mask.at(x - 1, y) && mask.at(x + 1, y) && mask.at(x, y - 1) && mask.at(x, y + 1)))
        distances_m.push_back(distance[mask.index(x, y)] / 3.0 * m_per_px);
}

double grey(const ColorImage& image, std::size_t pixel) {
  return 0.299 * image.rgb[3 * pixel] + 0.587 * image.rgb[3 * pixel + 1] + 0.114 * image.rgb[3 * pixel + 2];
}

double ssim_at(const ColorImage& a, const ColorImage& b, int x, int y) {
  constexpr int kHalf = 3;
  double mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
  for (int v = y - kHalf; v <= y + kHalf; ++v)
    for (int u = x - kHalf; u <= x + kHalf; ++u) {
      const auto pixel = static_cast<std::size_t>(v) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(u);
      const double ga = grey(a, pixel), gb = grey(b, pixel);
      mean_a += ga / 49.0;
      mean_b += gb / 49.0;
      aa += ga * ga / 49.0;
      bb += gb * gb / 49.0;
      ab += ga * gb / 49.0;
    }
  const double c1 = 6.5025, c2 = 58.5225;
  const double var_a = aa - mean_a * mean_a, var_b = bb - mean_b * mean_b, both = ab - mean_a * mean_b;
  return (2 * mean_a * mean_b + c1) * (2 * both + c2) /
         ((mean_a * mean_a + mean_b * mean_b + c1) * (var_a + var_b + c2));
}

}  // namespace

StandingDevice standing_device() { return desk_device({0.1, 0.55, 0.75, 0.2, -1.2, 0.0}); }

StandingDevice moved_device(StandingDevice device, const Vector3d& by_m) {
  device.world_from_haptic.iso.pretranslate(by_m);
  return device;
}

Overlap overlap_of(const Mask& mask, const Mask& truth) {
  std::size_t both = 0, only_mask = 0, only_truth = 0;
  for (std::size_t i = 0; i < mask.on.size(); ++i) {
    both += mask.on[i] != 0 && truth.on[i] != 0 ? 1 : 0;
    only_mask += mask.on[i] != 0 && truth.on[i] == 0 ? 1 : 0;
    only_truth += mask.on[i] == 0 && truth.on[i] != 0 ? 1 : 0;
  }
  const double true_count = static_cast<double>(both + only_truth);
  if (true_count == 0.0) return {};
  return {static_cast<double>(both) / true_count, static_cast<double>(only_mask) / true_count,
          static_cast<double>(both) / (true_count + static_cast<double>(only_mask))};
}

MaskMargin expected_margin() { return calibrated_margin(0.85e-3, kTurnAnAxis_rad, {kOmniWorkspace_m}); }

MaskFigures mask_figures(int count, const Intrinsics& lens, const MaskMargin& margin, bool arm_alone) {
  std::mt19937_64 random(20261127);
  MaskFigures figures;
  std::vector<double> distances_m;
  double seen = 0.0, covered = 0.0, more = 0.0;
  for (int i = 0; i < count; ++i) {
    Pose pose = random_pose(lens, random);
    auto& prisms = pose.device.model.prisms;
    if (arm_alone) prisms.erase(prisms.begin(), prisms.begin() + 2);
    const Mask truth = render({.device = pose.device}, pose.view, program::processors()).mask(Label::Device);
    const Eigen::Isometry3d error = Eigen::Translation3d(kOmniWorkspace_m) *
                                    isometry_of(kTurnAnAxis_rad * normals(random), 0.85e-3 * normals(random)) *
                                    Eigen::Translation3d(-kOmniWorkspace_m);
    StandingDevice believed = pose.device;
    believed.world_from_haptic.iso = believed.world_from_haptic.iso * error;
    const Mask mask = device_mask(believed, pose.view, margin);
    const Overlap overlap = overlap_of(mask, truth);
    const double pixels = static_cast<double>(truth.count());
    seen += pixels;
    covered += overlap.recall * pixels;
    more += overlap.too_much * pixels;
    if (pixels > 0.0) figures.least_recall = std::min(figures.least_recall, overlap.recall);
    const Vector3d middle = pose.device.world_from_haptic.iso * kOmniWorkspace_m;
    const double z_m = (pose.view.world_from_eye.iso.inverse() * middle).z();
    add_outline_distances(mask, truth, z_m / pose.view.intrinsics.fx, distances_m);
  }
  figures.recall = covered / seen;
  figures.too_much = more / seen;
  for (const double distance_m : distances_m) figures.mean_m += distance_m / static_cast<double>(distances_m.size());
  figures.furthest_m = quantile_of(distances_m, 0.95);
  return figures;
}

Transform<World, Eye> disturbed(const Transform<World, Eye>& pose, const PoseNoise& noise, std::uint64_t seed) {
  std::mt19937_64 random(seed * 977U + 5U);
  const Vector3d turn = noise.turn_rad * normals(random), move = noise.at_m * normals(random);
  return {pose.iso * isometry_of(turn, move)};
}

Background desk_background(const Intrinsics& lens, int count, ProxyKind kind, const PoseNoise& noise,
                           bool printed_pages, int threads) {
  std::vector<SourceImage> sources;
  for (const View& view : head_views(lens, count, 0.5, std::numbers::pi / 2.0, 121)) {
    SourceImage source{view, render({.printed_pages = printed_pages}, view, threads).color};
    source.view.world_from_eye = disturbed(view.world_from_eye, noise, sources.size());
    sources.push_back(std::move(source));
  }
  Proxy proxy = kind == ProxyKind::Planes ? desk_planes() : desk_depths(printed_pages, threads);
  Result<Background> background = Background::prepare(std::move(sources), std::move(proxy));
  demand(background.ok(), "the rendered desk is a background");
  return std::move(*background);
}

double psnr_db(const ColorImage& image, const ColorImage& truth, const Mask& where) {
  double squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < where.on.size(); ++i) {
    if (where.on[i] == 0) continue;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) squares += std::pow(double{1} * image.rgb[c] - truth.rgb[c], 2);
    count += 3.0;
  }
  return 10.0 * std::log10(255.0 * 255.0 / std::max(squares / count, 1e-9));
}

double ssim(const ColorImage& image, const ColorImage& truth, const Mask& where) {
  double sum = 0.0, count = 0.0;
  for (int y = 3; y + 3 < where.height; ++y)
    for (int x = 3; x + 3 < where.width; ++x)
      if (where.at(x, y)) {
        sum += ssim_at(image, truth, x, y);
        count += 1.0;
      }
  return sum / count;
}

double border_step(const ColorImage& image, const ColorImage& truth, const Mask& where) {
  double sum = 0.0, count = 0.0;
  const auto add = [&](int x, int y, int u, int v) {
    if (where.at(x, y) == where.at(u, v)) return;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t a = 3 * where.index(x, y) + c, b = 3 * where.index(u, v) + c;
      sum += std::abs((image.rgb[a] - truth.rgb[a]) - (image.rgb[b] - truth.rgb[b]));
      count += 1.0;
    }
  };
  for (int y = 0; y + 1 < where.height; ++y)
    for (int x = 0; x + 1 < where.width; ++x) {
      add(x, y, x + 1, y);
      add(x, y, x, y + 1);
    }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace telepalp::mixed
