#include "tools/replay/workers/sweep_cluster.h"

#include <utility>

#include "support/program/log.h"
#include "support/program/version.h"
#include "tools/replay/workers/sweep_subjects.h"

namespace telepalp::replay {
namespace {

constexpr auto kLongestKept = std::chrono::hours(24 * 7);

Result<void> make_streams(nats::Streams& streams) {
  const Result<void> orders = streams.keep(
      {.name = kOrders, .subjects = {kOrderSubjects}, .is_work_queue = true, .longest_kept = kLongestKept});
  if (!orders) return orders;
  return streams.keep({.name = kSweeps,
                       .subjects = {kAnswerSubjects, kSourceSubjects},
                       .is_work_queue = false,
                       .longest_kept = kLongestKept});
}

}  // namespace

std::string this_build() { return program::software("telepalp"); }

Result<SweepCluster> SweepCluster::join(const nats::Address& address, std::string_view program_name,
                                        const std::string& client, std::function<void()> on_return) {
  auto on_change = [name = std::string(program_name), on_return = std::move(on_return)](bool is_connected) {
    program::log(name, is_connected ? "connected to the cluster again"
                                    : "the connection to the cluster is lost; trying to connect again");
    if (is_connected && on_return) on_return();
  };
  auto connection = nats::NatsConnection::open({.address = address, .name = client, .on_change = std::move(on_change)});
  if (!connection) return connection.error();
  auto streams = nats::Streams::open(**connection);
  if (!streams) return streams.error();
  if (const Result<void> made = make_streams(**streams); !made) return made.error();
  return SweepCluster{.connection = *std::move(connection), .streams = *std::move(streams)};
}

}  // namespace telepalp::replay
