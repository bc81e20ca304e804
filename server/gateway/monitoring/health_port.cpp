#include "server/gateway/monitoring/health_port.h"

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <utility>
#include <vector>

#include "proto/wire/sockets/tcp_socket.h"
#include "server/access/unproven.h"
#include "server/gateway/health/metrics.h"
#include "server/gateway/http_reply.h"

namespace telepalp::gateway {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;

constexpr std::chrono::seconds kTimeToAsk{2};  // and to take the reply
constexpr std::size_t kMaxHealthHeaderBytes = 4 * 1024;

HttpReply answer_to(const HttpRequest& request, const HealthPort::Options& options) {
  const beast::string_view host = request[http::field::host];
  if (!host_is_ours({}, {host.data(), host.size()}))
    return refuse(request, http::status::misdirected_request, "ask for this port by its IP address or localhost");
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refuse(request, http::status::method_not_allowed, "this address answers only GET and HEAD");
  const std::string_view target(request.target().data(), request.target().size());
  if (target == kHealthTarget) {
    const std::string problem = options.problem ? options.problem() : "";
    return problem.empty() ? refuse(request, http::status::ok, "ok")
                           : refuse(request, http::status::service_unavailable, problem);
  }
  if (target != kMetricsTarget || !options.metrics)
    return refuse(request, http::status::not_found, "this port has /health and /metrics alone");
  HttpReply reply = refuse(request, http::status::ok, options.metrics());
  reply.set(http::field::content_type, "text/plain; version=0.0.4; charset=utf-8");
  return reply;
}

Error cannot_listen(const HealthPort::Options& options, const beast::error_code& failed) {
  return {.what = "cannot listen for health checks: " + failed.message(),
          .where = options.address + ":" + std::to_string(options.port),
          .fix = "choose another --health-port (0: any free one), or give --health-bind an address of this machine"};
}

}  // namespace

class HealthPort::Check final : public std::enable_shared_from_this<Check> {
 public:
  Check(tcp::socket socket, std::shared_ptr<const Options> options)
      : stream_(std::move(socket)), options_(std::move(options)) {
    unproven_ = access::newcomer(stream_.socket());
    parser_.header_limit(kMaxHealthHeaderBytes);
    parser_.body_limit(0);
  }

  void start() {
    stream_.expires_after(kTimeToAsk);
    http::async_read(stream_, buffer_, parser_, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (!failed) self->reply();
    });
  }

  [[nodiscard]] const access::Unproven& unproven() const noexcept { return unproven_; }

  [[nodiscard]] bool is_closed() const noexcept { return closed_; }

  void close() {
    closed_ = true;
    beast::error_code ignored;
    stream_.socket().close(ignored);
  }

 private:
  void reply() {
    if (closed_) return;  // what the options call may be gone
    reply_ = answer_to(parser_.get(), *options_);
    reply_.keep_alive(false);
    stream_.expires_after(kTimeToAsk);
    http::async_write(stream_, reply_, [self = shared_from_this()](beast::error_code, std::size_t) {
      beast::error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  std::shared_ptr<const Options> options_;
  beast::flat_buffer buffer_{kMaxHealthHeaderBytes};
  http::request_parser<http::string_body> parser_;
  HttpReply reply_;
  access::Unproven unproven_;
  bool closed_ = false;
};

Result<std::unique_ptr<HealthPort>> HealthPort::open(asio::io_context& io, Options options) {
  beast::error_code failed;
  const asio::ip::address address = asio::ip::make_address(options.address, failed);
  tcp::acceptor acceptor(io);
  if (!failed) failed = wire::open_acceptor(acceptor, {address, options.port});
  if (failed) return cannot_listen(options, failed);
  return std::unique_ptr<HealthPort>(new HealthPort(std::move(acceptor), std::move(options)));
}

HealthPort::HealthPort(tcp::acceptor acceptor, Options options)
    : acceptor_(std::move(acceptor)),
      accept_again_(acceptor_.get_executor()),
      options_(std::make_shared<const Options>(std::move(options))),
      port_(acceptor_.local_endpoint().port()) {
  accept();
}

HealthPort::~HealthPort() {
  beast::error_code ignored;
  acceptor_.close(ignored);
  for (const std::weak_ptr<Check>& check : checks_)
    if (const std::shared_ptr<Check> open = check.lock()) open->close();
}

void HealthPort::accept() {
  acceptor_.async_accept(alive_.guard([this](beast::error_code failed, tcp::socket socket) {
    if (failed == asio::error::operation_aborted) return;
    if (!failed) {
      admit(std::move(socket));
      return accept();
    }
    accept_again_.expires_after(std::chrono::milliseconds(100));  // probably no file descriptor is free
    accept_again_.async_wait(alive_.guard([this](beast::error_code cancelled) {
      if (!cancelled) accept();
    }));
  }));
}

void HealthPort::admit(tcp::socket socket) {
  // shared_ptr: the pending read or write owns the connection
  const auto check = std::make_shared<Check>(std::move(socket), options_);
  std::erase_if(checks_, [](const std::weak_ptr<Check>& other) { return other.expired(); });
  checks_.push_back(check);
  if (checks_.size() > kMostConnections) close_one();
  if (!check->is_closed()) check->start();
}

void HealthPort::close_one() {
  std::vector<std::shared_ptr<Check>> open;
  std::vector<access::Unproven> all;
  for (const std::weak_ptr<Check>& one : checks_)
    if (std::shared_ptr<Check> check = one.lock()) {
      all.push_back(check->unproven());
      open.push_back(std::move(check));
    }
  const std::optional<std::size_t> chosen = access::one_to_close(all, std::chrono::steady_clock::now());
  if (!chosen) return;
  open[*chosen]->close();
  std::erase_if(checks_, [&](const std::weak_ptr<Check>& one) { return one.lock() == open[*chosen]; });
}

}  // namespace telepalp::gateway
