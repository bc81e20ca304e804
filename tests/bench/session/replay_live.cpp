#include "tests/bench/session/replay_live.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <future>
#include <memory>
#include <thread>

#include "tools/link_proxy/link_proxy.h"

namespace telepalp::bench {
namespace {

using boost::asio::ip::udp;
using namespace std::chrono_literals;

constexpr std::size_t kLargestDatagram = 65536;

/// Gives the calling thread real-time priority if the system allows it, so that other programs do not delay it. Without
/// it, a busy computer makes the live run late, and the comparison is one of schedulers.
bool prefer_realtime() noexcept {
  sched_param parameters{};
  parameters.sched_priority = 20;  // below the station's, above ordinary programs
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

/// telepalp-link's proxy on a thread of its own, in front of `server_port`.
class ProxyThread {
 public:
  [[nodiscard]] static Result<std::unique_ptr<ProxyThread>> start(const replay::Scenario& scenario,
                                                                  std::uint16_t server_port) {
    auto running = std::make_unique<ProxyThread>();
    auto proxy = link_proxy::LinkProxy::start(running->io_, {.listen = {"127.0.0.1", 0},
                                                             .server = {"127.0.0.1", server_port},
                                                             .down = scenario.down,
                                                             .up = scenario.up,
                                                             .trace = {},
                                                             .seed = scenario.seed});
    if (!proxy) return proxy.error();
    running->proxy_ = std::move(*proxy);
    running->thread_ = std::thread([raw = running.get()] {
      (void)prefer_realtime();
      raw->io_.run();
    });
    return running;
  }
  ProxyThread() = default;
  ~ProxyThread() {
    io_.stop();
    if (thread_.joinable()) thread_.join();
  }
  ProxyThread(const ProxyThread&) = delete;
  ProxyThread& operator=(const ProxyThread&) = delete;
  [[nodiscard]] std::uint16_t port() const { return proxy_->port(); }

 private:
  boost::asio::io_context io_{1};
  std::unique_ptr<link_proxy::LinkProxy> proxy_;
  std::thread thread_;
};

/// The UDP sockets of the server and of the station.
struct Ends {
  boost::asio::io_context io;
  udp::socket server{io, udp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
  udp::socket station{io, udp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
  udp::endpoint station_at_server;  ///< the proxy's socket for this station
};

class SocketWire final : public replay::Wire {
 public:
  SocketWire(std::shared_ptr<Ends> ends, udp::socket& from, udp::socket& to, udp::endpoint target)
      : ends_(std::move(ends)), from_(from), to_(to), target_(std::move(target)) {}

  void send(Nanoseconds, std::span<const std::byte> datagram) override {
    boost::system::error_code failed;
    from_.send_to(boost::asio::buffer(datagram.data(), datagram.size()), target_, 0, failed);
    ++sent_;
  }
  std::optional<std::vector<std::byte>> receive(Nanoseconds) override {
    std::vector<std::byte> datagram(kLargestDatagram);
    udp::endpoint sender;
    boost::system::error_code failed;
    const std::size_t size = to_.receive_from(boost::asio::buffer(datagram), sender, 0, failed);
    if (failed) return std::nullopt;
    ++received_;
    datagram.resize(size);
    return datagram;
  }
  std::uint64_t lost() const noexcept override { return sent_ - std::min(sent_, received_); }

 private:
  std::shared_ptr<Ends> ends_;  // both wires use both sockets
  udp::socket& from_;
  udp::socket& to_;
  udp::endpoint target_;
  std::uint64_t sent_ = 0;
  std::uint64_t received_ = 0;
};

/// Lets the server learn at which address the proxy answers for the station. The proxy may lose a datagram, so several
/// are sent.
Result<void> introduce(Ends& ends, const udp::endpoint& proxy) {
  ends.server.non_blocking(true);
  ends.station.non_blocking(true);
  for (udp::socket* socket : {&ends.server, &ends.station})
    socket->set_option(boost::asio::socket_base::receive_buffer_size(1 << 22));
  std::array<std::byte, 16> hello{};
  for (int i = 0; i < 100; ++i) {
    boost::system::error_code failed;
    ends.station.send_to(boost::asio::buffer(hello), proxy, 0, failed);
    std::this_thread::sleep_for(20ms);
    ends.server.receive_from(boost::asio::buffer(hello), ends.station_at_server, 0, failed);
    if (failed) continue;
    std::this_thread::sleep_for(500ms);
    while (!failed) ends.server.receive_from(boost::asio::buffer(hello), ends.station_at_server, 0, failed);
    return {};
  }
  return Error{
      .what = "no datagram passed the proxy in 2 s", .where = "telepalp-bench replay", .fix = "allow UDP on loopback"};
}

/// Sleeps until a real time, and keeps the largest lateness.
struct Pace {
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
  Nanoseconds latest{0};
  void await(Nanoseconds since) {
    std::this_thread::sleep_until(began + since);
    latest = std::max(latest, Nanoseconds(std::chrono::steady_clock::now() - began) - since);
  }
};

}  // namespace

Result<LiveComparison> compare_live(const std::string& source, const scenes::Scene& scene,
                                    const replay::Scenario& scenario, double seconds) {
  const replay::RunSettings settings{.scene = scene, .surface = {}, .recorded = nullptr, .seconds = seconds};
  Result<replay::Tape> tape = replay::Tape::open(source, {});
  if (!tape) return tape.error();
  std::vector<replay::TickRecord> unimpaired;
  const Result<replay::RunResults> simulated = run_session(
      *tape, settings,
      {{.scenario = replay::unimpaired(scenario),
        .on_ticks = [&](const auto& ticks) { unimpaired.insert(unimpaired.end(), ticks.begin(), ticks.end()); }},
       {.scenario = scenario}});
  if (!simulated) return simulated.error();
  const auto ends = std::make_shared<Ends>();
  const auto proxy = ProxyThread::start(scenario, ends->server.local_endpoint().port());
  if (!proxy) return proxy.error();
  const udp::endpoint front(boost::asio::ip::address_v4::loopback(), (*proxy)->port());
  if (const Result<void> met = introduce(*ends, front); !met) return met.error();
  Result<replay::Tape> again = replay::Tape::open(source, {});
  if (!again) return again.error();
  std::optional<Pace> pace;
  replay::LiveNetwork network{
      .wires = {.down = std::make_unique<SocketWire>(ends, ends->server, ends->station, ends->station_at_server),
                .up = std::make_unique<SocketWire>(ends, ends->station, ends->server, front)},
      .await = [&](Nanoseconds since) {
        if (!pace) pace.emplace();  // begins after the tape was read
        pace->await(since);
      }};
  bool realtime = false;
  const auto run = [&] {
    realtime = prefer_realtime();
    return run_live(*again, settings, scenario, std::move(network), unimpaired);
  };
  const Result<replay::RunResult> live = std::async(std::launch::async, run).get();  // its thread's priority ends here
  if (!live) return live.error();
  return LiveComparison{simulated->runs.back().figures, live->figures, to_seconds(pace->latest), realtime};
}

}  // namespace telepalp::bench
