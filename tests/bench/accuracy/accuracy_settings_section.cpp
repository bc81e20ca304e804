#include <cmath>
#include <string>

#include "codec/color.h"
#include "codec/depth_stream.h"
#include "haptic_station/core/built_effects.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/bill/error_in_motion.h"
#include "haptic_station/ultrasound/b_mode.h"
#include "tests/bench/accuracy/accuracy_marks.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/accuracy_surface.h"
#include "tests/bench/accuracy/accuracy_viewer.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "where.h"

namespace telepalp::bench {
namespace {

constexpr const char* kScenes = TELEPALP_SOURCE_DIR "/haptic_station/scenes/";
constexpr double kFrames_per_s = 30.0;

/// Median processor time of `work` [ms].
template <class Work>
double median_ms(int times, const Work& work) {
  Distribution ms;
  for (int i = 0; i < times; ++i) {
    const double start_us = thread_us();
    work();
    ms.add(1e-3 * (thread_us() - start_us));
  }
  return ms.p50();
}

double psnr_dB(const ColorImage& a, const ColorImage& b) {
  double square = 0.0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) square += std::pow(int{a.rgb[i]} - int{b.rgb[i]}, 2);
  return 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(a.rgb.size()) / square);
}

Result<PageTable> jpeg_table(const ColorImage& color) {
  PageTable table{.head = {"`--jpeg-quality`", "kB a picture", "Mbit/s at 30 Hz", "encode ms", "decode ms", "PSNR dB"},
                  .rows = {}};
  for (const int quality : {50, 70, 85, 95}) {
    const std::string jpeg = codec::encode_color(color, quality);
    const auto bytes = std::as_bytes(std::span(jpeg));
    const Result<ColorImage> back = codec::decode_color(bytes);
    if (!back) return back.error();
    const double kB = 1e-3 * static_cast<double>(jpeg.size());
    table.rows.push_back({std::to_string(quality) + (quality == 85 ? " (default)" : ""), cell(kB),
                          cell(8e-3 * kB * kFrames_per_s),
                          cell(median_ms(15, [&] { (void)codec::encode_color(color, quality); })),
                          cell(median_ms(15, [&] { (void)codec::decode_color(bytes); })), cell(psnr_dB(color, *back))});
  }
  return table;
}

/// Depth of one camera on its way: size, decoding, surface, and the error of the surface.
Result<PageTable> camera_table() {
  PageTable table{.head = {"camera", "kB an image", "decode ms", "surface ms", "15 Hz, % of a core", "30 Hz", "60 Hz",
                           "torso mm / °"},
                  .rows = {}};
  const SurfaceVariant fast = few_variants().front();
  for (const int width : {320, 480, 640, 960, 1280}) {
    const int height = width * 3 / 4;
    const double focal = 525.0 * width / 640.0;
    const Result<FilmedTorso> torso =
        kinect_torso(0.8, {width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)});
    if (!torso) return torso.error();
    const std::string packet = codec::encode_depth(torso->frames.back().depth);
    const double decode_ms = median_ms(15, [&] { (void)codec::decode_depth(std::as_bytes(std::span(packet))); });
    const TouchError error = torso_touch_error(*torso, fast);
    const auto share = [&](double rate_hz) { return cell(0.1 * rate_hz * (decode_ms + error.build_ms)); };
    table.rows.push_back({std::to_string(width) + " x " + std::to_string(height),
                          cell(1e-3 * static_cast<double>(packet.size())), cell(decode_ms), cell(error.build_ms),
                          share(15.0), share(30.0), share(60.0),
                          cell(1e3 * error.position_m) + " / " + cell(error.normal_deg)});
  }
  return table;
}

Result<PageTable> levels_table() {
  PageTable table{.head = {"`disparity_levels`", "at 0.8 m, mm / °", "at 1.2 m", "at 2 m", "build ms"}, .rows = {}};
  for (const bool levels : {true, false}) {
    SurfaceVariant variant = few_variants().front();
    variant.settings.disparity_levels = levels;
    table.rows.push_back({levels ? "on (default)" : "off"});
    double build_ms = 0.0;
    for (const double above_m : {0.8, 1.2, 2.0}) {
      const Result<FilmedTorso> torso = kinect_torso(above_m);
      if (!torso) return torso.error();
      const TouchError error = torso_touch_error(*torso, variant);
      table.rows.back().push_back(cell(1e3 * error.position_m) + " / " + cell(error.normal_deg));
      build_ms += error.build_ms / 3.0;
    }
    table.rows.back().push_back(cell(build_ms));
  }
  return table;
}

Result<PageTable> anchors_table() {
  PageTable table{.head = {"anchor", "in a tick, µs", "force error in motion mN, p50 / p99"}, .rows = {}};
  const std::filesystem::path file = std::string(kScenes) + "skin.scene.textproto";
  const Result<scenes::Scene> shipped = scenes::read_scene(file);
  if (!shipped) return shipped.error();
  const station::SeenBody body;
  for (const auto& [word, anchor] : {std::pair("ANCHOR_FOLLOWS_SURFACE", effects::SkinAnchor::FollowsSurface),
                                     std::pair("ANCHOR_FIXED", effects::SkinAnchor::Fixed),
                                     std::pair("ANCHOR_SLIDING", effects::SkinAnchor::Sliding)}) {
    scenes::Scene scene = *shipped;
    std::get<effects::SkinSettings>(scene.effects[0]).anchor = anchor;
    const auto errors = station::errors_in_motion(scene, {}, file, body, 10.0);
    if (!errors) return errors.error();
    effects::EffectBank bank = core::bank_of(scene.effects);
    effects::EffectInput in;
    in.device = {{0.0, -0.03, 0.0}};
    in.contact = {
        .proxy = {}, .normal = {Eigen::Vector3d::UnitY()}, .distance_m = -0.03, .in_body = true, .valid = true};
    bank.begin(in);
    constexpr int kTicks = 2000;
    const double ms = median_ms(15, [&] {
      for (int i = 0; i < kTicks; ++i) (void)bank.step(in, 0.0005, 10.0);
    });
    table.rows.push_back({"`" + std::string(word) + "`", cell(1e3 * ms / kTicks),
                          cell(1e3 * errors->front().p50_N) + " / " + cell(1e3 * errors->front().p99_N)});
  }
  return table;
}

Result<PageTable> ultrasound_table() {
  PageTable table{.head = {"pixels", "image ms", "25 Hz, % of a core", "kB"}, .rows = {}};
  const Result<scenes::Scene> scene = scenes::read_scene(std::string(kScenes) + "ribs-ultrasound.scene.textproto");
  if (!scene) return scene.error();
  const ultrasound::ProbePose probe{.at = {0.05, 0.0, 0.0}};
  for (const int side_px : {128, 192, 256, 384, 512}) {
    const auto solids = scene->solids();
    const ultrasound::BModeSettings settings{.side_px = side_px};
    const ultrasound::BModeImage image = ultrasound::b_mode(solids, probe, settings);
    const double ms = median_ms(9, [&] { (void)ultrasound::b_mode(solids, probe, settings); });
    table.rows.push_back({std::to_string(side_px) + " x " + std::to_string(side_px) + (side_px == 256 ? " (used)" : ""),
                          cell(ms), cell(2.5 * ms),
                          cell(1e-3 * static_cast<double>(codec::encode_gray(image.gray, side_px, side_px).size()))});
  }
  return table;
}

}  // namespace

Result<Section> settings_section() {
  const Result<FilmedTorso> torso = kinect_torso(0.8);
  if (!torso) return torso.error();
  Section section;
  const auto add = [&](const std::string& name, const Result<PageTable>& table) -> Result<void> {
    if (!table) return table.error();
    section.parts.push_back({name, to_markdown(*table)});
    return {};
  };
  if (const auto done = add("jpeg", jpeg_table(torso->frames.front().color)); !done) return done.error();
  if (const auto done = add("camera", camera_table()); !done) return done.error();
  if (const auto done = add("levels", levels_table()); !done) return done.error();
  if (const auto done = add("anchors", anchors_table()); !done) return done.error();
  section.parts.push_back({"marks", to_markdown(marks_table())});
  if (const auto done = add("ultrasound", ultrasound_table()); !done) return done.error();
  if (const auto done = add("viewer", viewer_table(section.rows)); !done) return done.error();
  return section;
}

}  // namespace telepalp::bench
