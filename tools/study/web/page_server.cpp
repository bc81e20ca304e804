#include "tools/study/web/page_server.h"

#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>
#include <utility>

#include "tools/study/web/reply.h"

namespace telepalp::study {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;
constexpr std::chrono::seconds kTimeToAsk{10};
constexpr std::chrono::seconds kIdle{60};
constexpr std::chrono::milliseconds kFrame{16};
constexpr std::size_t kFramesAhead = 2;   // a browser that draws slowly gets fewer frames
constexpr std::size_t kMostWaiting = 64;  // answers; a page that reads none is closed

}  // namespace

/// Interface by which the server closes a connection of either kind.
class PageServer::Connection {
 public:
  virtual ~Connection() = default;
  virtual void close() = 0;
};

namespace {

/// An open page.
class LivePage final : public PageServer::Connection, public std::enable_shared_from_this<LivePage> {
 public:
  LivePage(tcp::socket socket, std::shared_ptr<const PageServer::Shared> shared)
      : stream_(std::move(socket)), clock_(stream_.get_executor()), shared_(std::move(shared)) {}

  void start(const HttpRequest& upgrade) {
    stream_.read_message_max(shared_->page.most_message_bytes);
    stream_.set_option(websocket::stream_base::timeout{kTimeToAsk, kIdle, true});
    stream_.async_accept(upgrade, [self = shared_from_this()](beast::error_code failed) {
      if (failed) return;
      self->open_ = true;
      self->conversation_ = self->shared_->page.open(self->stream_.get_executor(),
                                                     [page = self.get()](std::string text) { page->send(text); });
      self->send(self->conversation_->greeting());
      self->read();
    });
  }

  void close() override {
    open_ = false;
    // Later, because this call may come from the conversation itself.
    if (conversation_)
      asio::post(stream_.get_executor(), [self = shared_from_this(), over = std::move(conversation_)] {});
    clock_.cancel();
    beast::get_lowest_layer(stream_).close();
  }

 private:
  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (failed || !self->open_) return self->close();
      const std::string message = beast::buffers_to_string(self->buffer_.data());
      self->buffer_.consume(self->buffer_.size());
      self->conversation_->hear(message);
      if (!self->open_) return;
      self->run_clock();
      self->read();
    });
  }

  /// Lets time pass until the conversation is at rest.
  void run_clock() {
    if (std::exchange(running_, true)) return;
    stepped_ = std::chrono::steady_clock::now();
    clock_.expires_after(kFrame);
    wait();
  }
  void wait() {
    clock_.async_wait([self = shared_from_this()](beast::error_code cancelled) {
      if (cancelled || !self->open_) return;
      if (self->waiting_.size() <= kFramesAhead) {
        const auto now = std::chrono::steady_clock::now();
        const double passed_s = std::chrono::duration<double>(now - std::exchange(self->stepped_, now)).count();
        std::optional<std::string> frame = self->conversation_->step(passed_s);
        if (!self->open_) return;
        if (!frame) return void(self->running_ = false);
        self->send(std::move(*frame));
      }
      self->clock_.expires_at(std::max(self->clock_.expiry() + kFrame, std::chrono::steady_clock::now()));
      self->wait();
    });
  }

  void send(std::string text) {
    if (!open_) return;
    if (waiting_.size() >= kMostWaiting) return close();
    waiting_.push_back(std::move(text));
    if (waiting_.size() == 1) write();
  }
  void write() {
    stream_.text(true);
    stream_.async_write(asio::buffer(waiting_.front()),
                        [self = shared_from_this()](beast::error_code failed, std::size_t) {
                          if (failed) return self->close();
                          self->waiting_.pop_front();
                          if (!self->waiting_.empty()) self->write();
                        });
  }

  websocket::stream<beast::tcp_stream> stream_;
  asio::steady_timer clock_;
  std::shared_ptr<const PageServer::Shared> shared_;
  std::unique_ptr<Conversation> conversation_;
  beast::flat_buffer buffer_;
  std::deque<std::string> waiting_;  // the first one is being written
  std::chrono::steady_clock::time_point stepped_;
  bool open_ = false;
  bool running_ = false;
};

/// A connection that asks for files, and may become an open page.
class FileConnection final : public PageServer::Connection, public std::enable_shared_from_this<FileConnection> {
 public:
  using Add = std::function<void(const std::shared_ptr<PageServer::Connection>&)>;
  FileConnection(tcp::socket socket, std::shared_ptr<const PageServer::Shared> shared, Add add)
      : stream_(std::move(socket)), shared_(std::move(shared)), add_(std::move(add)) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeaderBytes);
    parser_->body_limit(0);
    stream_.expires_after(kTimeToAsk);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (!failed && self->add_) self->answer(self->parser_->release());
    });
  }

  void close() override {
    add_ = nullptr;  // the server may be gone
    beast::error_code ignored;
    stream_.socket().close(ignored);
  }

 private:
  void answer(const HttpRequest& request) {
    if (!websocket::is_upgrade(request)) return write(reply_to(request, shared_->page.files, shared_->door));
    if (std::optional<HttpReply> refusal = refusal_of_live(request, shared_->door)) return write(std::move(*refusal));
    stream_.expires_never();
    // shared_ptr: the pending read, write or wait owns the page
    const auto page = std::make_shared<LivePage>(stream_.release_socket(), shared_);
    add_(page);
    page->start(request);
  }

  void write(HttpReply reply) {
    reply_ = std::move(reply);
    stream_.expires_after(kTimeToAsk);
    http::async_write(stream_, reply_, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (failed) return;
      if (self->reply_.keep_alive()) return self->read();
      beast::error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  std::shared_ptr<const PageServer::Shared> shared_;
  Add add_;
  beast::flat_buffer buffer_{kMaxHeaderBytes};
  std::optional<http::request_parser<http::string_body>> parser_;
  HttpReply reply_;
};

Error cannot_listen(const Door& door, const beast::error_code& failed) {
  const bool taken = failed == asio::error::address_in_use;
  return {.what = taken ? "another program listens at this port" : "cannot listen: " + failed.message(),
          .where = door.listen + ":" + std::to_string(door.port),
          .fix = taken ? "give another --port, or --port 0 for any free one, or end the other program"
                       : "give --listen an address of this machine, such as 127.0.0.1, and --port a free port"};
}

}  // namespace

Result<std::unique_ptr<PageServer>> PageServer::open(asio::io_context& io, Door door, Page page) {
  beast::error_code failed;
  const asio::ip::address address = asio::ip::make_address(door.listen, failed);
  tcp::acceptor acceptor(io);
  const tcp::endpoint endpoint(address, door.port);
  if (!failed) acceptor.open(endpoint.protocol(), failed);
  if (!failed) acceptor.set_option(tcp::acceptor::reuse_address(true), failed);
  if (!failed) acceptor.bind(endpoint, failed);
  if (!failed) acceptor.listen(tcp::acceptor::max_listen_connections, failed);
  if (failed) return cannot_listen(door, failed);
  door.port = acceptor.local_endpoint().port();
  return std::unique_ptr<PageServer>(new PageServer(
      std::move(acceptor), std::make_shared<const Shared>(Shared{.door = std::move(door), .page = std::move(page)})));
}

PageServer::PageServer(tcp::acceptor acceptor, std::shared_ptr<const Shared> shared)
    : acceptor_(std::move(acceptor)), accept_again_(acceptor_.get_executor()), shared_(std::move(shared)) {
  accept();
}

PageServer::~PageServer() {
  beast::error_code ignored;
  acceptor_.close(ignored);
  for (const std::weak_ptr<Connection>& one : connections_)
    if (const std::shared_ptr<Connection> open = one.lock()) open->close();
}

void PageServer::accept() {
  acceptor_.async_accept([this](beast::error_code failed, tcp::socket socket) {
    if (failed == asio::error::operation_aborted) return;
    if (!failed) {
      admit(std::move(socket));
      return accept();
    }
    accept_again_.expires_after(std::chrono::milliseconds(100));  // probably no file descriptor is free
    accept_again_.async_wait([this](beast::error_code cancelled) {
      if (!cancelled) accept();
    });
  });
}

void PageServer::admit(tcp::socket socket) {
  beast::error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  // shared_ptr: the pending read or write owns the connection
  const auto connection =
      std::make_shared<FileConnection>(std::move(socket), shared_, [this](const auto& page) { add(page); });
  add(connection);
  connection->read();
}

void PageServer::add(const std::shared_ptr<Connection>& connection) {
  std::erase_if(connections_, [](const std::weak_ptr<Connection>& one) { return one.expired(); });
  if (connections_.size() >= kMostConnections) {
    if (const std::shared_ptr<Connection> oldest = connections_.front().lock()) oldest->close();
    connections_.pop_front();
  }
  connections_.push_back(connection);
}

}  // namespace telepalp::study
