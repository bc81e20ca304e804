#include <cmath>
#include <cstdio>

#include "clients/mixed/anchor/headset_anchor.h"
#include "clients/mixed/compose/misalignment.h"
#include "clients/mixed/compose/mixed_view.h"
#include "clients/mixed/files/anchor_touches.h"
#include "clients/mixed/files/image_sequence.h"
#include "clients/mixed/files/marker_board.h"
#include "clients/mixed/files/rendered_sequence.h"
#include "support/images/image_file.h"
#include "support/program/files/whole_file.h"
#include "support/program/options.h"

using namespace telepalp;
using namespace telepalp::mixed;

namespace {

namespace fs = std::filesystem;

constexpr auto kReaders = program::Readers::Group;  // the images may show people

Result<Background> read_background(const ImageSequence& sequence) {
  std::vector<SourceImage> sources;
  for (const PosedImage& image : sequence.background) {
    Result<ColorImage> color = read_frame(image.file, sequence.lens);
    if (!color) return color.error();
    sources.push_back({{sequence.lens, image.world_from_eye}, std::move(*color)});
  }
  return Background::prepare(std::move(sources), sequence.proxy);
}

/// How the frames are composed, as the command line chooses.
struct ComposeChoice {
  MixedSettings settings;
  MaskMargin margin;
};

Result<ComposeChoice> chosen(const program::Arguments& arguments, const DevicePlace& device) {
  const Result<std::int64_t> cameras = arguments.whole("cameras", 1, 4);
  if (!cameras) return cameras.error();
  ComposeChoice choice;
  choice.settings.completion.cameras_a_vertex = static_cast<int>(*cameras);
  choice.settings.shifted = !arguments.has("naive");
  const std::string margin = arguments.text("margin");
  if (margin != "calibrated" && margin != "paper")
    return Error{.what = "'" + margin + "' is not a margin", .where = "--margin", .fix = "give calibrated or paper"};
  choice.margin =
      margin == "paper" ? paper_margin() : calibrated_margin(device.deviation_m, device.turn_rad, {kOmniWorkspace_m});
  if (const std::string glove = arguments.text("glove"); !glove.empty()) {
    const Result<ColorImage> image = images::read_color_image(glove);
    if (!image) return image.error();
    choice.settings.glove = fit_hand_colour(colors_of(*image, Mask(image->width, image->height, 1)));
  }
  return choice;
}

void tell(const LiveImage& live, const MixedImage& mixed, const CamouflageState& state) {
  static constexpr const char* kPhases[] = {"visible", "hiding", "hidden", "revealing"};
  std::printf("%s: device %s (%.2f), emptied %.1f %%, hand moved %.1f px", live.image.file.filename().c_str(),
              kPhases[static_cast<int>(state.phase)], state.opacity,
              100.0 * static_cast<double>(mixed.emptied.count()) / static_cast<double>(mixed.emptied.on.size()),
              mixed.shift_px.norm());
  if (mixed.ghost > 0.0) std::printf(", ghost %.2f", mixed.ghost);
  if (mixed.unknown_px > 0) std::printf(", %zu px without background", mixed.unknown_px);
  if (mixed.ring_levels && *mixed.ring_levels > kChangedRing_levels)
    std::printf(", the background has changed: %.0f levels around the device", *mixed.ring_levels);
  std::printf("\n");
}

/// The tool's place minus the device's at the image's own instant; nullopt: no state of the station is near it.
std::optional<Vector<World>> gap_at(const ImageSequence& sequence, const LiveImage& live) {
  constexpr auto kPatience = std::chrono::milliseconds(50);
  const SessionTime taken(from_seconds(live.time_s - live.trust.image_age_s));
  const std::optional<CouplingEnds> ends = ends_at(sequence.coupling, taken, kPatience);
  if (!ends) return std::nullopt;
  return Vector<World>{sequence.device.world_from_haptic.iso.linear() * (ends->tool.m - ends->device.m)};
}

Result<void> compose_frames(const ImageSequence& sequence, const Background& background, const ComposeChoice& choice,
                            const fs::path& out) {
  CamouflageState state;
  // The state before the first image is unknown: assume that the image's trust has lasted for 1 s.
  double before_s = sequence.frames.front().time_s - 1.0;
  for (const LiveImage& live : sequence.frames) {
    const Result<ColorImage> image = read_frame(live.image.file, sequence.lens);
    if (!image) return image.error();
    const std::optional<Vector<World>> gap = gap_at(sequence, live);
    PictureTrust trust = live.trust;
    trust.fault |= !gap;
    for (double t = before_s; t < live.time_s; t += 0.02) state = advance(state, trust, 0.02);
    before_s = live.time_s;
    const StandingDevice device{omni(), live.joints_rad, sequence.device.world_from_haptic};
    const MixedImage mixed = mix(*image, {sequence.lens, live.image.world_from_eye}, background, device, choice.margin,
                                 gap.value_or(Vector<World>{}), choice.settings);
    const std::string png = images::encode_png(faded(*image, mixed.color, state.opacity));
    if (const auto done = program::write_whole_file(out / live.image.file.filename(), png, kReaders); !done)
      return done;
    tell(live, mixed, state);
  }
  return {};
}

Result<void> compose(const program::Arguments& arguments) {
  const Result<ImageSequence> sequence = read_sequence(arguments.text("images"));
  if (!sequence) return sequence.error();
  if (sequence->frames.empty())
    return Error{.what = "the table names no image",
                 .where = arguments.text("images") + "/frames.csv",
                 .fix = "add one row for each image with the device"};
  const Result<ComposeChoice> choice = chosen(arguments, sequence->device);
  if (!choice) return choice.error();
  const Result<Background> background = read_background(*sequence);
  if (!background) return background.error();
  const fs::path out = arguments.text("out");
  if (const auto made = program::make_folder(out, kReaders); !made) return made;
  return compose_frames(*sequence, *background, *choice, out);
}

Result<void> calibrate(const program::Arguments& arguments) {
  const Result<std::vector<Click>> clicks = read_clicks(arguments.text("clicks"));
  if (!clicks) return clicks.error();
  const Result<DeviceFit> fit = fit_device(omni(), *clicks);
  if (!fit) return fit.error();
  std::printf("%s\n", in_words(*fit, *clicks).c_str());
  const double turn_rad = std::sqrt(fit->covariance.topLeftCorner<3, 3>().trace() / 3.0);
  return program::write_whole_file(arguments.text("out"),
                                   device_table({fit->world_from_haptic, deviation_at_m(*fit, fit->centre), turn_rad}),
                                   kReaders);
}

Result<void> anchor(const program::Arguments& arguments) {
  const std::string gravity = arguments.text("gravity");
  if (gravity != "known" && gravity != "unknown")
    return Error{
        .what = "'" + gravity + "' is neither known nor unknown", .where = "--gravity", .fix = "give known or unknown"};
  const Result<AnchorTouches> read = read_touches(arguments.text("touches"));
  if (!read) return read.error();
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  if (!read->pivot.empty()) {
    const Result<Eigen::Vector3d> found = pivot_tip(read->pivot);
    if (!found) return found.error();
    tip = *found;
  }
  std::vector<Touch> touches;
  for (const AnchorTouches::AtPlace& one : read->places)
    touches.push_back({one.place, one.known, {one.headset_from_tool * tip}});
  const Result<HeadsetAnchor> found = anchor_headset(touches, gravity == "known" ? Gravity::Known : Gravity::Unknown);
  if (!found) return found.error();
  std::printf("tip %.1f %.1f %.1f mm from the tool's origin, residual %.2f mm rms\n", 1e3 * tip.x(), 1e3 * tip.y(),
              1e3 * tip.z(), 1e3 * found->rms_m);
  return program::write_whole_file(arguments.text("out"), anchor_table(*found), kReaders);
}

Result<void> board(const program::Arguments& arguments) {
  const Result<double> marker_mm = arguments.number("marker-mm", 5.0, 200.0);
  if (!marker_mm) return marker_mm.error();
  const fs::path svg = arguments.text("out");
  if (const auto done = program::write_whole_file(svg, board_svg(*marker_mm), kReaders); !done) return done;
  fs::path table = svg;
  return program::write_whole_file(table.replace_extension(".csv"), board_table(*marker_mm), kReaders);
}

Result<void> render_example(const program::Arguments& arguments) {
  const Result<std::int64_t> background = arguments.whole("background", 2, 1000);
  if (!background) return background.error();
  const Result<std::int64_t> frames = arguments.whole("frames", 1, 1000);
  if (!frames) return frames.error();
  const Result<double> gap_mm = arguments.number("gap-mm", 0.0, 100.0);
  if (!gap_mm) return gap_mm.error();
  const std::string proxy = arguments.text("proxy");
  if (proxy != "planes" && proxy != "depth")
    return Error{.what = "'" + proxy + "' is not a proxy", .where = "--proxy", .fix = "give planes or depth"};
  return write_rendered_sequence(arguments.text("out"), static_cast<int>(*background), static_cast<int>(*frames),
                                 *gap_mm * 1e-3, proxy == "planes" ? ProxyKind::Planes : ProxyKind::Depth);
}

template <Result<void> (*Do)(const program::Arguments&)>
int run(const program::Arguments& arguments) {
  const Result<void> done = Do(arguments);
  return done ? program::kDone : program::fail(done.error());
}

int run_compose(int argc, const char* const* argv) {
  return program::run_program(
      {.program = "telepalp-mixed compose",
       .purpose = "removes the haptic device from a sequence of images, and draws the hand at the tool",
       .positional = {},
       .options = {{"images", "DIR", "folder of the sequence; see docs/mixed.md", "desk"},
                   {"out", "DIR", "folder for the composed images; created if missing", "mixed"},
                   {"cameras", "N", "source images a vertex of the background, 1 to 4", "1"},
                   {"margin", "KIND", "how the device's mask is enlarged: calibrated or paper (5 %)", "calibrated"},
                   {"glove", "FILE", "a picture of nothing but the glove, by whose colour the hand is found"},
                   {"naive", "", "leave the hand where it is"}},
       .example = "telepalp-mixed compose --images desk --out mixed"},
      argc, argv, run<compose>);
}

int run_calibrate(int argc, const char* const* argv) {
  return program::run_program({.program = "telepalp-mixed calibrate",
                               .purpose = "computes where the device stands from clicks on shown rings",
                               .positional = {},
                               .options = {{"clicks", "FILE", "the clicks, one a row", "desk/clicks.csv"},
                                           {"out", "FILE", "the device's place, for compose", "desk/device.csv"}},
                               .example = "telepalp-mixed calibrate --clicks desk/clicks.csv --out desk/device.csv"},
                              argc, argv, run<calibrate>);
}

int run_anchor(int argc, const char* const* argv) {
  return program::run_program(
      {.program = "telepalp-mixed anchor",
       .purpose = "computes where a headset sees the device, from touches that the web viewer saved",
       .positional = {},
       .options = {{"touches", "FILE", "the touches; see docs/mixed.md", "touches.csv"},
                   {"gravity", "WHAT", "known: the device's base is level; unknown: it may be tilted", "known"},
                   {"out", "FILE", "the device's pose in the headset's space", "anchor.csv"}},
       .example = "telepalp-mixed anchor --touches desk/touches.csv"},
      argc, argv, run<anchor>);
}

int run_board(int argc, const char* const* argv) {
  return program::run_program(
      {.program = "telepalp-mixed board",
       .purpose = "writes a board of ArUco markers to print, and the places of its corners",
       .positional = {},
       .options = {{"out", "FILE.svg", "the board; FILE.csv beside it holds the corners", "board.svg"},
                   {"marker-mm", "MM", "side of a marker; 30 fits A4", "30"}},
       .example = "telepalp-mixed board --out board.svg"},
      argc, argv, run<board>);
}

int run_render(int argc, const char* const* argv) {
  return program::run_program(
      {.program = "telepalp-mixed render",
       .purpose = "writes a rendered sequence to try compose and calibrate with",
       .positional = {},
       .options = {{"out", "DIR", "folder of the sequence", "desk"},
                   {"background", "N", "images of the background", "121"},
                   {"frames", "N", "images with the device and a hand", "24"},
                   {"proxy", "KIND",
                    "surface of the background: planes of the desk and walls, or depth: a depth "
                    "camera's mesh with the things on the desk",
                    "planes"},
                   {"gap-mm", "MM", "how far the device sinks below the tool", "25"}},
       .example = "telepalp-mixed render --out desk --background 40 --frames 12"},
      argc, argv, run<render_example>);
}

program::Usage usage() {
  return {.program = "telepalp-mixed",
          .purpose = "shows the doctor's desk without the haptic device, and the hand at the virtual tool",
          .positional = {},
          .options = {},
          .example = "telepalp-mixed render --out desk --background 40 --frames 12",
          .commands = {{"render", "", "writes a rendered sequence to try the others with", run_render},
                       {"compose", "", "removes the device from a sequence of images", run_compose},
                       {"calibrate", "", "computes where the device stands", run_calibrate},
                       {"anchor", "", "computes where a headset sees the device", run_anchor},
                       {"board", "", "writes a board of markers to print", run_board}},
          .needs_command = true};
}

}  // namespace

int main(int argc, char** argv) {
  return program::run_program(usage(), argc, argv, [](const program::Arguments&) { return program::kAskedWrongly; });
}
