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

namespace telepalp::wire {

/// One end of a connection's datagrams: the sealed link, the watch over its path, and the timer that both need. The
/// owner has the socket. A client starts and keeps the path open by reports; a server answers them, and sends frames
/// while the path is up. Owner: the thread of its executor.
class DatagramEnd {
 public:
  struct Handlers {
    std::function<bool(std::span<const std::byte>)> send{};    ///< false: the socket is full, try again
    std::function<std::optional<link::Frame>()> next_frame{};  ///< to send; null: this end sends none
    std::function<void(link::Frame)> on_frame{};               ///< complete, and newer than the one before
    /// The peer lacks a frame on which those of `channel` depend.
    std::function<void(std::uint8_t channel)> on_key_frame_needed{};
    std::function<void(DatagramPhase)> on_phase{};  ///< Up or Blocked, when it was another before
    std::function<SessionTime()> now{};
  };

  DatagramEnd(const boost::asio::any_io_executor& executor, const link::SealSettings& seal, link::End end,
              Handlers handlers);

  /// A client begins to report, and a server to wait for it.
  void start();
  /// Takes a datagram; as link::DatagramLink::received(). Call pump() after one or more.
  std::optional<bool> received(std::span<const std::byte> datagram);
  /// Sends what may be sent now. Call it when next_frame() has a frame again.
  void pump();
  /// Nothing is called or sent any more.
  void close() noexcept;

  [[nodiscard]] DatagramPhase phase() const noexcept { return watch_.phase(); }
  [[nodiscard]] const link::DatagramLink& link() const noexcept { return link_; }
  /// Complete frames that were dropped because a newer one of their channel had come.
  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }

 private:
  void tell_phase();
  void take_frames(SessionTime now);
  void hear_wishes(SessionTime now);
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
  DatagramPhase told_ = DatagramPhase::Off;
  std::uint64_t answers_ = 0;  // of link_.path(), when it was last looked at
  SessionTime heard_at_{};     // the newest authenticated datagram
  SessionTime reported_at_{};
  std::optional<link::Datagram> unsent_;  // the socket was full
  std::uint64_t late_ = 0;
  bool closed_ = false;
  boost::asio::steady_timer timer_;
  std::optional<SessionTime> wakes_at_;                                     // nullopt: the timer does not run
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // an expired timer's handler looks at it
};

}  // namespace telepalp::wire
