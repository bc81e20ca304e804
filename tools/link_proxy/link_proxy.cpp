#include "tools/link_proxy/link_proxy.h"

#include <boost/asio/ip/address.hpp>
#include <cstdio>
#include <utility>

#include "proto/words/counted.h"
#include "support/program/json.h"
#include "tools/link_proxy/tcp_proxy.h"
#include "tools/link_proxy/udp_proxy.h"

namespace telepalp::link_proxy {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using asio::ip::udp;
using boost::system::error_code;
using impaired::LinkStatistics;

Result<asio::ip::address> numeric(const program::Address& address, std::string_view option) {
  error_code failed;
  const asio::ip::address host =
      asio::ip::make_address(address.host == "localhost" ? "127.0.0.1" : address.host, failed);
  if (!failed) return host;
  return Error{.what = "'" + address.host + "' is not an IP address",
               .where = std::string(option),
               .fix = "give a numeric address, for example 127.0.0.1"};
}

Error cannot_listen(const ProxyOptions& options, const error_code& failed) {
  return {.what = "cannot listen: " + failed.message(),
          .where = program::to_text(options.listen),
          .fix = "choose another address or port for --listen"};
}

std::string live_part(const char* name, const LinkStatistics& now, const LinkStatistics& before, double seconds,
                      std::size_t queued_B) {
  const auto since = [](std::uint64_t a, std::uint64_t b) { return static_cast<double>(a - b); };
  const double sent = since(now.sent, before.sent);
  const double lost_percent = sent > 0.0 ? 100.0 * since(now.lost, before.lost) / sent : 0.0;
  char text[160];
  std::snprintf(text, sizeof text, "%s %.0f kB/s, %s, lost %.1f %%, dropped by the full queue %llu, queue %.0f kB",
                name, since(now.delivered_bytes, before.delivered_bytes) * 1e-3 / seconds,
                counted(now.sent - before.sent, "new packet", "new packets").c_str(), lost_percent,
                static_cast<unsigned long long>(now.dropped - before.dropped), static_cast<double>(queued_B) * 1e-3);
  return text;
}

void add_totals(program::Json& json, std::string_view name, const LinkStatistics& of) {
  json.begin_object(name);
  json.add("sent", of.sent);
  json.add("sent_bytes", of.sent_bytes);
  json.add("delivered", of.delivered);
  json.add("delivered_bytes", of.delivered_bytes);
  json.add("lost", of.lost);
  json.add("dropped", of.dropped);
  json.add("reordered", of.reordered);
  json.add("duplicated", of.duplicated);
  json.add("corrupted", of.corrupted);
  json.add("worst_delay_ms", to_milliseconds(of.worst_delay));
  json.end_object();
}

}  // namespace

struct LinkProxy::Parts {
  Parts(asio::io_context& io, const ProxyOptions& options, const asio::ip::address& server)
      : shared_lines(new Lines{ImpairedLine(io, {options.up, options.seed, options.trace}),
                               ImpairedLine(io, {options.down, options.seed + 1, options.trace})}),
        lines(*shared_lines),
        tcp_proxy(io, shared_lines, tcp::endpoint(server, options.server.port)),
        udp_proxy(io, lines, udp::endpoint(server, options.server.port)) {}

  std::shared_ptr<Lines> shared_lines;  // with the TCP pairs
  Lines& lines;
  TcpProxy tcp_proxy;
  UdpProxy udp_proxy;
  LinkStatistics last_up;
  LinkStatistics last_down;
  std::chrono::steady_clock::time_point last_line = std::chrono::steady_clock::now();
};

LinkProxy::LinkProxy(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
LinkProxy::~LinkProxy() = default;

Result<std::unique_ptr<LinkProxy>> LinkProxy::start(asio::io_context& io, const ProxyOptions& options) {
  const Result<asio::ip::address> listen = numeric(options.listen, "--listen");
  if (!listen) return listen.error();
  const Result<asio::ip::address> server = numeric(options.server, "--connect");
  if (!server) return server.error();
  auto parts = std::make_unique<Parts>(io, options, *server);
  if (const error_code failed = parts->tcp_proxy.listen({*listen, options.listen.port}))
    return cannot_listen(options, failed);
  if (const error_code failed = parts->udp_proxy.listen({*listen, parts->tcp_proxy.port()}))
    return cannot_listen(options, failed);
  return std::unique_ptr<LinkProxy>(new LinkProxy(std::move(parts)));
}

std::uint16_t LinkProxy::port() const { return parts_->tcp_proxy.port(); }

std::string LinkProxy::live_line() {
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::max(1e-3, to_seconds(now - parts_->last_line));
  const LinkStatistics& down = parts_->lines.to_client.statistics();
  const LinkStatistics& up = parts_->lines.to_server.statistics();
  const std::string line =
      live_part("to clients", down, parts_->last_down, seconds, parts_->lines.to_client.queued_B()) + " | " +
      live_part("to server", up, parts_->last_up, seconds, parts_->lines.to_server.queued_B()) + " | TCP connections " +
      std::to_string(parts_->tcp_proxy.connections()) + ", UDP clients " + std::to_string(parts_->udp_proxy.clients());
  parts_->last_line = now;
  parts_->last_down = down;
  parts_->last_up = up;
  return line;
}

std::string LinkProxy::totals_json() const {
  program::Json json;
  json.begin_object();
  add_totals(json, "down", parts_->lines.to_client.statistics());
  add_totals(json, "up", parts_->lines.to_server.statistics());
  json.end_object();
  return std::move(json).finish();
}

void LinkProxy::stop() {
  parts_->tcp_proxy.stop();
  parts_->udp_proxy.stop();
}

}  // namespace telepalp::link_proxy
