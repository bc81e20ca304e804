#pragma once

#include <filesystem>
#include <optional>

#include "codec/color_reader.h"
#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/mcap/reader.h"
#include "server/capture/pacing/recorded_frames.h"

namespace telepalp::capture {

/// The frames of a recorded session. A frame has a depth image, the colour image of equal capture time, and the camera
/// model that was recorded last before the depth image.
class SessionFrames final : public RecordedFrames {
 public:
  /// `keep_compressed`: compressed() gives the images as recorded, and colour is not decoded. Error: not a session
  /// file, no depth, or no camera model.
  [[nodiscard]] static Result<SessionFrames> open(const std::filesystem::path& file, bool keep_compressed = false);

  std::optional<SessionTime> peek() override;
  std::optional<RgbdFrame> take() override;
  [[nodiscard]] const CompressedFrame* compressed() const override { return compressed_ ? &*compressed_ : nullptr; }
  /// Skips a frame. Its depth is decoded only if a frame that is taken later is predicted from it.
  void skip() override;
  void rewind() override;
  [[nodiscard]] std::string complaint() const override;
  [[nodiscard]] std::uint64_t damaged() const noexcept { return damaged_; }

 private:
  SessionFrames(wire::McapReader reader, bool keep_compressed)
      : reader_(std::move(reader)), keep_compressed_(keep_compressed) {
    rewind();
  }
  void read_on();
  void note(const wire::Message& message);
  void note_color(const wire::Message& message);

  struct Color {
    wire::CompressedColor compressed;
    std::optional<ColorImage> decoded;  ///< of video, which is decoded as it comes
  };
  struct Encoded {
    msg::DepthImage depth;
    std::optional<Color> color;
    Intrinsics pinhole;
  };
  void take_color(Color color, RgbdFrame& frame);

  wire::McapReader reader_;
  bool keep_compressed_;
  std::optional<CompressedFrame> compressed_;  // of the frame that was taken last
  std::optional<Intrinsics> pinhole_;
  std::optional<Color> color_;        // last colour message
  std::optional<Encoded> gathering_;  // depth image whose colour may follow
  std::optional<Encoded> next_;
  codec::DepthReader depth_;
  codec::ColorReader color_reader_;
  std::uint64_t damaged_ = 0;
};

}  // namespace telepalp::capture
