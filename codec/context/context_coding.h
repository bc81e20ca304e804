#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codec/context/kernel.h"
#include "codec/levels/ranked_frame.h"
#include "codec/packet/depth_packet.h"

namespace telepalp::codec {

/// The best kernel that this processor runs.
[[nodiscard]] const ContextKernel& context_kernel();

/// Bands of equal height, but for the last, that a frame is cut into. Why: they decode side by side, within one core
/// and across several.
struct Slicing {
  int slices = 1;
  int rows = 0;  ///< of each but the last

  /// LaneVector for a frame of any size worth cutting, more for large ones; a slice's models start from the trained
  /// tables.
  [[nodiscard]] static Slicing for_frame(int width, int height) noexcept;
  /// nullopt when so many slices cannot be had of so many rows.
  [[nodiscard]] static std::optional<Slicing> declared(int height, int slices) noexcept;
  [[nodiscard]] int rows_of(int slice, int height) const noexcept;
};

/// What a frame is coded against.
struct FrameBefore {
  std::span<const std::uint16_t> samples;  ///< of the same size; empty: the frame stands alone
  const LevelPalette* palette = nullptr;   ///< of `samples`, where it is at hand
};

/// Palette and slices of a frame. Where its pixels may have one of several ranks, `frame.ranks` become those that are
/// written. nullopt when that takes more bytes than its samples.
[[nodiscard]] std::optional<std::string> encode_contexts(RankedFrame& frame, int width, const FrameBefore& before,
                                                         const Slicing& slicing, const ContextKernel& kernel);

/// Samples from ranks. One beyond the palette, which only a damaged packet has, is as if not measured: the frame's crc
/// tells.
void put_levels(const Ranks& ranks, const LevelPalette& palette, std::span<std::uint16_t> samples);

/// Fills `samples` from such a body, and gives its palette. nullopt when it is damaged.
[[nodiscard]] std::optional<LevelPalette> decode_contexts(const Packet& packet, const FrameBefore& before,
                                                          std::span<std::uint16_t> samples,
                                                          const ContextKernel& kernel);

}  // namespace telepalp::codec
