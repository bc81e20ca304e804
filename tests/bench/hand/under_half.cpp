#include <algorithm>
#include <cmath>

#include "tests/bench/distribution.h"
#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/studies.h"

// The patient rises by 10 mm within 50 ms, under a hand on an arm that waits closely above the skin or presses it.
// Measures for how long the hand then feels less than half of the force that the true skin would give. An ideal display
// of the newest image, on the same path, shows which part of this time comes from the delay and the loss of images
// alone.

namespace telepalp::bench::hand {
namespace {

constexpr double kRise_m = 0.01, kRises_s = 0.05;
constexpr double kArrived_s = 1.6;  // the hand is at its place by then
constexpr double kShift_s = 2.2;    // the shift begins at most one frame period later
constexpr double kJudged_s = 1.5;
constexpr double kLeastLaw_N = 0.2;

struct ShiftCase {
  const char* name;
  Link link;
  std::optional<double> reach_s;  ///< nullopt: only measured
};
constexpr Link kPipeline{.one_way_s = 0.02, .jitter_s = 0.0, .loss = 0.0};
constexpr Link kFar{.one_way_s = 0.1, .jitter_s = 0.03, .loss = 0.0};

constexpr Link with_loss(Link link, double burst_frames) noexcept {
  link.loss = 0.1;
  link.burst_frames = burst_frames;
  return link;
}
constexpr ShiftCase kCases[] = {{"20 ms", kPipeline, 0.12},
                                {"100 ms", kFar, 0.22},
                                {"20 ms, 10 % of the frames lost", with_loss(kPipeline, 1.0), 0.15},
                                {"100 ms, 10 % of the frames lost", with_loss(kFar, 1.0), 0.24},
                                {"20 ms, 10 % lost in bursts of four", with_loss(kPipeline, 4.0), std::nullopt},
                                {"100 ms, 10 % lost in bursts of four", with_loss(kFar, 4.0), std::nullopt}};

struct UnderHalf {
  double station_s = 0.0;
  double ideal_s = 0.0;
};

/// True if `force_N` is less than half of the law's force, and the law's force is above kLeastLaw_N.
bool too_little(double force_N, const Tick& tick) noexcept {
  return tick.law_N() > kLeastLaw_N && force_N < 0.5 * tick.law_N();
}

UnderHalf play_under_half(const Link& link, int number) {
  device::Random random(52000 + static_cast<std::uint64_t>(number));
  const auto patient = torso();
  const Spot spot = spots()[random.bits() % spots().size()];
  const auto anchor = number % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding;
  const double depth_m = random.uniform(-0.003, 0.008);
  const double aim_m = depth_m > 0.0 ? depth_m * (1.0 + kSkin_N_per_m / kArm_N_per_m) : depth_m;
  const double shift_s = kShift_s + random.uniform(0.0, kFrame_s);
  Link seeded = link;
  seeded.seed = static_cast<std::uint64_t>(number) + 1;
  Feed feed({.patient = patient,
             .pose =
                 [shift_s](double t) {
                   capture::PatientPose pose;
                   pose.rise_m = kRise_m * std::clamp((t - shift_s) / kRises_s, 0.0, 1.0);
                   return pose;
                 },
             .link = seeded,
             .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const Eigen::Vector3d normal = normal_at(*patient, spot).v;
  BenchStation station(with_skin(anchor), placed, std::make_unique<ArmHand>(kArm_N_per_m, [normal, aim_m](double t) {
                         const double height_m = 0.04 - (0.04 + aim_m) * eased((t - 0.9) / (kArrived_s - 0.9));
                         return device::Intention{{height_m * normal}, {}};
                       }));
  UnderHalf under;
  run(feed, station, shift_s + kJudged_s, [&](const Tick& tick) {
    if (tick.time_s < shift_s) return;
    under.station_s += too_little(tick.pushed_N(), tick) ? kTick_s : 0.0;
    under.ideal_s += too_little(newest_image_N(feed, tick, placed).dot(tick.normal), tick) ? kTick_s : 0.0;
  });
  return under;
}

std::vector<Row> measure_under_half(const ShiftCase& one, const Options& options) {
  const std::string name = std::string("under half/") + one.name;
  std::vector<UnderHalf> all(static_cast<std::size_t>(options.seeds));
  for_each_parallel(options.seeds, options,
                    [&](int i) { all[static_cast<std::size_t>(i)] = play_under_half(one.link, i); });
  Distribution station_s;
  Distribution ideal_s;
  for (const UnderHalf& under : all) {
    station_s.add(under.station_s);
    ideal_s.add(under.ideal_s);
  }
  const std::string row = name + ": time with less than half the force law's force after the skin rises by 10 mm, ";
  const double p95_s = station_s.quantile(0.95);
  return {one.reach_s ? at_most(row + "p95", p95_s, "s", *one.reach_s) : measured(row + "p95", p95_s, "s"),
          measured(row + "median", station_s.p50(), "s"), measured(row + "worst", station_s.max(), "s"),
          measured(row + "ideal display of the newest image, p95", ideal_s.quantile(0.95), "s")};
}

}  // namespace

std::vector<Study> under_half() {
  std::vector<Study> studies;
  for (const ShiftCase& one : kCases)
    studies.push_back({std::string("under half/") + one.name,
                       [&one](const Options& options) { return measure_under_half(one, options); }});
  return studies;
}

}  // namespace telepalp::bench::hand
