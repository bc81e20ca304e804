#include "server/relay/relay_origin.h"

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <charconv>
#include <utility>

#include "proto/words/repeats/repeated_errors.h"
#include "server/relay/relay_frames.h"

namespace telepalp::relay {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostPosted_B = std::size_t{64} << 20;  // parts that wait for the network thread
constexpr int kClockProbes = 8;
constexpr auto kAnswersWithin = 1000ms;
constexpr auto kAsksAgainAtMostEvery = 300ms;

struct ClockEstimate {
  Nanoseconds offset{0};  ///< session time minus this machine's steady clock
  Nanoseconds error = Nanoseconds::max();
};

/// From the quickest of some probes.
Result<ClockEstimate> estimate_clock(nats::NatsConnection& nats, const std::string& site) {
  ClockEstimate best;
  for (int probe = 0; probe < kClockProbes; ++probe) {
    const Nanoseconds asked = std::chrono::steady_clock::now().time_since_epoch();
    const Result<std::string> answer = nats.ask(clock_subject(site), {}, kAnswersWithin);
    const Nanoseconds heard = std::chrono::steady_clock::now().time_since_epoch();
    if (!answer)
      return Error{.what = answer.error().what,
                   .where = answer.error().where,
                   .fix = "start telepalp-server --publish for this site"};
    std::int64_t session_ns = 0;
    const auto read = std::from_chars(answer->data(), answer->data() + answer->size(), session_ns);
    if (read.ec != std::errc() || read.ptr != answer->data() + answer->size() || session_ns <= 0)
      return Error{.what = "the answer is no time", .where = clock_subject(site), .fix = "run telepalp-server there"};
    if (const Nanoseconds error = (heard - asked) / 2; error < best.error)
      best = {.offset = Nanoseconds{session_ns} - (asked + error), .error = error};
  }
  return best;
}

class RelayOrigin final : public origin::Origin {
  /// Wraps `handler` so that it does nothing after stop(): the io_context may still hold it. It is defined before its
  /// first use because its return type is deduced.
  template <class Handler>
  auto while_running(Handler handler) const {
    return [running = std::weak_ptr<const bool>(running_), handler = std::move(handler)](const auto&... arguments) {
      if (!running.expired()) handler(arguments...);
    };
  }

 public:
  RelayOrigin(boost::asio::io_context& io, std::string site, std::function<void(const std::string&)> log)
      : io_(io), site_(std::move(site)), log_(std::move(log)), again_(io) {}
  ~RelayOrigin() override { stop(); }

  void start(Handlers handlers) override {
    handlers_ = std::move(handlers);
    const Result<void> subscribed =
        nats_->subscribe(all_subjects(site_), [this](const nats::NatsConnection::Note& note) { post(note); });
    if (!subscribed) log_(to_string(subscribed.error()));
    ask_again();
  }
  void stop() override {
    nats_.reset();  // first: its threads read running_
    running_.reset();
    again_.cancel();
  }
  void show_again(std::string_view) override { ask_again(); }
  void ask_again() {
    if (!running_ || std::exchange(waits_to_ask_, true)) return;
    again_.expires_at(std::max(std::chrono::steady_clock::now(), asked_ + kAsksAgainAtMostEvery));
    again_.async_wait(while_running([this](const boost::system::error_code& cancelled) {
      if (cancelled) return;
      waits_to_ask_ = false;
      asked_ = std::chrono::steady_clock::now();
      nats_->publish(again_subject(site_), {});
    }));
  }
  [[nodiscard]] bool is_still() const override { return false; }
  [[nodiscard]] bool withholds(const wire::Topic&, std::size_t) const override { return false; }
  [[nodiscard]] bool chooses_prediction() const override { return false; }  // its images are as they were published
  void let_predict(bool) override {}
  [[nodiscard]] std::uint64_t images() const override { return images_; }
  [[nodiscard]] std::string in_words(const msg::CaptureStatus& status) const override {
    return "site " + site_ + ": " + status.detail();
  }

  void take(std::unique_ptr<nats::NatsConnection> nats) { nats_ = std::move(nats); }
  /// On a thread of the library.
  void changed(bool is_connected) {
    boost::asio::post(io_, while_running([this, is_connected] {
                        log_(is_connected ? "connected to the cluster again" : "the connection to the cluster is lost");
                        if (is_connected && handlers_.on_message) ask_again();
                      }));
  }

 private:
  /// On a thread of the library.
  void post(const nats::NatsConnection::Note& note) {
    const std::optional<wire::Topic> topic = topic_of(site_, note.subject);
    if (!topic || posted_B_ + note.payload.size() > kMostPosted_B) return;
    posted_B_ += note.payload.size();
    boost::asio::post(io_,
                      while_running([this, topic = *topic, part = std::string(note.payload)] { add(topic, part); }));
  }
  void add(const wire::Topic& topic, const std::string& part) {
    posted_B_ -= part.size();
    const std::uint64_t malformed = joiner_.malformed();
    std::optional<wire::Message> message = joiner_.add(topic, part);
    if (joiner_.malformed() > malformed) say_refused(topic);
    if (!message) return;
    if (topic.name == wire::kCameraDepth.name) ++images_;
    handlers_.on_message(*std::move(message));
  }

  /// Somebody else may publish at the site's subjects: its messages are refused, and the site's go on.
  void say_refused(const wire::Topic& topic) {
    const Error error{.what = "it is no part of a telepalp server's message",
                      .where = subject_of(site_, topic),
                      .fix = "let only the site's account publish there (docs/operations.md)"};
    if (const auto line = refused_.line("message from the cluster refused", error, std::chrono::steady_clock::now()))
      log_(*line);
  }

  boost::asio::io_context& io_;
  const std::string site_;
  std::function<void(const std::string&)> log_;
  RepeatedErrors refused_;
  Handlers handlers_;
  PartJoiner joiner_;
  std::uint64_t images_ = 0;
  std::shared_ptr<const bool> running_ = std::make_shared<const bool>(true);  // null after stop()
  bool waits_to_ask_ = false;
  boost::asio::steady_timer again_;
  std::chrono::steady_clock::time_point asked_{};
  std::atomic<std::size_t> posted_B_{0};
  std::unique_ptr<nats::NatsConnection> nats_;  // last: its handlers use the other members
};

}  // namespace

Result<Upstream> connect_upstream(boost::asio::io_context& io, const UpstreamOptions& options) {
  auto origin = std::make_unique<RelayOrigin>(io, options.address.site, options.log);
  auto nats = nats::NatsConnection::open(
      {.address = options.address.cluster,
       .name = "edge of " + options.address.site,
       .on_change = [raw = origin.get()](bool is_connected) { raw->changed(is_connected); }});
  if (!nats) return nats.error();
  const Result<ClockEstimate> clock = estimate_clock(**nats, options.address.site);
  if (!clock) return clock.error();
  origin->take(std::move(nats).value());
  return Upstream{.origin = std::move(origin), .clock = wire::SessionClock(clock->offset), .clock_error = clock->error};
}

}  // namespace telepalp::relay
