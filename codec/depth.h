#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "proto/words/depth/depth_window.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// How depth is compressed. The command line and the field `format` of the message DepthImage use the mode's name().
enum class DepthMode : std::uint8_t {
  Fast = 0,      ///< lossless; run lengths and zstd's entropy coder: the cheapest to encode
  Intra = 1,     ///< lossless; context modelling with range coding; every frame is a key frame
  Temporal = 2,  ///< lossless; frames between key frames are predicted from the previous frame
  Bounded = 3,  ///< near-lossless: Temporal, with each depth moved within a DepthErrorBound; for display, not for touch
};
inline constexpr std::uint8_t kLastDepthMode = 3;

[[nodiscard]] std::string_view name(DepthMode mode) noexcept;

/// The mode of that name; nullopt for any other name.
[[nodiscard]] std::optional<DepthMode> depth_mode(std::string_view name) noexcept;

/// The default error bound of DepthMode::Bounded: one disparity step of a Kinect-class camera, which is about that
/// sensor's own resolution, and at least a millimetre.
inline constexpr DepthErrorBound kOneDisparityStep{.least_m = 0.001, .per_m = 2.85e-3};

/// How the error bound grows from a window of exact depth to the image's border.
enum class WindowGrowth : std::uint8_t {
  Flat,     ///< twice kOneDisparityStep everywhere outside the window
  Growing,  ///< from twice beside the window to four times kOneDisparityStep at the image's border
};

/// A window that is exact in `exact`, with the bounds of `growth` around it.
[[nodiscard]] DepthWindow window_around(const PixelRect& exact, WindowGrowth growth) noexcept;

/// A compressed depth image, with facts about it that a reader would otherwise parse from `bytes`.
struct EncodedDepth {
  std::string bytes;
  bool key_frame = true;  ///< decodes without the frame before it
  DepthMode mode = DepthMode::Fast;
  std::optional<DepthErrorBound> bound;  ///< largest bound on the error of a pixel; nullopt: lossless
  /// Where the image is exact although it has a bound. nullopt: the bound holds for each pixel.
  std::optional<DepthWindow> window = {};
  std::uint32_t crc = 0;  ///< CRC-32C of header and decoded samples; it names this frame as a reference
};

/// Compresses one depth image as a key frame. Lossless except for Bounded, which uses kOneDisparityStep. `depth`
/// must be well formed. The packet is at most 64 B larger than the samples.
[[nodiscard]] std::string encode_depth(const DepthImage& depth, DepthMode mode = DepthMode::Fast);

/// Decodes a key frame of any mode. A damaged or hostile packet is an error, never wrong depth: the decoded samples are
/// checked against a CRC made before coding. No allocation is larger than an image of 4096 x 4096 pixels
/// (kMaxImageSide) needs.
[[nodiscard]] Result<DepthImage> decode_depth(std::span<const std::byte> packet);

/// The header fields of a packet.
struct DepthPacketInfo {
  DepthMode mode = DepthMode::Fast;
  std::string_view coding;  ///< the body's format: "stored", "zstd", "tokens", "contexts", "dependent"
  int width = 0;
  int height = 0;
  double unit_m = 0.001;
  int slices = 1;
  int since_key = 0;                       ///< frames since the last key frame; 0: this is a key frame
  std::optional<DepthWindow> window = {};  ///< nullopt: no window
};

[[nodiscard]] Result<DepthPacketInfo> inspect_depth(std::span<const std::byte> packet);

/// True for a key frame, which decodes without the frame before it. False for bytes that are not a packet.
[[nodiscard]] bool is_key_frame(std::span<const std::byte> packet);

}  // namespace telepalp::codec
