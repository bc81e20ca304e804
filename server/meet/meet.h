#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>

#include "proto/keys/key_file.h"
#include "proto/keys/tls_context.h"
#include "proto/wire/tls_stream.h"
#include "proto/words/result.h"
#include "server/meet/caller/arrival.h"
#include "server/meet/caller/calls.h"
#include "server/meet/relay/relay_credentials.h"
#include "support/program/while_alive.h"

namespace telepalp::meet {

class SiteSession;

/// The meeting point: patients' sites join it under the names of their certificates, and callers who name a site in
/// their TLS greeting are joined with it. Between caller and site it passes bytes on: their TLS runs from end to end,
/// so it reads nothing of it and can refuse, but not impersonate. It stores nothing, so that a restart loses nothing.
/// Owner: `io`'s one thread.
class Meet {
 public:
  struct Limits {
    std::size_t arrivals = 256;  ///< connections that have not shown what they are
    std::size_t joining = 512;   ///< connections of sites, or of strangers who name the meeting point, before they join
    std::size_t sites = 2000;
    Calls::Limits calls{};
    std::size_t relayed = 256;  ///< connections that are passed on to the relay
  };
  struct Options {
    std::string address = "0.0.0.0";
    std::uint16_t port = 0;  ///< 0: any free port
    keys::KeyFile key;       ///< a server's key; sites whose keys its authority made may join
    keys::IsRevoked is_revoked = [](const keys::Identity&) { return false; };
    RelayDoor relay{};  ///< sites get credentials for it, and this port passes requests to it on by TCP
    std::function<void(const std::string&)> log = [](const std::string&) {};
    Limits limits{};
  };
  struct Counts {
    std::uint64_t relayed = 0;  ///< connections that were passed on to the relay
    std::uint64_t calls = 0;    ///< callers that were joined with a site
    std::uint64_t refused = 0;  ///< callers without a site, and connections closed to make room
  };

  /// Error: the port cannot be opened, or the key cannot be used.
  [[nodiscard]] static Result<std::unique_ptr<Meet>> listen(boost::asio::io_context& io, Options options);
  ~Meet();
  Meet(const Meet&) = delete;
  Meet& operator=(const Meet&) = delete;

  /// Stops listening and ends every connection but those of callers who are joined with a site.
  void close();

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  [[nodiscard]] std::size_t sites() const noexcept { return sites_.size(); }
  [[nodiscard]] std::size_t streams() const noexcept { return calls_.streams(); }
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
  Meet(boost::asio::io_context& io, Options options, wire::TlsSettings tls);
  void accept();
  void admit(boost::asio::ip::tcp::socket socket);
  void arrived(const Arrived& what, boost::asio::ip::tcp::socket socket, std::string bytes);
  void site_comes(boost::asio::ip::tcp::socket socket, std::string hello);
  [[nodiscard]] std::string join(const std::shared_ptr<SiteSession>& site);
  void leave(SiteSession& site, const std::string& why);
  void end_streams(const SiteSession& site);
  void caller_comes(const ClientHello& hello, boost::asio::ip::tcp::socket socket, std::string bytes);
  void refuse(boost::asio::ip::tcp::socket socket, unsigned char alert);
  template <class List>
  [[nodiscard]] typename List::value_type surplus(List& waiting, std::size_t most);
  void pass_to_relay(boost::asio::ip::tcp::socket socket, std::string bytes);
  void tell_relay(SiteSession& site) const;
  void renew_credentials();
  void give_memory_back();
  void look_after_all();

  Options options_;
  wire::TlsSettings tls_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer again_;
  boost::asio::steady_timer second_;
  std::uint16_t port_ = 0;
  std::list<std::shared_ptr<Arrival>> arrivals_;               // oldest first
  std::list<std::shared_ptr<SiteSession>> joining_;            // of sites, or of strangers, before they join
  std::map<std::string, std::shared_ptr<SiteSession>> sites_;  // by the serial of the site's certificate
  std::map<std::string, std::string> serials_;                 // by the name of a site
  Calls calls_;
  std::shared_ptr<std::size_t> relayed_ = std::make_shared<std::size_t>(0);  // shared: a stream may outlive this object
  Counts counts_;
  std::chrono::steady_clock::time_point renewed_{};  // the credentials of all sites
  std::size_t trimmed_at_ = 0;                       // the number of sites when memory was last given back
  program::WhileAlive alive_;
};

}  // namespace telepalp::meet
