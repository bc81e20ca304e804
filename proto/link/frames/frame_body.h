#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "proto/link/format/fragment.h"
#include "proto/words/time.h"

namespace telepalp::link {

/// Size of the capture time that precedes a frame's bytes.
inline constexpr std::size_t kStampBytes = sizeof(std::int64_t);

/// The content that is cut into shards: capture time, `bytes`, and zeros up to a whole number of shards.
[[nodiscard]] inline std::vector<std::byte> frame_body(SessionTime captured, std::span<const std::byte> bytes,
                                                       const FrameLayout& layout) {
  std::vector<std::byte> body(layout.data_shards * layout.shard_bytes);
  put_little_endian<std::int64_t>(body.data(), to_nanoseconds(captured));
  std::copy(bytes.begin(), bytes.end(), body.begin() + kStampBytes);
  return body;
}

/// The capture time in `body`; 0 for a negative one, which no correct peer sends and whose age would overflow.
[[nodiscard]] inline SessionTime stamp_of(std::span<const std::byte> body) noexcept {
  return session_time(std::max<std::int64_t>(0, get_little_endian<std::int64_t>(body.data())));
}

}  // namespace telepalp::link
