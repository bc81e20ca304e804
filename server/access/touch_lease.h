#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace telepalp::access {

/// Which doctor's station holds the touch: one at a time. It keeps the touch while it publishes; it gives the touch by
/// leaving, and loses it after kLease without a message. Then the next station that asks takes it. After a lost
/// connection the same doctor takes it again within the lease, and nobody else. Pure; owner: the server's network
/// thread.
class TouchLease {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kLease{10};

  /// The station `peer` of the doctor with the key `serial` asks for the touch. True: it holds the touch from now on.
  [[nodiscard]] bool take(std::uint64_t peer, const std::string& serial, const std::string& name, TimePoint now);
  /// `peer` shows that it lives. False: another station holds the touch by now.
  [[nodiscard]] bool renew(std::uint64_t peer, TimePoint now);
  /// `peer` has left. `on_purpose`: by a Goodbye; then the touch is free at once.
  void leave(std::uint64_t peer, bool on_purpose, TimePoint now);

  /// The name of the doctor that holds the touch.
  [[nodiscard]] std::optional<std::string> holder(TimePoint now) const;

 private:
  struct Held {
    std::uint64_t peer = 0;  // 0: its connection was lost
    std::string serial;
    std::string name;
    TimePoint until;
  };
  std::optional<Held> held_;
};

}  // namespace telepalp::access
