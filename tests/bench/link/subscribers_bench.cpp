#include "tests/bench/link/subscribers_bench.h"

#include <algorithm>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <cmath>
#include <ctime>
#include <numeric>

#include "proto/wire/client/client_link.h"
#include "server/hub/peer_listener.h"
#include "tests/bench/distribution.h"
#include "tests/bench/link/drained_sockets.h"
#include "tests/bench/process_load.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using boost::asio::ip::tcp;
using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t kDepthBytes = 91'000;  // of one image of the patient, fast mode
constexpr std::size_t kColorBytes = 32'000;
constexpr auto kPeriod = 33'333us;
constexpr auto kRun = 3s;  // shorter than the 5 s after which a silent peer is removed
constexpr int kImages = 90;
constexpr std::size_t kMany = 200;
constexpr std::size_t kSome = 64;

double thread_seconds() {
  timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
}

std::string control_bytes(const msg::Control& control) {
  const std::string payload = control.SerializeAsString();
  const wire::HeaderBytes header = wire::encode_header({.payload_bytes = static_cast<std::uint32_t>(payload.size())});
  return std::string(reinterpret_cast<const char*>(header.data()), header.size()) + payload;
}

/// What a subscriber of the camera says first.
std::string subscriber_words() {
  msg::Control hello;
  hello.mutable_hello()->set_protocol(wire::kProtocolVersion);
  hello.mutable_hello()->set_name("subscriber");
  msg::Control subscribe;
  subscribe.mutable_subscribe()->add_topics("/camera/*");
  return control_bytes(hello) + control_bytes(subscribe);
}

/// What one run cost and delivered.
struct Run {
  double processor_s = 0.0;  ///< of the sending thread
  std::vector<std::uint64_t> bytes;
  [[nodiscard]] double total_B() const {
    return static_cast<double>(std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0}));
  }
  [[nodiscard]] double least_over_most() const {
    const auto [least, most] = std::minmax_element(bytes.begin(), bytes.end());
    return static_cast<double>(*least) / std::max(1.0, static_cast<double>(*most));
  }
};

/// The server's own hub and listener on one thread, which publishes images at 30 Hz.
class Server {
 public:
  Server() {
    constexpr std::size_t kPlaces = 2 * kMany;
    auto made = hub::PeerListener::listen(io_, hub_, clock_, {.places = {.viewers = kPlaces, .strangers = kPlaces}});
    listener_ = std::move(made).value();
  }
  ~Server() {
    listener_->close("done");
    io_.run_for(100ms);
  }
  [[nodiscard]] std::uint16_t port() const { return listener_->port(); }
  boost::asio::io_context& io() { return io_; }
  [[nodiscard]] SessionTime now() const { return clock_.now(); }
  void await_subscribers(std::size_t count) {
    const auto until = SteadyClock::now() + 10s;
    while (hub_.subscriber_counts().size() < count && SteadyClock::now() < until) io_.run_one_for(5ms);
  }
  /// Publishes for kRun. Returns the processor time of this thread.
  double publish_images() {
    const double began_s = thread_seconds();
    auto due = SteadyClock::now();
    for (int image = 0; image < kImages; ++image) {
      hub_.publish({wire::kCameraDepth, clock_.now(), depth_, 0, true});
      hub_.publish({wire::kCameraColor, clock_.now(), color_, 0, true});
      due += kPeriod;
      io_.run_until(due);
    }
    return thread_seconds() - began_s;
  }

 private:
  boost::asio::io_context io_{1};
  hub::Hub hub_;
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  std::unique_ptr<hub::PeerListener> listener_;
  std::shared_ptr<const std::string> depth_ = std::make_shared<const std::string>(kDepthBytes, 'd');
  std::shared_ptr<const std::string> color_ = std::make_shared<const std::string>(kColorBytes, 'c');
};

Run served(std::size_t subscribers) {
  Server server;
  const DrainedSockets drained(server.port(), subscribers, subscriber_words());
  server.await_subscribers(subscribers);
  Run run;
  run.processor_s = server.publish_images();
  run.bytes = drained.bytes();
  return run;
}

/// The same messages by plain write() calls, one socket after the other; each socket skips an image while it is full,
/// as a subscriber of the hub does.
Run sent_bare(std::size_t sockets) {
  boost::asio::io_context io;
  tcp::acceptor acceptor(io, {boost::asio::ip::address_v4::loopback(), 0});
  acceptor.listen(static_cast<int>(2 * sockets));
  const DrainedSockets drained(acceptor.local_endpoint().port(), sockets, "");
  struct Sender {
    tcp::socket socket;
    std::size_t left = 0;  // bytes of the images that wait
  };
  std::vector<Sender> senders;
  for (std::size_t i = 0; i < sockets; ++i) {
    senders.push_back({acceptor.accept()});
    senders.back().socket.non_blocking(true);
    senders.back().socket.set_option(tcp::no_delay(true));
  }
  const std::string image(kDepthBytes + kColorBytes, 'x');
  Run run;
  const double began_s = thread_seconds();
  auto due = SteadyClock::now();
  for (int number = 0; number < kImages; ++number) {
    for (Sender& sender : senders)
      if (sender.left == 0) sender.left = image.size();
    due += kPeriod;
    bool waiting = true;
    while (waiting && SteadyClock::now() < due) {
      waiting = false;
      for (Sender& sender : senders) {
        if (sender.left == 0) continue;
        boost::system::error_code full;
        const std::size_t message = sender.left > kColorBytes ? sender.left - kColorBytes : sender.left;
        sender.left -= sender.socket.write_some(boost::asio::buffer(image.data(), message), full);
        waiting = waiting || sender.left != 0;
      }
      if (waiting) std::this_thread::sleep_for(200us);
    }
    std::this_thread::sleep_until(due);
  }
  run.processor_s = thread_seconds() - began_s;
  run.bytes = drained.bytes();
  return run;
}

/// Processor time for the images of one further subscriber, in milliseconds for each second of stream.
double per_subscriber_ms(const Run& few, const Run& many, std::size_t further) {
  return 1e3 * (many.processor_s - few.processor_s) / static_cast<double>(further) /
         std::chrono::duration<double>(kRun).count();
}

void add_cost(Report& report, int rounds) {
  Distribution ours_ms;
  Distribution bare_ms;
  for (int round = 0; round < rounds; ++round) {  // in turns: a slow second of the machine meets both
    ours_ms.add(per_subscriber_ms(served(1), served(kSome), kSome - 1));
    bare_ms.add(per_subscriber_ms(sent_bare(1), sent_bare(kSome), kSome - 1));
  }
  report.rows.push_back(measured("one more subscriber: processor time per second of stream", ours_ms.p50(), "ms"));
  report.rows.push_back(measured("one more bare socket: processor time per second of stream", bare_ms.p50(), "ms"));
  report.rows.push_back(at_most("processor time of one more subscriber, divided by that of one more bare socket",
                                ours_ms.p50() / bare_ms.p50(), "x", 1.3));
}

void add_many(Report& report) {
  const double full_B = static_cast<double>(kMany) * kImages * (kDepthBytes + kColorBytes);
  const Run bare = sent_bare(kMany);
  const Run ours = served(kMany);
  report.rows.push_back(
      measured("200 bare sockets: share of the bytes that is delivered", 100.0 * bare.total_B() / full_B, "%"));
  report.rows.push_back(measured("200 subscribers: share of the bytes that is delivered",
                                 100.0 * std::min(1.0, ours.total_B() / full_B), "%"));
  report.rows.push_back(at_least("bytes delivered to 200 subscribers, divided by those to 200 bare sockets",
                                 ours.total_B() / std::min(full_B, bare.total_B()), "x", 1.0 / 1.3));
  report.rows.push_back(
      at_least("200 subscribers: least bytes to a subscriber, divided by most", ours.least_over_most(), "", 0.9));
}

/// Time from publishing to the handler of a subscriber.
struct Waited {
  Distribution ms;
  double grown_MiB = 0.0;
};

enum class Others { Read, Stall };

void listen_beside(Others others, Waited& into) {
  constexpr std::size_t kOthers = 4;
  Server server;
  wire::ClientLink honest(server.io(), {.port = server.port(), .name = "honest", .subscribes = {"/camera/depth"}},
                          {.on_message = [&](const wire::Message& message) {
                            into.ms.add(to_milliseconds(server.now() - message.published));
                          }});
  honest.start();
  std::optional<DrainedSockets> reading;
  boost::asio::io_context io;
  std::vector<tcp::socket> deaf;
  if (others == Others::Read) reading.emplace(server.port(), kOthers, subscriber_words());
  while (others == Others::Stall && deaf.size() < kOthers) {
    deaf.emplace_back(io).connect({boost::asio::ip::address_v4::loopback(), server.port()});
    boost::asio::write(deaf.back(), boost::asio::buffer(subscriber_words()));
  }
  server.await_subscribers(1 + kOthers);
  const double before_MiB = resident_MiB(::getpid());
  server.publish_images();
  into.grown_MiB = std::max(into.grown_MiB, resident_MiB(::getpid()) - before_MiB);
  honest.stop();
  server.io().run_for(50ms);
}

void add_stalled(Report& report, int rounds) {
  Waited reading;
  Waited stalled;
  for (int round = 0; round < rounds; ++round) {
    listen_beside(Others::Read, reading);
    listen_beside(Others::Stall, stalled);
  }
  report.rows.push_back(
      measured("subscriber beside four that read: time from publishing to handling, p99", reading.ms.p99(), "ms"));
  report.rows.push_back(
      measured("subscriber beside four that stall: time from publishing to handling, p99", stalled.ms.p99(), "ms"));
  report.rows.push_back(at_most("subscriber's p99 beside four that stall, divided by that beside four that read",
                                stalled.ms.p99() / reading.ms.p99(), "x", 1.1));
  report.rows.push_back(
      at_most("four subscribers that stall: growth of the server's memory", stalled.grown_MiB, "MiB", 16.0));
}

}  // namespace

void add_subscribers(Report& report, double seconds) {
  const int rounds = std::max(2, static_cast<int>(std::lround(seconds / 10.0)));
  add_cost(report, rounds);
  add_many(report);
  add_stalled(report, rounds);
  report.notes.push_back(
      "subscribers: depth of 91 kB and colour of 32 kB at 30 Hz, encoded once, plain TCP on loopback, runs of 3 s");
  report.notes.push_back("bare sockets: the same bytes by write() on non-blocking sockets, without framing or queues");
}

Result<Report> run_subscribers(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 1.0, 600.0);
  if (!seconds) return seconds.error();
  Report report{.bench = "subscribers", .rows = {}, .notes = {}};
  add_subscribers(report, *seconds);
  return report;
}

}  // namespace telepalp::bench
