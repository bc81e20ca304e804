#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "codec/depth.h"
#include "proto/words/depth/depth_window.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

struct DepthStreamSettings {
  DepthMode mode = DepthMode::Intra;
  int key_every = 30;                         ///< length of a group of pictures: frames from one key frame to the next
  DepthErrorBound bound = kOneDisparityStep;  ///< of DepthMode::Bounded
};

/// Compresses the frames of one camera in order. Fast and Intra frames are all key frames. Temporal and Bounded frames
/// between key frames are predicted from the frame before.
class DepthEncoder {
 public:
  explicit DepthEncoder(const DepthStreamSettings& settings);
  ~DepthEncoder();
  DepthEncoder(DepthEncoder&&) noexcept;
  DepthEncoder& operator=(DepthEncoder&&) noexcept;

  /// `depth` must be well formed. A change of image size or unit forces a key frame. `window`: the part of the image
  /// that stays exact, in the modes Intra and Temporal; other modes ignore it. It must be well formed for this image,
  /// and may differ from frame to frame.
  [[nodiscard]] EncodedDepth encode(const DepthImage& depth, const std::optional<DepthWindow>& window = std::nullopt);

  /// Forces the next frame to be a key frame: a receiver joined, or lost a frame.
  void request_key_frame() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Decodes the frames of one DepthEncoder in order. A frame whose reference frame is missing is an error and changes
/// nothing. After a loss, decode() returns errors until the next key frame: it never returns wrong depth.
class DepthDecoder {
 public:
  DepthDecoder();
  ~DepthDecoder();
  DepthDecoder(DepthDecoder&&) noexcept;
  DepthDecoder& operator=(DepthDecoder&&) noexcept;

  [[nodiscard]] Result<DepthImage> decode(std::span<const std::byte> packet);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A decoded depth image with the facts that its packet's header gives.
struct DecodedDepth {
  DepthImage image;
  DepthMode mode = DepthMode::Fast;
  bool key_frame = true;
  std::optional<DepthWindow> window = {};  ///< nullopt: the packet states no window
};

/// Decodes some frames of a stream and skips others: read() or skip() is called for each packet, in the stream's order.
/// A skipped frame is decoded only if a frame that is read depends on it, or if over 32 frames or 16 MiB were skipped
/// since the last key frame or decoded frame. A skipped key frame discards the frames skipped before it.
class DepthReader {
 public:
  DepthReader();
  ~DepthReader();
  DepthReader(DepthReader&&) noexcept;
  DepthReader& operator=(DepthReader&&) noexcept;

  void skip(std::string packet);

  /// As DepthDecoder::decode(), after the skipped frames that `packet` depends on.
  [[nodiscard]] Result<DecodedDepth> read(std::span<const std::byte> packet);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace telepalp::codec
