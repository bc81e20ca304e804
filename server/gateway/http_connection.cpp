#include "server/gateway/http_connection.h"

#include <openssl/err.h>
#include <openssl/ssl.h>

#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>
#include <utility>

#include "server/gateway/foxglove_protocol.h"
#include "server/gateway/health/metrics.h"
#include "server/gateway/http_reply.h"
#include "server/gateway/sign_in.h"
#include "server/gateway/sign_in/web_stream.h"
#include "server/gateway/viewer_connection.h"
#include "server/gateway/visit.h"

namespace telepalp::gateway {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;

constexpr std::uint32_t kMaxHeaderBytes = 8 * 1024;
constexpr std::uint64_t kMaxBodyBytes = 1024;                    // of a token at the sign-in, or of a command by POST
constexpr std::uint64_t kMaxPartBytes = std::uint64_t{1} << 20;  // of a part of a session file, by POST

constexpr std::string_view kOtherSite =
    "this web page is from another site, which may not open the data stream. fix: allow the page's scheme and host: "
    "telepalp-server --allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kNoToken =
    "this program sends no valid token, so it may not open the data stream. fix: send the header Authorization: Bearer "
    "TOKEN, where TOKEN is all that follows \"token:\" in the file that the technician gave you";

/// A browser that trusts the server's key opens this host by HTTPS alone for a year (RFC 6797).
constexpr const char* kOnlyHttps = "max-age=31536000";

/// True for an error in the bytes of a request, not for the end of the stream.
bool is_malformed(beast::error_code failed) {
  return failed.category() == http::make_error_code(http::error::bad_method).category() &&
         failed != http::error::end_of_stream && failed != http::error::partial_message;
}

class HttpConnection final : public Connection, public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(tcp::socket socket, std::shared_ptr<GatewayContext> context)
      : Connection(std::move(context)), stream_(std::move(socket), this->context()->options.access->web_tls()) {
    beast::error_code gone;
    peer_ = stream_.socket().remote_endpoint(gone);
  }

  void start() {
    if (!stream_.is_tls()) return read();
    stream_.tcp().expires_after(context()->options.request_timeout);
    stream_.async_handshake([self = shared_from_this()](beast::error_code failed) {
      if (!failed) return self->read();
      if (ERR_GET_REASON(static_cast<unsigned long>(failed.value())) == SSL_R_HTTP_REQUEST) self->say_https();
    });
  }

  void read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeaderBytes);
    parser_->body_limit(kMaxPartBytes);
    stream_.tcp().expires_after(context()->options.request_timeout);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](beast::error_code failed, std::size_t) {
                              if (failed) return self->refuse_unreadable(failed);
                              self->read_body();
                            });
  }

  /// Only who may bring a session file may send a long body.
  void read_body() {
    const HttpRequest& head = parser_->get();
    const bool is_part =
        head.method() == http::verb::post && path_of(view(head.target())) == origin::kSessions.topic.name;
    if (!is_part || !Visit(*context(), head, peer_.address()).may(keys::Operation::Record)) {
      if (parser_->content_length().value_or(0) > kMaxBodyBytes) return refuse_unreadable(http::error::body_limit);
      parser_->body_limit(kMaxBodyBytes);
    }
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (failed) return self->refuse_unreadable(failed);
      self->answer(self->parser_->release());
    });
  }

  void close() override {
    beast::error_code ignored;
    stream_.socket().close(ignored);
  }

  [[nodiscard]] std::optional<access::Unproven> unproven() const override {
    if (visit_ && visit_->visitor()) return std::nullopt;
    return access::Unproven{.from = peer_.address(), .since = since_};
  }

 private:
  void refuse_unreadable(beast::error_code failed) {
    HttpRequest nothing;
    nothing.keep_alive(false);
    if (failed == http::error::header_limit || failed == http::error::body_limit)
      write(refuse(nothing, http::status::payload_too_large,
                   "the request is too large: its header may have at most " + std::to_string(kMaxHeaderBytes / 1024) +
                       " KiB, its body " + std::to_string(kMaxBodyBytes / 1024) + " KiB"));
    else if (is_malformed(failed))
      write(refuse(nothing, http::status::bad_request, "this is not an HTTP request"));
    else
      close();
  }

  /// Answers a browser that sends plain HTTP to this TLS port.
  void say_https() {
    static constexpr std::string_view kText =
        "HTTP/1.1 400 Bad Request\r\nContent-Type: text/plain\r\nConnection: close\r\nContent-Length: 56\r\n\r\n"
        "this port speaks HTTPS: begin the address with https://\n";
    boost::asio::async_write(stream_.socket(), boost::asio::buffer(kText),
                             [self = shared_from_this()](beast::error_code, std::size_t) {
                               beast::error_code ignored;
                               self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
                             });
  }

  void answer(HttpRequest request) {
    if (view(request.target()) == kHealthTarget) return write(health(request));
    visit_.emplace(*context(), request, peer_.address());
    if (beast::websocket::is_upgrade(request)) return upgrade(request);
    const auto reply = [self = shared_from_this()](HttpReply answer) { self->write(std::move(answer)); };
    if (!visit_->answer(request, reply))
      write(reply_to(request, context()->files, context()->options.policy, context()->now()));
  }

  HttpReply health(const HttpRequest& request) {
    const std::string problem = context()->options.problem ? context()->options.problem() : "";
    return refuse(request, problem.empty() ? http::status::ok : http::status::service_unavailable,
                  problem.empty() ? "ok" : problem);
  }

  void upgrade(const HttpRequest& request) {
    const RequestPolicy& policy = context()->options.policy;
    const std::string_view host = view(request[http::field::host]);
    if (!host_is_ours(policy, host)) return write(refuse(request, http::status::misdirected_request, kNotOurHost));
    const std::string_view origin = view(request[http::field::origin]);
    if (!origin_is_allowed(policy, origin, host, visit_->is_from_trusted_program()))
      return write(refuse(request, http::status::forbidden, origin.empty() ? kNoToken : kOtherSite));
    const auto subprotocol = foxglove::choose_subprotocol(view(request[http::field::sec_websocket_protocol]));
    if (!subprotocol)
      return write(refuse(request, http::status::bad_request,
                          "the request offers no known WebSocket subprotocol. fix: offer foxglove.websocket.v1"));
    if (!visit_->may(keys::Operation::Watch))
      return write(refuse(
          request, http::status::unauthorized,
          "sign in first, at https://" + std::string(host) + "/, or open wss://" + std::string(host) +
              "/?token=TOKEN, where TOKEN is all that follows \"token:\" in the file that the technician gave you"));
    if (const Result<void> may = context()->options.access->may_join(visit_->visitor()->who); !may)
      return write(refuse(request, http::status::too_many_requests, to_string(may.error())));
    // A browser's page cannot read why an upgrade is refused, so the stream opens and tells it.
    const Newcomer newcomer{*subprotocol, peer_, visit_->visitor(), visit_->reading(request)};
    stream_.tcp().expires_never();
    start_viewer_connection(std::move(stream_), request, newcomer, context());
  }

  void write(HttpReply reply) {
    reply_ = std::move(reply);
    if (stream_.is_tls()) reply_.set(http::field::strict_transport_security, kOnlyHttps);
    stream_.tcp().expires_after(context()->options.request_timeout);
    http::async_write(stream_, reply_, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (!failed && self->reply_.keep_alive()) return self->read();
      beast::error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  WebStream stream_;
  tcp::endpoint peer_;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
  std::optional<Visit> visit_;  // of the last request
  beast::flat_buffer buffer_{kMaxHeaderBytes + kMaxBodyBytes};
  std::optional<http::request_parser<http::string_body>> parser_;
  HttpReply reply_;
};

}  // namespace

void start_http_connection(tcp::socket socket, std::shared_ptr<GatewayContext> context) {
  // shared_ptr: the pending read or write owns the connection
  std::make_shared<HttpConnection>(std::move(socket), std::move(context))->start();
}

}  // namespace telepalp::gateway
