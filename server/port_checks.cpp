#include "server/port_checks.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <cstdio>
#include <vector>

#include "server/relay/relay_origin.h"
#include "support/nats/nats_connection.h"
#include "support/program/address.h"

namespace telepalp::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using asio::ip::udp;
using boost::system::error_code;

constexpr std::chrono::seconds kPatience{3};

Error cannot_listen(const char* protocol, const program::Address& at, const error_code& code) {
  const bool is_taken = code == asio::error::address_in_use;
  const std::string fix = is_taken ? "end the program that listens there (ss -lptun), or give another port"
                                   : "give an address of this computer, and a port above 1023";
  return {.what = std::string("cannot listen over ") + protocol + ": " +
                  (is_taken ? "another program, or another option, has this port" : code.message()),
          .where = program::to_text(at),
          .fix = fix};
}

/// Keeps each port that it found free, until the check ends.
class Ports {
 public:
  explicit Ports(asio::io_context& io) : io_(io) {}

  [[nodiscard]] Finding look(const std::string& what, const program::Address& at, bool with_udp) {
    error_code code;
    const auto address = asio::ip::make_address(at.host, code);
    if (!code) code = hold_tcp({address, at.port});
    if (code) return problem(what, cannot_listen("TCP", at, code));
    if (at.port == 0) return good(what, "any free one on " + at.host);
    if (with_udp) code = hold_udp({address, at.port});
    if (code) return problem(what, cannot_listen("UDP", at, code));
    return good(what, program::to_text(at) + " is free" + (with_udp ? ", TCP and UDP" : ""));
  }

 private:
  [[nodiscard]] error_code hold_tcp(const tcp::endpoint& at) {
    error_code code;
    tcp::acceptor& acceptor = tcp_.emplace_back(io_);
    acceptor.open(at.protocol(), code);
    if (!code) acceptor.set_option(tcp::acceptor::reuse_address(true), code);
    if (!code) acceptor.bind(at, code);
    if (!code) acceptor.listen(1, code);
    return code;
  }
  [[nodiscard]] error_code hold_udp(const udp::endpoint& at) {
    error_code code;
    udp::socket& socket = udp_.emplace_back(io_);
    socket.open(at.protocol(), code);
    if (!code) socket.bind(at, code);
    return code;
  }

  asio::io_context& io_;
  std::vector<tcp::acceptor> tcp_;
  std::vector<udp::socket> udp_;
};

/// Error: no address of the host takes a connection in time.
Result<void> reach(const program::Address& at) {
  asio::io_context io;  // its handlers refer to variables of this function, so they must not outlive it
  tcp::resolver resolver(io);
  tcp::socket socket(io);
  error_code result = asio::error::timed_out;
  resolver.async_resolve(at.host, std::to_string(at.port), [&](const error_code& code, const auto& found) {
    result = code;
    if (!code)
      asio::async_connect(socket, found,
                          [&](const error_code& connected, const tcp::endpoint&) { result = connected; });
    if (!code) result = asio::error::timed_out;  // until it is connected
  });
  io.run_for(kPatience);
  if (!result) return {};
  return Error{.what = "cannot be reached: " + result.message(),
               .where = program::to_text(at),
               .fix = "check the name, and that the firewall lets this computer connect to that port"};
}

}  // namespace

Findings check_ports(asio::io_context& io, const Asked& asked) {
  Ports ports(io);
  Findings found{ports.look("port for stations and recorders", {asked.server.bind, asked.server.port}, true)};
  if (asked.gateway)
    found.push_back(ports.look("port of the web page", {asked.gateway->address, asked.gateway->port}, false));
  if (asked.health)
    found.push_back(ports.look("port for monitoring", {asked.health->address, asked.health->port}, false));
  return found;
}

Findings check_others(asio::io_context& io, const Asked& asked) {
  Findings found;
  if (asked.meet) {
    const program::Address at{asked.meet->host, asked.meet->port};
    const Result<void> reached = reach(at);
    found.push_back(reached ? good("meeting point", program::to_text(at) + " takes connections")
                            : problem("meeting point", reached.error()));
  }
  if (asked.relay.shows) {
    const Result<relay::Upstream> upstream = relay::connect_upstream(io, {.address = *asked.relay.shows});
    found.push_back(upstream ? good("source", relay::in_words(*asked.relay.shows) + ": a server publishes this site")
                             : problem("source", upstream.error()));
  }
  if (asked.relay.publishes) {
    const relay::RelayAddress& to = *asked.relay.publishes;
    const auto cluster =
        nats::NatsConnection::open({.address = to.cluster, .name = std::string(kProgram) + " --check"});
    found.push_back(cluster ? good("cluster", relay::in_words(to) + " takes this server")
                            : problem("cluster", cluster.error()));
  }
  return found;
}

}  // namespace telepalp::server
