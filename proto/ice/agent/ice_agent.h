#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "proto/ice/words/candidate.h"
#include "proto/ice/words/path_kind.h"
#include "proto/ice/words/relay.h"
#include "proto/words/result.h"

namespace telepalp::ice {

/// One end of one attempt to find a path (RFC 8445), by libnice. Its consent checks (RFC 7675) keep the path open, and
/// notice within 30 s that the peer no longer wants datagrams. Owner: the thread of its executor.
class IceAgent {
 public:
  struct Options {
    bool controlling = false;  ///< of the two ends, the one that chooses
    std::vector<Relay> relays;
    Reach reach = Reach::Network;
    std::uint8_t type_of_service = 0;  ///< of the datagrams' IP headers
  };
  struct Credentials {
    std::string user;
    std::string password;
  };
  /// Called on the executor, and not after the agent is destroyed. A handler must not destroy the agent.
  struct Handlers {
    std::function<void(const Candidate&)> on_candidate;
    std::function<void()> on_all_candidates;  ///< on_candidate() comes no more
    std::function<void(PathKind)> on_path;    ///< datagrams can be sent, or now take another way
    std::function<void()> on_failed;          ///< no path, or the path's end
    std::function<void(std::span<const std::byte>)> on_datagram;
  };

  /// Error: the system gives no socket.
  [[nodiscard]] static Result<std::unique_ptr<IceAgent>> start(const boost::asio::any_io_executor& executor,
                                                               const Options& options, Handlers handlers);
  ~IceAgent();
  IceAgent(const IceAgent&) = delete;
  IceAgent& operator=(const IceAgent&) = delete;

  [[nodiscard]] const Credentials& credentials() const noexcept { return credentials_; }
  /// Both are is_credential(). Call it before add().
  void set_peer(const Credentials& peer);
  void add(const Candidate& candidate);
  /// False: the socket is full, and the datagram can be sent again. Without a path, the datagram is lost.
  [[nodiscard]] bool send(std::span<const std::byte> datagram);

 private:
  struct State;
  explicit IceAgent(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;  // shared with libnice's callbacks, until the agent has ended
  Credentials credentials_;
};

}  // namespace telepalp::ice
