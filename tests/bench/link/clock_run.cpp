#include "tests/bench/link/clock_run.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "proto/impaired/impaired_link.h"
#include "proto/wire/clock_sync.h"

namespace telepalp::bench::link {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kAhead = 100s;  // of the session clock, at local time 0
constexpr double kDrift = 50e-6;
constexpr Nanoseconds kSettled = 10s;
constexpr Nanoseconds kEnd = 20s;
constexpr Nanoseconds kReading = 1ms;

Nanoseconds session_at(Nanoseconds local) {
  return local + kAhead + Nanoseconds(static_cast<std::int64_t>(kDrift * static_cast<double>(local.count())));
}

/// Probes travel on the connection, which keeps their order.
impaired::Packet packet_of(const wire::ClockSample& sample) {
  impaired::Packet packet{.bytes = std::vector<std::byte>(sizeof sample), .stream = true};
  std::memcpy(packet.bytes.data(), &sample, sizeof sample);
  return packet;
}

wire::ClockSample sample_in(const impaired::Packet& packet) {
  wire::ClockSample sample{};
  std::memcpy(&sample, packet.bytes.data(), sizeof sample);
  return sample;
}

class ClockRun {
 public:
  ClockRun(const impaired::Impairment& either_way, std::uint64_t seed)
      : up_(either_way, seed), down_(either_way, seed + 1'000'000) {}

  ClockOutcome outcome() {
    while (now_ < kEnd) {
      now_ = next_event();
      answer();
      hear();
      if (now_ == next_probe_) probe();
      if (now_ == next_reading_) read();
    }
    return outcome_;
  }

 private:
  [[nodiscard]] Nanoseconds next_event() const {
    Nanoseconds next = std::min(next_probe_, next_reading_);
    for (const auto& arrival : {up_.next_arrival(), down_.next_arrival()})
      if (arrival) next = std::min(next, *arrival);
    return next;
  }
  void probe() {
    up_.send(now_, packet_of({.asked = now_, .received = {}, .replied = {}, .heard = {}}));
    next_probe_ += ++probes_ < 8 ? 20ms : 50ms;
  }
  void answer() {
    while (const auto packet = up_.receive(now_)) {
      wire::ClockSample sample = sample_in(*packet);
      sample.received = sample.replied = session_at(now_);
      down_.send(now_, packet_of(sample));
    }
  }
  void hear() {
    while (const auto packet = down_.receive(now_)) {
      wire::ClockSample sample = sample_in(*packet);
      sample.heard = now_;
      (void)sync_.add(sample);
    }
  }
  void read() {
    next_reading_ += kReading;
    if (!sync_.offset()) return;
    const Nanoseconds shown = now_ + sync_.offset()->at(now_);
    if (last_ && shown < *last_) ++outcome_.backwards;
    last_ = shown;
    if (now_ >= kSettled)
      outcome_.worst_error = std::max(outcome_.worst_error, std::chrono::abs(shown - session_at(now_)));
  }

  impaired::ImpairedLink up_;
  impaired::ImpairedLink down_;
  wire::ClockSync sync_;
  Nanoseconds now_{0};
  Nanoseconds next_probe_{0};
  Nanoseconds next_reading_{0};
  int probes_ = 0;
  std::optional<Nanoseconds> last_;
  ClockOutcome outcome_;
};

}  // namespace

ClockOutcome run_clock(Nanoseconds one_way, Nanoseconds jitter, std::uint64_t runs) {
  ClockOutcome worst;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const ClockOutcome one = ClockRun({.delay = one_way, .jitter = jitter}, seed).outcome();
    worst.worst_error = std::max(worst.worst_error, one.worst_error);
    worst.backwards += one.backwards;
  }
  return worst;
}

}  // namespace telepalp::bench::link
