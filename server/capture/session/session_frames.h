#pragma once

#include <filesystem>
#include <optional>

#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "proto/wire/mcap/reader.h"
#include "server/capture/pacing/recorded_frames.h"

namespace telepalp::server {

/// The frames of a recorded session. Depth leads; each gets the colour of the same capture, and the camera model last
/// published.
class SessionFrames final : public RecordedFrames {
 public:
  /// Refused: no session file, one without depth, or one without a camera model.
  [[nodiscard]] static Result<SessionFrames> open(const std::filesystem::path& file);

  std::optional<SessionTime> peek() override;
  std::optional<RgbdFrame> take() override;
  /// The skipped frame's depth is decoded only if a frame that is taken depends on it.
  void skip() override;
  void rewind() override;
  [[nodiscard]] std::string complaint() const override;
  [[nodiscard]] std::uint64_t damaged() const noexcept { return damaged_; }

 private:
  explicit SessionFrames(wire::McapReader reader) : reader_(std::move(reader)) { rewind(); }
  void read_on();
  void note(const wire::Message& message);

  struct Encoded {
    msg::DepthImage depth;
    std::optional<foxglove::CompressedImage> color;
    Intrinsics pinhole;
  };
  wire::McapReader reader_;
  std::optional<Intrinsics> pinhole_;
  std::optional<foxglove::CompressedImage> color_;  // the last one seen
  std::optional<Encoded> gathering_;                // a depth image whose colour may still come
  std::optional<Encoded> next_;
  codec::DepthReader depth_;
  std::uint64_t damaged_ = 0;
};

}  // namespace telepalp::server
