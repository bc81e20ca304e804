#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// The required compression ratios of a set of frames, one for each depth mode. They were measured before on this set.
struct RatiosAsked {
  std::string_view set;              ///< description of the frames
  std::array<double, 4> of_modes{};  ///< fast, intra, temporal, bounded; 0: no requirement
};

/// The identification of a set: the CRC-32C of its first frame's samples.
[[nodiscard]] std::uint32_t set_mark(const DepthImage& first);

/// The required ratios of the set whose first frame is `first`; nullptr for an unknown set. A ratio depends on the room
/// and the sensor, so one that was measured on one set says nothing about another.
[[nodiscard]] const RatiosAsked* ratios_asked(const DepthImage& first);

}  // namespace telepalp::bench
