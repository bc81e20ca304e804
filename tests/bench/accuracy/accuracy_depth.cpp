#include "tests/bench/accuracy/accuracy_depth.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "codec/depth_stream.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/touch/touch.h"
#include "server/capture/capture_source.h"
#include "support/program/files/shipped.h"
#include "tests/bench/accuracy/accuracy_rms.h"
#include "tests/bench/accuracy/accuracy_surface.h"
#include "tests/bench/distribution.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;

constexpr double kStiffness_N_per_m = 500.0;
constexpr double kDepth_m = 0.005;
constexpr int kPlaceStep_px = 12;

/// CPU time of this thread [ms]. Other programs lengthen it less than wall time.
double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Result<DepthSequence> recorded_room() {
  constexpr std::size_t kFrames = 12;
  const auto file = program::shipped_file("deploy/demo_data/oni/3dj_test.oni");
  if (!file)
    return Error{.what = "the recording is missing",
                 .where = "deploy/demo_data/oni/3dj_test.oni",
                 .fix = "build telepalp-bench in the repository, and unset TELEPALP_HOME"};
  auto source = capture::open_source("oni:" + file->string(),
                                     {.clock = wire::SessionClock{Nanoseconds{0}}, .loop = false, .paced = false});
  if (!source) return source.error();
  DepthSequence room{.name = "recorded room", .camera = {}, .frames = {}, .farthest_m = 1.2};
  while (room.frames.size() < kFrames) {
    auto frame = (*source)->next(std::chrono::milliseconds{1000});
    if (!frame) break;
    room.camera = frame->camera.depth;
    room.frames.push_back(std::move(frame->depth));
  }
  if (room.frames.empty())
    return Error{.what = "the recording gave no frame",
                 .where = file->string(),
                 .fix = "compare the file with the repository: git status"};
  return room;
}

/// Start and depth of a finger's press, on rays through every 12th pixel of the near scene.
struct Press {
  Vector3d from = Vector3d::Zero();
  Vector3d to = Vector3d::Zero();
};

std::vector<Press> presses_on(const DepthSequence& sequence) {
  std::vector<Press> all;
  const DepthImage& depth = sequence.frames.back();
  const Intrinsics& camera = sequence.camera;
  for (int v = kPlaceStep_px; v < depth.height; v += kPlaceStep_px)
    for (int u = kPlaceStep_px; u < depth.width; u += kPlaceStep_px) {
      const double z = depth.unit_m * depth.samples[static_cast<std::size_t>(v * depth.width + u)];
      if (!(z > 0.0) || z > sequence.farthest_m) continue;
      const Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      all.push_back({(z - 0.03) * ray, (z + kDepth_m) * ray});
    }
  return all;
}

/// Force on a finger at the end of each press; nullopt where it is not in contact.
std::vector<std::optional<Vector3d>> forces_of(const surface::SurfaceSnapshot& snapshot,
                                               const std::vector<Press>& presses) {
  constexpr int kSteps = 24;
  constexpr int kSettle = 12;
  std::vector<std::optional<Vector3d>> forces;
  surface::TouchSettings settings;
  settings.stale_after_s = 1e9;
  for (const Press& press : presses) {
    surface::Touch touch(settings);
    touch.adopt(snapshot, snapshot.captured);
    surface::TouchSample last;
    for (int i = 0; i <= kSteps + kSettle; ++i) {
      const double share = std::min(1.0, static_cast<double>(i) / kSteps);
      last = touch.step({press.from + share * (press.to - press.from)}, snapshot.captured, 0.0005);
    }
    const bool whole =
        last.in_body && last.coverage > 0.99;  // at a rim, holes determine the force instead of the codec
    forces.push_back(whole ? std::optional<Vector3d>(kStiffness_N_per_m * (last.proxy.m - press.to)) : std::nullopt);
  }
  return forces;
}

std::shared_ptr<const surface::SurfaceSnapshot> surface_of(const DepthSequence& sequence,
                                                           const std::vector<DepthImage>& frames) {
  surface::SurfaceBuilder builder{surface::SurfaceSettings{}};
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  for (std::size_t n = 0; n < frames.size(); ++n)
    snapshot =
        builder.add(frames[n], sequence.camera, testing::scene_time(static_cast<double>(n) / 30.0), std::nullopt);
  return snapshot;
}

void compare(const DepthImage& sent, const DepthImage& got, DepthPrice& into, RootMeanSquare& all_mm) {
  for (std::size_t i = 0; i < sent.samples.size(); ++i) {
    if (sent.samples[i] == 0) continue;
    const double error_mm = 1000.0 * sent.unit_m * std::abs(sent.samples[i] - got.samples[i]);
    into.worst_mm = std::max(into.worst_mm, error_mm);
    all_mm.add(error_mm);
  }
}

/// Compares forces. `captured`, `got`: the images of `sequence` as captured and as decoded; where they have a window,
/// without the pixels outside it.
void feel(const DepthSequence& sequence, const std::vector<DepthImage>& captured, const std::vector<DepthImage>& got,
          DepthPrice& price) {
  const std::vector<Press> presses = presses_on(sequence);
  const auto true_N = forces_of(*surface_of(sequence, captured), presses);
  const auto shown_N = forces_of(*surface_of(sequence, got), presses);
  Distribution error_N;
  RootMeanSquare all_N;
  for (std::size_t i = 0; i < presses.size(); ++i) {
    if (!true_N[i] || !shown_N[i]) continue;
    error_N.add((*shown_N[i] - *true_N[i]).norm());
    all_N.add((*shown_N[i] - *true_N[i]).norm());
  }
  price.places = static_cast<int>(error_N.count());
  price.force_rms_N = all_N.value();
  price.force_p99_N = error_N.p99();
  price.force_max_N = error_N.max();
}

}  // namespace

Result<std::vector<DepthSequence>> depth_sequences() {
  Result<DepthSequence> room = recorded_room();
  if (!room) return room.error();
  Result<FilmedTorso> torso = kinect_torso(0.8);
  if (!torso) return torso.error();
  DepthSequence patient{.name = "synthetic torso",
                        .camera = torso->patient.settings().camera,
                        .frames = {},
                        .farthest_m = torso->spot.at.z() + 0.05};
  for (RgbdFrame& frame : torso->frames)
    if (patient.frames.size() < room->frames.size()) patient.frames.push_back(std::move(frame.depth));
  return std::vector<DepthSequence>{std::move(*room), std::move(patient)};
}

PixelRect rect_of_the_hand(const DepthSequence& sequence, double share) {
  const DepthImage& depth = sequence.frames.back();
  double columns = 0.0, rows = 0.0, count = 0.0;
  for (int row = 0; row < depth.height; ++row)
    for (int column = 0; column < depth.width; ++column) {
      const double z_m = depth.unit_m * depth.at(column, row);
      if (!(z_m > 0.0) || z_m > sequence.farthest_m) continue;
      columns += column;
      rows += row;
      count += 1.0;
    }
  const int width = static_cast<int>(std::sqrt(share) * depth.width);
  const int height = static_cast<int>(std::sqrt(share) * depth.height);
  return {.column = std::clamp(static_cast<int>(columns / std::max(1.0, count)) - width / 2, 0, depth.width - width),
          .row = std::clamp(static_cast<int>(rows / std::max(1.0, count)) - height / 2, 0, depth.height - height),
          .width = width,
          .height = height};
}

Result<DepthPrice> price_of(const DepthSequence& sequence, codec::DepthMode mode, const DepthErrorBound& bound,
                            const std::optional<DepthWindow>& window) {
  codec::DepthEncoder encoder({.mode = mode, .bound = bound});
  codec::DepthDecoder decoder;
  DepthPrice price;
  Distribution encode_ms;
  Distribution decode_ms;
  double bytes = 0.0;
  double pixels = 0.0;
  RootMeanSquare error_mm;
  std::vector<DepthImage> got;
  for (const DepthImage& frame : sequence.frames) {
    const double start_ms = cpu_ms();
    const std::string packet = encoder.encode(frame, window).bytes;
    const double encoded_ms = cpu_ms();
    Result<DepthImage> decoded = decoder.decode(std::as_bytes(std::span(packet)));
    decode_ms.add(cpu_ms() - encoded_ms);
    encode_ms.add(encoded_ms - start_ms);
    if (!decoded) return decoded.error();
    compare(frame, *decoded, price, error_mm);
    bytes += static_cast<double>(packet.size());
    pixels += static_cast<double>(frame.samples.size());
    if (window) keep_only(*decoded, window->exact);
    got.push_back(std::move(decoded).value());
  }
  price.bits_per_pixel = 8.0 * bytes / pixels;
  price.ratio = 16.0 / price.bits_per_pixel;
  price.rms_mm = error_mm.value();
  price.encode_p50_ms = encode_ms.p50();
  price.decode_p50_ms = decode_ms.p50();
  std::vector<DepthImage> captured = sequence.frames;
  if (window)
    for (DepthImage& frame : captured) keep_only(frame, window->exact);
  feel(sequence, captured, got, price);
  return price;
}

}  // namespace telepalp::bench
