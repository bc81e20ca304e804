#include <algorithm>
#include <charconv>
#include <cstdio>

#include "haptic_station/probe/felt_plot.h"
#include "haptic_station/probe/palpation_path.h"
#include "haptic_station/probe/probed_surface.h"
#include "haptic_station/probe/touch_run.h"
#include "support/program/ending.h"
#include "support/program/files/whole_file.h"
#include "support/program/options.h"

namespace {

using namespace telepalp;

/// The options about the surface, which both commands have.
std::vector<program::Option> surface_options() {
  return {{"cloud", "FILE", "point cloud or mesh to touch: .pcd, .ply or .obj"},
          {"depth", "FILE", "depth image to touch, a 16-bit PNG; without --cloud"},
          {"camera", "FILE", "camera.textproto of the depth PNG"},
          {"setting", "NAME", "way to build the surface: fast, smooth, paper, cloud …", "fast"},
          {"unit-m", "M", "length of one unit of the cloud's coordinates, in metres; millimetres: 0.001", "1"},
          {"samples", "N", "points sampled on a mesh; default: as many as its shape needs; setting paper: 16000"},
          {"spacing-mm", "MM", "instead of --samples: spacing of the points"},
          {"anyway", "", "touch a model that is otherwise refused: coarse, noisy, or without a known outside"},
          {"flip-normals", "", "reverse all normals"}};
}

int path_command(int argc, const char* const* argv);

program::Usage touch_usage() {
  program::Usage usage{.program = "telepalp-probe",
                       .purpose =
                           "touches a point cloud, a mesh or a depth image along a trajectory, and writes "
                           "contact and force",
                       .positional = "",
                       .options = surface_options(),
                       .example = "telepalp-probe --cloud torso.pcd --trajectory path.csv --out felt.csv",
                       .commands = {{"path", "", "make a trajectory", path_command}}};
  usage.options.insert(
      usage.options.end(),
      {{"trajectory", "FILE", "CSV with columns t_s,x,y,z: metres, in the cloud's frame"},
       {"k", "N/M",
        "stiffness of the spring between device point and proxy (the device point held on the surface), in N/m", "500"},
       {"out", "FILE", "CSV to write: proxy, distance, normal and force at each waypoint"},
       {"plot", "FILE", "SVG to write: distance, force and computing time of each step, over time"}});
  return usage;
}

program::Usage path_usage() {
  program::Usage usage{.program = "telepalp-probe path",
                       .purpose =
                           "makes a path that palpates a point cloud, a mesh or a depth image: presses, "
                           "circles at depth, leaves, and goes on to the next spot",
                       .positional = "",
                       .options = surface_options(),
                       .example = "telepalp-probe path --cloud torso.pcd --out path.csv"};
  usage.options.insert(
      usage.options.end(),
      {{"at", "X,Y,Z", "first spot to press, in metres, in the cloud's frame; default: the cloud's middle"},
       {"spots", "N", "number of spots to press, at most", "5"},
       {"depth-mm", "MM", "depth of each press below the surface", "10"},
       {"speed-mm-s", "MM/S", "speed along the path", "100"},
       {"rate-hz", "HZ", "waypoints per second of the path", "2000"},
       {"out", "FILE", "CSV to write, with columns t_s,x,y,z"}});
  return usage;
}

Error asked_wrongly(const std::string& what) {
  return {.what = what, .where = "telepalp-probe", .fix = "see telepalp-probe --help"};
}

/// The value of the option, or 0 if it is left out.
Result<std::size_t> samples_of(const program::Arguments& arguments) {
  if (!arguments.has("samples")) return std::size_t{0};
  const auto samples = arguments.whole("samples", 100, 1'000'000);
  if (!samples) return samples.error();
  return static_cast<std::size_t>(*samples);
}

Result<double> spacing_m_of(const program::Arguments& arguments) {
  if (!arguments.has("spacing-mm")) return 0.0;
  const auto spacing_mm = arguments.number("spacing-mm", 0.1, 100.0);
  if (!spacing_mm) return spacing_mm.error();
  return 1e-3 * *spacing_mm;
}

/// Checks the options of a depth image. It needs the camera's file, which gives the unit of its depth. Its outside
/// needs no option: it is the side that the camera sees.
Result<void> check_depth(const program::Arguments& arguments) {
  if (arguments.text("camera").empty())
    return asked_wrongly("--depth is given without --camera, the camera.textproto of the depth PNG");
  for (const char* option : {"samples", "spacing-mm", "anyway", "flip-normals"})
    if (arguments.has(option))
      return Error{.what = "this option has no effect on a depth image",
                   .where = "--" + std::string(option),
                   .fix = "leave it out, or give --cloud FILE instead of --depth"};
  return {};
}

/// Error: a file to write is also another file of the command, which would be overwritten.
Result<void> check_files(const program::Arguments& arguments) {
  for (const char* written : {"out", "plot"})
    for (const char* other : {"cloud", "depth", "camera", "trajectory", "out"}) {
      const std::string file = arguments.text(written);
      if (file.empty() || std::string_view(other) == written || arguments.text(other).empty()) continue;
      if (program::is_same_file(file, arguments.text(other)))
        return Error{.what = "is also the file of --" + std::string(other) + ", which would be overwritten",
                     .where = "--" + std::string(written) + " " + file,
                     .fix = "name another file"};
    }
  return {};
}

/// Checks the options about the surface, and the names of all files, without reading a file.
Result<void> check_surface(const program::Arguments& arguments) {
  const bool cloud = !arguments.text("cloud").empty();
  const bool depth = !arguments.text("depth").empty();
  if (cloud && depth) return asked_wrongly("--cloud and --depth are both given, but only one surface can be touched");
  if (!cloud && !depth) return asked_wrongly("neither --cloud nor --depth is given, so there is no surface to touch");
  if (depth)
    if (const auto checked = check_depth(arguments); !checked) return checked;
  if (arguments.text("out").empty()) return asked_wrongly("--out, the CSV file to write, is missing");
  if (const auto checked = check_files(arguments); !checked) return checked;
  if (const auto setting = surface::surface_settings(arguments.text("setting")); !setting) return setting.error();
  if (const auto unit = arguments.number("unit-m", 1e-6, 1e6); !unit) return unit.error();
  if (const auto samples = samples_of(arguments); !samples) return samples.error();
  if (const auto spacing = spacing_m_of(arguments); !spacing) return spacing.error();
  if (arguments.has("samples") && arguments.has("spacing-mm"))
    return asked_wrongly("--samples and --spacing-mm are both given, but each determines the other");
  return {};
}

Result<probe::ProbedSurface> open_surface(const program::Arguments& arguments) {
  const surface::SurfaceSettings settings = *surface::surface_settings(arguments.text("setting"));
  if (arguments.text("cloud").empty())
    return probe::open_depth(arguments.text("depth"), arguments.text("camera"), settings);
  const probe::CloudOptions options{.unit_m = *arguments.number("unit-m", 1e-6, 1e6),
                                    .samples = *samples_of(arguments),
                                    .spacing_m = *spacing_m_of(arguments),
                                    .flip_normals = arguments.has("flip-normals"),
                                    .anyway = arguments.has("anyway")};
  Result<probe::ProbedSurface> surface = probe::open_cloud(arguments.text("cloud"), options, settings);
  if (surface && !surface->remarks.empty()) std::fprintf(stderr, "note: %s\n", surface->remarks.c_str());
  return surface;
}

int touch(const program::Arguments& arguments) {
  if (const auto checked = check_surface(arguments); !checked)
    return program::fail(checked.error(), program::kAskedWrongly);
  program::say_when_stopped("telepalp-probe: stopped: " + arguments.text("out") + " is not written");
  if (arguments.text("trajectory").empty())
    return program::fail(asked_wrongly("--trajectory, the CSV file of the path to touch along, is missing"),
                         program::kAskedWrongly);
  const Result<double> stiffness = arguments.number("k", 0.0, 1e5);
  if (!stiffness) return program::fail(stiffness.error(), program::kAskedWrongly);
  const Result<std::vector<probe::Waypoint>> trajectory = probe::read_trajectory(arguments.text("trajectory"));
  if (!trajectory) return program::fail(trajectory.error());
  const Result<probe::ProbedSurface> surface = open_surface(arguments);
  if (!surface) return program::fail(surface.error());
  std::fprintf(stderr, "the surface has %u points; method of the neighbour search: %s\n", surface->snapshot->points,
               surface->snapshot->index_name);
  const std::vector<probe::Felt> felt = probe::touch_along(*surface->snapshot, *trajectory, *stiffness);
  if (const auto done = probe::write_felt(arguments.text("out"), felt); !done) return program::fail(done.error());
  program::say_when_stopped("telepalp-probe: stopped: " + arguments.text("out") + " is written");
  std::fprintf(stderr, "%s\n", probe::in_words(felt).c_str());
  if (!arguments.has("plot")) return program::kDone;
  const std::filesystem::path touched = arguments.text("cloud") + arguments.text("depth");
  const std::string title = touched.filename().string() + ", " + arguments.text("setting");
  const auto done = probe::plot_felt(arguments.text("plot"), felt, title);
  return done ? program::kDone : program::fail(done.error());
}

Result<std::optional<Eigen::Vector3d>> place_of(const std::string& text) {
  if (text.empty()) return std::optional<Eigen::Vector3d>{};
  const auto waypoint = probe::parse_trajectory("0," + text, "--at");
  if (!waypoint || !waypoint->front().at_m.allFinite())
    return Error{
        .what = "'" + text + "' is not X,Y,Z in metres", .where = "--at", .fix = "write X,Y,Z as in --at 0.1,0,0.8"};
  return std::optional{waypoint->front().at_m};
}

Result<probe::PalpationSettings> palpation_of(const program::Arguments& arguments) {
  const auto at = place_of(arguments.text("at"));
  if (!at) return at.error();
  const auto spots = arguments.whole("spots", 1, 1000);
  if (!spots) return spots.error();
  const auto depth_mm = arguments.number("depth-mm", 0.0, 100.0);
  if (!depth_mm) return depth_mm.error();
  const auto speed = arguments.number("speed-mm-s", 1.0, 5000.0);
  if (!speed) return speed.error();
  const auto rate = arguments.number("rate-hz", 1.0, 100'000.0);
  if (!rate) return rate.error();
  probe::PalpationSettings settings;
  settings.at_m = *at;
  settings.spots = static_cast<int>(*spots);
  settings.depth_m = 1e-3 * *depth_mm;
  settings.speed_m_per_s = 1e-3 * *speed;
  settings.rate_hz = *rate;
  return settings;
}

int path(const program::Arguments& arguments) {
  if (const auto checked = check_surface(arguments); !checked)
    return program::fail(checked.error(), program::kAskedWrongly);
  program::say_when_stopped("telepalp-probe: stopped: " + arguments.text("out") + " is not written");
  const Result<probe::PalpationSettings> settings = palpation_of(arguments);
  if (!settings) return program::fail(settings.error(), program::kAskedWrongly);
  const Result<probe::ProbedSurface> surface = open_surface(arguments);
  if (!surface) return program::fail(surface.error());
  const auto path = probe::palpation_path(*surface->snapshot, surface->on_surface, *settings);
  if (!path) return program::fail(path.error());
  if (const auto done = probe::write_trajectory(arguments.text("out"), *path); !done)
    return program::fail(done.error());
  std::fprintf(stderr, "wrote %zu waypoints to %s; the path takes %.3g s\n", path->size(),
               arguments.text("out").c_str(), path->back().t_s);
  return program::kDone;
}

int path_command(int argc, const char* const* argv) { return program::run_program(path_usage(), argc, argv, path); }

}  // namespace

int main(int argc, char** argv) { return program::run_program(touch_usage(), argc, argv, touch); }
