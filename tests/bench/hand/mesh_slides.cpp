#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "haptic_station/surface/cloud/static_model.h"
#include "haptic_station/surface/cloud/winding_number.h"
#include "haptic_station/surface/touch/touch.h"
#include "support/program/files/shipped.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"
#include "where.h"

// A hand presses a mesh 2 mm deep and slides 40 mm over the surface that it feels. This study measures whether the
// force follows the hand without steps, whether the hand stays outside the mesh, and the share of the surface with
// walls that telepalp reports as too thin for its samples.

namespace telepalp::bench::hand {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using Eigen::Vector3f;
using models::PointModel;
using surface::CloudPoint;

constexpr double kMesh_N_per_m = 800.0;
constexpr double kSlides_m_per_s = 0.05;
constexpr double kDeep_m = 0.002;
constexpr double kLong_m = 0.04;
constexpr double kMostStep_N = 0.1;
constexpr int kSlides = 200;
constexpr std::size_t kTruthPoints = 300'000;
constexpr double kThrough_m = 0.003;  // a hand that is deeper inside the mesh has gone through its surface

struct Body {
  std::string name;
  PointModel mesh;
};

/// A mug as a stereo camera's fused mesh has it: 80 mm wide, 95 mm high, a wall of 3 mm, a bottom of 4 mm.
PointModel mug() {
  constexpr int kAround = 180;
  // The profile from the middle of the outer bottom, out, up, over the rim, down inside to the middle.
  std::vector<std::array<double, 2>> profile;
  const auto line_to = [&](double r, double h) {
    const std::array<double, 2> from = profile.back();
    const int parts = std::max(1, static_cast<int>(std::hypot(r - from[0], h - from[1]) / 0.0015));
    for (int i = 1; i <= parts; ++i)
      profile.push_back({from[0] + (r - from[0]) * i / parts, from[1] + (h - from[1]) * i / parts});
  };
  profile.push_back({1e-4, 0.0});
  line_to(0.038, 0.0);
  line_to(0.040, 0.002);
  line_to(0.040, 0.094);
  for (int i = 1; i <= 8; ++i) {
    const double turn = std::numbers::pi * i / 8.0;
    profile.push_back({0.0385 + 0.0015 * std::cos(turn), 0.094 + 0.0015 * std::sin(turn)});
  }
  line_to(0.037, 0.006);
  line_to(0.035, 0.004);
  line_to(1e-4, 0.004);
  PointModel mesh;
  for (const auto& [r, h] : profile)
    for (int i = 0; i < kAround; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kAround;
      mesh.points.emplace_back(static_cast<float>(r * std::cos(turn)), static_cast<float>(r * std::sin(turn)),
                               static_cast<float>(h));
    }
  const auto at = [](std::size_t row, int column) {
    return static_cast<std::uint32_t>(row * kAround + static_cast<std::size_t>(column % kAround));
  };
  for (std::size_t row = 0; row + 1 < profile.size(); ++row)
    for (int i = 0; i < kAround; ++i) {
      mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i)});
      mesh.triangles.push_back({at(row, i + 1), at(row + 1, i + 1), at(row + 1, i)});
    }
  return mesh;
}

/// The truth: on which side of the mesh a point lies, and how far from it.
struct Truth {
  surface::WindingNumber winding;
  std::shared_ptr<const surface::NeighborIndex> near;
  Vector3d origin_m;

  [[nodiscard]] bool has_gone_through(const Vector3d& at_m) const {
    const Vector3d local = at_m - origin_m;
    std::array<surface::Neighbor, 1> nearest;
    return near->within(local.cast<float>(), static_cast<float>(kThrough_m), nearest) == 0 && winding.at(local) > 0.5;
  }
};

struct Slide {
  double step_N = 0.0;  ///< greatest change of the force in a tick, minus stiffness times motion
  Vector3d step_at = Vector3d::Zero();
  double way_m = 0.0;      ///< length of the way in contact
  double through_s = 0.0;  ///< time inside the mesh by more than kThrough_m without force
};

/// A hand that slides over the surface that it feels, and presses to a depth of kDeep_m.
struct SlidingHand {
  Vector3d at;
  Vector3d along;  ///< unit, direction of the slide
  Vector3d out;    ///< unit, normal of the felt surface

  /// Moves the hand by one tick, and returns its movement. `slides`: false while it only comes nearer.
  Vector3d moves(bool slides, double depth_m) {
    along = (along - along.dot(out) * out).normalized();
    const double down = std::clamp((kDeep_m - depth_m) / 0.001, -0.7, 0.7);
    const Vector3d way = slides ? Vector3d(std::sqrt(1.0 - down * down) * along - down * out) : Vector3d(-out);
    const Vector3d moved = kSlides_m_per_s * kTick_s * way;
    at += moved;
    return moved;
  }
};

Slide slide_over(const surface::SurfaceSnapshot& model, const Truth& truth, const CloudPoint& place, double turn_rad) {
  constexpr int kMostTicks = 2400;
  const Vector3d out = place.normal.cast<double>();
  SlidingHand hand{truth.origin_m + place.at_m.cast<double>() + 0.003 * out,
                   Eigen::AngleAxisd(turn_rad, out) * out.unitOrthogonal(), out};
  surface::Touch touch;
  touch.adopt(model, at_time(0.0));
  Slide slide;
  Vector3d before_N = Vector3d::Zero();
  bool slides = false;
  double depth_m = 0.0;
  for (int i = 0; i < kMostTicks && slide.way_m < kLong_m; ++i) {
    const Vector3d moved = hand.moves(slides, depth_m);
    const surface::TouchSample felt = touch.step({hand.at}, at_time(i * kTick_s), kTick_s);
    const Vector3d now_N = kMesh_N_per_m * (felt.proxy.m - hand.at);
    const double step_N = i == 0 ? 0.0 : (now_N - before_N).norm() - kMesh_N_per_m * moved.norm();
    if (step_N > slide.step_N) {
      slide.step_N = step_N;
      slide.step_at = hand.at;
    }
    before_N = now_N;
    depth_m = felt.in_body ? (felt.foot.m - hand.at).norm() : 0.0;
    if (felt.in_body) hand.out = felt.normal;
    slides = slides || depth_m >= kDeep_m;
    if (slides && felt.in_body) slide.way_m += moved.norm();
    if (now_N.norm() < 0.1 && truth.has_gone_through(hand.at)) slide.through_s += kTick_s;
  }
  return slide;
}

/// `mesh` with its points relative to their mean, as sampling needs it. `middle_m`: becomes this mean.
PointModel centred(const PointModel& mesh, Vector3d& middle_m) {
  PointModel near = mesh;
  middle_m = Vector3d::Zero();
  for (const Vector3f& at : mesh.points) middle_m += at.cast<double>() / static_cast<double>(mesh.points.size());
  for (Vector3f& at : near.points) at = (at.cast<double>() - middle_m).cast<float>();
  return near;
}

std::vector<Row> measure_mesh_slides(const Body& body, const Options& options) {
  const std::string name = "slides/" + body.name;
  const Result<surface::StaticModel> made = surface::make_static_model(body.mesh, {});
  if (!made) return {at_most(name + ": " + made.error().what, NAN, "N", kMostStep_N)};
  Vector3d middle_m;
  const PointModel mesh = centred(body.mesh, middle_m);
  surface::IndexedPoints dense;
  for (const CloudPoint& point : surface::random_samples(mesh, kTruthPoints, 3)) dense.at_m.push_back(point.at_m);
  const Truth truth{surface::WindingNumber(mesh), surface::make_nanoflann_index(dense), middle_m};
  std::vector<CloudPoint> places = surface::random_samples(mesh, 4 * kSlides, 11);
  std::erase_if(places, [&](const CloudPoint& place) {  // inside another part
    return truth.winding.at(place.at_m.cast<double>() + 0.003 * place.normal.cast<double>()) > 0.5;
  });
  places.resize(std::min<std::size_t>(places.size(), kSlides));
  std::vector<Slide> slides(places.size());
  for_each_parallel(static_cast<int>(places.size()), options, [&](int i) {
    std::mt19937_64 random(static_cast<std::uint64_t>(i) + 1);
    const double turn_rad = std::uniform_real_distribution<double>(0.0, 2.0 * std::numbers::pi)(random);
    slides[static_cast<std::size_t>(i)] =
        slide_over(*made->snapshot, truth, places[static_cast<std::size_t>(i)], turn_rad);
  });
  Slide worst;
  double way_m = 0.0;
  double stepped = 0.0;
  for (const Slide& one : slides) {
    worst.step_N = std::max(worst.step_N, one.step_N);
    worst.through_s = std::max(worst.through_s, one.through_s);
    way_m += one.way_m;
    stepped += one.step_N > kMostStep_N ? 1.0 : 0.0;
  }
  const double all = static_cast<double>(std::max<std::size_t>(1, slides.size()));
  const bool slid = way_m > 0.7 * kLong_m * all;
  return {
      at_most(name + ": force step in a tick beyond K times the motion, worst of 200 slides", slid ? worst.step_N : NAN,
              "N", kMostStep_N),
      measured(name + ": slides with a step above 0.1 N", 100.0 * stepped / all, "%"),
      at_most(name + ": time without force more than 3 mm inside the mesh, worst slide", worst.through_s, "s", 0.05),
      measured(name + ": way in contact, mean of the slides", 1e3 * way_m / all, "mm"),
      at_most(name + ": surface with walls thinner than two spacings of its samples", 100.0 * made->thin_share, "%",
              2.0)};
}

std::vector<Row> measure_file(const std::string& name, const fs::path& file, const Options& options) {
  const Result<PointModel> read = models::read_point_model(file);
  if (!read) return {at_most("slides/" + name + ": " + to_string(read.error()), NAN, "N", kMostStep_N)};
  Body body{name, *read};
  constexpr float kDecimetre_m = 0.1F;  // MakeHuman's unit
  if (models::unit_error(body.mesh, 1.0))
    for (Vector3f& at : body.mesh.points) at *= kDecimetre_m;
  return measure_mesh_slides(body, options);
}

}  // namespace

std::vector<Study> mesh_slides() {
  std::vector<Study> studies;
  const auto add = [&](const std::string& name, const fs::path& file) {
    studies.push_back(
        {"slides/" + name, [name, file](const Options& options) { return measure_file(name, file, options); }});
  };
  add("liver of many parts", fs::path(TELEPALP_SOURCE_DIR) / "tests/data/mesh/VH_M_Liver.ply");
  for (const auto& [name, shipped] : {std::pair{"liver", "deploy/demo_data/organs/visible_human_liver.ply"},
                                      std::pair{"torso", "deploy/demo_data/torso/visible_human_torso.ply"}})
    add(name, program::shipped_file(shipped).value_or(shipped));
  studies.push_back({"slides/mug", [](const Options& options) {
                       return measure_mesh_slides({"mug", mug()}, options);
                     }});
  return studies;
}

std::vector<Study> slides_over(const fs::path& folder) {
  std::vector<Study> studies;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (const std::string ending = entry.path().extension(); ending == ".ply" || ending == ".obj")
      studies.push_back({"slides/" + entry.path().stem().string(), [file = entry.path()](const Options& options) {
                           return measure_file(file.stem().string(), file, options);
                         }});
  std::ranges::sort(studies, {}, &Study::name);
  return studies;
}

}  // namespace telepalp::bench::hand
