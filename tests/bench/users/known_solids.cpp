#include "tests/bench/users/known_solids.h"

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

double ball(double r) { return 4.0 / 3.0 * pi * r * r * r; }
double ring(double ring_radius, double tube) { return 2.0 * pi * pi * ring_radius * tube * tube; }

/// Volume of the part of a box about `center` in which `inside` holds, from 4 million random points. [m^3]
double monte_carlo(const Vector3d& center, const Vector3d& half, const std::function<bool(const Vector3d&)>& inside) {
  constexpr int kPoints = 4'000'000;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int count = 0;
  for (int i = 0; i < kPoints; ++i) {
    const Vector3d at(share(random), share(random), share(random));
    count += inside(center + at.cwiseProduct(half)) ? 1 : 0;
  }
  return 8.0 * half.prod() * count / kPoints;
}

/// Distance to the line from a to b.
double from_line(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - along * (b - a)).norm();
}

/// Two crossed rods, joined by the quadratic smooth minimum of width w.
double blended_cross() {
  constexpr double w = 0.02;
  return monte_carlo(Vector3d::Zero(), Vector3d(0.065, 0.065, 0.02), [](const Vector3d& p) {
    const double a = from_line(p, {-0.05, 0, 0}, {0.05, 0, 0}) - 0.01;
    const double b = from_line(p, {0, -0.05, 0}, {0, 0.05, 0}) - 0.01;
    const double share = std::max(0.0, w - std::abs(a - b)) / w;
    return std::min(a, b) - 0.25 * w * share * share < 0.0;
  });
}

bool in_ring(const Vector3d& p, double ring_radius, double tube) {  // about z
  const double off = std::hypot(p.x(), p.y()) - ring_radius;
  return off * off + p.z() * p.z() < tube * tube;
}

double half_ring() {
  return monte_carlo({-0.0615, 0, 0}, {0.0516, 0.1131, 0.0081},
                     [](const Vector3d& p) { return p.x() < -0.01 && in_ring(p, 0.105, 0.008); });
}

/// 25 rings in a square lattice; each overlaps its neighbours.
double ring_lattice() {
  return monte_carlo({0.044, 0.044, 0}, {0.0561, 0.0561, 0.00201}, [](const Vector3d& p) {
    for (int i = 0; i < 25; ++i)
      if (in_ring(p - Vector3d(0.022 * (i % 5), 0.022 * (i / 5), 0.0), 0.01, 0.002)) return true;
    return false;
  });
}

std::string joined(const std::vector<std::string>& solids) {
  std::string text;
  for (std::size_t i = 0; i < solids.size(); ++i) text += (i + 1 < solids.size() ? "+ " : "") + solids[i] + " ";
  return text;
}

/// `solid` at the n x n points of a lattice in two axes, or the n^3 points in three.
std::string lattice(const std::string& solid, int n, double step, const char* axes) {
  std::vector<std::string> all;
  const std::string_view names(axes);
  const int count = names.size() == 3 ? n * n * n : n * n;
  for (int i = 0; i < count; ++i) {
    double at[3] = {0.0, 0.0, 0.0};
    int rest = i;
    for (const char axis : names) {
      at[axis - 'x'] = step * (rest % n);
      rest /= n;
    }
    all.push_back("tr " + std::to_string(at[0]) + " " + std::to_string(at[1]) + " " + std::to_string(at[2]) + " " +
                  solid);
  }
  return joined(all);
}

constexpr const char* kS2Rings =
    "tr 0.5 0.35 0.015 tx -0.6 -0.3 -0.06 -30 0 0 1 + tr -0.03 0.0 0.0 torusx 0.182 0.009 "
    "+ tr -0.01 0.0 0.0 torusx 0.184 0.01 tr 0.01 0.0 0.0 torusx 0.186 0.01";

double bored_cube() {
  constexpr double r = 0.01, side = 0.08;
  return side * side * side - 3.0 * pi * r * r * side + 8.0 * std::numbers::sqrt2 * r * r * r;
}

std::vector<KnownSolid> smooth_solids() {
  return {
      {"ball", "sphere 0.05", 1, 2, ball(0.05)},
      {"ring", "torusy 0.05 0.02", 1, 0, ring(0.05, 0.02)},
      {"S2's rings", kS2Rings, 3, 0, ring(0.182, 0.009) + ring(0.184, 0.01) + ring(0.186, 0.01)},
      {"two linked rings", "+ torusx 0.03 0.005 tr 0 0.03 0 torusz 0.03 0.005", 2, 0, 2.0 * ring(0.03, 0.005)},
      {"scaled arc of 320 degrees", "sc 0.001 tx 100 20 30 40 1 2 3 arcz 100 4 20 340", 1, 2,
       320.0 / 360.0 * ring(0.1, 0.004) + ball(0.004)},
      {"balls on a wire of 1 mm",
       "+ tr 0.05 0 0 sphere 0.01 + tr -0.05 0 0 sphere 0.01 capsule -0.05 0 0 0.05 0 0 0.0005", 1, 2,
       2.0 * ball(0.01) + pi * 0.0005 * 0.0005 * 0.08},
      {"blended cross", "blend 0.02 capsule -0.05 0 0 0.05 0 0 0.01 capsule 0 -0.05 0 0 0.05 0 0.01", 1, 2,
       blended_cross()},
      {"lattice of 25 rings", lattice("torusz 0.01 0.002", 5, 0.022, "xy"), 1, -80, ring_lattice()},
      {"shell of 2 mm", "- sphere 0.05 sphere 0.048", 2, 4, ball(0.05) - ball(0.048)},
      {"four nested surfaces", "- sphere 0.05 - sphere 0.045 - sphere 0.04 sphere 0.03", 4, 8,
       ball(0.05) - ball(0.045) + ball(0.04) - ball(0.03)},
  };
}

std::vector<KnownSolid> sharp_solids() {
  return {
      {"turned box", "tx 0.1 0.2 0.3 30 1 2 3 box 0.05 0.03 0.02", 1, 2, 8.0 * 0.05 * 0.03 * 0.02},
      {"plate of 0.8 mm", "box 0.05 0.0004 0.05", 1, 2, 0.1 * 0.1 * 0.0008},
      {"half a rib", "clip 1 0 0 -0.01 torusz 0.105 0.008", 1, 2, half_ring()},
      {"cube with three bores", "- box 0.04 0.04 0.04 + cylinderx 0.01 0.05 + cylindery 0.01 0.05 cylinderz 0.01 0.05",
       1, -8, bored_cube()},
      {"two crossed cylinders' common part", "* cylinderx 0.02 0.05 cylindery 0.02 0.05", 1, 2,
       16.0 / 3.0 * 0.02 * 0.02 * 0.02},
      {"lens of two balls", "* tr 0.0433 0 0 sphere 0.05 tr -0.0433 0 0 sphere 0.05", 1, 2,
       pi * (4.0 * 0.05 + 0.0866) * (0.1 - 0.0866) * (0.1 - 0.0866) / 12.0},
      {"cube with 27 hollows", "- box 0.05 0.05 0.05 tr -0.03 -0.03 -0.03 " + lattice("sphere 0.008", 3, 0.03, "xyz"),
       28, 56, 1e-3 - 27.0 * ball(0.008)},
      {"plate with 81 holes", "- box 0.1 0.001 0.1 tr -0.08 0 -0.08 " + lattice("cylindery 0.004 0.01", 9, 0.02, "xz"),
       1, -160, 0.2 * 0.2 * 0.002 - 81.0 * pi * 0.004 * 0.004 * 0.002},
      {"pipe with a wall of 1 mm", "- cylindery 0.02 0.05 cylindery 0.019 0.06", 1, 0,
       pi * (0.02 * 0.02 - 0.019 * 0.019) * 0.1},
      {"slot of 0.4 mm", "- box 0.03 0.03 0.03 box 0.0002 0.02 0.04", 1, 0, 0.06 * 0.06 * 0.06 - 0.0004 * 0.04 * 0.06},
  };
}

}  // namespace

std::vector<KnownSolid> known_solids() {
  std::vector<KnownSolid> all = smooth_solids();
  for (KnownSolid& solid : sharp_solids()) all.push_back(std::move(solid));
  return all;
}

std::vector<KnownSolid> solids_without_mesh() {
  return {{"balls that touch at a point", "+ sphere 0.02 tr 0.04 0 0 sphere 0.02", 0, 0, 0.0},
          {"a half-space", "plane 0 1 0 -0.05", 0, 0, 0.0},
          {"two balls' empty common part", "* sphere 0.02 tr 0.1 0 0 sphere 0.02", 0, 0, 0.0}};
}

}  // namespace telepalp::bench
