#include "tests/bench/cluster/session_rows.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <string>
#include <thread>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/reader.h"
#include "support/session_store/session_place.h"
#include "tests/bench/cluster/nats_cluster.h"
#include "tests/bench/cluster/running_server.h"
#include "where.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::size_t kClusterNodes = 3;
constexpr double kLeastSession_s = 8.0;
constexpr auto kEndsWithin = 60s;
constexpr const char* kRecorder = TELEPALP_BINARY_DIR "/bin/telepalp-record";

/// What a recording holds, and what it lacks between its first and its last message of each topic.
struct Kept {
  std::uint64_t messages = 0;
  std::uint64_t missing = 0;
};

Result<Kept> kept_in(const std::string& session) {
  Result<wire::McapReader> reader = wire::McapReader::open(session);
  if (!reader) return reader.error();
  struct Numbers {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    std::uint64_t count = 0;
  };
  std::map<std::string_view, Numbers> topics;
  Kept kept;
  while (true) {
    const auto message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    Numbers& numbers = topics[(*message)->topic.name];
    if (numbers.count++ == 0) numbers.first = (*message)->sequence;
    numbers.last = std::max(numbers.last, (*message)->sequence);
    ++kept.messages;
  }
  for (const auto& [topic, numbers] : topics) kept.missing += numbers.last - numbers.first + 1 - numbers.count;
  return kept;
}

Error failed(const std::string& what, const fs::path& log) {
  return {.what = what, .where = log.string(), .fix = "read this file"};
}

/// Records for `seconds`; after a third of the time, node `killed` is killed.
Result<Kept> record_through_a_kill(const fs::path& scratch, std::size_t killed, double seconds) {
  const fs::path folder = scratch / ("kill" + std::to_string(killed));
  fs::create_directory(folder);
  Result<NatsCluster> cluster = NatsCluster::start(kClusterNodes, folder, NatsCluster::Stores::Files);
  if (!cluster) return cluster.error();
  const Result<RunningServer> site = start_server(folder, "site", {"--source", "synthetic"});
  if (!site) return site.error();
  const std::string session = cluster->urls_from(0) + "/bench/session.mcap";
  support::ChildProcess recorder(
      kRecorder,
      {"--connect", "127.0.0.1:" + std::to_string(site->port), "--out", session, "--keep-days", "1", "--consent",
       "a synthetic patient", "--seconds", std::to_string(seconds)},
      folder / "record.log");
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds / 3.0));
  cluster->node(killed).signal(SIGKILL);
  if (recorder.wait(std::chrono::seconds(static_cast<int>(seconds)) + kEndsWithin) != 0)
    return failed("the recording failed", folder / "record.log");
  // Read from the nodes that are left, as one that looks for the session later.
  return kept_in(cluster->urls_from((killed + 1) % kClusterNodes) + "/bench/session.mcap");
}

std::string bytes_of_session(const std::string& session) {
  const auto source = wire::mcap::open_session(session);
  std::string all;
  if (!source || !(*source)->read(0, static_cast<std::size_t>((*source)->size()), all)) all.clear();
  return all;
}

Result<void> add_copies(const fs::path& scratch, double seconds, std::vector<Row>& rows) {
  const Result<NatsCluster> cluster = NatsCluster::start(1, scratch, NatsCluster::Stores::Files);
  if (!cluster) return cluster.error();
  const Result<RunningServer> site = start_server(scratch, "copied", {"--source", "synthetic"});
  if (!site) return site.error();
  const fs::path log = scratch / "copy.log";
  const auto run = [&](const std::vector<std::string>& words) {
    return support::ChildProcess(kRecorder, words, log).wait(std::chrono::seconds(static_cast<int>(seconds)) + 60s) ==
           0;
  };
  const std::string file = scratch / "a.mcap", back = scratch / "b.mcap";
  const std::string stored = cluster->url(0) + "/bench/a.mcap";
  if (!run({"--connect", "127.0.0.1:" + std::to_string(site->port), "--out", file, "--consent", "a synthetic patient",
            "--seconds", std::to_string(seconds)}) ||
      !run({"copy", file, "--keep-days", "1", "--out", stored}) || !run({"copy", stored, "--out", back}))
    return failed("a copy failed", log);
  const std::string one = bytes_of_session(file), other = bytes_of_session(back);
  const auto differs = [&] {
    std::size_t count = std::max(one.size(), other.size()) - std::min(one.size(), other.size());
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) count += one[i] != other[i] ? 1 : 0;
    return static_cast<double>(count);
  };
  rows.push_back(at_most("session copied to the cluster and back: bytes that differ", differs(), "", 0.0));
  rows.push_back(
      measured("session copied to the cluster and back: size", static_cast<double>(one.size()) * 1e-6, "MB"));
  return {};
}

}  // namespace

Result<void> add_session_rows(const fs::path& scratch, double seconds, std::vector<Row>& rows) {
  session_store::use_cluster_sessions();
  std::uint64_t messages = 0, missing = 0;
  for (std::size_t killed = 0; killed < kClusterNodes; ++killed) {
    const Result<Kept> kept = record_through_a_kill(scratch, killed, std::max(seconds, kLeastSession_s));
    if (!kept) return kept.error();
    messages += kept->messages;
    missing += kept->missing;
  }
  rows.push_back(at_most("session recorded in a cluster, each of three nodes killed in turn: messages lost",
                         static_cast<double>(missing), "", 0.0));
  rows.push_back(measured("session recorded in a cluster: messages", static_cast<double>(messages), ""));
  return add_copies(scratch, std::max(seconds, kLeastSession_s), rows);
}

}  // namespace telepalp::bench
