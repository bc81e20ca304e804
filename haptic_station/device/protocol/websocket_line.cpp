#include "haptic_station/device/protocol/websocket_line.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <charconv>
#include <optional>
#include <utility>

#include "support/program/address.h"

namespace telepalp::device {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using std::chrono::milliseconds;

constexpr std::chrono::milliseconds kSilence{1000};    // time without a message after which to reconnect
constexpr std::chrono::milliseconds kAgainAfter{250};  // pause between attempts
constexpr milliseconds kConnectTimeout{2000};

}  // namespace

Result<WebSocketUrl> parse_websocket_url(std::string_view text, const WebSocketUrl& standard, std::string_view where) {
  const auto refused = [&](const std::string& what) {
    return Error{.what = "'" + std::string(text) + "' " + what,
                 .where = std::string(where),
                 .fix = "give a URL, as in " + std::string(where) + ":" + to_string(standard)};
  };
  constexpr std::string_view kScheme = "ws://";
  if (!text.starts_with(kScheme) || text.size() > 512)
    return refused("does not begin with ws://, or is longer than 512 characters");
  std::string_view rest = text.substr(kScheme.size());
  for (const char c : rest)
    if (c <= ' ' || c > '~' || c == '@' || c == '#')
      return refused("has a character that is not accepted here, such as a space, @ or #");
  WebSocketUrl url = standard;
  if (const std::size_t slash = rest.find('/'); slash != std::string_view::npos) {
    if (slash + 1 < rest.size()) url.path = rest.substr(slash);
    rest = rest.substr(0, slash);
  }
  std::string_view port;
  if (rest.starts_with('[')) {
    const std::size_t end = rest.find(']');
    if (end == std::string_view::npos) return refused("has no ] after the host");
    url.host = rest.substr(1, end - 1);
    port = rest.substr(end + 1);
  } else {
    url.host = rest.substr(0, rest.find(':'));
    port = rest.substr(url.host.size());
  }
  if (url.host.empty()) return refused("names no host");
  if (port.empty()) return url;
  const auto [end, error] = std::from_chars(port.data() + 1, port.data() + port.size(), url.port);
  if (port[0] != ':' || error != std::errc{} || end != port.data() + port.size() || url.port == 0)
    return refused("has no port from 1 to 65535");
  return url;
}

std::string to_string(const WebSocketUrl& url) { return "ws://" + program::to_text({url.host, url.port}) + url.path; }

/// One connection, from the name look-up to its end. Each pending operation keeps it alive.
class WebSocketLine::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(asio::io_context& io, std::shared_ptr<Shared> line);
  void start();
  void send(std::string text);
  void close() {
    dead_ = true;
    resolver_.cancel();
    beast::get_lowest_layer(stream_).close();
  }

 private:
  void resolved(const tcp::resolver::results_type& places);
  void connected();
  void read();
  void write();
  void lost(const std::string& why);

  std::shared_ptr<Shared> line_;
  tcp::resolver resolver_;
  websocket::stream<beast::tcp_stream> stream_;
  beast::flat_buffer incoming_;
  std::string outgoing_;
  std::optional<std::string> waiting_;
  bool open_ = false;
  bool writing_ = false;
  bool dead_ = false;
};

struct WebSocketLine::Shared {
  asio::io_context& io;
  WebSocketUrl url;
  Settings settings;
  Handlers handlers;
  asio::steady_timer again;
  std::weak_ptr<Connection> connection;
  bool stopped = false;

  void connect(const std::shared_ptr<Shared>& self) {
    if (stopped) return;
    const auto made = std::make_shared<Connection>(io, self);
    connection = made;
    made->start();
  }
  void connect_later(const std::shared_ptr<Shared>& self) {
    again.expires_after(kAgainAfter);
    again.async_wait([self](const boost::system::error_code& error) {
      if (!error) self->connect(self);
    });
  }
};

WebSocketLine::Connection::Connection(asio::io_context& io, std::shared_ptr<Shared> line)
    : line_(std::move(line)), resolver_(io), stream_(io) {}

void WebSocketLine::Connection::start() {
  const std::string port = std::to_string(line_->url.port);
  resolver_.async_resolve(line_->url.host, port,
                          [self = shared_from_this()](beast::error_code error, const tcp::resolver::results_type& at) {
                            if (error) return self->lost("the host name cannot be resolved: " + error.message());
                            self->resolved(at);
                          });
}

void WebSocketLine::Connection::resolved(const tcp::resolver::results_type& places) {
  if (dead_) return;
  beast::get_lowest_layer(stream_).expires_after(kConnectTimeout);
  beast::get_lowest_layer(stream_).async_connect(
      places, [self = shared_from_this()](beast::error_code error, const tcp::endpoint&) {
        if (error) return self->lost(error.message());
        self->connected();
      });
}

void WebSocketLine::Connection::connected() {
  beast::error_code ignored;
  beast::get_lowest_layer(stream_).socket().set_option(tcp::no_delay(true), ignored);
  beast::get_lowest_layer(stream_).expires_never();
  websocket::stream_base::timeout limits{kConnectTimeout, websocket::stream_base::none(), false};
  stream_.set_option(limits);
  stream_.read_message_max(line_->settings.most_text_bytes);
  const std::string host = line_->url.host + ":" + std::to_string(line_->url.port);
  stream_.async_handshake(host, line_->url.path, [self = shared_from_this()](beast::error_code error) {
    if (error) return self->lost("the WebSocket handshake failed: " + error.message());
    self->open_ = true;
    self->line_->handlers.on_open();
    self->read();
  });
}

void WebSocketLine::Connection::read() {
  if (dead_) return;
  beast::get_lowest_layer(stream_).expires_after(kSilence);
  stream_.async_read(incoming_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    if (error == beast::error::timeout) return self->lost("the service sends no more messages");
    if (error) return self->lost(error.message());
    const auto bytes = self->incoming_.data();
    self->line_->handlers.on_text({static_cast<const char*>(bytes.data()), bytes.size()});
    self->incoming_.consume(self->incoming_.size());
    self->read();
  });
}

void WebSocketLine::Connection::send(std::string text) {
  if (!open_ || dead_) return;
  waiting_ = std::move(text);
  if (!writing_) write();
}

void WebSocketLine::Connection::write() {
  outgoing_ = std::move(*waiting_);
  waiting_.reset();
  writing_ = true;
  stream_.text(true);
  stream_.async_write(asio::buffer(outgoing_), [self = shared_from_this()](beast::error_code error, std::size_t) {
    self->writing_ = false;
    if (error) return self->lost(error.message());
    if (self->waiting_ && !self->dead_) self->write();
  });
}

void WebSocketLine::Connection::lost(const std::string& why) {
  if (dead_) return;
  close();
  if (line_->stopped) return;
  line_->handlers.on_lost(why);
  line_->connect_later(line_);
}

WebSocketLine::WebSocketLine(asio::io_context& io, WebSocketUrl url, const Settings& settings, Handlers handlers)
    : shared_(new Shared{io, std::move(url), settings, std::move(handlers), asio::steady_timer(io), {}, false}) {}

WebSocketLine::~WebSocketLine() { stop(); }

void WebSocketLine::start() { shared_->connect(shared_); }

void WebSocketLine::send(std::string text) {
  if (const auto connection = shared_->connection.lock()) connection->send(std::move(text));
}

void WebSocketLine::stop() {
  shared_->stopped = true;
  shared_->again.cancel();
  if (const auto connection = shared_->connection.lock()) connection->close();
}

}  // namespace telepalp::device
