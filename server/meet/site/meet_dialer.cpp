#include "server/meet/site/meet_dialer.h"

#include <netinet/tcp.h>

#include <algorithm>
#include <array>
#include <boost/asio/connect.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <deque>
#include <utility>

#include "messages/meet.pb.h"
#include "proto/wire/sockets/tcp_socket.h"
#include "proto/wire/sockets/udp_socket.h"
#include "proto/wire/tls_stream.h"
#include "server/meet/site/told_relay.h"
#include "server/meet/words/meet_frames.h"

namespace telepalp::meet {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::milliseconds kFirstWait{500}, kLongestWait{5000};
constexpr auto kTimeToConnect = 5s;
constexpr std::chrono::milliseconds kLookAtAddress{100};  // between two looks, and before the first try at a new one
constexpr std::size_t kMostAnswers = 64;                  // connections to the meeting point that are being opened

/// Lets the system check each second that the connection still leads to the meeting point. A router that has forgotten
/// the connection answers the check with a reset. Without any answer the connection ends after 6 s.
void watch_way(tcp::socket& socket) {
  using Seconds = asio::detail::socket_option::integer<IPPROTO_TCP, TCP_KEEPIDLE>;
  using Between = asio::detail::socket_option::integer<IPPROTO_TCP, TCP_KEEPINTVL>;
  using Times = asio::detail::socket_option::integer<IPPROTO_TCP, TCP_KEEPCNT>;
  using Unanswered_ms = asio::detail::socket_option::integer<IPPROTO_TCP, TCP_USER_TIMEOUT>;
  error_code ignored;  // without the options, kSilence ends the connection
  socket.set_option(asio::socket_base::keep_alive(true), ignored);
  socket.set_option(Seconds(1), ignored);
  socket.set_option(Between(1), ignored);
  socket.set_option(Times(6), ignored);
  socket.set_option(Unanswered_ms(6000), ignored);
}

}  // namespace

/// The connection to the meeting point, and the attempts to have one.
class MeetDialer::Line : public std::enable_shared_from_this<Line> {
 public:
  Line(asio::io_context& io, Options options, wire::TlsSettings tls)
      : io_(io),
        options_(std::move(options)),
        tls_(std::move(tls)),
        resolver_(io),
        timer_(io),
        beat_(io),
        look_(io),
        relay_(options_.log) {
    if (!options_.has_address)
      options_.has_address = [this](const asio::ip::address& own) { return wire::is_own_address(io_, own); };
  }

  [[nodiscard]] bool has_joined() const noexcept { return joined_; }
  [[nodiscard]] const std::vector<msg::IceRelay>& relays() const noexcept { return relay_.relays(); }

  void dial() {
    resolver_.async_resolve(
        options_.host, std::to_string(options_.port),
        [self = shared_from_this()](const error_code& failed, const tcp::resolver::results_type& at) {
          if (self->ended_) return;
          if (failed) return self->lost(failed.message());
          self->connect(at);
        });
  }

  void end() {
    ended_ = true;
    resolver_.cancel();
    timer_.cancel();
    hang_up();
  }

 private:
  using Stream = asio::ssl::stream<tcp::socket>;

  /// Wraps `handler` so that it does nothing once `stream` is not the present one.
  template <class Handler>
  auto of(std::shared_ptr<Stream> stream, Handler handler) {
    return [self = shared_from_this(), stream = std::move(stream), handler](const auto&... arguments) {
      if (self->stream_ == stream && !self->ended_) handler(arguments...);
    };
  }

  void connect(const tcp::resolver::results_type& at) {
    // shared_ptr: pending operations of an attempt that was given up still hold its stream
    stream_ = std::make_shared<Stream>(io_, *tls_);
    keys::expect_host(*stream_->native_handle(), options_.host);
    give_up_after(kTimeToConnect);
    const auto connected = of(stream_, [this](const error_code& failed, const tcp::endpoint& endpoint) {
      if (failed) return lost(failed.message());
      meet_ = endpoint;
      moved_ = moved_ || !options_.has_address(own_);  // the old address was lost meanwhile
      error_code gone;
      own_ = stream_->next_layer().local_endpoint(gone).address();
      watch_way(stream_->next_layer());
      shake_hands();
    });
    asio::async_connect(
        stream_->next_layer(), at,
        [connected](const error_code& failed, const tcp::endpoint& endpoint) { connected(failed, endpoint); });
  }

  void shake_hands() {
    stream_->async_handshake(asio::ssl::stream_base::client, of(stream_, [this](const error_code& failed) {
                               if (!failed) return join();
                               const auto refusal = keys::refusal_of(*stream_->native_handle(),
                                                                     static_cast<unsigned long>(failed.value()),
                                                                     *options_.key, options_.host);
                               lost(refusal ? refusal->what + ". fix: " + refusal->fix : failed.message());
                             }));
  }

  void join() {
    heard_ = std::chrono::steady_clock::now();
    msg::SiteToMeet message;
    message.set_join(kVersion);
    message.set_moved(moved_);
    send(message);
    read();
    beat();
    look_at_address();
  }

  /// A lost address is noticed here, because silence would show it only after kSilence.
  void look_at_address() {
    look_.expires_after(kLookAtAddress);
    look_.async_wait(of(stream_, [this](const error_code& cancelled) {
      if (cancelled) return;
      if (options_.has_address(own_)) return look_at_address();
      moved_ = true;
      wait_ = kLookAtAddress;
      lost("this computer's address has changed");
    }));
  }

  void read() {
    stream_->async_read_some(asio::buffer(bytes_), of(stream_, [this](const error_code& failed, std::size_t count) {
                               if (failed) return broken(failed);
                               heard_ = std::chrono::steady_clock::now();
                               frames_.append({bytes_.data(), count});
                               const std::shared_ptr<Stream> present = stream_;
                               while (const auto frame = frames_.next()) {
                                 take(*frame);
                                 if (stream_ != present) return;
                               }
                               if (frames_.is_bad()) return lost("it announced a message that is too large");
                               read();
                             }));
  }

  void take(const std::string& frame) {
    msg::MeetToSite message;
    if (!message.ParseFromString(frame)) return lost("it sent what is no message of this protocol");
    if (message.has_welcome()) welcome(message.welcome());
    if (message.has_relay()) relay_.heard(message.relay());
    if (message.has_call()) answer(message.call());
    if (message.what_case() == msg::MeetToSite::kRefused) lost("it refuses this site: " + message.refused());
  }

  void welcome(const msg::MeetWelcome& welcome) {
    timer_.cancel();
    joined_ = true;
    moved_ = false;
    wait_ = kFirstWait;
    told_.clear();
    std::string names;
    for (const std::string& name : welcome.names()) names += (names.empty() ? "" : ", ") + name;
    options_.log("joined the meeting point " + options_.host + ": callers reach this site by the name " + names);
    if (welcome.names().empty()) return;
    const std::string port = options_.port == 443 ? "" : ":" + std::to_string(options_.port);
    options_.log("programs: --connect " + welcome.names(0) + "@" + options_.host + port +
                 "; browsers, where this name leads "
                 "to the meeting point: https://" +
                 welcome.names(0) + port + "/");
  }

  /// Opens a connection to the meeting point that begins with the call's token, and hands it over.
  void answer(const msg::MeetCall& call) {
    const Caller caller{.is_browser = call.browser(), .from = call.from()};
    if (call.token().size() != kTokenBytes || answers_ >= kMostAnswers || !options_.takes(caller))
      return decline(call.token());
    ++answers_;
    struct Answer {
      tcp::socket socket;
      asio::steady_timer deadline;
      std::string words;
    };
    const auto opened = std::make_shared<Answer>(
        Answer{tcp::socket(io_), asio::steady_timer(io_), std::string(kAnswer) + call.token()});
    opened->deadline.expires_after(kTimeToConnect);
    opened->deadline.async_wait([opened](const error_code& cancelled) {
      error_code ignored;
      if (!cancelled) opened->socket.close(ignored);
    });
    const auto done = [self = shared_from_this(), opened, caller](const error_code& failed, std::size_t) {
      --self->answers_;
      opened->deadline.cancel();
      if (!failed && !self->ended_) self->options_.on_caller(std::move(opened->socket), caller);
    };
    opened->socket.async_connect(meet_, [opened, done](const error_code& failed) {
      if (failed) return done(failed, 0);
      asio::async_write(opened->socket, asio::buffer(opened->words), done);
    });
  }

  void decline(const std::string& token) {
    msg::SiteToMeet message;
    message.set_decline(token);
    send(message);
  }

  void send(const msg::SiteToMeet& message) {
    // shared_ptr: a write that was given up may still read it
    to_send_.push_back(std::make_shared<const std::string>(framed(message)));
    if (to_send_.size() == 1) write_next();
  }

  void write_next() {
    asio::async_write(*stream_, asio::buffer(*to_send_.front()),
                      of(stream_, [this, kept = to_send_.front()](const error_code& failed, std::size_t) {
                        if (failed) return broken(failed);
                        to_send_.pop_front();
                        if (!to_send_.empty()) write_next();
                      }));
  }

  void beat() {
    if (std::chrono::steady_clock::now() - heard_ > kSilence) return lost("nothing came from it for 25 s");
    msg::SiteToMeet still_here;
    still_here.set_beat(true);
    send(still_here);
    beat_.expires_after(kBeat);
    beat_.async_wait(of(stream_, [this](const error_code& cancelled) {
      if (!cancelled) beat();
    }));
  }

  void give_up_after(std::chrono::seconds time) {
    timer_.expires_after(time);
    timer_.async_wait(of(stream_, [this](const error_code& cancelled) {
      if (!cancelled) lost("it did not answer");
    }));
  }

  /// A reset or silence on the way to the meeting point: the callers' connections went the same way.
  void broken(const error_code& failed) {
    const bool way_is_lost = failed == asio::error::connection_reset || failed == asio::error::timed_out;
    if (way_is_lost) wait_ = kLookAtAddress;
    moved_ = moved_ || way_is_lost;
    lost(failed.message());
  }

  /// Says why once, and not again at each attempt that fails in the same way.
  void lost(const std::string& why) {
    hang_up();
    if (std::exchange(joined_, false) || told_ != why)
      options_.log("no connection with the meeting point " + options_.host + ": " + why + "; this server tries again");
    told_ = why;
    timer_.expires_after(wait_);
    wait_ = std::min(2 * wait_, options_.has_address(own_) ? kLongestWait : kFirstWait);  // a new one may come soon
    timer_.async_wait([self = shared_from_this()](const error_code& cancelled) {
      if (!cancelled && !self->ended_) self->dial();
    });
  }

  void hang_up() {
    timer_.cancel();
    beat_.cancel();
    look_.cancel();
    to_send_.clear();
    frames_ = {};
    if (!stream_) return;
    error_code ignored;
    stream_->next_layer().close(ignored);
    stream_ = nullptr;  // its pending operations hold it
  }

  asio::io_context& io_;
  Options options_;
  wire::TlsSettings tls_;
  tcp::resolver resolver_;
  asio::steady_timer timer_;  // ends an attempt that takes too long, or begins the next attempt
  asio::steady_timer beat_;
  asio::steady_timer look_;  // at the address
  std::shared_ptr<Stream> stream_;
  tcp::endpoint meet_;
  asio::ip::address own_;  // from which it dialled
  FrameReader frames_;
  std::array<char, 1024> bytes_{};
  std::deque<std::shared_ptr<const std::string>> to_send_;
  std::chrono::steady_clock::time_point heard_;
  std::chrono::milliseconds wait_ = kFirstWait;
  std::string told_;  // why the last attempt failed
  std::size_t answers_ = 0;
  ToldRelay relay_;  // kept while the meeting point does not answer: the credentials may still hold
  bool joined_ = false;
  bool moved_ = false;  // own_ or the way was lost, and the meeting point does not know it yet
  bool ended_ = false;
};

Result<std::unique_ptr<MeetDialer>> MeetDialer::start(asio::io_context& io, Options options) {
  Result<wire::TlsSettings> tls = wire::tls_settings(keys::client_context(*options.key));
  if (!tls) return tls.error();
  auto line = std::make_shared<Line>(io, std::move(options), std::move(tls).value());
  line->dial();
  return std::unique_ptr<MeetDialer>(new MeetDialer(std::move(line)));
}

MeetDialer::MeetDialer(std::shared_ptr<Line> line) : line_(std::move(line)) {}

MeetDialer::~MeetDialer() { line_->end(); }

bool MeetDialer::has_joined() const noexcept { return line_->has_joined(); }

std::vector<msg::IceRelay> MeetDialer::relays() const { return line_->relays(); }

}  // namespace telepalp::meet
