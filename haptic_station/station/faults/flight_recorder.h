#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "haptic_station/loop/tick_sample.h"
#include "proto/words/result.h"

namespace telepalp::station {

/// The last ticks before now: 10 s of them at 2 kHz, in memory that is there from the start. Pure; owner: network
/// thread.
class FlightRecorder {
 public:
  explicit FlightRecorder(std::size_t ticks = 20'000) : ticks_(ticks) {}

  void add(const TickSample& sample) noexcept;
  /// Oldest first.
  [[nodiscard]] std::vector<TickSample> ticks() const;

 private:
  std::vector<TickSample> ticks_;
  std::size_t next_ = 0;
  bool full_ = false;
};

/// Looks for faults among the ticks, and keeps what led to them. Pure; owner: network thread.
class FaultWatch {
 public:
  void add(const TickSample& sample) noexcept;
  /// The tick of a fault that has not been told yet.
  [[nodiscard]] std::optional<TickSample> begun() noexcept { return std::exchange(begun_, std::nullopt); }
  /// The ticks around a fault, once it is half a second old, so that the letting go is seen; or sooner, when the
  /// station ends.
  [[nodiscard]] std::optional<std::vector<TickSample>> due(bool ending);

 private:
  static constexpr std::uint64_t kTicksAfter = 1000;
  FlightRecorder flight_recorder_;
  std::optional<TickSample> begun_;
  std::optional<std::uint64_t> fault_tick_;
  std::uint64_t newest_tick_ = 0;
  bool faulted_ = false;
};

/// What led to a fault, as a session file: every tick, the states at 100 Hz, the changes of phase, and the fault. Any
/// program that reads sessions reads it. `samples` is not empty. Blocks on the disk.
[[nodiscard]] Result<std::filesystem::path> write_flight_record(const std::filesystem::path& folder,
                                                                const std::vector<TickSample>& samples,
                                                                const std::string& fault, const std::string& scene);

/// Where a station keeps what must outlive it, if it is not told: the user's folder for state.
[[nodiscard]] std::filesystem::path default_state_folder();

}  // namespace telepalp::station
