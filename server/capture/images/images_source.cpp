#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

#include "codec/color.h"
#include "proto/words/counted.h"
#include "server/capture/images/camera_file.h"
#include "server/capture/images/image_listing.h"
#include "server/capture/pacing/sequence_source.h"
#include "server/capture/sources.h"
#include "support/images/image_file.h"

namespace telepalp::capture {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 200'000;
constexpr std::size_t kKeptBytes = 256U << 20U;  // a sequence up to this size is decoded once and kept

/// Paths relative to `folder`, at most one folder down.
Result<std::vector<fs::path>> list(const fs::path& folder) {
  std::error_code code;
  std::vector<fs::path> files;
  fs::recursive_directory_iterator entry{folder, code};
  for (; !code && entry != fs::recursive_directory_iterator{}; entry.increment(code)) {
    if (entry->is_directory(code) && entry.depth() >= 1) entry.disable_recursion_pending();
    if (entry->is_regular_file(code)) files.push_back(entry->path().lexically_relative(folder));
    if (files.size() > kMaxFiles)
      return Error{.what = "holds more than 200000 files",
                   .where = folder.string(),
                   .fix = "split the recording into several folders"};
  }
  if (code)
    return Error{.what = "cannot be listed: " + code.message(),
                 .where = folder.string(),
                 .fix = "give a folder that this program may read"};
  return files;
}

/// Everything needed to load any frame of the directory.
struct Recording {
  fs::path folder;
  std::vector<ImagePair> pairs;
  RecordedCamera camera;
  int color_width = 0;  // 0: no colour
  int color_height = 0;
};

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

Error other_size(const fs::path& file, int width, int height, int first_width, int first_height) {
  return {.what = "is " + size_text(width, height) + " pixels, but the first image has " +
                  size_text(first_width, first_height),
          .where = file.string(),
          .fix = "keep only images of the same size in this folder"};
}

/// Reads a PNG, TIFF or JPEG file. A JPEG begins with FF D8.
Result<ColorImage> read_color(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (in.get() != 0xff || in.get() != 0xd8) return images::read_color_image(file);
  in.seekg(0);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Result<ColorImage> color = codec::decode_color(std::as_bytes(std::span(bytes)));
  if (color) return color;
  Error error = color.error();
  error.where = file.string();
  return error;
}

Result<RgbdFrame> load(const Recording& recording, std::size_t number) {
  const ImagePair& pair = recording.pairs[number];
  Result<images::GrayImage16> depth = images::read_depth_image(recording.folder / pair.depth);
  if (!depth) return depth.error();
  const Intrinsics& pinhole = recording.camera.model.depth;
  if (depth->width != pinhole.width || depth->height != pinhole.height)
    return other_size(recording.folder / pair.depth, depth->width, depth->height, pinhole.width, pinhole.height);
  for (std::uint16_t& sample : depth->samples)
    if (sample > recording.camera.ignore_above) sample = 0;
  RgbdFrame frame;
  frame.camera = recording.camera.model;
  frame.depth = {depth->width, depth->height, recording.camera.depth_unit_m, std::move(depth->samples)};
  if (!pair.color) return frame;
  Result<ColorImage> color = read_color(recording.folder / *pair.color);
  if (!color) return color.error();
  if (color->width != recording.color_width || color->height != recording.color_height)
    return other_size(recording.folder / *pair.color, color->width, color->height, recording.color_width,
                      recording.color_height);
  frame.color = std::move(*color);
  return frame;
}

Result<RecordedCamera> camera_beside(const fs::path& folder, int width, int height) {
  const fs::path file = folder / "camera.textproto";
  std::error_code code;
  if (!fs::exists(file, code)) return assumed_camera(file, width, height);
  return read_camera_file(file, width, height);
}

/// Loads and keeps all frames if they take at most kKeptBytes. Otherwise it checks the first frame, and keeps none.
Result<std::vector<RgbdFrame>> load_all(const Recording& recording) {
  const Intrinsics& pinhole = recording.camera.model.depth;
  const auto pixels = [](int width, int height) { return static_cast<std::size_t>(width * height); };
  const std::size_t frame_bytes =
      2 * pixels(pinhole.width, pinhole.height) + 3 * pixels(recording.color_width, recording.color_height);
  const bool keep = frame_bytes * recording.pairs.size() <= kKeptBytes;
  std::vector<RgbdFrame> frames;
  for (std::size_t number = 0; number < (keep ? recording.pairs.size() : 1); ++number) {
    Result<RgbdFrame> frame = load(recording, number);
    if (!frame) return frame.error();
    if (keep) frames.push_back(std::move(*frame));
  }
  return frames;
}

std::string color_in_words(const Recording& recording) {
  if (recording.color_width == 0) return " without colour";
  return recording.camera.model.color_registered ? " with colour" : " with colour that is not registered to depth";
}

std::string describe(const Recording& recording) {
  const Intrinsics& pinhole = recording.camera.model.depth;
  std::string text = counted(recording.pairs.size(), "image ", "images ") + size_text(pinhole.width, pinhole.height) +
                     color_in_words(recording) + " from " + recording.folder.string();
  return recording.camera.warning.empty() ? text : recording.camera.warning + "; playing " + text;
}

}  // namespace

Result<std::unique_ptr<CaptureSource>> open_images(const std::string& folder, const SourceOptions& options) {
  const Result<std::vector<fs::path>> files = list(folder);
  if (!files) return files.error();
  Result<std::vector<ImagePair>> pairs = order_images(*files, folder);
  if (!pairs) return pairs.error();
  const Result<images::GrayImage16> first = images::read_depth_image(fs::path{folder} / pairs->front().depth);
  if (!first) return first.error();
  Result<RecordedCamera> camera = camera_beside(folder, first->width, first->height);
  if (!camera) return camera.error();
  auto recording = std::make_shared<Recording>(Recording{folder, std::move(*pairs), std::move(*camera), 0, 0});
  if (recording->pairs.front().color) {
    const Result<ColorImage> picture = read_color(recording->folder / *recording->pairs.front().color);
    if (!picture) return picture.error();
    recording->color_width = picture->width;
    recording->color_height = picture->height;
  }
  Result<std::vector<RgbdFrame>> kept = load_all(*recording);
  if (!kept) return kept.error();
  const Nanoseconds period = from_seconds(1.0 / recording->camera.frames_per_s);
  // shared_ptr, because std::function copies its captures; the frames are constant.
  const auto frames = std::make_shared<const std::vector<RgbdFrame>>(std::move(*kept));
  return play({.count = recording->pairs.size(),
               .period = period,
               .load = [recording, frames](std::size_t number) -> Result<RgbdFrame> {
                 if (!frames->empty()) return (*frames)[number];
                 return load(*recording, number);
               },
               .description = describe(*recording)},
              options);
}

}  // namespace telepalp::capture
