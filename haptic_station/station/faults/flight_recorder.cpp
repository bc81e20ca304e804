#include "haptic_station/station/faults/flight_recorder.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>

#include "haptic_station/core/outbox/tick_messages.h"
#include "proto/wire/mcap/writer.h"
#include "proto/words/demand.h"
#include "support/program/files/whole_file.h"
#include "support/program/version.h"

namespace telepalp::station {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTicksPerState = 20;  // 100 Hz

/// The time in seconds is unique: only an operator re-arms, so there is at most one fault a second.
std::string name_of_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[40];
  std::strftime(text, sizeof text, "fault-%Y%m%dT%H%M%SZ.mcap", &utc);
  return text;
}

/// Writes one tenth of a second: its ticks, states and events. `phase` carries the last phase from batch to batch.
Result<void> write_batch(wire::McapWriter& file, const std::vector<loop::TickSample>& batch, std::uint8_t& phase) {
  const auto put = [&](const wire::Topic& topic, const loop::TickSample& at, const auto& message) {
    return file.write(wire::make_message(topic, session_time(at.stamp_ns), message));
  };
  for (const auto run : core::unbroken_runs(batch))
    if (auto done = put(wire::kStationTicks, run.front(), core::ticks_message(run)); !done) return done;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const loop::TickSample& sample = batch[i];
    if (i % kTicksPerState == 0)
      if (auto done = put(wire::kStationState, sample, core::state_message(sample)); !done) return done;
    if (sample.phase == phase) continue;
    if (auto done = put(wire::kStationEvents, sample, core::phase_event(sample, phase)); !done) return done;
    phase = sample.phase;
    if (phase != msg::PHASE_FAULTED) continue;
    if (auto done = put(wire::kStationEvents, sample, core::fault_event(sample)); !done) return done;
  }
  return {};
}

}  // namespace

void FlightRecorder::add(const loop::TickSample& sample) noexcept {
  ticks_[next_] = sample;
  next_ = (next_ + 1) % ticks_.size();
  if (next_ == 0) full_ = true;
}

std::vector<loop::TickSample> FlightRecorder::ticks() const {
  std::vector<loop::TickSample> out;
  out.reserve(full_ ? ticks_.size() : next_);
  const auto middle = ticks_.begin() + static_cast<std::ptrdiff_t>(next_);
  if (full_) out.insert(out.end(), middle, ticks_.end());
  out.insert(out.end(), ticks_.begin(), middle);
  return out;
}

void FaultWatch::add(const loop::TickSample& sample) noexcept {
  flight_recorder_.add(sample);
  newest_tick_ = sample.tick;
  const bool faulted = sample.phase == msg::PHASE_FAULTED;
  if (faulted && !faulted_) {
    begun_ = sample;
    fault_tick_ = sample.tick;
  }
  faulted_ = faulted;
}

std::optional<std::vector<loop::TickSample>> FaultWatch::due(bool ending) {
  if (!fault_tick_ || (!ending && newest_tick_ < *fault_tick_ + kTicksAfter)) return std::nullopt;
  fault_tick_.reset();
  return flight_recorder_.ticks();
}

Result<fs::path> write_flight_record(const fs::path& folder, const std::vector<loop::TickSample>& samples,
                                     const std::string& scene) {
  demand(!samples.empty(), "a flight recording holds at least one tick");
  if (const Result<void> made = program::make_folder(folder, program::Readers::Group); !made)
    return Error{.what = made.error().what,
                 .where = made.error().where,
                 .fix = "give --state-dir a folder that this user may write to"};
  Result<wire::McapWriter> file =
      wire::McapWriter::open(folder / name_of_now(), {"telepalp-station", program::version(), program::commit(),
                                                      "flight recorder: the last seconds before a fault", scene});
  if (!file) return file.error();
  constexpr std::size_t kBatch = 200;
  std::uint8_t phase = samples.front().phase;
  for (std::size_t from = 0; from < samples.size(); from += kBatch) {
    const auto first = samples.begin() + static_cast<std::ptrdiff_t>(from);
    const auto count = static_cast<std::ptrdiff_t>(std::min(kBatch, samples.size() - from));
    if (auto done = write_batch(*file, {first, first + count}, phase); !done) return done.error();
  }
  if (auto closed = file->close(); !closed) return closed.error();
  return file->name();
}

fs::path default_state_folder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0')
    return fs::path(state) / "telepalp";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".local/state/telepalp";
  return "telepalp-state";
}

}  // namespace telepalp::station
