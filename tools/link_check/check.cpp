#include "tools/link_check/check.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <utility>
#include <vector>

#include "proto/ice/words/path_kind.h"
#include "proto/wire/client/client_link.h"
#include "proto/wire/topics.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::link_check {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPortAnswersWithin{3};
constexpr std::chrono::seconds kSessionBeginsWithin{5};
constexpr std::size_t kMostAges = 100'000;

/// Runs what waits on `io` until nothing is left, or for `most`.
void run_for(asio::io_context& io, Clock::duration most) {
  io.restart();
  io.run_for(most);
}

std::vector<tcp::endpoint> endpoints_of(const program::Address& server) {
  asio::io_context io;
  error_code failed;
  const auto found = tcp::resolver(io).resolve(server.host, std::to_string(server.port), failed);
  std::vector<tcp::endpoint> endpoints;
  if (!failed)
    for (const auto& entry : found) endpoints.push_back(entry.endpoint());
  return endpoints;
}

/// Opens a connection to the first of `endpoints` that answers, at `port`, and closes it.
Port tried(std::vector<tcp::endpoint> endpoints, std::uint16_t port) {
  asio::io_context io(1);
  tcp::socket socket(io);
  for (tcp::endpoint& endpoint : endpoints) endpoint.port(port);
  Port found{.number = port, .answer = Port::Answer::Silent};
  const Clock::time_point begin = Clock::now();
  asio::async_connect(socket, endpoints, [&](const error_code& failed, const tcp::endpoint&) {
    found.opens_after_ms = to_milliseconds(Clock::now() - begin);
    if (!failed) found.answer = Port::Answer::Opens;
    if (failed == asio::error::connection_refused) found.answer = Port::Answer::Refuses;
  });
  run_for(io, kPortAnswersWithin);
  return found;
}

/// One session with the server. Listens to the images for a while and counts them. Runs on the calling thread.
class Session {
 public:
  Session(const CheckOptions& options, bool listens)
      : listens_(listens),
        link_(io_,
              {.host = options.server.host,
               .port = options.server.port,
               .site = options.server.site,
               .name = "telepalp-link",
               .key = options.key,
               .consent = options.consent,
               .subscribes = listens ? std::vector<std::string>{"/camera/*"} : std::vector<std::string>{}},
              {.on_message = [this](const wire::Message& message) { on_message(message); },
               .on_state = [this](wire::LinkState state, const std::string&) { on_state(state); },
               .on_notice =
                   [this](const std::string& text) {
                     if (notice_.empty()) notice_ = text;
                   }}) {}

  void run(std::chrono::duration<double> listens_s, Findings& found) {
    link_.start();
    run_for(io_, kSessionBeginsWithin);
    if (link_.state() != wire::LinkState::Connected) {
      found.no_session = why_no_session();
    } else {
      listen(std::chrono::duration_cast<Clock::duration>(listens_s), found);
    }
    found.notice = notice_;
    link_.stop("the check is over");
    run_for(io_, std::chrono::seconds(1));
  }

 private:
  void on_state(wire::LinkState state) {
    if (state == wire::LinkState::Connected || state == wire::LinkState::Refused) io_.stop();
  }
  void on_message(const wire::Message& message) {
    bytes_ += message.payload->size();
    if (message.topic.name != wire::kCameraDepth.name) return;
    if (ages_ms_.size() < kMostAges) ages_ms_.push_back(to_milliseconds(link_.clock().now() - message.published));
  }
  [[nodiscard]] Error why_no_session() const {
    if (link_.state() == wire::LinkState::Refused) return link_.refusal();
    if (link_.not_served_because()) return *link_.not_served_because();
    return {.what = "the server " + link_.no_answer(), .where = {}, .fix = "see what its log says"};
  }
  [[nodiscard]] Findings::Udp udp() const {
    switch (link_.datagrams()) {
      case wire::DatagramPhase::Up:
        return Findings::Udp::Arrives;
      case wire::DatagramPhase::Off:
        return Findings::Udp::NotOffered;
      case wire::DatagramPhase::Trying:
      case wire::DatagramPhase::Blocked:
        break;
    }
    return Findings::Udp::Blocked;
  }
  /// A path without UDP is known after PathWatch::kAnswerWithin.
  void listen(Clock::duration time, Findings& found) {
    time = std::max<Clock::duration>(time, wire::PathWatch::kAnswerWithin + std::chrono::milliseconds(500));
    run_for(io_, time);
    const double seconds = std::chrono::duration<double>(time).count();
    found.round_trip_ms = 2.0 * to_milliseconds(link_.clock_uncertainty());
    found.udp = udp();
    if (const auto path = link_.path(); path && found.udp == Findings::Udp::Arrives) {
      found.way = link_.way();
      found.relayed = ice::is_relayed(*path);
    }
    if (!listens_) return;
    const auto counts = link_.received();
    const auto depth = counts.find(wire::kCameraDepth.name);
    found.images = Images{.per_s = static_cast<double>(ages_ms_.size()) / seconds,
                          .Mbit_per_s = 8e-6 * static_cast<double>(bytes_) / seconds,
                          .age_p50_ms = ages_ms_.empty() ? 0.0 : quantile_of(ages_ms_, 0.5),
                          .age_p95_ms = ages_ms_.empty() ? 0.0 : quantile_of(ages_ms_, 0.95),
                          .missed = depth == counts.end() ? 0 : depth->second.missed};
  }

  asio::io_context io_{1};
  bool listens_;
  std::vector<double> ages_ms_;
  std::string notice_;
  std::uint64_t bytes_ = 0;
  wire::ClientLink link_;
};

}  // namespace

Findings check(const CheckOptions& options) {
  Findings found{.server = program::to_text(options.server),
                 .link = {.number = options.server.port},
                 .web = {.number = options.web_port}};
  if (options.key) found.key = keys::describe(options.key->identity);
  const std::vector<tcp::endpoint> endpoints = endpoints_of(options.server);
  for (const tcp::endpoint& endpoint : endpoints) found.addresses.push_back(endpoint.address().to_string());
  found.why_no_images = "were not asked for: no session began";
  found.no_session = Error{.what = "no TCP connection", .where = {}, .fix = {}};
  if (endpoints.empty()) return found;
  found.link = tried(endpoints, options.server.port);
  if (options.web_port != options.server.port) found.web = tried(endpoints, options.web_port);
  if (found.link.answer != Port::Answer::Opens) return found;
  found.no_session.reset();
  const bool listens = !options.key || !options.consent.empty();
  Session(options, listens).run(options.listens_s, found);
  if (!found.no_session && !listens)
    found.why_no_images = "were not asked for: give --consent TEXT, once the patient has agreed that you watch";
  return found;
}

}  // namespace telepalp::link_check
