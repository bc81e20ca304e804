#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "server/access/unproven.h"

namespace telepalp::meet {

/// The calls to sites: callers whose site has not answered yet, and callers who are joined with it. When a site has no
/// place left for a further caller, one caller whom the site may not know yet is refused: one of the network that holds
/// the most, so that one address cannot keep the others out. Owner: the meeting point's thread.
class Calls {
 public:
  using Socket = boost::asio::ip::tcp::socket;
  using TimePoint = std::chrono::steady_clock::time_point;
  struct Limits {
    std::size_t waiting_per_site = 32;  ///< calls that the site has not answered
    std::size_t streams_per_site = 64;
  };

  /// `refuse` is called with each caller who is not joined.
  Calls(const Limits& limits, std::function<void(Socket)> refuse) : limits_(limits), refuse_(std::move(refuse)) {}

  /// Keeps a caller of the site with the serial `site` until the site answers. `first`: what was read from the caller.
  /// Returns the call's token; nullopt: there is no place, and the caller is refused.
  [[nodiscard]] std::optional<std::string> add(const std::string& site, Socket caller, std::string first);
  /// Joins the caller with the site's connection. False: nobody waits with this token.
  [[nodiscard]] bool answered(const std::string& token, Socket site);
  void declined(const std::string& token);
  /// Refuses callers who have waited for too long.
  void refuse_late(TimePoint now);
  /// Ends the streams of a site. Returns their number.
  std::size_t end_streams(const std::string& site);
  /// Forgets the callers who wait, and leaves the streams.
  void clear() { waiting_.clear(); }

  [[nodiscard]] std::size_t streams() const noexcept { return streams_->size(); }

 private:
  struct Waiting {
    Socket caller;
    std::string first;
    std::string site;
    access::Unproven who;
  };
  struct Stream {
    access::Unproven who;
    std::function<void()> end;
  };
  using Streams = std::multimap<std::string, Stream>;

  [[nodiscard]] bool has_place_to_wait(const std::string& site, const access::Unproven& newcomer);
  [[nodiscard]] bool has_place_for_stream(const std::string& site, const access::Unproven& newcomer);

  Limits limits_;
  std::function<void(Socket)> refuse_;
  std::map<std::string, Waiting> waiting_;                          // by token
  std::shared_ptr<Streams> streams_ = std::make_shared<Streams>();  // by site; shared: a stream may outlive this object
};

}  // namespace telepalp::meet
