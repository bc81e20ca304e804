#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "codec/depth_bound.h"
#include "codec/depth_codec.h"
#include "codec/depth_coding.h"
#include "codec/level_palette.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

struct DepthStreamSettings {
  DepthMode mode = DepthMode::Intra;
  int key_every = 30;     ///< frames from one key frame to the next, where frames depend on one another
  DepthBound bound = {};  ///< of DepthMode::Bounded
};

/// Compresses the frames of one camera, one after the other. Fast and Intra frames stand alone; Temporal and Bounded
/// ones depend on the one before, but for key frames.
class DepthEncoder {
 public:
  explicit DepthEncoder(const DepthStreamSettings& settings) : settings_(settings) {}

  /// `depth` must be well formed. A frame of another size or unit is a key frame.
  [[nodiscard]] std::string encode(const DepthImage& depth);

  /// The next frame is a key frame: somebody joined, or lost one.
  void want_key_frame() noexcept { key_wanted_ = true; }

 private:
  WrittenFrame write(const DepthImage& depth, bool is_key, const Reference& reference);

  DepthStreamSettings settings_;
  StandIns stand_ins_;  // of Bounded, made for the key frame: levels that change from frame to frame cost more
  DepthImage before_;   // as the decoder has it
  LevelPalette before_palette_;
  std::uint32_t before_crc_ = 0;
  int since_key_ = 0;
  bool key_wanted_ = true;
};

/// Gives the frames back. A frame whose reference is not the one at hand is an error and changes nothing: after a loss,
/// errors last until the next key frame, and depth is right or absent.
class DepthDecoder {
 public:
  [[nodiscard]] Result<DepthImage> decode(std::span<const std::byte> packet);

 private:
  DepthImage before_;
  std::optional<LevelPalette> before_palette_;  // as its packet had it
  std::uint32_t before_crc_ = 0;
};

}  // namespace telepalp::codec
