#include "tests/bench/cluster/nodes/node_rows.h"

#include <array>
#include <chrono>
#include <csignal>
#include <string>

#include "tests/bench/cluster/nats_cluster.h"
#include "tests/bench/cluster/nodes/partition_rows.h"
#include "tests/bench/cluster/nodes/station_watch.h"
#include "tests/bench/cluster/running_server.h"
#include "tests/bench/cluster/watching.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = Watched::Clock;

constexpr std::size_t kNodes = 3;
constexpr std::size_t kOfSite = 0;
constexpr std::size_t kOfEdge = kNodes - 1;
constexpr auto kFrozen = 5s;
constexpr auto kAfter = 6s;

struct Loss {
  const char* name;
  std::size_t node;
  bool is_killed;  ///< else it is frozen for kFrozen
};
constexpr std::array kLosses{Loss{"the edge's node killed: ", kOfEdge, true},
                             Loss{"the site's node killed: ", kOfSite, true},
                             Loss{"the edge's node frozen for 5 s: ", kOfEdge, false}};

Result<void> add_loss(const fs::path& scratch, const Loss& loss, std::vector<Row>& rows) {
  Result<NatsCluster> cluster = NatsCluster::start(kNodes, scratch);
  if (!cluster) return cluster.error();
  const Result<ServerPair> pair = start_pair(scratch, cluster->urls_from(kOfSite), cluster->urls_from(kOfEdge));
  if (!pair) return pair.error();
  Viewers viewers;
  const Watched& at_site = viewers.add(pair->site.port);
  const Watched& at_edge = viewers.add(pair->edge.port);
  if (!viewers.all_see()) return sees_nothing();
  const auto station = StationWatch::start(viewers.io(), "127.0.0.1", pair->site.port, scratch, "station");
  if (!station) return station.error();
  const auto lasts = loss.is_killed ? Clock::duration(kAfter) : Clock::duration(kFrozen + kAfter);
  viewers.run_for(2s);
  const StationWatch::Moment began = (*station)->moment();
  viewers.run_for(lasts);
  const StationWatch::Moment lost_at = (*station)->moment();
  const std::size_t site_before = at_site.arrived.size();
  const std::uint64_t first = at_site.arrived.rbegin()->first;
  const Clock::time_point lost = Clock::now();
  cluster->node(loss.node).signal(loss.is_killed ? SIGKILL : SIGSTOP);
  Clock::time_point healed = lost;
  if (!loss.is_killed) {
    viewers.run_for(kFrozen);
    healed = Clock::now();
    cluster->node(loss.node).signal(SIGCONT);
  }
  viewers.run_for(kAfter);
  const std::string what = loss.name;
  rows.push_back(at_most(what + "longest gap at the edge's viewer" + (loss.is_killed ? "" : " after it goes on"),
                         at_edge.longest_gap_s(healed, Clock::now()), "s", loss.is_killed ? 2.0 : 1.0));
  const std::uint64_t numbers = at_site.arrived.rbegin()->first - first;
  rows.push_back(at_most(what + "images that a viewer of the site missed meanwhile",
                         static_cast<double>(numbers) - static_cast<double>(at_site.arrived.size() - site_before), "",
                         0.0));
  add_station_rows(what, (*station)->between(began, lost_at), (*station)->since(lost_at), rows);
  return {};
}

}  // namespace

Result<void> add_node_rows(const fs::path& scratch, std::vector<Row>& rows) {
  for (const Loss& loss : kLosses)
    if (Result<void> done = add_loss(scratch, loss, rows); !done) return done;
  return add_partition_rows(scratch, rows);
}

}  // namespace telepalp::bench
