#include "tests/bench/link/srt_run.h"

#include <arpa/inet.h>
#include <srt/srt.h>

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <cstring>
#include <map>
#include <thread>

#include "proto/words/demand.h"
#include "tests/bench/link/camera_feed.h"
#include "tests/bench/link/plain_address.h"
#include "tests/bench/link/real_time_priority.h"
#include "tools/link_proxy/link_proxy.h"

namespace telepalp::bench::link {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMessage_B = 1316;  ///< SRT's default for a live stream

struct MessageLabel {
  std::uint32_t number;
  std::uint16_t messages;  ///< of the image
  std::uint16_t image;
  std::uint64_t image_B;
};

template <class Value>
void set(SRTSOCKET socket, SRT_SOCKOPT option, Value value) {
  demand(srt_setsockopt(socket, 0, option, &value, sizeof value) == 0, "SRT takes the option");
}

SRTSOCKET make_socket(const Scenario& scenario) {
  const SRTSOCKET socket = srt_create_socket();
  const Nanoseconds latency = scenario.deadline - scenario.encoding - scenario.down.delay;
  set(socket, SRTO_LATENCY, static_cast<std::int32_t>(latency / 1ms));
  constexpr std::string_view kPassphrase = "a passphrase of a benchmark";
  demand(srt_setsockopt(socket, 0, SRTO_PASSPHRASE, kPassphrase.data(), static_cast<int>(kPassphrase.size())) == 0,
         "SRT takes a passphrase");
  set(socket, SRTO_PBKEYLEN, std::int32_t{32});
  set(socket, SRTO_CONNTIMEO, std::int32_t{20'000});
  set(socket, SRTO_RCVTIMEO, std::int32_t{500});
  set(socket, SRTO_MAXBW, std::int64_t{-1});
  return socket;
}

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

std::uint16_t port_of(SRTSOCKET socket) {
  sockaddr_in address{};
  int size = sizeof address;
  srt_getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

double send_image(SRTSOCKET to, const CameraImage& image) {
  const std::size_t part_B = kMessage_B - sizeof(MessageLabel);
  const auto messages = static_cast<std::uint16_t>((image.bytes.size() + part_B - 1) / part_B);
  const MessageLabel label{image.number, messages, image.image, image.bytes.size()};
  std::array<char, kMessage_B> message{};
  double sent_B = 0.0;
  for (std::size_t at = 0; at < image.bytes.size(); at += part_B) {
    const std::size_t size = sizeof label + std::min(part_B, image.bytes.size() - at);
    std::memcpy(message.data(), &label, sizeof label);
    std::memcpy(message.data() + sizeof label, image.bytes.data() + at, size - sizeof label);
    srt_sendmsg(to, message.data(), static_cast<int>(size), -1, 1);
    sent_B += static_cast<double>(size);
  }
  return sent_B;
}

struct Arrival {
  MessageLabel label;
  Nanoseconds at;
};

std::vector<Arrival> receive_until(SRTSOCKET from, Clock::time_point start, const std::atomic<bool>& stop) {
  std::vector<Arrival> arrivals;
  std::map<std::pair<int, std::uint32_t>, std::uint16_t> messages;
  std::array<char, 1500> message{};
  while (!stop) {
    const int size = srt_recvmsg(from, message.data(), static_cast<int>(message.size()));
    if (size < static_cast<int>(sizeof(MessageLabel))) continue;
    MessageLabel label{};
    std::memcpy(&label, message.data(), sizeof label);
    if (++messages[{label.image, label.number}] == label.messages) arrivals.push_back({label, Clock::now() - start});
  }
  return arrivals;
}

/// The proxy on a thread of its own.
class RunningProxy {
 public:
  RunningProxy(const Scenario& scenario, std::uint16_t server) {
    auto proxy = link_proxy::LinkProxy::start(io_, {.listen = {"127.0.0.1", 0},
                                                    .server = {"127.0.0.1", server},
                                                    .down = scenario.down,
                                                    .up = scenario.up,
                                                    .trace = {},
                                                    .seed = scenario.seed});
    demand(proxy.ok(), "the proxy listens on loopback");
    proxy_ = std::move(*proxy);
    thread_ = std::thread([this] { io_.run(); });
  }
  ~RunningProxy() {
    io_.stop();
    thread_.join();
  }
  [[nodiscard]] std::uint16_t port() const { return proxy_->port(); }

 private:
  boost::asio::io_context io_{1};
  std::unique_ptr<link_proxy::LinkProxy> proxy_;
  std::thread thread_;
};

}  // namespace

Outcome run_srt(const Scenario& scenario) {
  const RealTimePriority priority;
  srt_startup();
  srt_setloglevel(0);
  const SRTSOCKET listener = make_socket(scenario);
  const sockaddr_in any = loopback(0);
  demand(srt_bind(listener, plain(any), sizeof any) == 0 && srt_listen(listener, 1) == 0, "SRT listens on loopback");
  const RunningProxy proxy(scenario, port_of(listener));
  const SRTSOCKET client = make_socket(scenario);
  const sockaddr_in address = loopback(proxy.port());
  std::thread connecting([&] { srt_connect(client, plain(address), sizeof address); });
  const SRTSOCKET server = srt_accept(listener, nullptr, nullptr);
  connecting.join();

  CameraFeed feed(scenario);
  std::atomic<bool> stop = false;
  std::vector<Arrival> arrivals;
  const Clock::time_point start = Clock::now();
  std::thread receiving([&] { arrivals = receive_until(client, start, stop); });
  while (!feed.finished(Clock::now() - start)) {
    for (const CameraImage& image : feed.due(Clock::now() - start)) feed.outcome().sent_B += send_image(server, image);
    std::this_thread::sleep_for(1ms);
  }
  stop = true;
  receiving.join();
  for (const Arrival& arrival : arrivals)  // SRT delivers when its latency is over: a scheduler's 5 ms are forgiven
    feed.complete(static_cast<Image>(arrival.label.image), arrival.label.number,
                  from_seconds(arrival.label.number / scenario.frames_hz), arrival.label.image_B, arrival.at - 5ms);
  SRT_TRACEBSTATS stats{};
  if (srt_bstats(server, &stats, 0) == 0) feed.outcome().sent_B = static_cast<double>(stats.byteSentTotal);
  srt_close(client);
  srt_close(server);
  srt_close(listener);
  srt_cleanup();
  return feed.outcome();
}

}  // namespace telepalp::bench::link
