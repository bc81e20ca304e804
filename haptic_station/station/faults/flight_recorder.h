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

/// A ring of the last 20 000 ticks (10 s at 2 kHz), allocated at the start. Pure; owner: network thread.
class FlightRecorder {
 public:
  explicit FlightRecorder(std::size_t ticks = 20'000) : ticks_(ticks) {}

  void add(const loop::TickSample& sample) noexcept;
  /// The recorded ticks, oldest first.
  [[nodiscard]] std::vector<loop::TickSample> ticks() const;

 private:
  std::vector<loop::TickSample> ticks_;
  std::size_t next_ = 0;
  bool full_ = false;
};

/// Detects faults among the ticks and keeps the ticks around a fault. Pure; owner: network thread.
class FaultWatch {
 public:
  void add(const loop::TickSample& sample) noexcept;
  /// The first tick of a new fault; each fault is returned once.
  [[nodiscard]] std::optional<loop::TickSample> begun() noexcept { return std::exchange(begun_, std::nullopt); }
  /// The ticks around a fault, once: 0.5 s after the fault, so that they include the release of the force, or at once
  /// if `ending` (the station ends). A second fault in these 0.5 s delays them to 0.5 s after itself.
  [[nodiscard]] std::optional<std::vector<loop::TickSample>> due(bool ending);

 private:
  static constexpr std::uint64_t kTicksAfter = 1000;
  FlightRecorder flight_recorder_;
  std::optional<loop::TickSample> begun_;
  std::optional<std::uint64_t> fault_tick_;
  std::uint64_t newest_tick_ = 0;
  bool faulted_ = false;
};

/// Writes the ticks around a fault to a session file in `folder`: every tick, the state at 100 Hz, each phase change,
/// and each fault that begins among the ticks, with the cause that the fault's first tick states. `scene`: the scene's
/// name. `samples` is not empty. Returns the file's path. Blocks on the disk.
[[nodiscard]] Result<std::filesystem::path> write_flight_record(const std::filesystem::path& folder,
                                                                const std::vector<loop::TickSample>& samples,
                                                                const std::string& scene);

/// Default folder for files that outlive the station: the user's XDG state folder.
[[nodiscard]] std::filesystem::path default_state_folder();

}  // namespace telepalp::station
