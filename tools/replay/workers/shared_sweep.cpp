#include "tools/replay/workers/shared_sweep.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "proto/words/counted.h"
#include "proto/words/repeats/repeated_errors.h"
#include "tools/replay/commands/progress_bar.h"
#include "tools/replay/commands/settings.h"
#include "tools/replay/words/say.h"
#include "tools/replay/workers/cell_answer.h"
#include "tools/replay/workers/cell_maker.h"
#include "tools/replay/workers/recordings.h"
#include "tools/replay/workers/sweep_board.h"
#include "tools/replay/workers/sweep_cluster.h"
#include "tools/replay/workers/sweep_subjects.h"
#include "tools/replay/workers/time_left.h"
#include "tools/replay/workers/worker_watch.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kHeader_B = 4096;  // for subject and headers, within the largest payload of the cluster
constexpr auto kPollsEvery = 100ms;
constexpr auto kChecksEvery = 10s;
constexpr auto kLogsEvery = 30s;  // where no progress bar can be drawn

double now_s() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

class SharedSweep {
 public:
  SharedSweep(const Request& request, FinishedCells& finished, const std::atomic<bool>& stop)
      : request_(request),
        finished_(finished),
        stop_(stop),
        sweep_(identity_of(request, request.scenario)),
        board_(missing_cells()),
        left_(now_s()) {}

  Result<SharedOutcome> run();

 private:
  [[nodiscard]] std::vector<std::string> missing_cells();
  [[nodiscard]] Result<void> connect();
  [[nodiscard]] Result<void> send_source();
  [[nodiscard]] Result<void> take_stored(bool at_begin);
  [[nodiscard]] Result<void> order_missing(const std::set<std::string>& queued);
  [[nodiscard]] Result<std::set<std::string>> queued_cells();
  [[nodiscard]] Result<void> check();
  [[nodiscard]] Result<void> wait();
  [[nodiscard]] Result<void> take_answer(const std::string& subject, const std::string& payload);
  [[nodiscard]] Result<void> forget_answers();
  [[nodiscard]] CellOrder order_of(std::size_t cell) const;
  [[nodiscard]] std::string in_words(std::size_t cell) const;
  [[nodiscard]] std::string progress() const;
  [[nodiscard]] std::uint64_t most_chunk_B() const;

  const Request& request_;
  FinishedCells& finished_;
  const std::atomic<bool>& stop_;
  std::string sweep_;
  std::map<std::string, std::vector<std::size_t>> cells_;  // by identity: equal cells have several places
  SweepBoard board_;
  TimeLeft left_;
  std::optional<LocalRecording> recording_;
  std::map<std::string, std::string> reasons_;  // of refused cells
  RepeatedErrors errors_;
  std::set<std::string> served_by_;  // names of workers
  bool was_refused_ = false;         // the cluster held refusals for an earlier run of this command
  Clock::time_point began_ = Clock::now();
  WorkerWatch watch_{this_build(), began_};
  Inbox answers_;
  std::atomic<bool> answers_missed_{false};  // while the connection was lost
  SweepCluster cluster_;                     // last: its threads use the other members
};

std::vector<std::string> SharedSweep::missing_cells() {
  std::vector<std::string> missing;
  for (const std::size_t cell : finished_.next(request_.cells.size())) {
    missing.push_back(identity_of(request_, request_.cells[cell].scenario));
    cells_[missing.back()].push_back(cell);
  }
  return missing;
}

Result<void> SharedSweep::connect() {
  auto cluster = SweepCluster::join(*request_.workers, "telepalp-replay", "telepalp-replay --sweep",
                                    [this] { answers_missed_ = true; });
  if (!cluster) return cluster.error();
  cluster_ = *std::move(cluster);
  const auto into = [](Inbox& inbox) { return [&inbox](const nats::NatsConnection::Note& note) { inbox.put(note); }; };
  const Result<void> subscribed = cluster_.connection->subscribe(answer_subject(sweep_, "*"), into(answers_));
  if (!subscribed) return subscribed;
  return cluster_.connection->subscribe(kWorkerIsHere, into(watch_.inbox()));
}

/// The largest chunk that fits into the cluster's largest payload [B].
std::uint64_t SharedSweep::most_chunk_B() const {
  return std::max(cluster_.connection->most_payload_B(), kHeader_B) - kHeader_B;
}

/// Stores the recording, if there is one, in the cluster.
Result<void> SharedSweep::send_source() {
  if (was_refused_ && recording_)
    if (const Result<void> done = forget_recording(*cluster_.streams, recording_->content); !done) return done;
  if (!recording_) return {};
  ProgressBar bar(1e-6 * static_cast<double>(recording_->content.size_B));
  return store_recording(*cluster_.streams, *recording_, stop_,
                         [&](std::uint64_t bytes) { bar.show(1e-6 * static_cast<double>(bytes), "MB sent"); });
}

Result<void> SharedSweep::take_answer(const std::string& subject, const std::string& payload) {
  const std::optional<CellPlace> place = place_of(subject);
  const auto cells = place ? cells_.find(place->cell) : cells_.end();
  if (cells == cells_.end()) return {};  // of another grid of the same source
  const Result<CellAnswer> answer = parse_answer(payload, this_build(), place->cell);
  const auto ignored = [&](const Error& error) {
    if (const auto line = errors_.line("answer ignored", error, Clock::now())) say(*line);
    return Result<void>();
  };
  if (!answer) return ignored(answer.error());
  if (!answer->refused.empty()) {
    if (board_.on(place->cell, CellEvent::Refusal)) {
      reasons_[place->cell] = answer->refused;
      say("workers have given up " + in_words(cells->second.front()) + ": " + answer->refused);
    }
    return {};
  }
  if (board_.phase(place->cell) == CellPhase::Finished) return {};
  for (const std::size_t cell : cells->second)
    if (const Result<void> added = finished_.add(cell, answer->report); !added)
      return finished_.figures()[cell] ? added : ignored(added.error());
  board_.on(place->cell, CellEvent::Report);
  left_.finished(now_s());
  served_by_.insert(answer->worker);
  return {};
}

/// Takes the answers that the cluster has stored. `at_begin`: erases the refusals of an earlier run of this command, so
/// that these cells are tried again.
Result<void> SharedSweep::take_stored(bool at_begin) {
  const auto stored = cluster_.streams->subjects(kSweeps, answer_subject(sweep_, "*"));
  if (!stored) return stored.error();
  for (const std::string& subject : *stored) {
    const std::optional<CellPlace> place = place_of(subject);
    if (!place || !board_.phase(place->cell) || board_.phase(place->cell) == CellPhase::Finished) continue;
    const auto payload = cluster_.streams->newest(kSweeps, subject);
    if (!payload) return payload.error();
    if (!*payload) continue;
    if (const Result<void> taken = take_answer(subject, **payload); !taken) return taken;
    if (!at_begin || board_.phase(place->cell) == CellPhase::Finished) continue;
    was_refused_ = true;
    if (const Result<void> erased = cluster_.streams->erase(kSweeps, subject); !erased) return erased;
  }
  return {};
}

Result<std::set<std::string>> SharedSweep::queued_cells() {
  const auto subjects = cluster_.streams->subjects(kOrders, order_subject(this_build(), sweep_, "*"));
  if (!subjects) return subjects.error();
  std::set<std::string> queued;
  for (const std::string& subject : *subjects)
    if (const auto place = place_of(subject)) queued.insert(place->cell);
  return queued;
}

CellOrder SharedSweep::order_of(std::size_t cell) const {
  CellOrder order{.build = this_build(),
                  .sweep = sweep_,
                  .cell = identity_of(request_, request_.cells[cell].scenario),
                  .source = request_.source,
                  .source_digest = request_.source_digest,
                  .scene_text = request_.scene_text,
                  .options = request_.options};
  if (recording_) order.recording = recording_->content;
  for (const Assertion& assertion : request_.assertions)
    order.assertions += (order.assertions.empty() ? "" : ",") + assertion.text;
  for (std::size_t axis = 0; axis < request_.axes.size(); ++axis)
    order.at.emplace_back(request_.axes[axis].name, request_.cells[cell].values[axis]);
  return order;
}

/// Orders the cells that are neither finished nor in the queue.
Result<void> SharedSweep::order_missing(const std::set<std::string>& queued) {
  for (const std::string& cell : board_.in(CellPhase::Missing)) {
    if (stop_) return {};
    if (!queued.contains(cell)) {
      const std::string order = encode(order_of(cells_.at(cell).front()));
      const Result<void> stored = cluster_.streams->store(order_subject(this_build(), sweep_, cell), order);
      if (!stored) return stored;
    }
    board_.on(cell, CellEvent::Order);
  }
  return {};
}

/// Takes answers that were missed while the connection was lost, and orders cells again whose order the cluster has
/// lost. It reads the queue before the answers, because a worker stores its answer before the order leaves the queue.
Result<void> SharedSweep::check() {
  const Result<std::set<std::string>> queued = queued_cells();
  if (!queued) return queued.error();
  if (const Result<void> taken = take_stored(false); !taken) return taken;
  for (const std::string& cell : board_.in(CellPhase::Ordered))
    if (!queued->contains(cell)) board_.on(cell, CellEvent::Vanished);
  return order_missing(*queued);
}

std::string SharedSweep::in_words(std::size_t cell) const {
  std::string text = "the run";
  for (std::size_t axis = 0; axis < request_.axes.size(); ++axis)
    text += " " + axes_of({.at = {{std::string(request_.axes[axis].name), request_.cells[cell].values[axis]}}}).front();
  return text;
}

std::string SharedSweep::progress() const {
  const std::size_t open = board_.count(CellPhase::Ordered) + board_.count(CellPhase::Missing);
  const std::optional<double> left_s = left_.left_s(open, now_s());
  return "runs, " + counted(watch_.count(), "worker", "workers") +
         (left_s ? ", about " + span_of_time(*left_s) + " left" : "");
}

Result<void> SharedSweep::wait() {
  ProgressBar bar(static_cast<double>(request_.cells.size()));
  const bool is_drawn = bar.is_shown();
  Clock::time_point here = Clock::now(), checks = here + kChecksEvery, logs = here + kLogsEvery;
  while (!stop_ && !board_.is_settled()) {
    const Clock::time_point now = Clock::now();
    for (const Inbox::Note& note : answers_.take())
      if (const Result<void> taken = take_answer(note.subject, note.payload); !taken) return taken;
    watch_.look(now, nats::without_password(request_.workers->url));
    if (now >= here) {
      cluster_.connection->publish(
          kSweepIsHere, encode(Presence{.name = sweep_, .build = this_build(), .finished = finished_.count()}));
      here = now + kPresenceEvery;
    }
    if ((now >= checks || answers_missed_) && cluster_.connection->is_connected()) {
      answers_missed_ = false;
      if (const Result<void> checked = check(); !checked)
        if (const auto line = errors_.line("the cluster cannot be asked for answers", checked.error(), now)) say(*line);
      checks = now + kChecksEvery;
    }
    bar.show(static_cast<double>(finished_.count()), progress().c_str());
    if (!is_drawn && now >= logs) {
      say(std::to_string(finished_.count()) + " of " + std::to_string(request_.cells.size()) + " " + progress());
      logs = now + kLogsEvery;
    }
    std::this_thread::sleep_for(kPollsEvery);
  }
  return {};
}

/// Erases the answers of this sweep's cells: all are finished. Answers for another grid of the same source stay.
Result<void> SharedSweep::forget_answers() {
  const auto stored = cluster_.streams->subjects(kSweeps, answer_subject(sweep_, "*"));
  if (!stored) return stored.error();
  for (const std::string& subject : *stored)
    if (const auto place = place_of(subject); place && board_.phase(place->cell) == CellPhase::Finished)
      if (const Result<void> erased = cluster_.streams->erase(kSweeps, subject); !erased) return erased;
  return {};
}

Result<SharedOutcome> SharedSweep::run() {
  const auto scene = request_.options.find("scene");
  const bool is_known = scene != request_.options.end() && scene_of_library(scene->second, request_.scene_text);
  if (!is_known && names_a_file(request_.scene_text))
    return Error{.what = "workers cannot be sent the files that this scene names",
                 .where = request_.scene_file.string(),
                 .fix = "use a scene of telepalp's library, or one that names no file, or leave out --workers"};
  if (const Result<void> connected = connect(); !connected) return connected.error();
  auto recording = local_recording(request_.source, most_chunk_B());
  if (!recording) return recording.error();
  recording_ = *std::move(recording);
  if (const Result<void> taken = take_stored(true); !taken) return taken.error();
  if (board_.count(CellPhase::Finished) > 0)
    say(counted(board_.count(CellPhase::Finished), "run was", "runs were") +
        " finished by workers before, and not made again");
  if (board_.count(CellPhase::Missing) > 0) {
    if (const Result<void> sent = send_source(); !sent) return sent.error();
    const Result<std::set<std::string>> queued = queued_cells();
    if (!queued) return queued.error();
    if (const Result<void> ordered = order_missing(*queued); !ordered) return ordered.error();
  }
  if (const Result<void> waited = wait(); !waited) return waited.error();
  SharedOutcome outcome{.ordered = board_.count(CellPhase::Ordered)};
  for (const std::string& cell : board_.in(CellPhase::Refused))
    outcome.refused.push_back(in_words(cells_.at(cell).front()) + ": " + reasons_[cell]);
  if (stop_ || !outcome.refused.empty()) return outcome;
  if (!served_by_.empty())
    say(counted(board_.size(), "run", "runs") + " by " + counted(served_by_.size(), "worker", "workers") + " in " +
        span_of_time(std::chrono::duration<double>(Clock::now() - began_).count()));
  if (const Result<void> forgotten = forget_answers(); !forgotten)
    say("the cluster keeps the results for seven days: " + to_string(forgotten.error()));
  return outcome;
}

}  // namespace

Result<SharedOutcome> share_sweep(const Request& request, FinishedCells& finished, const std::atomic<bool>& stop) {
  return SharedSweep(request, finished, stop).run();
}

}  // namespace telepalp::replay
