#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "proto/link/datagram_link.h"
#include "proto/wire/datagrams/key_frame_repair.h"
#include "proto/wire/datagrams/path_watch.h"
#include "proto/wire/urgent.h"

namespace telepalp::wire {

/// One end of a connection's datagrams: the sealed link, the watch over its path, and the timer that both need. The
/// caller owns the socket. The client opens the path, and keeps it open, by sending reports (link::Feedback). The
/// server answers with reports. Both send frames while the path is up. Owner: the thread of its executor.
class DatagramEnd {
 public:
  struct Handlers {
    std::function<bool(std::span<const std::byte>)> send{};  ///< false: the socket is full, try again
    /// The next frame of those `wanted`. Null: none now. Empty function: this end sends none.
    std::function<std::shared_ptr<const link::SharedFrame>(Wanted wanted)> next_frame{};
    /// Takes a complete frame that is newer than all before it on its channel. Empty function: this end takes none.
    std::function<void(link::Frame)> on_frame{};
    /// The peer cannot decode `channel` until it gets a key frame.
    std::function<void(std::uint8_t channel)> on_key_frame_needed{};
    std::function<void(DatagramPhase)> on_phase{};  ///< called when the phase becomes Up or Blocked
    std::function<SessionTime()> now{};
  };

  DatagramEnd(const boost::asio::any_io_executor& executor, const link::SealSettings& seal, link::End end,
              Handlers handlers);

  /// Opens the path: a client begins to send reports, and a server begins to wait for them.
  void start();
  /// Processes a datagram; call pump() afterwards. nullopt: not from the peer. True: newer than all datagrams before.
  std::optional<bool> received(std::span<const std::byte> datagram);
  /// Writes a challenge for the peer's new address (link::DatagramLink::challenge()). False: none can be made.
  [[nodiscard]] bool challenge(std::uint64_t nonce, link::Datagram& into) {
    return !closed_ && link_.challenge(nonce, handlers_.now(), into);
  }
  [[nodiscard]] std::optional<std::uint64_t> take_response() noexcept { return link_.take_response(); }
  /// Sends datagrams while the path and the socket have room. Call it when next_frame() has a frame again.
  void pump();
  /// Datagrams now go another way, which may work where the last one did not.
  void way_changed();
  /// Stops the timer: afterwards no handler is called, and nothing is sent.
  void close() noexcept;

  [[nodiscard]] DatagramPhase phase() const noexcept { return watch_.phase(); }
  [[nodiscard]] const link::DatagramLink& link() const noexcept { return link_; }
  /// Complete frames that were dropped because a newer one of their channel had come.
  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }

 private:
  void report_phase();
  void take_frames(SessionTime now);
  void request_key_frames(SessionTime now);
  void report_when_due(SessionTime now);
  [[nodiscard]] bool reports(SessionTime now) const noexcept;
  void offer_next(SessionTime now);
  [[nodiscard]] bool send_next(SessionTime now);
  void wake_at(SessionTime at, SessionTime now);

  link::End end_;
  Handlers handlers_;
  link::DatagramLink link_;
  PathWatch watch_;
  KeyFrameRepair repair_;
  DatagramPhase reported_phase_ = DatagramPhase::Off;
  std::uint64_t answers_ = 0;  // link_.path().answers() after the last received datagram
  SessionTime heard_at_{};     // arrival of the newest authenticated datagram
  SessionTime reported_at_{};
  link::Datagram unsent_;    // sealed here, and sent from here
  bool has_unsent_ = false;  // it waits until the socket has room
  std::uint64_t late_ = 0;
  bool closed_ = false;
  boost::asio::steady_timer timer_;
  std::optional<SessionTime> wakes_at_;                                     // nullopt: the timer does not run
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // the timer's handlers hold weak_ptrs to it
};

}  // namespace telepalp::wire
