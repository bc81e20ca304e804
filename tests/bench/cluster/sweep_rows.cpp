#include "tests/bench/cluster/sweep_rows.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <thread>

#include "support/nats/nats_connection.h"
#include "tests/bench/cluster/nats_cluster.h"
#include "where.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kCells = 64;
constexpr auto kSweepPatience = 540s;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Error failed(const fs::path& log) {
  return {.what = "a sweep or a worker failed", .where = log.string(), .fix = "read the programs' output there"};
}

/// A sweep and its workers, in files of one folder.
class SweepRun {
 public:
  SweepRun(const fs::path& scratch, std::string name, std::string url)
      : folder_(scratch / name), url_(std::move(url)), scratch_(scratch) {
    fs::create_directories(folder_);
  }
  /// Starts a worker, and waits until it is ready.
  bool add_worker() {
    const fs::path log = folder_ / ("worker" + std::to_string(workers_.size()) + ".log");
    workers_.push_back(std::make_unique<support::ChildProcess>(
        TELEPALP_BINARY_DIR "/bin/telepalp-worker",
        std::vector<std::string>{"--connect", url_, "--cache", scratch_ / "cache"}, log));
    for (const auto end = Clock::now() + 20s; Clock::now() < end; std::this_thread::sleep_for(50ms))
      if (bytes_of(log).find("ready: ") != std::string::npos) return true;
    return false;
  }
  support::ChildProcess& worker(std::size_t number) { return *workers_[number]; }

  /// Runs the sweep to its end, and returns how long it took. `meanwhile`: called when a quarter of the cells are
  /// finished. nullopt: the sweep fails.
  std::optional<double> seconds(const std::function<void()>& meanwhile = {}) {
    std::vector<std::string> words{"synthetic:torso,motion=irregular,width=160",
                                   "--seconds",
                                   "4",
                                   "--threads",
                                   "1",
                                   "--sweep",
                                   "delay=0:10:150",
                                   "loss=0,2,5,10%",
                                   "--out",
                                   folder_ / "out"};
    if (!url_.empty()) words.insert(words.end(), {"--workers", url_});
    const Clock::time_point began = Clock::now();
    support::ChildProcess sweep(TELEPALP_BINARY_DIR "/bin/telepalp-replay", words, log());
    if (meanwhile) {
      while (finished() < kCells / 4 && Clock::now() < began + kSweepPatience) std::this_thread::sleep_for(20ms);
      meanwhile();
    }
    if (sweep.wait(kSweepPatience) != 0) return std::nullopt;
    return std::chrono::duration<double>(Clock::now() - began).count();
  }
  [[nodiscard]] fs::path log() const { return folder_ / "sweep.log"; }

  /// Number of result files of `other` that are missing here, or have other bytes here.
  [[nodiscard]] double files_that_differ_from(const SweepRun& other) const {
    double count = 0.0;
    for (const auto& entry : fs::recursive_directory_iterator(other.folder_ / "out")) {
      const fs::path own = folder_ / "out" / fs::relative(entry.path(), other.folder_ / "out");
      if (entry.is_regular_file() && bytes_of(own) != bytes_of(entry.path())) count += 1.0;
    }
    return count;
  }

 private:
  [[nodiscard]] std::size_t finished() const {
    std::error_code none_yet;
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& cell : fs::directory_iterator(folder_ / "out" / "cells", none_yet)) ++count;
    return count;
  }

  fs::path folder_;
  std::string url_;  // empty: without workers
  fs::path scratch_;
  std::vector<std::unique_ptr<support::ChildProcess>> workers_;
};

/// Number of deliveries of orders to workers since the cluster started; nullopt: the cluster does not tell it.
std::optional<double> deliveries(const std::string& url) {
  const auto nats = nats::NatsConnection::open({.address = {.url = url}, .name = "bench"});
  if (!nats) return std::nullopt;
  const auto names = (*nats)->ask("$JS.API.CONSUMER.NAMES.TELEPALP_ORDERS", "", 5s);
  std::smatch found;
  if (!names || !std::regex_search(*names, found, std::regex("workers-[0-9a-f]+"))) return std::nullopt;
  const auto facts = (*nats)->ask("$JS.API.CONSUMER.INFO.TELEPALP_ORDERS." + found.str(), "", 5s);
  const std::regex delivered(R"re("delivered":\{"consumer_seq":([0-9]+))re");
  if (!facts || !std::regex_search(*facts, found, delivered)) return std::nullopt;
  return std::stod(found[1]);
}

/// A cluster of its own for each run, so that no run finds another one's results.
struct Clustered {
  NatsCluster cluster;
  SweepRun run;
};
Result<Clustered> with_workers(const fs::path& scratch, const std::string& name, int workers) {
  fs::create_directories(scratch / (name + "-nats"));
  Result<NatsCluster> cluster = NatsCluster::start(1, scratch / (name + "-nats"), NatsCluster::Stores::Files);
  if (!cluster) return cluster.error();
  const std::string url = cluster->url(0);
  Clustered made{*std::move(cluster), SweepRun(scratch, name, url)};
  for (int i = 0; i < workers; ++i)
    if (!made.run.add_worker()) return failed(scratch / name);
  return made;
}

}  // namespace

Result<void> add_sweep_rows(const fs::path& scratch, std::vector<Row>& rows) {
  SweepRun alone(scratch, "alone", "");
  const std::optional<double> alone_s = alone.seconds();
  if (!alone_s) return failed(alone.log());
  std::vector<double> seconds;
  double differ = 0.0;
  for (const int workers : {1, 2}) {
    Result<Clustered> shared = with_workers(scratch, "workers" + std::to_string(workers), workers);
    if (!shared) return shared.error();
    const std::optional<double> took_s = shared->run.seconds();
    if (!took_s) return failed(shared->run.log());
    seconds.push_back(*took_s);
    differ += shared->run.files_that_differ_from(alone);
  }
  Result<Clustered> killed = with_workers(scratch, "killed", 2);
  if (!killed) return killed.error();
  const auto took_s = killed->run.seconds([&] { killed->run.worker(0).signal(SIGKILL); });
  const std::optional<double> delivered = deliveries(killed->cluster.url(0));
  if (!took_s || !delivered) return failed(killed->run.log());
  differ += killed->run.files_that_differ_from(alone);
  rows.push_back(at_least("sweep of 64 runs: speed of 2 workers / of 1", seconds[0] / seconds[1], "x", 1.8));
  rows.push_back(
      at_most("sweep: result files by 1, 2, and 2 workers of which one is killed, that differ from those "
              "without workers",
              differ, "", 0.0));
  rows.push_back(at_most("sweep, 1 of 2 workers killed: runs begun more than once", *delivered - kCells, "", 1.0));
  rows.push_back(measured("sweep: by 1 worker", seconds[0], "s"));
  rows.push_back(measured("sweep: by telepalp-replay alone, one thread", *alone_s, "s"));
  rows.push_back(measured("sweep, 1 of 2 workers killed", *took_s, "s"));
  return {};
}

}  // namespace telepalp::bench
