#include "server/relay/publisher.h"

#include <algorithm>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "server/relay/relay_frames.h"

namespace telepalp::relay {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostTaken_B = std::size_t{2} << 20;  // by the thread, and not written yet
constexpr std::size_t kMostPart_B = std::size_t{512} << 10;
constexpr auto kAgainAtMostEvery = 300ms;
constexpr auto kAnotherAnswersWithin = 300ms;

}  // namespace

/// The hub's subscription on the network thread, the queue, and the thread that empties it.
class Publisher::Line : public std::enable_shared_from_this<Line> {
 public:
  Line(boost::asio::io_context& io, hub::Hub& hub, const wire::SessionClock& clock, Options options)
      : io_(io), hub_(hub), clock_(clock), options_(std::move(options)), again_(io) {}

  Result<void> start();
  void stop();
  [[nodiscard]] Counts counts() const noexcept { return {.published = published_, .lost = lost_}; }

 private:
  template <class Call>
  void on_network_thread(Call call) {
    boost::asio::post(io_, [line = weak_from_this(), call = std::move(call)] {
      if (const auto self = line.lock(); self && !self->stopped_) call(*self);
    });
  }
  void join();
  void take();
  void show_again();
  void write();
  void write(const wire::Message& message, PartCutter& cutter);

  boost::asio::io_context& io_;
  hub::Hub& hub_;
  wire::SessionClock clock_;
  Options options_;
  bool stopped_ = false;
  bool waits_to_show_ = false;
  hub::SubscriberId subscriber_ = 0;  // 0: none
  boost::asio::steady_timer again_;
  std::chrono::steady_clock::time_point shown_{};

  std::mutex mutex_;
  std::condition_variable given_;
  std::deque<wire::Message> taken_;  // guarded by mutex_
  bool ends_ = false;                // guarded by mutex_
  std::atomic<std::size_t> taken_B_{0};
  std::atomic<std::uint64_t> published_{0};
  std::atomic<std::uint64_t> lost_{0};
  std::unique_ptr<nats::NatsConnection> nats_;
  std::thread writer_;
};

Result<void> Publisher::Line::start() {
  const std::string& site = options_.address.site;
  auto nats =
      nats::NatsConnection::open({.address = options_.address.cluster,
                                  .name = "telepalp-server of " + site,
                                  .on_change =
                                      [line = weak_from_this()](bool is_connected) {
                                        if (const auto self = line.lock())
                                          self->on_network_thread([is_connected](Line& on) {
                                            on.options_.log(is_connected ? "connected to the cluster again"
                                                                         : "the connection to the cluster is lost");
                                            if (is_connected) on.show_again();
                                          });
                                      },
                                  .writes_at_once = true});
  if (!nats) return nats.error();
  nats_ = std::move(nats).value();
  if (nats_->ask(clock_subject(site), {}, kAnotherAnswersWithin))
    return Error{.what = "another server publishes the site '" + site + "' there",
                 .where = in_words(options_.address),
                 .fix = "stop it, or give this site another name: nats://HOST/SITE"};
  const Result<void> clock = nats_->subscribe(clock_subject(site), [this](const nats::NatsConnection::Note& note) {
    if (!note.reply_to.empty())
      nats_->publish(std::string(note.reply_to), std::to_string(to_nanoseconds(clock_.now())));
  });
  if (!clock) return clock.error();
  const Result<void> again = nats_->subscribe(again_subject(site), [this](const nats::NatsConnection::Note&) {
    on_network_thread([](Line& line) { line.show_again(); });
  });
  if (!again) return again.error();
  writer_ = std::thread([this] { write(); });
  join();
  return {};
}

void Publisher::Line::stop() {
  stopped_ = true;
  again_.cancel();
  if (subscriber_ != 0) hub_.leave(subscriber_);
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  given_.notify_one();
  if (writer_.joinable()) writer_.join();
  nats_.reset();
}

/// A new subscriber gets the latched messages, and its first depth image is a key frame.
void Publisher::Line::join() {
  if (subscriber_ != 0) hub_.leave(subscriber_);
  subscriber_ = hub_.join("relay", in_words(options_.address), [line = weak_from_this()] {
    if (const auto self = line.lock()) self->take();
  });
  std::vector<std::string> topics;
  for (const wire::Topic& topic : wire::kTopics)
    if (is_relayed(topic)) topics.emplace_back(topic.name);
  hub_.subscribe(subscriber_, topics);
  shown_ = std::chrono::steady_clock::now();
}

/// Requests of many edges become one.
void Publisher::Line::show_again() {
  if (std::exchange(waits_to_show_, true)) return;
  again_.expires_at(std::max(std::chrono::steady_clock::now(), shown_ + kAgainAtMostEvery));
  again_.async_wait([line = weak_from_this()](const boost::system::error_code& cancelled) {
    const auto self = line.lock();
    if (cancelled || !self || self->stopped_) return;
    self->waits_to_show_ = false;
    self->join();
    self->take();
  });
}

void Publisher::Line::take() {
  bool took = false;
  while (!stopped_ && subscriber_ != 0 && taken_B_ < kMostTaken_B) {
    std::optional<wire::Message> message = hub_.next(subscriber_);
    if (!message) break;
    taken_B_ += message->payload->size();
    const std::scoped_lock lock(mutex_);
    taken_.push_back(*std::move(message));
    took = true;
  }
  if (took) given_.notify_one();
}

void Publisher::Line::write() {
  PartCutter cutter(std::clamp(nats_->most_payload_B(), kLeastPartBytes, kMostPart_B));
  std::unique_lock lock(mutex_);
  while (true) {
    given_.wait(lock, [this] { return ends_ || !taken_.empty(); });
    if (ends_) return;
    const wire::Message message = std::move(taken_.front());
    taken_.pop_front();
    lock.unlock();
    write(message, cutter);
    if (taken_B_.fetch_sub(message.payload->size()) >= kMostTaken_B) on_network_thread([](Line& line) { line.take(); });
    lock.lock();
  }
}

void Publisher::Line::write(const wire::Message& message, PartCutter& cutter) {
  const std::string subject = subject_of(options_.address.site, message.topic);
  const bool is_written = cutter.cut(message, [&](std::string_view part) { return nats_->publish(subject, part); });
  ++(is_written ? published_ : lost_);
}

Publisher::Publisher(std::shared_ptr<Line> line) : line_(std::move(line)) {}
Publisher::~Publisher() { line_->stop(); }
Publisher::Counts Publisher::counts() const noexcept { return line_->counts(); }

Result<std::unique_ptr<Publisher>> Publisher::open(boost::asio::io_context& io, hub::Hub& hub,
                                                   const wire::SessionClock& clock, Options options) {
  auto line = std::make_shared<Line>(io, hub, clock, std::move(options));
  std::unique_ptr<Publisher> publisher(new Publisher(line));
  if (const Result<void> started = line->start(); !started) return started.error();
  return publisher;
}

}  // namespace telepalp::relay
