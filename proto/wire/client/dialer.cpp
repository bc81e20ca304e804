#include "proto/wire/client/dialer.h"

#include <utility>

#include "proto/wire/sockets/udp_socket.h"

namespace telepalp::wire {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::seconds kConnectDeadline{3};

}  // namespace

Dialer::Dialer(boost::asio::io_context& io, Server server, Handlers handlers)
    : io_(io),
      server_(std::move(server)),
      handlers_(std::move(handlers)),
      resolver_(io),
      connecting_(io),
      deadline_(io) {}

void Dialer::dial() {
  attempt_ = std::make_shared<const bool>(true);
  error_code not_numeric;
  const auto address = boost::asio::ip::make_address(server_.host, not_numeric);
  if (not_numeric) return resolve();
  untried_ = {{address, server_.port}};
  connect_next();
}

void Dialer::hang_up() {
  attempt_.reset();
  resolver_.cancel();
  deadline_.cancel();
  error_code ignored;
  connecting_.close(ignored);
}

void Dialer::resolve() {
  resolver_.async_resolve(server_.host, std::to_string(server_.port),
                          while_dialing([this](const error_code& code, const tcp::resolver::results_type& found) {
                            if (code) return handlers_.on_failed(code.message());
                            untried_.assign(found.begin(), found.end());
                            connect_next();
                          }));
}

/// Tries the next address of the host. A name may have several, for example ::1 and 127.0.0.1, and the server may
/// listen at one of them only. Without a key, nothing leaves this machine: a patient in clear text on a network is
/// worse than no connection.
void Dialer::connect_next() {
  const Endpoint endpoint = untried_.front();
  untried_.pop_front();
  if (!server_.key && !endpoint.address().is_loopback())
    return handlers_.on_refused(
        {.what = "the server is on another machine, and no key is given",
         .where = {},
         .fix = "give --key FILE; the technician of the server makes it: telepalp-keys client"});
  connecting_ = tcp::socket(io_);
  deadline_.call_after(kConnectDeadline, [this] {
    error_code ignored;
    connecting_.close(ignored);
  });
  connecting_.async_connect(endpoint, while_dialing([this, endpoint](const error_code& code) {
                              deadline_.cancel();
                              if (code && !untried_.empty()) return connect_next();
                              if (code) return handlers_.on_failed(code.message());
                              connected(std::move(connecting_), endpoint);
                            }));
}

bool Dialer::has_own_address() const { return is_own_address(io_, own_); }

void Dialer::connected(tcp::socket socket, const Endpoint& server) {
  error_code gone;
  own_ = socket.local_endpoint(gone).address();
  Result<std::unique_ptr<ByteStream>> stream = secured(std::move(socket));
  if (!stream) return handlers_.on_refused(stream.error());
  handlers_.on_connected(std::move(stream).value(), server);
}

Result<std::unique_ptr<ByteStream>> Dialer::secured(tcp::socket socket) {
  if (!server_.key) return plain_tcp(std::move(socket));
  if (!tls_) {
    Result<TlsSettings> settings = tls_settings(keys::client_context(*server_.key));
    if (!settings) return settings.error();
    tls_ = std::move(settings).value();
  }
  return tls_at_client(std::move(socket), tls_, server_.name(), server_.key);
}

}  // namespace telepalp::wire
