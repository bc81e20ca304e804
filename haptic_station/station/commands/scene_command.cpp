#include "haptic_station/station/commands/scene_command.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numbers>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/bill/scene_bill.h"
#include "haptic_station/station/commands/scene_mesh.h"
#include "haptic_station/station/picture/scene_picture.h"
#include "haptic_station/station/rigs/inner_layers.h"
#include "haptic_station/station/rigs/scene_parts.h"
#include "haptic_station/ultrasound/b_mode.h"
#include "support/images/image_file.h"
#include "support/program/files/whole_file.h"
#include "support/program/options.h"
#include "support/program/terminal.h"

namespace telepalp::station {
namespace {

program::Usage usage() {
  return {
      .program = "telepalp-station scene",
      .purpose = "checks a scene file, measures its computing time, and draws what lies under the skin",
      .positional = "",
      .options = {{"out", "FILE", "file to write; for 'show' and 'image': .png; for 'mesh': .ply or .obj"},
                  {"from", "above|feet|side", "for 'show': side of the patient from which the scene is seen", "above"},
                  {"width-m", "M", "for 'show': width of the part that is seen, in metres; default: all objects fit"},
                  {"at", "X,Z",
                   "for 'image': middle of the probe, in metres from the origin of the haptic base's frame: X to the "
                   "patient's left, Z to the feet; the skin is flat, y = 0",
                   "0,0"},
                  {"turn-deg", "DEG",
                   "for 'image': turn of the probe about the vertical, in degrees; the right side of the image is, at "
                   "0, the patient's left, at 90, the head",
                   "0"},
                  {"layer", "NAME", "for 'mesh': name of the layer; default: the scene's first layer"},
                  {"seconds", "S", "for 'bill': session time that is measured, in seconds", "12"},
                  {"cell-mm", "MM",
                   "for 'mesh': side of the smallest cells, in millimetres; they are used only where thin walls, gaps "
                   "or bends need them; default: 1/12 000 of the layer's longest side"}},
      .example = "telepalp-station scene show ribs-ultrasound --out ribs.png",
      .commands = {{"check", "SCENE", "check the scene and list its effects"},
                   {"bill", "SCENE", "measure what the station costs with and without each effect"},
                   {"show", "SCENE", "write a picture of what lies under the skin"},
                   {"image", "SCENE", "write the ultrasound image under a probe on the skin"},
                   {"mesh", "SCENE", "write a layer's surface as a watertight mesh, or say why there is none"}},
      .needs_command = true};
}

Result<void> write(const std::string& bytes, const std::filesystem::path& file) {
  if (const Result<void> written = program::write_whole_file(file, bytes, program::Readers::Anyone); !written)
    return written;
  std::printf("wrote %s\n", file.string().c_str());
  return {};
}

/// Error: `--out` is missing, or ends in none of `endings`.
Result<void> check_out(const program::Arguments& arguments, std::initializer_list<const char*> endings) {
  const std::string out = arguments.text("out");
  std::string all;
  for (const char* ending : endings) {
    if (out.ends_with(ending)) return {};
    all += (all.empty() ? "" : " or ") + std::string(ending);
  }
  return Error{.what = out.empty() ? "the file to write is not named" : "'" + out + "' does not end in " + all,
               .where = "--out",
               .fix = "give a file name that ends in " + all};
}

struct ReadScene {
  scenes::Scene scene;
  std::filesystem::path file;
};

Result<ReadScene> read_scene_named(const std::string& name) {
  const Result<std::filesystem::path> file = scenes::find_scene(name);
  if (!file) return file.error();
  Result<scenes::Scene> scene = scenes::read_scene(*file);
  if (!scene) return scene.error();
  return ReadScene{std::move(scene).value(), *file};
}

Result<void> check_nothing(const program::Arguments&) { return {}; }

Result<void> check(const ReadScene& read, const program::Arguments&) {
  const scenes::Scene& scene = read.scene;
  if (const Result<SceneParts> parts = read_parts(scene, read.file, false); !parts) return parts.error();
  std::printf("%s\n", validity_in_words(scene).c_str());
  return {};
}

Result<void> check_bill(const program::Arguments& arguments) {
  if (const Result<double> seconds = arguments.number("seconds", 1.0, 120.0); !seconds) return seconds.error();
  return {};
}

Result<void> bill(const ReadScene& read, const program::Arguments& arguments) {
  const double seconds = *arguments.number("seconds", 1.0, 120.0);
  const bool shows = program::takes_progress(stderr);
  const Result<SceneBill> bill =
      bill_of(read.scene, read.file, seconds, Detail::EachEffect, [shows](int done, int all) {
        if (shows) std::fprintf(stderr, "\rsecond %d of %d of the session", done + 1, all);
      });
  if (shows) std::fputs("\r\033[K", stderr);
  if (!bill) return bill.error();
  std::printf(
      "processor time of the station on this computer with the scene %s: %.0f s of the "
      "scene's simulated hand, on a breathing body before a camera of 640x480 pixels at 30 Hz\n\n%s",
      read.scene.name.c_str(), seconds, in_words(*bill).c_str());
  return {};
}

Result<PictureSide> side_of(const program::Arguments& arguments) {
  const std::string from = arguments.text("from");
  if (from == "above") return PictureSide::Above;
  if (from == "feet") return PictureSide::Feet;
  if (from == "side") return PictureSide::Side;
  return Error{
      .what = "'" + from + "' is not one of above, feet and side", .where = "--from", .fix = "give one of them"};
}

Result<std::optional<double>> width_of(const program::Arguments& arguments) {
  if (!arguments.has("width-m")) return std::optional<double>{};
  const Result<double> width_m = arguments.number("width-m", 0.01, 10.0);
  if (!width_m) return width_m.error();
  return std::optional(*width_m);
}

Result<void> check_show(const program::Arguments& arguments) {
  if (const auto out = check_out(arguments, {".png"}); !out) return out;
  if (const auto side = side_of(arguments); !side) return side.error();
  if (const auto width_m = width_of(arguments); !width_m) return width_m.error();
  return {};
}

Result<void> show(const ReadScene& read, const program::Arguments& arguments) {
  const Result<SceneParts> parts = read_parts(read.scene, read.file, false);
  if (!parts) return parts.error();
  const std::span<const SkinPoint> skin = parts->model ? std::span(parts->model->skin) : std::span<const SkinPoint>{};
  return write(images::encode_png(picture_of_scene(read.scene, skin, *side_of(arguments), *width_of(arguments))),
               arguments.text("out"));
}

Result<ultrasound::ProbePose> probe_of(const program::Arguments& arguments) {
  const std::string text = arguments.text("at");
  double x = 0.0;
  double z = 0.0;
  char more = '\0';
  if (std::sscanf(text.c_str(), "%lf,%lf%c", &x, &z, &more) != 2 || !(std::hypot(x, z) < 2.0))
    return Error{.what = "'" + text + "' is not two numbers X,Z in metres within 2 m of the origin",
                 .where = "--at",
                 .fix = "give metres, as in --at 0.05,-0.1"};
  const Result<double> turn_deg = arguments.number("turn-deg", -360.0, 360.0);
  if (!turn_deg) return turn_deg.error();
  const double turn = *turn_deg * std::numbers::pi / 180.0;
  return ultrasound::ProbePose{.at = {x, 0.0, z}, .across = {std::cos(turn), 0.0, -std::sin(turn)}};
}

Result<void> check_image(const program::Arguments& arguments) {
  if (const auto out = check_out(arguments, {".png"}); !out) return out;
  if (const auto probe = probe_of(arguments); !probe) return probe.error();
  return {};
}

Result<void> image(const ReadScene& read, const program::Arguments& arguments) {
  const scenes::Scene& scene = read.scene;
  const ultrasound::BModeImage seen = ultrasound::b_mode(scene.solids(), *probe_of(arguments),
                                                         image_settings(scene).value_or(ultrasound::BModeSettings{}));
  ColorImage color{.width = seen.side_px, .height = seen.side_px, .rgb = {}};
  for (const std::uint8_t gray : seen.gray) color.rgb.insert(color.rgb.end(), 3, gray);
  return write(images::encode_png(color), arguments.text("out"));
}

Result<void> check_mesh(const program::Arguments& arguments) {
  if (const auto out = check_out(arguments, {".ply", ".obj"}); !out) return out;
  if (const auto cell_m = smallest_cell_m(arguments); !cell_m) return cell_m.error();
  return {};
}

Result<void> mesh(const ReadScene& read, const program::Arguments& arguments) {
  const std::string out = arguments.text("out");
  const Result<solids::CheckedMesh> made = mesh_of_layer(read.scene, arguments);
  if (!made) return made.error();
  return write(out.ends_with(".obj") ? solids::to_obj(made->mesh) : solids::to_ply(made->mesh), out);
}

struct Task {
  std::string_view name;
  Result<void> (*check_options)(const program::Arguments&);
  Result<void> (*run)(const ReadScene&, const program::Arguments&);
};
constexpr std::array kTasks{Task{"check", check_nothing, check}, Task{"bill", check_bill, bill},
                            Task{"show", check_show, show}, Task{"image", check_image, image},
                            Task{"mesh", check_mesh, mesh}};

int run_task(const program::Arguments& arguments) {
  const std::vector<std::string>& words = arguments.positional();
  const auto task = std::ranges::find(kTasks, words.empty() ? "" : words.front(), &Task::name);
  if (task == kTasks.end() || words.size() != 2)
    return program::fail(
        {.what = "a task and one scene are needed",
         .where = "telepalp-station scene",
         .fix = "give check, bill, show, image or mesh, then a scene; see telepalp-station scene --help"},
        program::kAskedWrongly);
  if (const Result<void> options = task->check_options(arguments); !options)
    return program::fail(options.error(), program::kAskedWrongly);
  const Result<ReadScene> scene = read_scene_named(words.back());
  if (!scene) return program::fail(scene.error());
  print_warnings(scene->scene);
  const Result<void> done = task->run(*scene, arguments);
  return done ? program::kDone : program::fail(done.error());
}

}  // namespace

int scene_command(int argc, const char* const* argv) { return program::run_program(usage(), argc, argv, run_task); }

}  // namespace telepalp::station
