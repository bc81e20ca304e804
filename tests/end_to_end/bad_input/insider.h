#pragma once

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "proto/keys/tls_context.h"
#include "proto/wire/tls_stream.h"
#include "tests/server/loopback_site.h"

namespace telepalp::bad_input {

inline std::string greeting(const std::string& name) {
  msg::Control control;
  control.mutable_hello()->set_protocol(wire::kProtocolVersion);
  control.mutable_hello()->set_name(name);
  return server::control_frame(control);
}

inline std::string subscription(const std::string& topic) {
  msg::Control control;
  control.mutable_subscribe()->add_topics(topic);
  return server::control_frame(control);
}

/// A peer with a valid key that sends any bytes over TLS.
class Insider {
 public:
  Insider(std::uint16_t port, const std::shared_ptr<const keys::KeyFile>& key)
      : settings_(wire::tls_settings(keys::client_context(*key)).value()), stream_(io_, *settings_) {
    keys::expect_host(*stream_.native_handle(), "127.0.0.1");
    stream_.lowest_layer().connect({boost::asio::ip::make_address("127.0.0.1"), port});
    stream_.handshake(boost::asio::ssl::stream_base::client);
  }
  /// False: the server has ended the connection.
  bool say(const std::string& bytes) {
    boost::system::error_code failed;
    boost::asio::write(stream_, boost::asio::buffer(bytes), failed);
    return !failed;
  }
  /// True if the server ends the connection within `patience`. Reads and drops what it sends.
  bool is_ended_within(std::chrono::milliseconds patience) {
    bool ended = false;
    std::array<char, 16384> buffer{};
    std::function<void()> read = [&] {
      stream_.async_read_some(boost::asio::buffer(buffer), [&](const boost::system::error_code& code, std::size_t n) {
        heard_.append(buffer.data(), n);
        ended = static_cast<bool>(code);
        if (!ended) read();
      });
    };
    read();
    const auto until = std::chrono::steady_clock::now() + patience;
    while (!ended && std::chrono::steady_clock::now() < until) io_.run_one_for(std::chrono::milliseconds(20));
    boost::system::error_code ignored;
    stream_.lowest_layer().cancel(ignored);
    io_.poll();
    return ended;
  }
  [[nodiscard]] const std::string& heard() const noexcept { return heard_; }

 private:
  boost::asio::io_context io_;
  wire::TlsSettings settings_;
  boost::asio::ssl::stream<boost::asio::ip::tcp::socket> stream_;
  std::string heard_;
};

}  // namespace telepalp::bad_input
