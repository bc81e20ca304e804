#include "tests/haptic_station/surface/analytic_surface.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "support/sensor/depth_sensor.h"

namespace telepalp::testing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class Plane final : public AnalyticSurface {
 public:
  Plane(const Vector3d& at, const Vector3d& normal) : at_(at), normal_(normal.normalized()) {}
  std::string name() const override { return "plane"; }
  double depth_along(double x, double y) const override {
    const double facing = normal_.dot(Vector3d(x, y, 1.0));
    return facing < -1e-9 ? normal_.dot(at_) / facing : 0.0;
  }
  TrueFoot foot(const Vector3d& query) const override {
    const double distance = normal_.dot(query - at_);
    return {query - distance * normal_, normal_, distance};
  }

 private:
  Vector3d at_;
  Vector3d normal_;
};

class Sphere final : public AnalyticSurface {
 public:
  Sphere(const Vector3d& centre, double radius) : centre_(centre), radius_(radius) {}
  std::string name() const override { return "sphere"; }
  double depth_along(double x, double y) const override {
    const Vector3d ray(x, y, 1.0);
    const double b = ray.dot(centre_);
    const double c = centre_.squaredNorm() - radius_ * radius_;
    const double discriminant = b * b - ray.squaredNorm() * c;
    return discriminant < 0.0 ? 0.0 : (b - std::sqrt(discriminant)) / ray.squaredNorm();
  }
  TrueFoot foot(const Vector3d& query) const override {
    const Vector3d normal = (query - centre_).normalized();
    return {centre_ + radius_ * normal, normal, (query - centre_).norm() - radius_};
  }

 private:
  Vector3d centre_;
  double radius_;
};

class Torus final : public AnalyticSurface {
 public:
  Torus(const Vector3d& centre, double ring, double tube) : centre_(centre), ring_(ring), tube_(tube) {}
  std::string name() const override { return "torus"; }
  double depth_along(double x, double y) const override {
    const Vector3d ray(x, y, 1.0);
    double z = std::max(0.0, (centre_.norm() - ring_ - tube_) / ray.norm());
    for (int step = 0; step < 400; ++step) {  // sphere tracing
      const double distance = foot(z * ray).distance_m;
      if (std::abs(distance) < 1e-9) return z;
      z += distance / ray.norm();
      if (z > centre_.z() + ring_ + tube_) return 0.0;
    }
    return 0.0;
  }
  TrueFoot foot(const Vector3d& query) const override {
    const Vector3d from = query - centre_;
    const double across = std::hypot(from.x(), from.y());
    const Vector3d ring = across > 0.0 ? Vector3d(from.x() / across, from.y() / across, 0.0) : Vector3d(1.0, 0.0, 0.0);
    const Vector3d spoke = from - ring_ * ring;
    const Vector3d normal = spoke.normalized();
    return {centre_ + ring_ * ring + tube_ * normal, normal, spoke.norm() - tube_};
  }

 private:
  Vector3d centre_;
  double ring_;
  double tube_;
};

struct Height {
  double z = 0.0;
  Vector2d slope = Vector2d::Zero();
  Eigen::Matrix2d bend = Eigen::Matrix2d::Zero();
};

class HeightField final : public AnalyticSurface {
 public:
  HeightField(std::string name, std::function<Height(double, double)> height)
      : name_(std::move(name)), height_(std::move(height)) {}
  std::string name() const override { return name_; }
  double depth_along(double x, double y) const override {
    double z = height_(0.0, 0.0).z;
    for (int step = 0; step < 60; ++step) {
      const Height h = height_(x * z, y * z);
      const double change = (h.z - z) / (1.0 - h.slope.dot(Vector2d(x, y)));
      z += std::clamp(change, -0.05, 0.05);
      if (std::abs(change) < 1e-10) break;
    }
    return z;
  }
  TrueFoot foot(const Vector3d& query) const override {
    Vector2d at = query.head<2>();
    for (int step = 0; step < 60; ++step) {
      const Height h = height_(at.x(), at.y());
      const double gap = h.z - query.z();
      const Vector2d pull = (at - query.head<2>()) + gap * h.slope;
      Eigen::Matrix2d hessian = Eigen::Matrix2d::Identity() + h.slope * h.slope.transpose() + gap * h.bend;
      if (hessian.determinant() < 0.1 || hessian(0, 0) < 0.1)
        hessian = Eigen::Matrix2d::Identity() + h.slope * h.slope.transpose();
      const Vector2d change = -hessian.inverse() * pull;
      at += change.norm() > 0.01 ? Vector2d(change * (0.01 / change.norm())) : change;
      if (change.norm() < 1e-12) break;
    }
    const Height h = height_(at.x(), at.y());
    const Vector3d foot(at.x(), at.y(), h.z);
    const Vector3d normal = Vector3d(h.slope.x(), h.slope.y(), -1.0).normalized();
    return {foot, normal, normal.dot(query - foot)};
  }

 private:
  std::string name_;
  std::function<Height(double, double)> height_;
};

}  // namespace

std::unique_ptr<AnalyticSurface> plane(const Vector3d& at, const Vector3d& normal) {
  return std::make_unique<Plane>(at, normal);
}
std::unique_ptr<AnalyticSurface> sphere(const Vector3d& centre, double radius_m) {
  return std::make_unique<Sphere>(centre, radius_m);
}
std::unique_ptr<AnalyticSurface> torus(const Vector3d& centre, double ring_m, double tube_m) {
  return std::make_unique<Torus>(centre, ring_m, tube_m);
}
std::unique_ptr<AnalyticSurface> saddle(double z0, double bend) {
  return std::make_unique<HeightField>("saddle", [=](double x, double y) {
    Height h{z0 - 0.5 * bend * (x * x - y * y), Vector2d(-bend * x, bend * y), Eigen::Matrix2d::Zero()};
    h.bend.diagonal() << -bend, bend;
    return h;
  });
}
std::unique_ptr<AnalyticSurface> gaussian_bump(double z0, double height, double width) {
  return std::make_unique<HeightField>("Gaussian bump", [=](double x, double y) {
    const double w2 = width * width;
    const double bump = height * std::exp(-(x * x + y * y) / (2.0 * w2));
    Height h{z0 - bump, Vector2d(bump * x / w2, bump * y / w2), Eigen::Matrix2d::Zero()};
    h.bend << bump / w2 - bump * x * x / (w2 * w2), -bump * x * y / (w2 * w2), -bump * x * y / (w2 * w2),
        bump / w2 - bump * y * y / (w2 * w2);
    return h;
  });
}
std::unique_ptr<AnalyticSurface> crease(double z0, double slope) {
  return std::make_unique<HeightField>("crease", [=](double x, double) {
    return Height{z0 - std::abs(x) * slope, Vector2d(x < 0.0 ? slope : -slope, 0.0), Eigen::Matrix2d::Zero()};
  });
}

Intrinsics camera_with_spacing(double z_m, double spacing_m) {
  return {.width = 640, .height = 480, .fx = z_m / spacing_m, .fy = z_m / spacing_m, .cx = 319.5, .cy = 239.5};
}
Intrinsics kinect_camera() { return {.width = 640, .height = 480, .fx = 575.0, .fy = 575.0, .cx = 319.5, .cy = 239.5}; }

DepthImage render(const AnalyticSurface& surface, const Intrinsics& camera, const RenderSettings& settings) {
  DepthImage image{.width = camera.width, .height = camera.height, .unit_m = settings.unit_m, .samples = {}};
  image.samples.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const double z = surface.depth_along((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy);
      const double steps = std::round(z / settings.unit_m);
      image.samples.push_back(steps > 0.0 && steps < 65536.0 ? static_cast<std::uint16_t>(steps) : std::uint16_t{0});
    }
  return settings.sigma_m > 0.0 || settings.hole_share > 0.0 ? with_noise(image, settings) : image;
}

DepthImage with_noise(const DepthImage& clean, const RenderSettings& settings) {
  DepthImage noisy = clean;
  const sensor::DepthSensor camera({.noise = sensor::DepthNoise::Gaussian,
                                    .gaussian_sigma_m = settings.sigma_m,
                                    .disparity_steps = false,
                                    .unit_m = clean.unit_m,
                                    .seed = settings.seed});
  const sensor::Exposure exposure = camera.expose(0);
  for (std::size_t i = 0; i < noisy.samples.size(); ++i) {
    std::uint16_t& sample = noisy.samples[i];
    if (sample == 0) continue;
    const std::uint32_t bits = exposure.bits(static_cast<std::uint32_t>(i));
    const bool hole = static_cast<double>(bits >> 24U) < 256.0 * settings.hole_share;
    const auto z_m = static_cast<float>(sample * clean.unit_m);
    sample = hole ? std::uint16_t{0} : exposure.sample_of(z_m, bits);
  }
  return noisy;
}

}  // namespace telepalp::testing
