#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "codec/color_reader.h"
#include "codec/depth_stream.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/mcap/reader.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::export_tool {

/// What an export wrote, and how many damaged parts or messages of the session it had to leave out.
struct Exported {
  std::uint64_t written = 0;
  std::uint64_t left_out = 0;
};

/// A line for the user: how many damaged messages of `session` the export leaves out. Empty if `left_out` is 0.
[[nodiscard]] std::string left_out_in_words(std::uint64_t left_out, const std::string& session);

/// Decodes the frames of a session in order: each depth image with the colour image of equal capture time and the last
/// camera model before it.
class Frames {
 public:
  /// Error: not a session file.
  [[nodiscard]] static Result<Frames> open(const std::filesystem::path& file);

  /// Calls `take` with each frame until it returns false or the session ends. Damaged frames are skipped and counted.
  /// Error: the error that `take` returned.
  [[nodiscard]] Result<void> for_each(const std::function<Result<bool>(const RgbdFrame&)>& take);

  /// The last frame that was published up to `at_s` seconds after the session's first message. Error: no depth image in
  /// the 10 s before that time, or the last depth image cannot be decoded.
  [[nodiscard]] Result<RgbdFrame> at(double at_s);

  /// Number of chunks, images and camera models so far that could not be read or decoded.
  [[nodiscard]] std::uint64_t damaged() const noexcept { return damaged_; }

 private:
  explicit Frames(wire::McapReader reader) : reader_(std::move(reader)) {}
  struct Color {
    wire::CompressedColor compressed;
    std::optional<ColorImage> decoded;  ///< of video, which is decoded as it comes
  };
  struct Waiting {
    std::string packet;
    std::int64_t captured_ns = 0;
    std::optional<Color> color;
  };
  [[nodiscard]] std::optional<wire::Message> next();
  void note(const wire::Message& message);
  void take_depth(const wire::Message& message);
  void note_color(const wire::Message& message);
  [[nodiscard]] Result<RgbdFrame> decode(const Waiting& waiting);

  wire::McapReader reader_;
  codec::DepthReader depth_;
  codec::ColorReader color_reader_;
  std::optional<Intrinsics> pinhole_;
  std::optional<Intrinsics> color_pinhole_;
  std::optional<Color> color_;      // colour image whose depth image has not come yet
  std::optional<Waiting> waiting_;  // depth image whose colour may follow
  std::uint64_t damaged_ = 0;
};

}  // namespace telepalp::export_tool
