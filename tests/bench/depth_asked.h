#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// The compression ratios asked of a set of frames on which they were measured before, one for each depth mode.
struct RatiosAsked {
  std::string_view set;              ///< what the frames show, for people
  std::array<double, 4> of_modes{};  ///< fast, intra, temporal, bounded; 0: none is asked
};

/// What a set is known by: the CRC-32C of its first frame's samples.
[[nodiscard]] std::uint32_t set_mark(const DepthImage& first);

/// The ratios asked of the set that begins with `first`; nullptr for any other set. A ratio depends on the room and the
/// sensor, so one that was measured on one set says nothing about another.
[[nodiscard]] const RatiosAsked* ratios_asked(const DepthImage& first);

}  // namespace telepalp::bench
