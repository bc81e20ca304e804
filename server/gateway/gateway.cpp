#include "server/gateway/gateway.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "proto/wire/sockets/tcp_socket.h"
#include "server/gateway/full_house.h"
#include "server/gateway/http_connection.h"
#include "support/program/address.h"

namespace telepalp::gateway {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

Error cannot_listen(const GatewayOptions& options, const boost::system::error_code& failed) {
  return {.what = "cannot listen: " + failed.message(),
          .where = options.address + ":" + std::to_string(options.port),
          .fix = "choose another --http-port (0: any free one), or give --bind an address of this machine"};
}

Result<tcp::acceptor> listen(asio::io_context& io, const GatewayOptions& options) {
  boost::system::error_code failed;
  const asio::ip::address address = asio::ip::make_address(options.address, failed);
  if (failed) return cannot_listen(options, failed);
  const tcp::endpoint endpoint{address, options.port};
  tcp::acceptor acceptor(io);
  if (failed = wire::open_acceptor(acceptor, endpoint); failed) return cannot_listen(options, failed);
  return acceptor;
}

/// The host in the URL of a gateway that listens on all addresses, because nobody can open 0.0.0.0: of the key's hosts,
/// the first one that other computers can use, or else the first one.
std::string host_for_visitors(const std::vector<std::string>& hosts) {
  const auto is_own = [](const std::string& host) {
    boost::system::error_code is_name;
    const auto address = asio::ip::make_address(host, is_name);
    return host == "localhost" || host.starts_with('*') || (!is_name && address.is_loopback());
  };
  const auto found = std::ranges::find_if_not(hosts, is_own);
  return found != hosts.end() ? *found : hosts.empty() ? "localhost" : hosts.front();
}

}  // namespace

Connection::Connection(std::shared_ptr<GatewayContext> context) : context_(std::move(context)) {
  context_->connections.insert(this);
}

Connection::~Connection() { context_->connections.erase(this); }

Result<std::unique_ptr<Gateway>> Gateway::open(asio::io_context& io, hub::Hub& hub, std::function<SessionTime()> now,
                                               GatewayOptions options) {
  StaticFiles files;
  if (!options.viewer_files.empty()) {
    auto read = StaticFiles::read(options.viewer_files);
    if (!read) return read.error();
    files = std::move(read).value();
  }
  auto acceptor = listen(io, options);
  if (!acceptor) return acceptor.error();
  for (const std::string& host : options.access->web_hosts()) options.policy.allowed_hosts.push_back(host);
  options.policy.scheme = options.access->has_keys() ? "https" : "http";
  options.offer.resources.insert(options.resources.begin(), options.resources.end());
  const std::string session_id = std::to_string(to_nanoseconds(now()));
  auto context = std::make_shared<GatewayContext>(GatewayContext{
      hub, options, std::move(files), now, session_id, {io, options.open_session, options.resources, now}, {}});
  context->states =
      std::make_unique<origin::StatePublisher>(context->views, context->options.offer.resources, std::move(now));
  context->view_maker = std::make_unique<views::ViewMaker>(
      io, hub, context->views, context->options.log ? context->options.log : [](const std::string&) {});
  return std::unique_ptr<Gateway>(new Gateway(std::move(acceptor).value(), std::move(context)));
}

Gateway::Gateway(tcp::acceptor acceptor, std::shared_ptr<GatewayContext> context)
    : acceptor_(std::move(acceptor)),
      accept_again_(acceptor_.get_executor()),
      second_(acceptor_.get_executor()),
      look_(acceptor_.get_executor()),
      context_(std::move(context)),
      port_(acceptor_.local_endpoint().port()) {
  accept();
  look_after_connections_every_second();
  look_at_states();
}

Gateway::~Gateway() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  const std::unordered_set<Connection*> open = context_->connections;  // a copy: close() may change the set
  for (Connection* const connection : open) connection->close();
  context_->view_maker.reset();  // the hub may be destroyed before the last connection
}

std::string Gateway::url() const {
  const access::Access& access = *context_->options.access;
  std::string host = context_->options.address;
  if (asio::ip::make_address(host).is_unspecified()) host = host_for_visitors(access.web_hosts());
  return (access.has_keys() ? "https://" : "http://") + program::to_text({host, port_}) + "/";
}

void Gateway::look_after_connections_every_second() {
  const bool has_keys = context_->options.access->has_keys();
  if (has_keys) context_->options.access->look_at_files();
  const std::unordered_set<Connection*> open = context_->connections;  // check_access() may take them out
  for (Connection* const connection : open) {
    connection->send_playback_state();
    if (has_keys) connection->check_access();
  }
  second_.expires_after(std::chrono::seconds(1));
  second_.async_wait(alive_.guard([this](boost::system::error_code cancelled) {
    if (!cancelled) look_after_connections_every_second();
  }));
}

void Gateway::offer(origin::Offer offer) {
  origin::Offer& present = context_->options.offer;
  present = std::move(offer);
  present.resources.insert(context_->options.resources.begin(), context_->options.resources.end());
  for (Connection* const connection : context_->connections) connection->offer_changed();
}

void Gateway::look_at_states() {
  context_->states->look();
  context_->holder.end_if_silent(context_->now());
  for (Connection* const connection : context_->connections) connection->look_at_own_states();
  look_.expires_after(origin::StatePublisher::kLook);
  look_.async_wait(alive_.guard([this](boost::system::error_code cancelled) {
    if (!cancelled) look_at_states();
  }));
}

void Gateway::accept() {
  acceptor_.async_accept(alive_.guard([this](boost::system::error_code failed, tcp::socket socket) {
    if (failed == asio::error::operation_aborted) return;
    if (failed) {  // probably no file descriptor is free; an immediate retry would waste the processor
      accept_again_.expires_after(std::chrono::milliseconds(100));
      accept_again_.async_wait(alive_.guard([this](boost::system::error_code cancelled) {
        if (!cancelled) accept();
      }));
      return;
    }
    admit(std::move(socket));
    accept();
  }));
}

void Gateway::admit(tcp::socket socket) {
  make_room(access::newcomer(socket));
  if (context_->connections.size() < context_->options.max_connections)
    start_http_connection(std::move(socket), context_);
  else
    refuse(std::move(socket));
}

/// When all places are taken, closes a connection that has brought no valid key (one_to_close()). When there is none,
/// it closes a viewer that has subscribed to nothing.
void Gateway::make_room(const access::Unproven& newcomer) {
  if (context_->connections.size() < context_->options.max_connections) return;
  const auto has = [this](auto property) {
    return std::find_if(context_->connections.begin(), context_->connections.end(), property);
  };
  const auto end = context_->connections.end();
  if (has([](const Connection* connection) { return connection->unproven().has_value(); }) != end)
    return make_room_among_strangers(newcomer);
  const auto idle = has([](const Connection* connection) { return connection->is_idle(); });
  if (idle != end) let_go(**idle);
}

/// Makes no room if the newcomer itself comes from the network that holds most.
void Gateway::make_room_among_strangers(const access::Unproven& newcomer) {
  std::vector<Connection*> strangers;
  std::vector<access::Unproven> all;
  for (Connection* const connection : context_->connections) {
    const std::optional<access::Unproven> unproven = connection->unproven();
    if (!unproven) continue;
    strangers.push_back(connection);
    all.push_back(*unproven);
  }
  all.push_back(newcomer);
  const std::optional<std::size_t> chosen = access::one_to_close(all, newcomer.since);
  if (chosen && *chosen < strangers.size()) let_go(*strangers[*chosen]);
}

void Gateway::let_go(Connection& connection) {
  context_->connections.erase(&connection);  // its pending handlers destroy it later; its place is free at once
  connection.close();
}

void Gateway::refuse(tcp::socket socket) {
  constexpr std::chrono::seconds kQuiet{5};
  const std::string places = std::to_string(context_->options.max_connections);
  const auto now = std::chrono::steady_clock::now();
  if (context_->options.log && (refusal_noted_ == decltype(refusal_noted_){} || now - refusal_noted_ >= kQuiet)) {
    refusal_noted_ = now;
    context_->options.log("a browser is refused: all " + places +
                          " places for browsers are taken. fix: close another viewer");
  }
  refuse_full_house(std::move(socket), "the server is full: all " + places +
                                           " places for browsers are taken. fix: close another viewer, then try again");
}

}  // namespace telepalp::gateway
