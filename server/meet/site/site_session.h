#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "messages/meet.pb.h"
#include "server/access/unproven.h"
#include "server/meet/site/site_tls.h"
#include "server/meet/words/meet_frames.h"

namespace telepalp::meet {

/// The meeting point's connection with one patient's site: TLS, the site's names from its certificate, calls to it.
/// Pending operations keep it alive; close() ends them.
class SiteSession : public std::enable_shared_from_this<SiteSession> {
 public:
  struct Handlers {
    /// The site has shown a valid certificate; names() and serial() are known. Returns why the site is refused;
    /// empty: it is in.
    std::function<std::string(const std::shared_ptr<SiteSession>&)> on_join;
    std::function<void(SiteSession&)> on_joined{};  ///< the site has been welcomed
    std::function<void(const std::string& token)> on_decline;
    std::function<void(SiteSession&, const std::string& why)> on_end;  ///< called once
  };

  /// `hello`: what was already read from the socket.
  SiteSession(boost::asio::ip::tcp::socket socket, std::string hello, wire::TlsSettings tls, Handlers handlers);
  void start();  ///< does nothing after close()
  void call(const msg::MeetCall& call);
  void tell(const msg::MeetRelay& relay);
  void close(const std::string& why);

  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  [[nodiscard]] const std::string& serial() const noexcept { return serial_; }
  [[nodiscard]] const std::string& peer() const noexcept { return peer_; }
  [[nodiscard]] const access::Unproven& who() const noexcept { return who_; }
  /// The site joins from another address, because it has lost the one that it had.
  [[nodiscard]] bool has_moved() const noexcept { return moved_; }

 private:
  void end_after_alert(const boost::system::error_code& failed);
  void shaken_hands();
  void read();
  [[nodiscard]] bool take(const std::string& frame);
  void join(std::uint32_t version);
  void refuse(const std::string& why);
  void send(const msg::MeetToSite& message);
  void write_next();
  void beat();

  SiteTls stream_;
  boost::asio::steady_timer beat_;
  std::string peer_;
  access::Unproven who_;
  Handlers handlers_;
  FrameReader frames_;
  std::array<char, 1024> bytes_{};
  std::deque<std::string> to_send_;
  std::chrono::steady_clock::time_point heard_;
  std::vector<std::string> names_;
  std::string serial_;
  bool joined_ = false;
  bool moved_ = false;
  bool closed_ = false;
};

}  // namespace telepalp::meet
