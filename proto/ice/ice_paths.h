#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "messages/control.pb.h"
#include "proto/ice/words/candidate.h"
#include "proto/ice/words/path_kind.h"
#include "proto/ice/words/relay.h"

namespace telepalp::ice {

class IceAgent;

/// The paths of one connection's datagrams, at one end: attempts to find one, of which the server begins each. Both
/// ends send by the newest attempt that the server has taken, and receive by all that have not ended, so that a better
/// path is taken over without a gap. Owner: the thread of its executor.
class IcePaths {
 public:
  enum class End { Client, Server };
  struct Handlers {
    std::function<void(const msg::IcePath&)> signal;  ///< send it to the other end, inside the session
    std::function<void(std::span<const std::byte>)> on_datagram;
    /// Datagrams now go this way; nullopt: there is no path any more.
    std::function<void(std::optional<PathKind>)> on_path;
    /// Of a server: the relays to try, with credentials that hold.
    std::function<std::vector<msg::IceRelay>()> relays = [] { return std::vector<msg::IceRelay>{}; };
    /// A relay is not used, or gives no address, for this reason. Called in each attempt.
    std::function<void(const Error&)> on_unused_relay = [](const Error&) {};
  };
  struct Settings {
    End end = End::Client;
    Reach reach = Reach::Network;
    std::uint8_t type_of_service = 0;
    std::chrono::milliseconds attempt_lasts{12'000};
    std::chrono::milliseconds better_every{30'000};  ///< time between attempts to do without the relay
  };
  struct Counts {
    std::uint64_t attempts = 0;
    std::uint64_t refused = 0;  ///< what the peer may not send: candidates, credentials, attempts
  };

  IcePaths(const boost::asio::any_io_executor& executor, const Settings& settings, Handlers handlers);
  ~IcePaths();
  IcePaths(const IcePaths&) = delete;
  IcePaths& operator=(const IcePaths&) = delete;

  /// Of a server: begins an attempt, now or when the pause after the last one is over. An attempt that runs goes on.
  void begin();
  /// Of a server: nothing arrives by the present path. It is used until there is another one, of whatever kind.
  void lost();
  /// The peer's message. What the peer may not say is ignored and counted.
  void heard(const msg::IcePath& message);
  /// False: the socket is full, and the datagram can be sent again. Without a path the datagram is lost.
  [[nodiscard]] bool send(std::span<const std::byte> datagram);
  /// Afterwards no handler is called. The attempts end with this object, which no handler may destroy.
  void close();

  [[nodiscard]] std::optional<PathKind> path() const noexcept;
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
  using Clock = std::chrono::steady_clock;
  using Number = std::uint32_t;
  struct Attempt {
    std::unique_ptr<IceAgent> agent;
    std::optional<PathKind> path{};
    Clock::time_point since{};
    std::optional<Clock::time_point> ends_at{};  ///< a newer attempt has replaced it
    std::size_t candidates = 0;                  ///< of the peer
    std::optional<Relay> waits_for_relay{};      ///< that has given no address yet
    bool knows_peer = false;
  };

  void tell_candidate(Number number, const Candidate& candidate);
  void candidates_end(Number number);
  [[nodiscard]] bool start(Number number, const std::vector<msg::IceRelay>& relays);
  [[nodiscard]] std::vector<Relay> usable(const std::vector<msg::IceRelay>& relays);
  void begin_now();
  void on_path(Number number, PathKind kind);
  void on_failed(Number number);
  [[nodiscard]] Attempt* joined(const msg::IcePath& message);
  void learn(Attempt& attempt, const msg::IcePath& message);
  void judge(const msg::IcePath& message);
  void take(Number number);
  void drop(Number number);
  void end(Number number);
  void look_soon();
  void look();
  void say(Number number, msg::IcePath::Verdict verdict) const;
  void tell_path();
  [[nodiscard]] const Attempt* used() const noexcept;

  Settings settings_;
  Handlers handlers_;
  boost::asio::any_io_executor executor_;
  boost::asio::steady_timer timer_;
  std::map<Number, Attempt> attempts_;
  Number last_ = 0;                                    // the newest attempt
  Number taken_ = 0;                                   // 0: none
  std::pair<Number, std::optional<PathKind>> told_{};  // the attempt taken, and its path
  Clock::time_point begun_{};                          // the newest attempt
  bool wants_attempt_ = false;
  bool is_silent_ = false;           // lost() was called for the present path
  std::chrono::milliseconds pause_;  // from one attempt's begin to the next one's
  Counts counts_;
  bool closed_ = false;
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // the timer's handlers hold weak_ptrs to it
};

}  // namespace telepalp::ice
