#include "tools/replay/workers/worker.h"

#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "proto/words/repeated_errors.h"
#include "support/nats/work_queue.h"
#include "support/program/log.h"
#include "support/program/version.h"
#include "tools/replay/commands/request.h"
#include "tools/replay/workers/cell_answer.h"
#include "tools/replay/workers/cell_maker.h"
#include "tools/replay/workers/recordings.h"
#include "tools/replay/workers/sweep_subjects.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kProgram = "telepalp-worker";
constexpr auto kKept = std::chrono::hours(24 * 7);
constexpr auto kTakesWithin = 500ms;
constexpr auto kHereEvery = 2s;
constexpr auto kAgainAfter = 1s;  // times the deliveries: a cell that fails does not keep a queue busy
constexpr int kMostStoreTries = 5;

void log(const std::string& text) { program::log(kProgram, text); }

/// Names the builds of sweeps that this worker cannot serve, each once. Owner: the library's thread.
class OtherBuilds {
 public:
  void hear(std::string_view bytes) {
    constexpr std::size_t kMostBuilds = 100;
    const Result<Presence> sweep = parse_presence(bytes);
    if (!sweep || sweep->build == this_build() || builds_.size() >= kMostBuilds) return;
    if (builds_.insert(sweep->build).second)
      log("a sweep of another version waits for workers: " + sweep->build + ". This worker is " + this_build() +
          ", and makes none of its runs. fix: install the same version on both computers");
  }

 private:
  std::set<std::string> builds_;
};

/// Says that the worker is there. A thread of its own, because the worker's computes for long.
class Herald {
 public:
  Herald(nats::NatsConnection& connection, std::string name)
      : connection_(connection), name_(std::move(name)), thread_([this] { tell(); }) {}
  ~Herald() {
    {
      const std::scoped_lock lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  Herald(const Herald&) = delete;
  Herald& operator=(const Herald&) = delete;
  void finished(std::uint64_t cells) { finished_ = cells; }

 private:
  void tell() {
    std::unique_lock lock(mutex_);
    do
      connection_.publish(kWorkerIsHere, encode(Presence{.name = name_, .build = this_build(), .finished = finished_}));
    while (!changed_.wait_for(lock, kHereEvery, [this] { return ends_; }));
  }

  nats::NatsConnection& connection_;
  std::string name_;
  std::atomic<std::uint64_t> finished_{0};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ends_ = false;   // guarded by mutex_
  std::thread thread_;  // last: it uses the other members
};

class Worker {
 public:
  Worker(const WorkerOptions& options, nats::Streams& streams, const std::atomic<bool>& stop)
      : options_(options),
        streams_(streams),
        stop_(stop),
        maker_(options.cache, options.memory_B),
        cache_(options.cache, options.cache_B) {}

  void work(nats::WorkItem item);
  [[nodiscard]] const WorkerCounts& counts() const noexcept { return counts_; }

 private:
  [[nodiscard]] Result<std::string> report_of(const CellOrder& order);
  [[nodiscard]] Result<CellOrder> order_in(const nats::WorkItem& item, const std::optional<CellPlace>& place) const;
  [[nodiscard]] Result<void> answer(const CellPlace& place, CellAnswer answer);
  void finish(nats::WorkItem& item, const CellPlace& place, std::string report);
  void give_back(nats::WorkItem& item, const std::string& why, std::chrono::milliseconds after);
  void refuse(nats::WorkItem& item, const std::optional<CellPlace>& place, const std::string& why);

  const WorkerOptions& options_;
  nats::Streams& streams_;
  const std::atomic<bool>& stop_;
  const OrderRules rules_{.build = this_build(), .options = names_of_run_options()};
  CellMaker maker_;
  RecordingCache cache_;
  WorkerCounts counts_;
};

Result<CellOrder> Worker::order_in(const nats::WorkItem& item, const std::optional<CellPlace>& place) const {
  const Error elsewhere{.what = "its subject names another cell than its content",
                        .where = program::escaped(std::string(item.subject().substr(0, 160))),
                        .fix = "let only telepalp-replay publish on the subjects telepalp-sweep.cell.>"};
  if (!place) return elsewhere;
  Result<CellOrder> order = parse_order(item.payload(), rules_);
  if (order && (order->sweep != place->sweep || order->cell != place->cell)) return elsewhere;
  return order;
}

Result<std::string> Worker::report_of(const CellOrder& order) {
  std::string source = order.source;
  if (order.recording) {
    const Result<std::filesystem::path> file = cache_.fetch(streams_, *order.recording, stop_);
    if (!file) return file.error();
    source = file->string();
  }
  return maker_.make(order, source, stop_);
}

/// Waits while the cluster cannot be reached: what took minutes to compute is not thrown away at once.
Result<void> Worker::answer(const CellPlace& place, CellAnswer answer) {
  answer.build = this_build();
  answer.cell = place.cell;
  answer.worker = options_.name;
  Result<void> stored;
  for (int i = 0; i < kMostStoreTries; ++i) {
    if (i > 0) std::this_thread::sleep_for(1s);
    stored = streams_.store(answer_subject(place.sweep, place.cell), encode(answer));
    if (stored || stop_) return stored;
  }
  return stored;
}

void Worker::finish(nats::WorkItem& item, const CellPlace& place, std::string report) {
  const Result<void> stored = answer(place, {.report = std::move(report)});
  if (!stored) return give_back(item, "the cluster does not take its result: " + to_string(stored.error()), 10s);
  item.finished();
  ++counts_.finished;
}

void Worker::give_back(nats::WorkItem& item, const std::string& why, std::chrono::milliseconds after) {
  ++counts_.given_back;
  const bool told = item.give_back(after);
  log("a run is given back to other workers: " + why +
      (told ? "" : ". The cluster is not reached, and delivers it again after 10 s"));
}

void Worker::refuse(nats::WorkItem& item, const std::optional<CellPlace>& place, const std::string& why) {
  ++counts_.refused;
  log("a run is removed from the queue, because it was delivered " + std::to_string(item.deliveries()) +
      " times: " + why);
  if (place)
    if (const Result<void> stored = answer(*place, {.refused = why}); !stored)
      return give_back(item, "the cluster does not take the refusal: " + to_string(stored.error()), 10s);
  item.remove_as_bad();
}

void Worker::work(nats::WorkItem item) {
  const std::optional<CellPlace> place = place_of(item.subject());
  if (item.deliveries() > kMostDeliveries)
    return refuse(item, place,
                  "no worker has finished it. It was lost with its worker each time: the worker crashed, was killed or "
                  "had no memory left. fix: run this cell alone with telepalp-replay");
  const Result<CellOrder> order = order_in(item, place);
  const Result<std::string> report = order ? report_of(*order) : order.error();
  if (report) return finish(item, *place, *report);
  if (stop_) return give_back(item, "this worker was asked to end", 0ms);
  if (item.deliveries() >= kMostDeliveries) return refuse(item, place, to_string(report.error()));
  give_back(item, to_string(report.error()), kAgainAfter * static_cast<int>(item.deliveries()));
}

void say_changes(bool is_connected) {
  log(is_connected ? "connected to the cluster again"
                   : "the connection to the cluster is lost; trying to connect again");
}

/// Takes cells until it is stopped, or idle for too long.
void take_cells(nats::WorkQueue& queue, Worker& worker, Herald& herald, const WorkerOptions& options,
                const std::atomic<bool>& stop) {
  RepeatedErrors errors;
  Clock::time_point worked = Clock::now();
  while (!stop && (options.idle.count() <= 0.0 || Clock::now() - worked < options.idle)) {
    Result<std::optional<nats::WorkItem>> item = queue.take(kTakesWithin);
    if (!item) {
      if (const auto line = errors.line("the queue cannot be read", item.error(), Clock::now())) log(*line);
      std::this_thread::sleep_for(kTakesWithin);
    } else if (*item) {
      worker.work(std::move(**item));
      herald.finished(worker.counts().finished);
      worked = Clock::now();
    }
  }
}

}  // namespace

std::string this_build() { return program::software("telepalp"); }

Result<void> keep_streams(nats::Streams& streams) {
  const Result<void> orders =
      streams.keep({.name = kOrders, .subjects = {kOrderSubjects}, .is_work_queue = true, .longest_kept = kKept});
  if (!orders) return orders;
  return streams.keep(
      {.name = kSweeps, .subjects = {kAnswerSubjects, kSourceSubjects}, .is_work_queue = false, .longest_kept = kKept});
}

Result<WorkerCounts> run_worker(const WorkerOptions& options, const std::atomic<bool>& stop) {
  OtherBuilds others;  // outlives the connection, whose thread calls it
  auto connection = nats::NatsConnection::open(
      {.address = options.cluster, .name = std::string(kProgram) + " " + options.name, .on_change = say_changes});
  if (!connection) return connection.error();
  auto streams = nats::Streams::open(**connection);
  if (!streams) return streams.error();
  if (const Result<void> kept = keep_streams(**streams); !kept) return kept.error();
  auto queue =
      nats::WorkQueue::open(**streams, kOrders, "workers-" + build_token(this_build()), orders_of_build(this_build()));
  if (!queue) return queue.error();
  Worker worker(options, **streams, stop);
  Herald herald(**connection, options.name);
  const Result<void> hears = (*connection)->subscribe(kSweepIsHere, [&others](const nats::NatsConnection::Note& note) {
    others.hear(note.payload);
  });
  if (!hears) return hears.error();
  log("ready: makes runs of sweeps of " + this_build() + ", one at a time, as " + options.name);
  take_cells(**queue, worker, herald, options, stop);
  return worker.counts();
}

}  // namespace telepalp::replay
