#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace telepalp::access {

/// Decides which doctor's station may publish on the station's topics (it "holds the touch"): one at a time. The holder
/// keeps the touch while it publishes, and frees it with a Goodbye or after kLease without a message; then any station
/// may take it. When the holder's connection breaks, only the same doctor may take the touch within kLease. Pure;
/// owner: the server's network thread.
class TouchLease {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kLease{10};

  /// Station `peer`, of the doctor whose key is `serial`, asks for the touch. Returns true if it now holds the touch.
  [[nodiscard]] bool take(std::uint64_t peer, const std::string& serial, const std::string& name, TimePoint now);
  /// Extends the lease of `peer`, which has published. Returns false if `peer` does not hold the touch.
  [[nodiscard]] bool renew(std::uint64_t peer, TimePoint now);
  /// `peer` has left. `on_purpose`: with a Goodbye, which frees the touch at once; else its doctor has kLease to
  /// return.
  void leave(std::uint64_t peer, bool on_purpose, TimePoint now);

  /// The name of the doctor who holds the touch; nullopt: the touch is free.
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
