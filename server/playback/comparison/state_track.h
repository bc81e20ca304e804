#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "messages/station.pb.h"
#include "proto/words/result.h"

namespace telepalp::playback {

/// The part of a station's state that compare_tracks() uses.
struct TrackPoint {
  std::int64_t at_ns = 0;          ///< session time of the state
  std::array<float, 3> force_N{};  ///< in the haptic base's frame
  float indentation_m = 0.0F;
  msg::Phase phase = msg::PHASE_UNSPECIFIED;
};

/// The states of the station whose state comes first in a session, in order of time.
struct StateTrack {
  std::int64_t begin_ns = 0;  ///< session time of the session's first message
  std::int64_t end_ns = 0;    ///< session time of the session's last message
  std::vector<TrackPoint> points;
  std::uint64_t damaged = 0;  ///< chunks and states that could not be read
  bool is_cut = false;        ///< the file has states after the first kMostTrackPoints
};

/// Two hours at 100 Hz; later states are left out.
inline constexpr std::size_t kMostTrackPoints = 720'000;

/// Reads the states of a session file; a damaged chunk costs only its own states. `stopping`: ends the reading early.
/// Error: the file cannot be opened, or holds no state of a station.
[[nodiscard]] Result<StateTrack> read_track(const std::filesystem::path& file, const std::atomic<bool>& stopping);

}  // namespace telepalp::playback
