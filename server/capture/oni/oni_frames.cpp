#include "server/capture/oni/oni_frames.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "codec/color.h"
#include "proto/words/counted.h"
#include "server/capture/oni/record_walk.h"

namespace telepalp::capture {
namespace {

constexpr std::chrono::microseconds kStaleColor{200'000};

/// Focal length: half the pixels / tangent of half the angle. Without a usable angle in the recording, a Kinect's is
/// assumed.
double focal_px(int pixels, double angle_rad, int width) {
  if (angle_rad > 0.1 && angle_rad < 3.0) return 0.5 * pixels / std::tan(0.5 * angle_rad);
  return 525.0 * width / 640.0;
}

Intrinsics pinhole_of(const OniStream& stream) {
  return {.width = stream.width,
          .height = stream.height,
          .fx = focal_px(stream.width, stream.horizontal_view_rad, stream.width),
          .fy = focal_px(stream.height, stream.vertical_view_rad, stream.width),
          .cx = 0.5 * (stream.width - 1),
          .cy = 0.5 * (stream.height - 1)};
}

CameraModel camera_of(const OniRecording& recording) {
  CameraModel camera;
  camera.depth = pinhole_of(recording.depth);
  camera.color = recording.color.images.empty() ? camera.depth : pinhole_of(recording.color);
  camera.color_registered = false;
  return camera;
}

/// The colour image in `packet`; nullopt when it is damaged or has another size than its stream.
std::optional<ColorImage> decoded_color(const OniStream& stream, const std::string& packet) {
  if (stream.codec == OniCodec::Jpeg) {
    Result<ColorImage> color = codec::decode_color(std::as_bytes(std::span(packet)));
    if (!color || color->width != stream.width || color->height != stream.height) return std::nullopt;
    return std::move(*color);
  }
  ColorImage color{stream.width, stream.height, {}};
  color.rgb.resize(3 * static_cast<std::size_t>(stream.width) * static_cast<std::size_t>(stream.height));
  if (packet.size() != color.rgb.size()) return std::nullopt;
  std::memcpy(color.rgb.data(), packet.data(), packet.size());
  return color;
}

}  // namespace

OniFrames::OniFrames(std::ifstream stream, std::string file, OniRecording recording)
    : stream_(std::move(stream)),
      file_(std::move(file)),
      recording_(std::move(recording)),
      camera_(camera_of(recording_)) {}

Result<std::unique_ptr<OniFrames>> OniFrames::open(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return Error{.what = "cannot be read", .where = file, .fix = "check the path and its permissions"};
  Result<OniRecording> recording = read_oni_recording(stream, file);
  if (!recording) return recording.error();
  std::unique_ptr<OniFrames> frames(new OniFrames(std::move(stream), file, std::move(*recording)));
  if (const Result<void> checked = frames->check_first_images(); !checked) return checked.error();
  return frames;
}

/// An error when none of the first depth images can be decoded: then the description of the stream is probably damaged,
/// and no later image can be decoded either.
Result<void> OniFrames::check_first_images() {
  constexpr std::size_t kMostTried = 10;
  const std::vector<OniImage>& images = recording_.depth.images;
  std::optional<Error> first;
  for (std::size_t i = 0; i < std::min(images.size(), kMostTried); ++i) {
    const Result<DepthImage> depth = read_oni_depth(stream_, recording_.depth, images[i], file_);
    if (depth) return {};
    if (!first) first = depth.error();
  }
  first->what = "cannot be played: " + first->what + (recording_.complaint.empty() ? "" : "; ") + recording_.complaint;
  return *first;
}

std::optional<SessionTime> OniFrames::peek() {
  if (next_ >= recording_.depth.images.size()) return std::nullopt;
  return SessionTime{recording_.depth.images[next_].time};
}

std::optional<RgbdFrame> OniFrames::take() {
  const OniImage& image = recording_.depth.images[next_++];
  Result<DepthImage> depth = read_oni_depth(stream_, recording_.depth, image, file_);
  if (!depth) {
    note(depth.error().what + " at byte " + std::to_string(image.at));
    return std::nullopt;
  }
  RgbdFrame frame;
  frame.camera = camera_;
  frame.depth = std::move(*depth);
  frame.color = color_at(image.time);
  return frame;
}

/// Empty when no colour image lies near `time`, or when that image is damaged.
ColorImage OniFrames::color_at(std::chrono::microseconds time) {
  const std::vector<OniImage>& images = recording_.color.images;
  if (images.empty()) return {};
  const auto after =
      std::lower_bound(images.begin(), images.end(), time,
                       [](const OniImage& image, std::chrono::microseconds at) { return image.time < at; });
  const auto nearer = [&](auto a, auto b) {
    return std::chrono::abs(a->time - time) < std::chrono::abs(b->time - time);
  };
  auto nearest = after == images.end() ? std::prev(after) : after;
  if (nearest != images.begin() && nearer(std::prev(nearest), nearest)) nearest = std::prev(nearest);
  if (std::chrono::abs(nearest->time - time) > kStaleColor) return {};
  const std::optional<std::string> packet = read_at(stream_, nearest->at, nearest->bytes);
  std::optional<ColorImage> color;
  if (packet) color = decoded_color(recording_.color, *packet);
  if (!color) note("a colour image is damaged, at byte " + std::to_string(nearest->at));
  return color ? std::move(*color) : ColorImage{};
}

void OniFrames::note(const std::string& damage) {
  if (first_damage_.empty()) first_damage_ = damage;
}

std::string OniFrames::complaint() const {
  const std::string& whole = recording_.complaint;
  return whole + (whole.empty() || first_damage_.empty() ? "" : "; ") + first_damage_;
}

std::string OniFrames::describe() const {
  const OniStream& depth = recording_.depth;
  return "recording " + file_ + ", " + counted(depth.images.size(), "frame of ", "frames of ") +
         std::to_string(depth.width) + "x" + std::to_string(depth.height) +
         (recording_.color.images.empty() ? " depth" : " depth and colour, colour not aligned with depth");
}

}  // namespace telepalp::capture
