#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "messages/control.pb.h"
#include "server/access/access.h"

namespace telepalp::hub {

/// The touch (the right to publish on the station's topics) for one peer. Taking, offering and losing it is written to
/// the audit log. Without keys every peer may touch and none holds the touch, because only programs of this machine can
/// connect. Owner: the network thread.
class PeerTouch {
 public:
  using Clock = std::chrono::steady_clock;

  using Audit = std::function<void(access::AuditEvent, const std::string& more)>;

  /// `peer`: its number. `audit`: writes an event of this peer to the audit log, with further fields.
  PeerTouch(access::Access& access, std::uint64_t peer, Audit audit)
      : access_(access), peer_(peer), audit_(std::move(audit)) {}

  void set_run(std::uint64_t run) noexcept { run_ = run; }  ///< of the peer's Hello
  [[nodiscard]] bool holds() const noexcept { return holds_; }

  struct Taken {
    bool may_touch = false;
    /// Number of the peer that lost the touch: by handing it over, or because its station has connected again.
    std::optional<std::uint64_t> from;
  };
  /// Takes the touch for `who` if it is free. `accepts`: the doctor accepts, so that the touch is also taken from a
  /// holder that offers it to `who`, or after this station had to wait for it (TouchLease).
  [[nodiscard]] Taken take(const keys::Identity& who, bool accepts);
  /// Call it at each message of the peer; it extends the lease. False: the peer held the touch and has lost it.
  [[nodiscard]] bool renew();
  /// Another peer, of doctor `who`, has the touch now, so this peer loses it. Returns the reason for this peer's
  /// Goodbye.
  std::string lose_to(const keys::Identity& who, bool is_same_doctor);
  void leave(bool on_purpose);  ///< `on_purpose`: the peer sent a Goodbye, which frees the touch at once

  /// Offers the touch to the doctor named `to`; an empty `to` withdraws the offer. Returns the answer for the peer.
  [[nodiscard]] msg::HandOver offer(const keys::Identity& who, const std::string& to);

  /// Text for `who`, who may not take the touch now: who holds the touch, and how `who` can get it.
  [[nodiscard]] std::string is_held(const keys::Identity& who) const;

 private:
  [[nodiscard]] std::string offered(const std::string& to);

  access::Access& access_;
  std::uint64_t peer_;
  std::uint64_t run_ = 0;
  Audit audit_;
  bool holds_ = false;
  std::optional<Clock::time_point> offered_at_;
};

}  // namespace telepalp::hub
