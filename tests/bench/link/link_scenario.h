#pragma once

#include <cstdint>
#include <vector>

#include "proto/impaired/impairment.h"
#include "tests/bench/distribution.h"

namespace telepalp::bench::link {

inline constexpr Nanoseconds kStep = std::chrono::microseconds(250);  ///< of virtual time

/// A camera's frames over an impaired path. A frame is a depth image and a colour image; sizes are those of today's
/// default on the synthetic patient, and vary by a tenth.
struct Scenario {
  impaired::Impairment down{};
  impaired::Impairment up{};
  double seconds = 30.0;
  double frames_hz = 30.0;
  double depth_B = 91'000.0;
  double colour_B = 32'000.0;
  bool depth_depends = false;  ///< true: depth comes in chains; a key frame only when it is asked for
  Nanoseconds encoding = std::chrono::milliseconds(5);    ///< from capture until the frame is offered
  Nanoseconds deadline = std::chrono::milliseconds(100);  ///< after capture
  std::uint64_t seed = 1;
};

struct Outcome {
  std::uint64_t frames = 0;
  std::uint64_t in_time = 0;     ///< both images complete by the deadline
  std::uint64_t shown = 0;       ///< depth images that were the newest when they were complete
  std::uint64_t key_frames = 0;  ///< of depth, with depth_depends
  double content_B = 0.0;
  double sent_B = 0.0;        ///< in the camera's direction, without IP and UDP headers
  double answered_B = 0.0;    ///< in the other direction
  Distribution latency_ms;    ///< from offering an image until it is complete
  Distribution depth_age_ms;  ///< of the newest depth image, each millisecond
  std::uint64_t wrong = 0;    ///< images with other bytes than were sent

  [[nodiscard]] double in_time_percent() const {
    return 100.0 * static_cast<double>(in_time) / static_cast<double>(frames);
  }
  [[nodiscard]] double overhead_percent() const { return 100.0 * (sent_B / content_B - 1.0); }
};

/// In virtual time: the same scenario gives the same outcome.
[[nodiscard]] Outcome run_telepalp(const Scenario& scenario);
[[nodiscard]] Outcome run_plain_udp(const Scenario& scenario);
/// A stream without congestion control: a lost segment holds up all that follow for a round trip.
[[nodiscard]] Outcome run_plain_tcp(const Scenario& scenario);

/// A symmetric path.
[[nodiscard]] Scenario over(Nanoseconds round_trip, double loss, double burst_packets);

}  // namespace telepalp::bench::link
