#pragma once

#include <optional>
#include <span>

#include "codec/bounded/reconstruction.h"
#include "codec/packet/depth_packet.h"
#include "codec/stream/frame_coding.h"
#include "proto/words/depth/depth_window.h"
#include "proto/words/rgbd_frame.h"

// A frame with a window is coded as two images of their own: the pixels in the window, losslessly, and the whole image
// without them, near-losslessly. Two images need fewer bytes than one: each has a palette (list of distinct depths) and
// models that suit its depths, which are fine in the window and coarse around it.
//
// The body of Coding::Contexts and Dependent is: slices of the window u8 (0: raw samples) | size varint | the window |
// the image around it, in header.slices slices. Neither palette refers to the reference frame's. Coding::Stored holds
// the raw samples of the whole image.

namespace telepalp::codec {

/// Codes `depth` exactly in the window and within its bounds elsewhere. `mode`: Intra or Temporal. `window` must be
/// well formed. `reconstruction`: the depths to which pixels around the window may move; missing ones are added.
[[nodiscard]] CodedFrame code_window(const DepthImage& depth, DepthMode mode, const DepthWindow& window,
                                     ReconstructionLevels& reconstruction, const Reference& reference);

/// Decodes the body of a packet with a window, Coding::Contexts or Dependent, into `samples`. `before`: the samples of
/// the reference frame; empty for a key frame. False when the body is damaged.
[[nodiscard]] bool decode_window(const Packet& packet, std::span<const std::uint16_t> before,
                                 std::span<std::uint16_t> samples);

}  // namespace telepalp::codec
