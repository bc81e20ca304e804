#include "tests/bench/cluster/cluster_bench.h"

#include <filesystem>
#include <functional>
#include <thread>
#include <utility>

#include "server/hub/hub.h"
#include "server/relay/publisher.h"
#include "support/nats/nats_connection.h"
#include "tests/bench/choice.h"
#include "tests/bench/cluster/model_rows.h"
#include "tests/bench/cluster/nats_cluster.h"
#include "tests/bench/cluster/nodes/node_rows.h"
#include "tests/bench/cluster/running_server.h"
#include "tests/bench/cluster/session_rows.h"
#include "tests/bench/cluster/soak_rows.h"
#include "tests/bench/cluster/sweep_rows.h"
#include "tests/bench/cluster/watching.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/process_load.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = Watched::Clock;

constexpr std::size_t kViewers = 20;

/// Adds rows of how much later each image arrives at the edge's viewer than at the site's.
void add_delay(const Watched& at_site, const Watched& at_edge, Clock::time_point from, std::vector<Row>& rows) {
  Distribution added_ms;
  std::size_t lost = 0;
  for (const auto& [number, time] : at_site.arrived) {
    if (time < from || time > Clock::now() - 1s) continue;
    const auto other = at_edge.arrived.find(number);
    if (other == at_edge.arrived.end())
      ++lost;
    else
      added_ms.add(std::chrono::duration<double, std::milli>(other->second - time).count());
  }
  rows.push_back(
      at_most("relay: added, image at the server's viewer -> at the edge's, p50", added_ms.p50(), "ms", 2.0));
  rows.push_back(at_most("relay: the same, p99", added_ms.p99(), "ms", 8.0));
  rows.push_back(measured("relay: images compared", static_cast<double>(added_ms.count()), ""));
  rows.push_back(measured("relay: images that the edge's viewer never had", static_cast<double>(lost), ""));
}

/// Bytes that a server sends for each second of processor time, with kViewers viewers [MB].
Result<double> sent_MB_per_cpu_s(const RunningServer& server, double seconds) {
  Viewers viewers;
  viewers.add(server.port, kViewers);
  if (!viewers.all_see()) return sees_nothing();
  const std::uint64_t bytes = viewers.bytes();
  const double before_s = cpu_s(server.process->pid());
  viewers.run_for(std::chrono::duration<double>(seconds));
  return 1e-6 * static_cast<double>(viewers.bytes() - bytes) / (cpu_s(server.process->pid()) - before_s);
}

constexpr std::size_t kMessages = 2000;
constexpr std::size_t kMessage_B = 90'000;  // a depth image of the synthetic patient

/// Calls `publish` kMessages times, `pause` apart. Returns the processor time of all threads until `is_done`, less that
/// of the pauses themselves [us].
double cpu_us(Clock::duration pause, const std::function<void()>& publish, const std::function<bool()>& is_done) {
  const auto run = [&](const std::function<void()>& each, const std::function<bool()>& done) {
    const double before_us = process_us();
    const Clock::time_point begin = Clock::now();
    for (std::size_t i = 0; i < kMessages; ++i) {
      if (pause > 0ms) std::this_thread::sleep_until(begin + i * pause);
      each();
    }
    while (!done()) std::this_thread::sleep_for(500us);
    return process_us() - before_us;
  };
  const double pauses_us = run([] {}, [] { return true; });
  return run(publish, is_done) - pauses_us;
}

/// Processor time of a bare NATS client that publishes kMessages payloads [us].
Result<double> bare_publisher_cpu_us(const std::string& url, Clock::duration pause) {
  auto nats = nats::NatsConnection::open({.address = {.url = url}, .name = "bare"});
  if (!nats) return nats.error();
  const std::string payload(kMessage_B, 'x');
  return cpu_us(
      pause, [&] { (*nats)->publish("telepalp.bare.camera.depth", payload); }, [] { return true; });
}

/// Processor time of the same messages through a hub and telepalp's own publisher [us].
Result<double> publisher_cpu_us(const std::string& url, Clock::duration pause) {
  boost::asio::io_context io(1);
  hub::Hub hub;
  auto publisher = relay::Publisher::open(io, hub, wire::SessionClock::anchored_to_wall_clock(),
                                          {.address = {.cluster = {.url = url}, .site = "cost"}});
  if (!publisher) return publisher.error();
  const auto payload = std::make_shared<const std::string>(kMessage_B, 'x');
  constexpr std::uint64_t kInFlight = 16;  // less than the publisher takes, so that the hub drops none
  const auto done = [&] { return (*publisher)->counts().published + (*publisher)->counts().lost; };
  std::uint64_t given = 0;
  const auto publish = [&] {
    while (done() + kInFlight < given) std::this_thread::sleep_for(500us);
    hub.publish({wire::kCameraDepth, SessionTime{}, payload, 0, true});
    ++given;
  };
  const double used_us = cpu_us(pause, publish, [&] { return done() >= given; });
  if ((*publisher)->counts().lost > 0)
    return Error{.what = "the publisher lost messages, so its processor time is not that of all",
                 .where = "telepalp-bench cluster",
                 .fix = "run the bench again on a machine with less other load"};
  return used_us;
}

struct PublishCost {
  Distribution ratio;  ///< to a bare publisher
  Distribution us;     ///< of a message
};

Result<PublishCost> publish_cost(const NatsCluster& cluster, Clock::duration pause) {
  PublishCost cost;
  for (int pair = 0; pair < 5; ++pair) {
    const Result<double> bare = bare_publisher_cpu_us(cluster.url(0), pause);
    if (!bare) return bare.error();
    const Result<double> ours = publisher_cpu_us(cluster.url(0), pause);
    if (!ours) return ours.error();
    cost.ratio.add(*ours / *bare);
    cost.us.add(*ours / static_cast<double>(kMessages));
  }
  return cost;
}

Result<void> add_publish_cost(const NatsCluster& cluster, std::vector<Row>& rows) {
  const Result<PublishCost> paced = publish_cost(cluster, 1ms);
  if (!paced) return paced.error();
  const Result<PublishCost> at_once = publish_cost(cluster, 0ms);
  if (!at_once) return at_once.error();
  rows.push_back(
      at_most("publishing one message each ms: processor time / a bare NATS publisher's of the same bytes, "
              "median of 5 pairs",
              paced->ratio.p50(), "x", 1.2));
  rows.push_back(
      measured("publishing one message each ms: processor time of an image of 90 kB", paced->us.p50(), "us"));
  rows.push_back(
      measured("publishing without a pause: processor time / a bare NATS publisher's", at_once->ratio.p50(), "x"));
  rows.push_back(measured("publishing without a pause: processor time of an image of 90 kB", at_once->us.p50(), "us"));
  return {};
}

Result<void> add_steady_rows(const fs::path& scratch, double seconds, std::vector<Row>& rows) {
  const Result<NatsCluster> cluster = NatsCluster::start(1, scratch);
  if (!cluster) return cluster.error();
  const Result<ServerPair> pair = start_pair(scratch, cluster->url(0), cluster->url(0));
  if (!pair) return pair.error();
  {
    Viewers viewers;
    const Watched& at_site = viewers.add(pair->site.port);
    const Watched& at_edge = viewers.add(pair->edge.port);
    if (!viewers.all_see()) return sees_nothing();
    const Clock::time_point from = Clock::now() + 1s;
    viewers.run_for(std::chrono::duration<double>(seconds + 2.0));
    add_delay(at_site, at_edge, from, rows);
  }
  const Result<RunningServer> alone = start_server(scratch, "alone", {"--source", "synthetic"});
  if (!alone) return alone.error();
  const Result<double> direct = sent_MB_per_cpu_s(*alone, seconds);
  if (!direct) return direct.error();
  const Result<double> edge = sent_MB_per_cpu_s(pair->edge, seconds);
  if (!edge) return edge.error();
  rows.push_back(at_least("edge: bytes sent for each second of processor time / the direct server's, 20 viewers each",
                          *edge / *direct, "x", 0.8));
  rows.push_back(measured("edge: sent for each second of processor time", *edge, "MB"));
  return add_publish_cost(*cluster, rows);
}

Result<void> add_nodes(const fs::path& scratch, double, std::vector<Row>& rows) { return add_node_rows(scratch, rows); }

Result<void> add_sweeps(const fs::path& scratch, double, std::vector<Row>& rows) {
  return add_sweep_rows(scratch, rows);
}

struct Section {
  std::string_view name;
  Result<void> (*add)(const fs::path& scratch, double seconds, std::vector<Row>& rows);
};

}  // namespace

Result<Report> run_cluster(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 2.0, 7200.0);
  if (!seconds) return seconds.error();
  const std::vector<Section> all{{"relay", add_steady_rows}, {"nodes", add_nodes},    {"sessions", add_session_rows},
                                 {"model", add_model_rows},  {"soak", add_soak_rows}, {"sweep", add_sweeps}};
  const Result<std::vector<Section>> chosen = chosen_sections(all, arguments, "cluster");
  if (!chosen) return chosen.error();
  const support::TemporaryFolder scratch;
  Report report{.bench = "cluster", .rows = {}, .notes = {"real nats-server and programs, on loopback"}};
  for (const Section& section : *chosen)
    if (const Result<void> done = section.add(scratch.path(), *seconds, report.rows); !done) return done.error();
  return report;
}

}  // namespace telepalp::bench
