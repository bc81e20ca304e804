#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>

#include "haptic_station/probe/probed_surface.h"
#include "haptic_station/probe/trajectory.h"
#include "haptic_station/surface/touch.h"
#include "proto/program/options.h"

namespace {

using namespace telepalp;

program::Usage usage() {
  return {.program = "telepalp-probe",
          .purpose = "touches a cloud, a mesh or a depth image along a trajectory and writes what was felt",
          .positional = "",
          .options = {{"cloud", "FILE", "a .pcd, .ply or .obj to touch"},
                      {"depth", "FILE", "or a 16-bit depth PNG"},
                      {"camera", "FILE", "camera.textproto of that PNG"},
                      {"trajectory", "FILE", "CSV with columns t_s,x,y,z: metres, in the cloud's frame"},
                      {"out", "FILE", "CSV to write"},
                      {"setting", "NAME", "how the surface is made: fast, smooth, paper, cloud …", "fast"},
                      {"k", "N/M", "stiffness of the coupling", "500"},
                      {"unit-m", "M", "metres for one unit of the cloud's coordinates", "1"}},
          .example = "telepalp-probe --cloud torso.pcd --trajectory path.csv --out felt.csv"};
}

struct Asked {
  probe::ProbedSurface surface;
  std::vector<probe::Waypoint> trajectory;
  double stiffness_N_per_m = 500.0;
  std::string out;
};

Error asked_wrongly(const std::string& what) {
  return {.what = what, .where = "telepalp-probe", .fix = "see telepalp-probe --help"};
}

Result<probe::ProbedSurface> open_surface(const program::Arguments& arguments,
                                          const surface::SurfaceSettings& settings) {
  const Result<double> unit_m = arguments.number("unit-m", 1e-6, 1e6);
  if (!unit_m) return unit_m.error();
  if (!arguments.text("cloud").empty()) return probe::open_cloud(arguments.text("cloud"), *unit_m, settings);
  return probe::open_depth(arguments.text("depth"), arguments.text("camera"), settings);
}

/// What can be told wrong from the command line alone.
Result<void> check(const program::Arguments& arguments) {
  const bool cloud = !arguments.text("cloud").empty();
  const bool depth = !arguments.text("depth").empty();
  if (cloud == depth) return asked_wrongly("give either --cloud or --depth");
  if (depth && arguments.text("camera").empty()) return asked_wrongly("--depth needs --camera");
  if (arguments.text("trajectory").empty()) return asked_wrongly("--trajectory is missing");
  if (arguments.text("out").empty()) return asked_wrongly("--out is missing");
  if (const auto setting = surface::surface_settings(arguments.text("setting")); !setting) return setting.error();
  if (const auto k = arguments.number("k", 0.0, 1e5); !k) return k.error();
  return {};
}

Result<Asked> prepare(const program::Arguments& arguments) {
  Result<std::vector<probe::Waypoint>> trajectory = probe::read_trajectory(arguments.text("trajectory"));
  if (!trajectory) return trajectory.error();
  Result<probe::ProbedSurface> surface = open_surface(arguments, *surface::surface_settings(arguments.text("setting")));
  if (!surface) return surface.error();
  return Asked{std::move(*surface), std::move(*trajectory), *arguments.number("k", 0.0, 1e5), arguments.text("out")};
}

void write_row(std::FILE* out, double t_s, const surface::TouchSample& sample, const Eigen::Vector3d& force_N,
               double step_us) {
  const Eigen::Vector3d& p = sample.proxy.m;
  const Eigen::Vector3d& n = sample.normal;
  std::fprintf(out, "%.9g,%.9g,%.9g,%.9g,%.9g,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.3f\n", t_s, p.x(), p.y(), p.z(),
               sample.valid ? sample.distance_m : std::nan(""), sample.in_body ? 1 : 0, n.x(), n.y(), n.z(),
               force_N.x(), force_N.y(), force_N.z(), step_us);
}

/// Touches every waypoint in turn. No surface in reach: distance is nan and the force zero. A waypoint that is not a
/// number is answered at the last place that was one.
Result<void> touch_all(const Asked& asked) {
  const std::string beside = asked.out + ".part";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(beside.c_str(), "w"), &std::fclose);
  if (!out) return Error{.what = "cannot be written", .where = asked.out, .fix = "check the folder and its rights"};
  std::fputs("t_s,px,py,pz,distance_m,in_body,nx,ny,nz,fx,fy,fz,step_us\n", out.get());
  surface::TouchSettings settings;
  settings.slewed_start = false;  // offline, a start in the body is an answer, not a danger
  surface::Touch touch(settings);
  touch.adopt(*asked.surface.snapshot, SessionTime{});
  double last_s = asked.trajectory.front().t_s;
  Eigen::Vector3d last_at = Eigen::Vector3d::Zero();
  for (const probe::Waypoint& waypoint : asked.trajectory) {
    const auto start = std::chrono::steady_clock::now();
    const surface::TouchSample felt = touch.step({waypoint.at_m}, SessionTime{}, waypoint.t_s - last_s);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    last_s = waypoint.t_s;
    surface::TouchSample sample = felt;
    if (waypoint.at_m.allFinite())
      last_at = waypoint.at_m;
    else
      sample.proxy.m = last_at;
    if (!sample.valid) sample.proxy.m = last_at;
    write_row(out.get(), waypoint.t_s, sample, asked.stiffness_N_per_m * (sample.proxy.m - last_at), took.count());
  }
  if (std::fflush(out.get()) != 0 || std::rename(beside.c_str(), asked.out.c_str()) != 0)
    return Error{.what = "cannot be written to its end", .where = asked.out, .fix = "check the disk"};
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const Result<std::optional<program::Arguments>> read = program::read_arguments(usage(), argc, argv);
  if (!read) return program::fail(read.error(), program::kAskedWrongly);
  if (!*read) return program::kDone;
  if (const Result<void> checked = check(**read); !checked)
    return program::fail(checked.error(), program::kAskedWrongly);
  const Result<Asked> asked = prepare(**read);
  if (!asked) return program::fail(asked.error());
  if (!asked->surface.remarks.empty()) std::fprintf(stderr, "note: %s\n", asked->surface.remarks.c_str());
  std::fprintf(stderr, "touching %u points through the %s\n", asked->surface.snapshot->points,
               asked->surface.snapshot->index_name);
  if (const Result<void> done = touch_all(*asked); !done) return program::fail(done.error());
  return program::kDone;
}
