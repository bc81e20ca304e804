#include "tests/bench/cluster/nodes/partition_rows.h"

#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include "tests/bench/cluster/nats_cluster.h"
#include "tests/bench/cluster/nodes/station_watch.h"
#include "tests/bench/cluster/running_server.h"
#include "tests/bench/cluster/watching.h"
#include "tests/bench/site/two_networks.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = Watched::Clock;
using Side = TwoNetworks::Side;

constexpr SiteLine kWide{.Mbit_per_s = 2000.0, .buffer_ms = 30.0};
constexpr int kOfCluster = 3;
constexpr int kAlone = 2;  // the node that is cut off
constexpr auto kCutOff = 5s;
constexpr auto kWatchedAfter = 6s;

Side side_of(int node) { return node == kAlone ? Side::Doctor : Side::Patient; }
std::string host_of(int node) { return node == kAlone ? TwoNetworks::kDoctor : TwoNetworks::kPatient; }
std::string url_of(int node) { return "nats://" + host_of(node) + ":" + std::to_string(4222 + node); }

struct Seen {
  double gap_while_s = 0.0;
  double gap_after_s = 0.0;
  double missed_at_site = 0.0;
  StationWatch::Facts station_before, station_meanwhile;
};

Result<std::vector<std::unique_ptr<support::ChildProcess>>> start_nodes(const TwoNetworks& networks,
                                                                        const fs::path& scratch) {
  const auto route_of = [](int node) { return "nats://" + host_of(node) + ":" + std::to_string(6222 + node); };
  std::vector<std::unique_ptr<support::ChildProcess>> nodes;
  for (int node = 0; node < kOfCluster; ++node) {
    const fs::path log = scratch / ("part" + std::to_string(node) + ".log");
    nodes.push_back(
        networks.start(side_of(node), "/usr/sbin/nats-server",
                       {"-a", host_of(node), "-p", std::to_string(4222 + node), "--cluster_name", "bench", "--cluster",
                        route_of(node), "--routes", route_of(0) + "," + route_of(1) + "," + route_of(2)},
                       log));
    if (!nats_is_ready(log, 20s))
      return Error{.what = "nats-server does not start", .where = log.string(), .fix = "read this file"};
  }
  std::this_thread::sleep_for(1s);  // until the nodes have found each other
  return nodes;
}

/// On a thread of the patient's network, where all but the third node are.
Result<Seen> watch(const TwoNetworks& networks, const fs::path& scratch) {
  const auto nodes = start_nodes(networks, scratch);
  if (!nodes) return nodes.error();
  const Result<RunningServer> site = start_server(
      scratch, "part_site", {"--source", "synthetic", "--publish", url_of(0) + "," + url_of(1) + "/bench"});
  if (!site) return site.error();
  const Result<RunningServer> edge =
      start_server(scratch, "part_edge", {"--source", url_of(kAlone) + "," + url_of(1) + "/bench"});
  if (!edge) return edge.error();
  Viewers viewers;
  const Watched& at_site = viewers.add(site->port);
  const Watched& at_edge = viewers.add(edge->port);
  if (!viewers.all_see()) return sees_nothing();
  const auto station = StationWatch::start(viewers.io(), "127.0.0.1", site->port, scratch, "part_station");
  if (!station) return station.error();
  viewers.run_for(2s);
  const StationWatch::Moment began = (*station)->moment();
  viewers.run_for(kCutOff + kWatchedAfter);
  const StationWatch::Moment cut_at = (*station)->moment();
  const std::size_t before = at_site.arrived.size();
  const std::uint64_t first = at_site.arrived.rbegin()->first;
  const Clock::time_point cut = Clock::now();
  if (Result<void> done = networks.set_joined(false); !done) return done.error();
  viewers.run_for(kCutOff);
  if (Result<void> done = networks.set_joined(true); !done) return done.error();
  const Clock::time_point healed = Clock::now();
  viewers.run_for(kWatchedAfter);
  const double numbers = static_cast<double>(at_site.arrived.rbegin()->first - first);
  return Seen{.gap_while_s = at_edge.longest_gap_s(cut, healed),
              .gap_after_s = at_edge.longest_gap_s(healed, Clock::now()),
              .missed_at_site = numbers - static_cast<double>(at_site.arrived.size() - before),
              .station_before = (*station)->between(began, cut_at),
              .station_meanwhile = (*station)->since(cut_at)};
}

}  // namespace

Result<void> add_partition_rows(const fs::path& scratch, std::vector<Row>& rows) {
  const auto networks = TwoNetworks::make(kWide);
  if (!networks) return networks.error();
  std::optional<Result<Seen>> seen;
  (*networks)->run(Side::Patient, [&](const std::stop_token&) { seen.emplace(watch(**networks, scratch)); }).join();
  if (!*seen) return seen->error();
  const std::string what = "node cut off for 5 s: ";
  rows.push_back(at_most(what + "longest gap at the edge's viewer after it heals", (*seen)->gap_after_s, "s", 1.0));
  rows.push_back(measured(what + "longest gap at the edge's viewer meanwhile", (*seen)->gap_while_s, "s"));
  rows.push_back(at_most(what + "images that a viewer of the site missed meanwhile", (*seen)->missed_at_site, "", 0.0));
  add_station_rows(what, (*seen)->station_before, (*seen)->station_meanwhile, rows);
  return {};
}

}  // namespace telepalp::bench
