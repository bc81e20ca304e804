#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "haptic_station/solids/polish.h"
#include "haptic_station/solids/solid_proxy.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A hand slides over creases, corners, edges and blends. Measures whether the force follows the hand without steps, and
// whether the proxy is where an independent projection, or the same hand in steps 100 times as fine, puts it.

namespace telepalp::bench::hand {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using solids::SolidProxy;
using solids::SolidTree;

constexpr double kSolid_N_per_m = 1200.0;
constexpr double kFastest_m_per_s = 0.3;

std::shared_ptr<const SolidTree> tree_of(const std::string& text) {
  return *solids::build_tree(*solids::parse_polish(text, "crease"));
}

std::string text_of(const Vector3d& v) {
  return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
}

/// A hand that wanders about the origin within `reach_m`, at up to kFastest_m_per_s: three sine waves on each axis.
class Wandering {
 public:
  Wandering(std::uint64_t seed, double reach_m) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> turn(0.0, 2.0 * std::numbers::pi);
    std::uniform_real_distribution<double> pace(2.0, 9.0);
    for (auto& axis : waves_)
      for (Wave& wave : axis) wave = {reach_m / 3.0, pace(random), turn(random)};
  }
  [[nodiscard]] Vector3d at(double t) const {
    Vector3d sum = Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis)
      for (const Wave& wave : waves_[static_cast<std::size_t>(axis)])
        sum[axis] += wave.high_m * std::sin(wave.rad_per_s * t + wave.phase_rad);
    return sum;
  }

 private:
  struct Wave {
    double high_m;
    double rad_per_s;
    double phase_rad;
  };
  std::array<std::array<Wave, 3>, 3> waves_{};
};

/// The free room of a crease or corner: n . x >= offset for each plane.
struct Room {
  std::vector<Vector3d> normals;
  std::vector<double> offsets_m;

  [[nodiscard]] std::string polish() const {
    std::string text;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (i + 1 < normals.size()) text += "+ ";
      text += "plane " + text_of(normals[i]) + " " + std::to_string(offsets_m[i]) + " ";
    }
    return text;
  }
};

/// `planes` walls around an axis; `opening_rad`: angle between opposite walls. They meet in a point, or each is moved
/// by up to 4 mm.
Room room_of(int planes, double opening_rad, bool in_a_point, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const Matrix3d turn = Eigen::Quaterniond(Eigen::Vector4d(unit(random), unit(random), unit(random), unit(random)))
                            .normalized()
                            .toRotationMatrix();
  Room room;
  for (int i = 0; i < planes; ++i) {
    const double around = 2.0 * std::numbers::pi * (i + (planes > 2 ? 0.3 * unit(random) : 0.0)) / planes;
    const double half = 0.5 * opening_rad;
    const Vector3d inwards(-std::cos(half) * std::cos(around), -std::cos(half) * std::sin(around), std::sin(half));
    Vector3d normal = turn * inwards;
    for (double& n : normal) n = std::round(1e6 * n) / 1e6;  // as the text has it
    const double offset = in_a_point ? 0.0 : std::round(1e6 * 0.004 * unit(random)) / 1e6;
    room.normals.push_back(normal.normalized());
    room.offsets_m.push_back(offset / normal.norm());
  }
  return room;
}

/// The point of the room nearest to `p`, by coordinate ascent on the multipliers (Hildreth 1957): shares nothing with
/// the search that is judged.
Vector3d projected(const Room& room, const Vector3d& p) {
  std::vector<double> push(room.normals.size(), 0.0);
  Vector3d at = p;
  for (int round = 0; round < 1'000'000; ++round) {
    double changed = 0.0;
    for (std::size_t i = 0; i < push.size(); ++i) {
      const double more = std::max(-push[i], room.offsets_m[i] - room.normals[i].dot(at));
      push[i] += more;
      at += more * room.normals[i];
      changed = std::max(changed, std::abs(more));
    }
    if (changed < 1e-14) break;
  }
  return at;
}

struct CreaseResult {
  double step_N = 0.0;
  double off_m = 0.0;
  double touched = 0.0;  ///< share of the ticks in which the hand was in a wall
};

CreaseResult slide_in(const Room& room, std::uint64_t seed, int steps) {
  constexpr int kChecked = 200;  // every so many steps the projection is computed
  const auto tree = tree_of(room.polish());
  const Wandering hand(seed, 0.02);
  SolidProxy proxy;
  Vector3d device =
      0.05 * std::accumulate(room.normals.begin(), room.normals.end(), Vector3d(0.0, 0.0, 0.0)).normalized();
  Vector3d before_N = Vector3d::Zero();
  CreaseResult result;
  for (int i = 0; i < steps; ++i) {
    const Vector3d wanted = hand.at(i * kTick_s);
    const Vector3d way = wanted - device;
    const double most_m = kFastest_m_per_s * kTick_s;
    const Vector3d moved = way.norm() > most_m ? Vector3d(most_m * way.normalized()) : way;
    device += moved;
    const solids::ProxyAt at = proxy.step(*tree, device);
    const Vector3d now_N = kSolid_N_per_m * at.depth_m * at.outwards;
    if (i > 0) result.step_N = std::max(result.step_N, (now_N - before_N).norm() - kSolid_N_per_m * moved.norm());
    before_N = now_N;
    result.touched += at.depth_m > 0.0 ? 1.0 / steps : 0.0;
    if (i % kChecked == 0) result.off_m = std::max(result.off_m, (at.at - projected(room, device)).norm());
  }
  return result;
}

std::vector<Row> measure_creases(int planes, const Options& options) {
  constexpr int kRooms = 50;
  constexpr int kSteps = 5000;  // in all rooms of the four studies: 10^6
  std::array<CreaseResult, kRooms> results{};
  for_each_parallel(kRooms, options, [&](int i) {
    std::mt19937_64 random(static_cast<std::uint64_t>(1000 * planes + i));
    const double opening_deg = 10.0 + 160.0 * i / (kRooms - 1);
    const Room room = room_of(planes, opening_deg * std::numbers::pi / 180.0, i % 2 == 0, random);
    results[static_cast<std::size_t>(i)] = slide_in(room, static_cast<std::uint64_t>(i + 1), kSteps);
  });
  CreaseResult worst{.touched = 1.0};
  for (const CreaseResult& one : results) {
    worst.touched = std::min(worst.touched, one.touched);
    worst.step_N = std::max(worst.step_N, one.step_N);
    worst.off_m = std::max(worst.off_m, one.off_m);
  }
  const bool touched = worst.touched > 0.2;
  const std::string name = "crease/" + std::to_string(planes) + " half-spaces";
  return {at_most(name + ", opening 10 to 170 degrees: force step in a tick beyond K times the motion, worst",
                  touched ? worst.step_N : NAN, "N", 0.02),
          at_most(name + ", opening 10 to 170 degrees: proxy off the exact projection, worst",
                  touched ? 1e6 * worst.off_m : NAN, "um", 5.0)};
}

struct Edge {
  const char* name;
  const char* solid;
};
constexpr Edge kEdges[] = {
    {"box", "box 0.02 0.02 0.02"},
    {"box in a ball", "* box 0.02 0.02 0.02 sphere 0.026"},
    {"clipped ball", "clip 0 1 0.3 0.005 sphere 0.025"},
    {"drilled block", "- box 0.025 0.02 0.025 cylindery 0.006 0.03"},
    {"cut block", "- box 0.025 0.02 0.025 tr 0.02 0.02 0 box 0.015 0.012 0.03"},
    {"blended balls", "blend 0.01 tr -0.015 0 0 sphere 0.018 tr 0.015 0 0 sphere 0.018"},
    {"blended box", "blend 0.008 box 0.02 0.01 0.02 tr 0 0.012 0 sphere 0.012"},
    {"turned cylinder", "ro 33 1 2 3 cylinderz 0.02 0.012"},
};

/// The largest distance between the proxies of one path in steps of a tick and in steps 100 times as fine; NaN if the
/// hand was in the solid for less than a quarter of the time.
double off_finer_m(const Edge& edge, std::uint64_t seed) {
  constexpr int kTicks = 6000;
  constexpr int kFiner = 100;
  constexpr double kDeep_m = 0.003;
  constexpr double kFar_m = 0.06;
  const auto tree = tree_of(edge.solid);
  const Wandering turning(seed, 1.0);
  // The hand wanders over the solid, some 3 mm below its surface, so that it passes edges from all sides.
  const auto wanted_at = [&](double t) {
    const Vector3d direction = turning.at(0.15 * t).normalized();
    double out_m = kFar_m;
    for (int i = 0; i < 100; ++i)
      out_m = std::max(0.0, out_m - 0.5 * (solids::solid_at(*tree, out_m * direction).m + kDeep_m));
    return Vector3d(out_m * direction);
  };
  SolidProxy coarse;
  SolidProxy fine;
  double worst_m = 0.0;
  int touched = 0;
  Vector3d device = kFar_m * turning.at(0.0).normalized();
  for (int i = 1; i <= kTicks; ++i) {
    const Vector3d before = device;
    const Vector3d way = wanted_at(i * kTick_s) - device;
    device += way * std::min(1.0, kFastest_m_per_s * kTick_s / way.norm());
    solids::ProxyAt exact;
    for (int j = 1; j <= kFiner; ++j) exact = fine.step(*tree, before + (device - before) * j / kFiner);
    worst_m = std::max(worst_m, (coarse.step(*tree, device).at - exact.at).norm());
    touched += exact.depth_m > 0.0 ? 1 : 0;
  }
  return touched > kTicks / 4 ? worst_m : NAN;
}

std::vector<Row> measure_edges(const Options& options) {
  constexpr int kPaths = 6;
  const auto edges = static_cast<int>(std::size(kEdges));
  std::vector<double> off_m(static_cast<std::size_t>(kPaths * edges));
  for_each_parallel(kPaths * edges, options, [&](int i) {
    off_m[static_cast<std::size_t>(i)] = off_finer_m(kEdges[i % edges], static_cast<std::uint64_t>(1 + i / edges));
  });
  std::vector<Row> rows;
  for (int edge = 0; edge < edges; ++edge) {
    double worst_m = 0.0;
    int touched = 0;
    for (int path = 0; path < kPaths; ++path) {
      const double one_m = off_m[static_cast<std::size_t>(path * edges + edge)];
      touched += std::isnan(one_m) ? 0 : 1;  // a hand that stays in a hole touches nothing
      worst_m = std::isnan(one_m) ? worst_m : std::max(one_m, worst_m);
    }
    rows.push_back(at_most(std::string("edge/") + kEdges[edge].name + ": proxy off a run 100 times as fine, worst",
                           touched > kPaths / 2 ? 1e6 * worst_m : NAN, "um", 20.0));
  }
  return rows;
}

}  // namespace

std::vector<Study> creases() {
  std::vector<Study> studies;
  for (const int planes : {2, 3, 4, 6})
    studies.push_back({"crease/" + std::to_string(planes) + " half-spaces",
                       [planes](const Options& options) { return measure_creases(planes, options); }});
  studies.push_back({"edge", measure_edges});
  return studies;
}

}  // namespace telepalp::bench::hand
