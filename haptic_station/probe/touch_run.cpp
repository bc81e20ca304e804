#include "haptic_station/probe/touch_run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "haptic_station/surface/touch/touch.h"
#include "proto/words/counted.h"
#include "proto/words/numbers/quantile.h"
#include "support/program/files/whole_file.h"

namespace telepalp::probe {
namespace {

constexpr double kTeleport_m = 0.5;  // a longer jump in one step is no hand's movement; it ends the contact

constexpr const char* kColumns = "t_s,px,py,pz,distance_m,in_body,nx,ny,nz,fx,fy,fz,step_us\n";

void append_row(std::string& out, const Felt& felt) {
  const auto& [p, n, f] = std::tie(felt.proxy_m, felt.normal, felt.force_N);
  std::array<char, 512> row{};
  std::snprintf(row.data(), row.size(), "%.9g,%.9g,%.9g,%.9g,%.9g,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.3f\n", felt.t_s,
                p.x(), p.y(), p.z(), felt.distance_m, felt.in_body ? 1 : 0, n.x(), n.y(), n.z(), f.x(), f.y(), f.z(),
                felt.step_us);
  out += row.data();
}

}  // namespace

std::vector<Felt> touch_along(const surface::SurfaceSnapshot& snapshot, const std::vector<Waypoint>& trajectory,
                              double stiffness_N_per_m) {
  surface::TouchSettings settings;
  settings.gentle_start = false;  // offline a sudden force harms nobody, so a start in the body gives the full force
  surface::Touch touch(settings);
  touch.adopt(snapshot, SessionTime{});
  std::vector<Felt> all;
  all.reserve(trajectory.size());
  double last_s = trajectory.empty() ? 0.0 : trajectory.front().t_s;
  Eigen::Vector3d last_m = Eigen::Vector3d::Zero();
  for (const Waypoint& waypoint : trajectory) {
    if (waypoint.at_m.allFinite() && (waypoint.at_m - last_m).norm() > kTeleport_m) {
      touch.release();
      touch.adopt(snapshot, SessionTime{});
    }
    const auto start = std::chrono::steady_clock::now();
    const surface::TouchSample sample = touch.step({waypoint.at_m}, SessionTime{}, waypoint.t_s - last_s);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    const bool measured = waypoint.at_m.allFinite();
    if (measured) last_m = waypoint.at_m;
    last_s = waypoint.t_s;
    const bool felt = measured && sample.valid;
    const Eigen::Vector3d proxy = felt ? sample.proxy.m : last_m;
    all.push_back({.t_s = waypoint.t_s,
                   .proxy_m = proxy,
                   .distance_m = felt ? sample.distance_m : std::numeric_limits<double>::quiet_NaN(),
                   .in_body = felt && sample.in_body,
                   .normal = felt ? sample.normal : Eigen::Vector3d::Zero(),
                   .force_N = stiffness_N_per_m * (proxy - last_m),
                   .step_us = took.count()});
  }
  return all;
}

std::string in_words(const std::vector<Felt>& felt) {
  std::size_t in_body = 0, without_surface = 0;
  double most_N = 0.0;
  std::vector<double> step_us;
  for (const Felt& one : felt) {
    in_body += one.in_body ? 1U : 0U;
    without_surface += std::isnan(one.distance_m) ? 1U : 0U;
    most_N = std::max(most_N, one.force_N.norm());
    step_us.push_back(one.step_us);
  }
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
                "waypoints: %zu, in contact: %zu; largest force %.3g N; median computing time of a waypoint %.3g us",
                felt.size(), in_body, most_N, step_us.empty() ? 0.0 : median_of(step_us));
  std::string words = text.data();
  if (without_surface > 0)
    words += "\nnothing is felt at " + counted(without_surface, "waypoint", "waypoints") +
             ", because no surface is in reach there: it is far from the surface, or in a hole, or behind a flank that "
             "the camera does not see";
  return words;
}

Result<void> write_felt(const std::filesystem::path& file, const std::vector<Felt>& felt) {
  std::string text = kColumns;
  for (const Felt& one : felt) append_row(text, one);
  return program::write_whole_file(file, text, program::Readers::Group);
}

}  // namespace telepalp::probe
