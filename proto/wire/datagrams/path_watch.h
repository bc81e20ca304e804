#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <string_view>

#include "proto/words/time.h"

namespace telepalp::wire {

/// Whether datagrams arrive at the peer, as one end of a connection knows it. Images go by datagram in Up only.
enum class DatagramPhase {
  Off,      ///< the server has offered no datagrams
  Trying,   ///< offered, but the peer has not answered a datagram yet
  Up,       ///< the peer answers
  Blocked,  ///< no answer, because of a firewall or an outage; tried again after a pause
};
enum class DatagramEvent { Offered, Answered, Silent, PauseOver };

struct DatagramRow {
  DatagramPhase from;
  DatagramEvent on;
  DatagramPhase to;
};
inline constexpr DatagramRow kDatagramTransitions[] = {
    {DatagramPhase::Off, DatagramEvent::Offered, DatagramPhase::Trying},
    {DatagramPhase::Trying, DatagramEvent::Answered, DatagramPhase::Up},
    {DatagramPhase::Trying, DatagramEvent::Silent, DatagramPhase::Blocked},
    {DatagramPhase::Up, DatagramEvent::Silent, DatagramPhase::Blocked},
    {DatagramPhase::Blocked, DatagramEvent::Answered, DatagramPhase::Up},
    {DatagramPhase::Blocked, DatagramEvent::PauseOver, DatagramPhase::Trying},
};
[[nodiscard]] constexpr DatagramPhase next(DatagramPhase phase, DatagramEvent event) noexcept {
  for (const DatagramRow& row : kDatagramTransitions)
    if (row.from == phase && row.on == event) return row.to;
  return phase;  // a pair not listed changes nothing
}

[[nodiscard]] constexpr std::string_view name(DatagramPhase phase) noexcept {
  switch (phase) {
    case DatagramPhase::Off:
      return "off";
    case DatagramPhase::Trying:
      return "trying";
    case DatagramPhase::Up:
      return "up";
    case DatagramPhase::Blocked:
      return "blocked";
  }
  return "?";
}

/// The phase of a datagram path over time. Pauses double from kFirstPause to kLongestPause. Pure: time is an argument.
class PathWatch {
 public:
  static constexpr Nanoseconds kAnswerWithin =
      std::chrono::milliseconds(1500);  ///< longest time in Trying; a report and its answer take 0.6 s by satellite
  static constexpr Nanoseconds kSilence = std::chrono::seconds(1);  ///< longest time without an answer in Up
  static constexpr Nanoseconds kFirstPause = std::chrono::seconds(2);
  static constexpr Nanoseconds kLongestPause = std::chrono::seconds(30);
  static constexpr Nanoseconds kSteady =
      std::chrono::seconds(10);  ///< after this time in Up, pauses start at kFirstPause again

  void offered(SessionTime now) noexcept { on(DatagramEvent::Offered, now); }
  /// The peer acknowledged a datagram of this end: the path works in both directions.
  void answered(SessionTime now) noexcept {
    answered_at_ = now;
    on(DatagramEvent::Answered, now);
  }
  /// Datagrams now go another way, which may work: the pause is over.
  void way_changed(SessionTime now) noexcept { on(DatagramEvent::PauseOver, now); }
  /// Call it at the time due().
  void step(SessionTime now) noexcept {
    const auto at = due();
    if (at && now >= *at) on(phase_ == DatagramPhase::Blocked ? DatagramEvent::PauseOver : DatagramEvent::Silent, now);
  }
  /// When the phase changes unless the peer answers before; nullopt: never.
  [[nodiscard]] std::optional<SessionTime> due() const noexcept {
    switch (phase_) {
      case DatagramPhase::Trying:
        return since_ + kAnswerWithin;
      case DatagramPhase::Up:
        return answered_at_ + kSilence;
      case DatagramPhase::Blocked:
        return since_ + pause_;
      case DatagramPhase::Off:
        break;
    }
    return std::nullopt;
  }
  [[nodiscard]] DatagramPhase phase() const noexcept { return phase_; }

 private:
  void on(DatagramEvent event, SessionTime now) noexcept {
    const DatagramPhase before = phase_;
    phase_ = next(phase_, event);
    if (phase_ == before) return;
    if (before == DatagramPhase::Up && now - since_ >= kSteady) pause_ = Nanoseconds{0};
    if (phase_ == DatagramPhase::Blocked) pause_ = std::clamp(2 * pause_, kFirstPause, kLongestPause);
    since_ = now;
  }

  DatagramPhase phase_ = DatagramPhase::Off;
  SessionTime since_{};
  SessionTime answered_at_{};
  Nanoseconds pause_{0};
};

}  // namespace telepalp::wire
