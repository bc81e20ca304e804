#pragma once

#include <map>
#include <random>
#include <vector>

#include "tests/bench/link/link_scenario.h"

namespace telepalp::bench::link {

enum Image : std::uint8_t { kDepth, kColour };

struct CameraImage {
  Image image;
  std::uint32_t number;
  Nanoseconds captured;
  std::vector<std::byte> bytes;
};

/// The camera's images, and the count of those that arrive. Times are since the start.
class CameraFeed {
 public:
  explicit CameraFeed(const Scenario& scenario);

  /// The images that are encoded by `now`, each once.
  [[nodiscard]] std::vector<CameraImage> due(Nanoseconds now);
  /// An image is complete at the receiver.
  void complete(Image image, std::uint32_t number, Nanoseconds captured, std::size_t bytes, Nanoseconds now);
  /// Records the age of the newest depth image; call it once a millisecond.
  void sample_age(Nanoseconds now);
  [[nodiscard]] bool finished(Nanoseconds now) const noexcept;
  [[nodiscard]] Outcome& outcome() noexcept { return outcome_; }

 private:
  [[nodiscard]] std::vector<std::byte> content(double mean_B);

  Scenario scenario_;
  std::mt19937_64 random_;
  std::uint32_t next_ = 0;
  std::map<std::uint32_t, int> images_in_time_;
  std::map<std::pair<int, std::uint32_t>, std::size_t> sizes_;
  Nanoseconds newest_depth_{-1};
  Outcome outcome_;
};

}  // namespace telepalp::bench::link
