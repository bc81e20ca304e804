#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace telepalp::replay {

/// The parts of a replay whose cost is measured.
enum class Part : std::uint8_t { Source, Encode, Link, Decode, Build, Loop, Judge, Record };
inline constexpr std::size_t kPartCount = 8;
inline constexpr std::array<const char*, kPartCount> kPartNames{
    "source", "encoding", "simulated network", "decoding", "surface", "haptic loop", "comparison", "recording"};

/// Reads a clock [ns]. The simulation has no clock of its own; its caller passes one to measure the cost of the parts.
using CostClock = std::int64_t (*)() noexcept;
[[nodiscard]] inline std::int64_t no_clock() noexcept { return 0; }

/// Sums the cost of each part [ns]. No figure of a run depends on these costs.
class Stopwatch {
 public:
  explicit Stopwatch(CostClock clock = no_clock) noexcept : clock_(clock) {}

  /// Runs `work` and adds its cost to `part`.
  template <class Work>
  decltype(auto) time(Part part, Work&& work) {
    const Booking booking(*this, part);
    return work();
  }
  /// As time(), for the work of each tick: one call in kSampled is measured and counts for all of them, because reading
  /// the clock is a system call that costs as much as the work of a quiet tick.
  template <class Work>
  decltype(auto) sample(Part part, Work&& work) {
    const bool measured = calls_[static_cast<std::size_t>(part)]++ % kSampled == 0;
    if (!measured) return work();
    const Booking booking(*this, part, kSampled);
    return work();
  }
  /// The costs of parts that follow each other: the time since the begin or the last end() belongs to one part.
  class Laps {
   public:
    explicit Laps(Stopwatch& watch) noexcept : watch_(watch), began_(watch.clock_()) {}
    void end(Part part) noexcept {
      const std::int64_t now = watch_.clock_();
      watch_.costs_[static_cast<std::size_t>(part)] += now - std::exchange(began_, now);
    }

   private:
    Stopwatch& watch_;
    std::int64_t began_;
  };
  [[nodiscard]] std::int64_t cost_ns(Part part) const noexcept { return costs_[static_cast<std::size_t>(part)]; }
  void add(const Stopwatch& other) noexcept {
    for (std::size_t i = 0; i < kPartCount; ++i) costs_[i] += other.costs_[i];
  }

 private:
  /// Three frames take 200 ticks. 17 and 200 are coprime, so that all ticks of these frames are measured equally often.
  static constexpr std::int64_t kSampled = 17;

  class Booking {
   public:
    Booking(Stopwatch& watch, Part part, std::int64_t weight = 1) noexcept
        : watch_(watch), part_(part), weight_(weight), began_(watch.clock_()) {}
    ~Booking() { watch_.costs_[static_cast<std::size_t>(part_)] += weight_ * (watch_.clock_() - began_); }
    Booking(const Booking&) = delete;
    Booking& operator=(const Booking&) = delete;

   private:
    Stopwatch& watch_;
    Part part_;
    std::int64_t weight_;
    std::int64_t began_;
  };

  CostClock clock_;
  std::array<std::int64_t, kPartCount> costs_{};
  std::array<std::int64_t, kPartCount> calls_{};  // of sample()
};

}  // namespace telepalp::replay
