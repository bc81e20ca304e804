#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace telepalp::device {

/// A WebSocket service like that of a device's maker, on a real loopback socket, with faults on request. It serves one
/// client at a time; a new client replaces the old one.
class FakeService {
 public:
  using Answer = std::function<std::optional<std::string>(const std::string&)>;

  /// Sends `greeting` to each client, and the result of `answer` to each of its texts. Port 0: any free one.
  FakeService(std::string greeting, Answer answer, std::uint16_t port = 0)
      : greeting_(std::move(greeting)),
        answer_(std::move(answer)),
        acceptor_(io_, {boost::asio::ip::address_v4::loopback(), port}) {
    port_ = acceptor_.local_endpoint().port();
    accept();
    thread_ = std::thread([this] { io_.run(); });
  }
  /// Closes at once, as if the service were killed.
  ~FakeService() {
    io_.stop();
    thread_.join();
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  void say(std::string text) {
    boost::asio::post(io_, [this, text = std::move(text)] {
      if (client_) client_->say(text);
    });
  }
  /// Breaks the connection without a closing handshake.
  void drop() {
    boost::asio::post(io_, [this] {
      if (client_) client_->stream.next_layer().close();
    });
  }
  /// All texts received from all clients.
  [[nodiscard]] std::vector<std::string> heard() {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  /// The newest text received; empty before the first.
  [[nodiscard]] std::string newest() {
    const std::lock_guard lock(mutex_);
    return heard_.empty() ? std::string() : heard_.back();
  }
  [[nodiscard]] int clients() {
    const std::lock_guard lock(mutex_);
    return clients_;
  }

 private:
  struct Client : std::enable_shared_from_this<Client> {
    explicit Client(boost::asio::ip::tcp::socket socket) : stream(std::move(socket)) {}
    void say(const std::string& text) {
      waiting.push_back(text);
      if (waiting.size() == 1) write();
    }
    void write() {
      stream.async_write(boost::asio::buffer(waiting.front()),
                         [self = shared_from_this()](boost::beast::error_code error, std::size_t) {
                           if (error) return;
                           self->waiting.pop_front();
                           if (!self->waiting.empty()) self->write();
                         });
    }
    boost::beast::websocket::stream<boost::beast::tcp_stream> stream;
    boost::beast::flat_buffer incoming;
    std::deque<std::string> waiting;
  };

  void accept() {
    acceptor_.async_accept([this](boost::beast::error_code error, boost::asio::ip::tcp::socket socket) {
      if (error) return;
      client_ = std::make_shared<Client>(std::move(socket));
      client_->stream.async_accept([this, client = client_](boost::beast::error_code failed) {
        if (failed) return;
        {
          const std::lock_guard lock(mutex_);
          ++clients_;
        }
        if (!greeting_.empty()) client->say(greeting_);
        read(client);
      });
      accept();
    });
  }
  void read(const std::shared_ptr<Client>& client) {
    client->stream.async_read(client->incoming, [this, client](boost::beast::error_code error, std::size_t) {
      if (error) return;
      const std::string text = boost::beast::buffers_to_string(client->incoming.data());
      client->incoming.consume(client->incoming.size());
      {
        const std::lock_guard lock(mutex_);
        heard_.push_back(text);
      }
      if (const auto reply = answer_(text)) client->say(*reply);
      read(client);
    });
  }

  std::string greeting_;
  Answer answer_;
  boost::asio::io_context io_{1};
  boost::asio::ip::tcp::acceptor acceptor_;
  std::uint16_t port_ = 0;
  std::shared_ptr<Client> client_;  // owner: thread_
  std::mutex mutex_;
  std::vector<std::string> heard_;
  int clients_ = 0;
  std::thread thread_;
};

/// Waits until `holds()` is true; false after five seconds.
inline bool soon(const std::function<bool()>& holds) {
  for (int i = 0; i < 2500; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

}  // namespace telepalp::device
