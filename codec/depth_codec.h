#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// How depth is compressed; the name is what the command line and DepthImage.format say.
enum class DepthMode : std::uint8_t {
  Fast = 0,      ///< without loss; runs and zstd's entropy stage: the cheapest to encode
  Intra = 1,     ///< without loss; context-modelled, every frame stands alone
  Temporal = 2,  ///< without loss; frames between key frames depend on the one before
  Bounded = 3,   ///< as Temporal, of depth moved within a hard bound; for the eye, not for touch
};
inline constexpr std::uint8_t kLastDepthMode = 3;

[[nodiscard]] std::string_view name(DepthMode mode) noexcept;

/// The mode of that name; nullopt when there is none.
[[nodiscard]] std::optional<DepthMode> depth_mode(std::string_view name) noexcept;

/// Compresses one depth image so that it stands alone; without loss but for Bounded, which keeps the default
/// DepthBound. `depth` must be well formed. The packet is never more than 64 B larger than the samples.
[[nodiscard]] std::string encode_depth(const DepthImage& depth, DepthMode mode = DepthMode::Fast);

/// The image that `packet` holds, of any mode, when it stands alone. A damaged or hostile packet is an error, never
/// wrong depth: the samples are checked against a CRC made before coding. Nothing is allocated beyond what
/// kMaxImageSide allows.
[[nodiscard]] Result<DepthImage> decode_depth(std::span<const std::byte> packet);

/// What a packet says of itself, without being decoded.
struct DepthPacketInfo {
  DepthMode mode = DepthMode::Fast;
  std::string_view coding;  ///< "stored", "zstd", "tokens", "contexts" or "dependent"
  int width = 0;
  int height = 0;
  double unit_m = 0.001;
  int slices = 1;
  int since_key = 0;  ///< frames since the key frame that it depends on; 0: it stands alone
};

[[nodiscard]] Result<DepthPacketInfo> inspect_depth(std::span<const std::byte> packet);

/// Whether `packet` can be decoded without the one before it: fast and intra frames, and key frames. False for what is
/// no packet.
[[nodiscard]] bool stands_alone(std::span<const std::byte> packet);

}  // namespace telepalp::codec
