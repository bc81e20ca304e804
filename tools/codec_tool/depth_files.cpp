#include "tools/codec_tool/depth_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <variant>
#include <vector>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/reader.h"
#include "server/capture/open_recording.h"
#include "support/images/image_file.h"
#include "tools/codec_tool/pgm.h"

namespace telepalp::codec_tool {
namespace {

namespace fs = std::filesystem;
using Visit = std::function<Result<void>(NamedDepth)>;
using PassOver = std::function<void(const Error&)>;

bool is_image(const fs::path& file) {
  constexpr std::array kEndings{".png", ".tif", ".tiff", ".pgm"};
  return std::find(kEndings.begin(), kEndings.end(), file.extension()) != kEndings.end();
}

std::vector<fs::path> image_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (fs::recursive_directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
    if (entry->is_regular_file(code) && is_image(entry->path())) files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

Result<images::AnyImage> read_any(const fs::path& file) {
  if (file.extension() != ".pgm") return images::read_image(file);
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  Result<images::GrayImage16> image = decode_pgm(bytes, file.string());
  if (!image) return image.error();
  return images::AnyImage{*std::move(image)};
}

/// Visits the image in `file`. An image without depth is skipped if `colour_may_be` is set, else it is an error.
Result<void> visit_image(const fs::path& file, double unit_m, bool colour_may_be, const Visit& visit) {
  Result<images::AnyImage> image = read_any(file);
  if (!image) return image.error();
  auto* const depth = std::get_if<images::GrayImage16>(&*image);
  if (depth == nullptr) {
    if (colour_may_be) return {};
    return Error{.what = "is not a 16-bit grey image",
                 .where = file.string(),
                 .fix = "give depth as a 16-bit grey PNG, TIFF or PGM"};
  }
  return visit(
      {file.filename().string(),
       {},
       {.width = depth->width, .height = depth->height, .unit_m = unit_m, .samples = std::move(depth->samples)}});
}

Result<void> visit_session(const fs::path& file, const Visit& visit, const PassOver& pass_over) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  reader->select({.topics = {std::string(wire::kCameraDepth.name)}});
  codec::DepthDecoder decoder;
  for (std::size_t number = 0;; ++number) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!*message) return {};
    msg::DepthImage image;
    if (!image.ParseFromString(*(*message)->payload))
      return Error{
          .what = "message " + std::to_string(number) + " of /camera/depth, counted from 0, is not a depth image",
          .where = file.string(),
          .fix = "check the session: telepalp-record verify " + file.string()};
    Result<DepthImage> depth = decoder.decode(std::as_bytes(std::span(image.data())));
    if (!depth) {
      if (!pass_over)
        return Error{.what = "depth image " + std::to_string(number) +
                             ", counted from 0, cannot be decoded: " + depth.error().what,
                     .where = file.string(),
                     .fix = "to write the depth images that can be decoded: telepalp-codec decode " + file.string() +
                            " OUT_DIR"};
      pass_over(depth.error());
      continue;
    }
    const SessionTime captured{Nanoseconds{static_cast<std::int64_t>(image.captured_ns())}};
    if (Result<void> done =
            visit({std::to_string(number), captured, *std::move(depth), wire::loss_of(wire::depth_fidelity(image))});
        !done)
      return done;
  }
}

Result<void> visit_source(const std::string& spec, const Visit& visit, const PassOver& pass_over) {
  Result<std::unique_ptr<capture::CaptureSource>> source =
      capture::open_recording(spec, {.clock = wire::SessionClock{Nanoseconds{0}}, .loop = false, .paced = false});
  if (!source) return source.error();
  for (std::size_t number = 0;;) {
    std::optional<RgbdFrame> frame = (*source)->next(std::chrono::milliseconds{100});
    if (frame) {
      if (Result<void> done = visit({std::to_string(number++), frame->captured, std::move(frame->depth)}); !done)
        return done;
    } else if ((*source)->state() == capture::CaptureState::Ended) {
      const std::string complaint = (*source)->complaint();
      if (complaint.empty()) return {};
      const Error damage{.what = complaint,
                         .where = spec,
                         .fix = "if the recording is damaged or cut off, copy the whole recording again"};
      if (!pass_over || number == 0) return damage;
      pass_over(damage);
      return {};
    } else if ((*source)->state() == capture::CaptureState::Lost) {
      return Error{.what = (*source)->detail(), .where = spec, .fix = "check the file"};
    }
  }
}

}  // namespace

Result<void> for_each_depth(const fs::path& input, double unit_m, const Visit& visit, const PassOver& pass_over) {
  std::error_code code;
  if (!fs::exists(input, code))
    return Error{.what = "there is no such file", .where = input.string(), .fix = "check the path"};
  if (fs::is_directory(input, code)) {
    for (const fs::path& file : image_files(input))
      if (Result<void> done = visit_image(file, unit_m, true, visit); !done) return done;
    return {};
  }
  if (is_image(input)) return visit_image(input, unit_m, false, visit);
  if (input.extension() == ".mcap") return visit_session(input, visit, pass_over);
  if (input.extension() == ".oni") return visit_source("oni:" + input.string(), visit, pass_over);
  if (input.extension() == ".pcd") return visit_source("pcd:" + input.string(), visit, pass_over);
  return Error{.what = "is not a depth file",
               .where = input.string(),
               .fix = "give PNG, TIFF, PGM, .oni, .pcd, .mcap, or a folder of images"};
}

std::size_t count_depth_files(const fs::path& input) {
  std::error_code code;
  return fs::is_directory(input, code) ? image_files(input).size() : 0;
}

}  // namespace telepalp::codec_tool
