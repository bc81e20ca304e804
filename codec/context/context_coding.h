#pragma once

#include <optional>
#include <string>
#include <vector>

#include "codec/context/kernel.h"
#include "codec/levels/ranked_frame.h"
#include "codec/packet/depth_packet.h"

namespace telepalp::codec {

/// The fastest kernel that this processor supports.
[[nodiscard]] const ContextKernel& context_kernel();

/// How a frame is cut into slices: bands of rows, equal in height except the last. Slices are coded independently, so
/// that one core codes four of them in lockstep.
struct Slicing {
  int slices = 1;
  int rows = 0;  ///< rows of each slice except the last

  /// One to four slices for a frame of up to 2^20 pixels, up to 64 for a larger one. Small slices code worse: a slice
  /// adapts its models anew from the trained tables, which takes many pixels.
  [[nodiscard]] static Slicing for_frame(int width, int height) noexcept;
  /// The slicing that a packet declares. nullopt: `height` rows cannot be cut into `slices` slices.
  [[nodiscard]] static std::optional<Slicing> declared(int height, int slices) noexcept;
  [[nodiscard]] int rows_of(int slice, int height) const noexcept;
};

/// The reference frame, from which a frame is predicted.
struct FrameBefore {
  std::span<const std::uint16_t> samples;  ///< samples of a frame of the same size; empty: a key frame
  const LevelPalette* palette = nullptr;   ///< of `samples`; nullptr: it is computed from `samples`
};

/// Codes a frame's palette (its distinct depths) and its slices. A pixel's rank is the index of its depth in the
/// palette. In near-lossless coding, where each pixel may take a range of ranks, `frame.ranks` receives the chosen
/// ranks. nullopt: the result would not be smaller than the raw samples.
[[nodiscard]] std::optional<std::string> encode_contexts(RankedFrame& frame, int width, const FrameBefore& before,
                                                         const Slicing& slicing, const ContextKernel& kernel);

/// Converts ranks to samples. A rank beyond the palette, which only a damaged packet contains, becomes "not measured";
/// the check of the frame's CRC then fails.
void put_levels(const Ranks& ranks, const LevelPalette& palette, std::span<std::uint16_t> samples);

/// Decodes a body of encode_contexts() into `samples` and returns its palette. nullopt: the body is damaged.
[[nodiscard]] std::optional<LevelPalette> decode_contexts(const Packet& packet, const FrameBefore& before,
                                                          std::span<std::uint16_t> samples,
                                                          const ContextKernel& kernel);

}  // namespace telepalp::codec
