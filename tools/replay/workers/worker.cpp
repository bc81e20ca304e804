#include "tools/replay/workers/worker.h"

#include <set>
#include <thread>
#include <utility>

#include "proto/words/repeats/repeated_errors.h"
#include "support/nats/work_queue.h"
#include "support/program/log.h"
#include "support/program/repeated_call.h"
#include "tools/replay/commands/request.h"
#include "tools/replay/workers/cell_answer.h"
#include "tools/replay/workers/cell_maker.h"
#include "tools/replay/workers/recordings.h"
#include "tools/replay/workers/sweep_cluster.h"
#include "tools/replay/workers/sweep_subjects.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kProgram = "telepalp-worker";
constexpr auto kTakesWithin = 500ms;
constexpr auto kAgainAfter = 1s;  // times the deliveries, so that a failing cell leaves time for the others
constexpr int kMostStoreTries = 5;

void log(const std::string& text) { program::log(kProgram, text); }

/// Logs each other build of which a sweep waits for workers, once. Owner: the library's thread.
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

/// Stores the answer. While the cluster cannot be reached it tries again for some seconds, because the report may have
/// taken minutes to compute.
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
  log("a run is removed from the queue, because it was delivered " + std::to_string(item.deliveries()) +
      " times: " + why);
  if (place)
    if (const Result<void> stored = answer(*place, {.refused = why}); !stored)
      return give_back(item, "the cluster does not take the refusal: " + to_string(stored.error()), 10s);
  item.remove_as_bad();
  ++counts_.refused;
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

/// Takes cells until it is stopped, or idle for too long. `finished`: receives the count of finished cells.
void take_cells(nats::WorkQueue& queue, Worker& worker, std::atomic<std::uint64_t>& finished,
                const WorkerOptions& options, const std::atomic<bool>& stop) {
  RepeatedErrors errors;
  Clock::time_point worked = Clock::now();
  while (!stop && (options.idle.count() <= 0.0 || Clock::now() - worked < options.idle)) {
    Result<std::optional<nats::WorkItem>> item = queue.take(kTakesWithin);
    if (!item) {
      if (const auto line = errors.line("the queue cannot be read", item.error(), Clock::now())) log(*line);
      std::this_thread::sleep_for(kTakesWithin);
    } else if (*item) {
      worker.work(std::move(**item));
      finished = worker.counts().finished;
      worked = Clock::now();
    }
  }
}

}  // namespace

Result<WorkerCounts> run_worker(const WorkerOptions& options, const std::atomic<bool>& stop) {
  OtherBuilds others;  // outlives the connection, whose thread calls it
  auto cluster = SweepCluster::join(options.cluster, kProgram, std::string(kProgram) + " " + options.name);
  if (!cluster) return cluster.error();
  nats::NatsConnection& connection = *cluster->connection;
  auto queue = nats::WorkQueue::open(*cluster->streams, kOrders, "workers-" + build_token(this_build()),
                                     orders_of_build(this_build()));
  if (!queue) return queue.error();
  const Result<void> subscribed = connection.subscribe(
      kSweepIsHere, [&others](const nats::NatsConnection::Note& note) { others.hear(note.payload); });
  if (!subscribed) return subscribed.error();
  std::atomic<std::uint64_t> finished{0};
  const auto tell = [&] {
    connection.publish(kWorkerIsHere,
                       encode(Presence{.name = options.name, .build = this_build(), .finished = finished}));
  };
  tell();
  const program::RepeatedCall tells(kPresenceEvery, tell);  // a thread of its own, because a cell takes long
  Worker worker(options, *cluster->streams, stop);
  log("ready: makes runs of sweeps of " + this_build() + ", one at a time, as " + options.name);
  take_cells(**queue, worker, finished, options, stop);
  return worker.counts();
}

}  // namespace telepalp::replay
