#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "haptic_station/solids/distance_lattice.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// Objects inside the body. Measures whether the hand meets them at the same depth below the skin after the patient has
// moved, and whether the force ever pulls a hand that pushes through them.

namespace telepalp::bench::hand {
namespace {

constexpr double kTopDepth_m = 0.03;
constexpr double kNotMet_m = 0.05;  // depth error that counts for an object that is not met

enum class Object { Sphere, Cylinder, Organ };

/// A ball of radius 25 mm as an organ's shape.
std::shared_ptr<const solids::DistanceLattice> ball(const Eigen::Vector3d& center_m, double radius_m) {
  constexpr int kNodes = 40;
  auto lattice = std::make_shared<solids::DistanceLattice>();
  lattice->spacing_m = 0.003;
  lattice->size = {kNodes, kNodes, kNodes};
  lattice->origin_m = center_m - Eigen::Vector3d::Constant(0.5 * lattice->spacing_m * (kNodes - 1));
  lattice->nodes_m.resize(static_cast<std::size_t>(kNodes * kNodes * kNodes));
  for (int k = 0; k < kNodes; ++k)
    for (int j = 0; j < kNodes; ++j)
      for (int i = 0; i < kNodes; ++i)
        lattice->nodes_m[lattice->index(i, j, k)] = static_cast<float>(
            (lattice->origin_m + lattice->spacing_m * Eigen::Vector3d(i, j, k) - center_m).norm() - radius_m);
  return lattice;
}

StationSettings with_object(Object object) {
  StationSettings settings;
  (void)settings.effects.add(effects::Skin{});  // S1's law
  const Point<HapticBase> top{{0.0, -kTopDepth_m, 0.0}};
  switch (object) {
    case Object::Sphere:
      (void)settings.effects.add(effects::InnerSphere({.center = {top.m - Eigen::Vector3d{0.0, 0.02, 0.0}}}));
      break;
    case Object::Cylinder:
      (void)settings.effects.add(effects::InnerCylinder({.top_center = top}));
      break;
    case Object::Organ:
      (void)settings.effects.add(effects::Organ({.shape = ball(top.m - Eigen::Vector3d{0.0, 0.025, 0.0}, 0.025)}));
      break;
  }
  return settings;
}

/// The hand comes down beside `at` after `from_s`, at 40 mm/s, to `deepest_m` below the skin at rest.
RigidHand::Path press(const Eigen::Vector3d& at_m, double from_s, double deepest_m) {
  return [=](double t, const control::ControlOutput&) {
    const double height_m = std::max(-deepest_m, 0.05 - 0.04 * std::max(0.0, t - from_s));
    return Point<HapticBase>{{at_m.x(), at_m.y() + height_m, at_m.z()}};
  };
}

/// How an object is met.
struct Met {
  double depth_m = kNotMet_m + kTopDepth_m;  ///< below the true skin
  double beside_m = 0.0;                     ///< from its place in the true body to where it is displayed
  bool unseen = false;                       ///< the station says that it does not see the skin above the object
  bool slide_unseen = false;                 ///< the station says that it cannot tell a motion along the skin
};

/// How the object is met at `at_m`, with the patient in `pose` from the third second on.
Met met_at(Object object, const capture::PatientPose& pose, const Eigen::Vector3d& at_m) {
  const auto patient = torso();
  const auto placed = haptic_from_camera(*patient, spots()[0]);
  const StationSettings settings = with_object(object);
  Feed feed({.patient = patient,
             .pose =
                 [&](double t) {
                   capture::PatientPose now;
                   const double share = eased((t - 2.0) / 1.0);
                   now.rise_m = share * pose.rise_m;
                   now.slide_m = share * pose.slide_m;
                   return now;
                 },
             .link = {},
             .builder = {},
             .effects = settings.effects,
             .haptic_from_camera = placed});
  BenchStation station(settings, placed, std::make_unique<RigidHand>(press(at_m, 5.0, 0.075)));
  Met result;
  bool met = false;
  run(feed, station, 8.2, [&](const Tick& tick) {
    const effects::ObjectTouch touch = station.ticks().effects().touch();
    if (met || !tick.displayed || (touch != effects::ObjectTouch::Upper && touch != effects::ObjectTouch::Lateral))
      return;
    met = true;
    result.depth_m = tick.true_depth_m;
    // The head is at the image's left: a slide towards it is one towards -x, and one to the right side towards -z.
    const Eigen::Vector3d true_m{-pose.slide_m.x(), pose.rise_m, -pose.slide_m.y()};
    for (const loop::ObjectPlacement& placement : station.ticks().objects()) {
      if (!placement.watched) continue;
      result.beside_m = (Eigen::Vector3f(placement.moved.data()).cast<double>() - true_m).norm();
      result.unseen |= placement.unseen;
      result.slide_unseen |= placement.slide_unseen;
    }
  });
  return result;
}

/// By how much the object's depth in the moved body differs from that in the body at rest.
struct Shifted {
  double worst_m = 0.0;        ///< of the places that are not flagged
  double beside_m = 0.0;       ///< displayed beside its place in the true body, at the worst of these places
  double flagged_share = 0.0;  ///< of the places, where the station says that it cannot tell
};
Shifted shifted_by(Object object, const std::vector<capture::PatientPose>& poses, const std::vector<double>& offsets_m,
                   const Options& options) {
  const auto places = static_cast<int>(offsets_m.size());
  const auto count = static_cast<int>(poses.size()) * places;
  const auto placed = haptic_from_camera(*torso(), spots()[0]);
  const Vector<DepthCamera> up = placed.inverse() * Vector<HapticBase>{Eigen::Vector3d::UnitY()};
  std::vector<double> off_m(static_cast<std::size_t>(count));
  std::vector<double> beside_m(static_cast<std::size_t>(count));
  std::vector<int> flagged(static_cast<std::size_t>(count));
  for_each_parallel(count, options, [&](int i) {
    const double offset_m = offsets_m[static_cast<std::size_t>(i % places)];
    const capture::PatientPose& pose = poses[static_cast<std::size_t>(i / places)];
    const auto skin_at = [&](const capture::PatientPose& posed, double x_m, double z_m) {
      const auto height =
          torso()->surface_of(posed).height_along(placed.inverse() * Point<HapticBase>{{x_m, 0.0, z_m}}, up);
      return Eigen::Vector3d{x_m, height ? height->m : 0.0, z_m};
    };
    const Met rest = met_at(object, {}, skin_at({}, offset_m, 0.0));
    const Met moved = met_at(object, pose, skin_at(pose, offset_m - pose.slide_m.x(), -pose.slide_m.y()));
    const bool is_flagged = moved.unseen || (pose.slides() && moved.slide_unseen);
    flagged[static_cast<std::size_t>(i)] = is_flagged ? 1 : 0;
    if (is_flagged) return;
    off_m[static_cast<std::size_t>(i)] = std::abs(moved.depth_m - rest.depth_m);
    beside_m[static_cast<std::size_t>(i)] = moved.beside_m;
  });
  return {.worst_m = *std::max_element(off_m.begin(), off_m.end()),
          .beside_m = *std::max_element(beside_m.begin(), beside_m.end()),
          .flagged_share = std::accumulate(flagged.begin(), flagged.end(), 0.0) / count};
}

capture::PatientPose risen(double rise_m) {
  capture::PatientPose pose;
  pose.rise_m = rise_m;
  return pose;
}
capture::PatientPose slid(double x_m, double y_m) {
  capture::PatientPose pose;
  pose.slide_m = {x_m, y_m};
  return pose;
}

std::vector<Row> measure_depth(const std::string& name, Object object, const Options& options) {
  const double edge_m = object == Object::Cylinder ? 0.024 : 0.0;  // a flat top tells of a slide at its edge alone
  const Shifted risen_by = shifted_by(object, {risen(-0.01), risen(-0.005), risen(0.005), risen(0.01)}, {0.0}, options);
  const Shifted slid_by =
      shifted_by(object, {slid(0.02, 0.0), slid(0.0, 0.02), slid(-0.02, 0.0)},
                 object == Object::Cylinder ? std::vector{-edge_m, edge_m} : std::vector{0.0}, options);
  return {
      at_most(name + ": change of the object's depth below the skin when the skin rises or sinks up to 10 mm, worst",
              1e3 * risen_by.worst_m, "mm", 2.0),
      at_most(name + ": change of the object's depth below the skin when the skin slides 20 mm sideways, worst",
              1e3 * slid_by.worst_m, "mm", 3.0),
      at_most(
          name + ": distance of the displayed object from its true place after the skin slides 20 mm sideways, worst",
          1e3 * slid_by.beside_m, "mm", 3.0),
      at_most(name + ": skin rises or sinks up to 10 mm, and the station calls this motion unseen, share of presses",
              100.0 * risen_by.flagged_share, "%", 0.0),
      at_most(name + ": skin slides 20 mm, and the station calls this motion unseen, share of presses",
              100.0 * slid_by.flagged_share, "%", 0.0)};
}

/// The least upward force during a push straight down to `far_m` below the skin.
std::vector<Row> measure_far_face(const std::string& name, Object object, double far_m, const Options& options) {
  const std::array<double, 3> beside_m{0.0, 0.004, 0.01};
  std::array<double, 3> least_N{};
  for_each_parallel(static_cast<int>(beside_m.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const auto patient = torso();
    Feed feed({.patient = patient, .pose = [](double) { return capture::PatientPose{}; }, .link = {}, .builder = {}});
    BenchStation station(with_object(object), haptic_from_camera(*patient, spots()[0]),
                         std::make_unique<RigidHand>(press({beside_m[at], 0.0, 0.0}, 1.0, far_m)));
    least_N[at] = 1e9;
    run(feed, station, 1.0 + (far_m + 0.05) / 0.04, [&](const Tick& tick) {
      if (tick.device_m.y() > -kTopDepth_m) return;
      least_N[at] = std::min(least_N[at], tick.displayed ? tick.force_N.y() : -10.0);  // -10: fell through
    });
  });
  return {at_least(name + ": least force against a push down to the object's far face",
                   *std::min_element(least_N.begin(), least_N.end()), "N", 0.0)};
}

}  // namespace

std::vector<Study> inner_objects() {
  std::vector<Study> studies;
  for (const auto& [name, object] :
       {std::pair{"inner/sphere", Object::Sphere}, std::pair{"inner/cylinder", Object::Cylinder}})
    studies.push_back({name, [name, object](const Options& options) { return measure_depth(name, object, options); }});
  struct Far {
    const char* name;
    Object object;
    double far_m;
  };
  for (const Far& far : {Far{"far face/sphere", Object::Sphere, 0.07}, Far{"far face/cylinder", Object::Cylinder, 0.08},
                         Far{"far face/organ", Object::Organ, 0.08}})
    studies.push_back({far.name, [far](const Options& options) {
                         return measure_far_face(far.name, far.object, far.far_m, options);
                       }});
  return studies;
}

}  // namespace telepalp::bench::hand
