#include "haptic_station/core/journal/journal_replay.h"

#include <cstring>
#include <utility>

#include "haptic_station/core/journal/journal_words.h"
#include "proto/wire/vector_message.h"

namespace telepalp::core {
namespace {

bool same_bits(const google::protobuf::RepeatedField<double>& recorded, const Eigen::Vector3d& now) {
  return std::memcmp(recorded.data(), now.data(), 3 * sizeof(double)) == 0;
}

std::string numbered(const char* what, std::uint64_t number) { return what + (" " + std::to_string(number)); }

}  // namespace

JournalReplay::JournalReplay(loop::HapticLoop& loop, SurfaceStage& surfaces, CollisionStage* collision, OnTick on_tick)
    : loop_(loop), surfaces_(surfaces), collision_(collision), on_tick_(std::move(on_tick)) {}

JournalVerdict JournalReplay::run(JournalReader& reader) {
  while (!verdict_.stopped) {
    const std::optional<msg::JournalBlock> block = reader.next();
    if (!block) break;
    if (block->has_surface_run()) run_surface(block->surface_run());
    if (block->has_collision_run()) run_collision(block->collision_run());
    for (const msg::JournalTick& tick : block->ticks().ticks()) waiting_.push_back(tick);
    tick_on();
  }
  if (!verdict_.stopped && !waiting_.empty()) stop_at(waiting_.front());
  return verdict_;
}

void JournalReplay::stop_at(const msg::JournalTick& tick) {
  verdict_.stopped = numbered("tick", tick.tick()) + " adopts " + numbered("surface", tick.surface()) + ", which " +
                     broken_.value_or("the journal does not hold");
}

/// A run that is missing leaves the stage in an unknown state, so no later surface can be made.
void JournalReplay::run_surface(const msg::JournalSurfaceRun& run) {
  ++verdict_.surface_runs;
  if (broken_) return;
  if (run.read().empty() || run.surface() > surfaces_made_ + 1) {
    broken_ = "the journal does not hold";
    return;
  }
  const StepTimes times = times_of(run);
  SurfaceStage::Result result = surfaces_.run(job_of(run), [&](StageStep step) { return times.of(step); });
  const std::uint64_t number = result.surface ? result.surface->number : 0;
  if (number != run.surface()) broken_ = "the surface stage did not make again";
  if (broken_ || !result.surface) return;
  surfaces_made_ = number;
  made_.emplace(number, std::move(*result.surface));
}

void JournalReplay::run_collision(const msg::JournalCollisionRun& run) {
  ++verdict_.collision_runs;
  if (broken_) return;
  const auto found = made_.find(run.newer());
  if (collision_ == nullptr || (run.newer() != 0 && found == made_.end())) {
    broken_ = "the collision detection cannot make again";
    return;
  }
  CollisionStage::Job job{
      .begun = session_time(run.begun_ns()), .newer = {}, .device = {wire::vector_of(run.device())}};
  if (run.newer() != 0) {
    job.newer = found->second;
    made_.erase(made_.begin(), found);
  }
  CollisionStage::Result result = collision_->run(job, [&](StageStep) { return session_time(run.done_ns()); });
  if (result.plane) planes_.emplace(result.plane->number, std::move(*result.plane));
}

void JournalReplay::tick_on() {
  while (!waiting_.empty() && !verdict_.stopped && tick(waiting_.front())) waiting_.pop_front();
}

/// A tick that is missing leaves the loop in an unknown state, so no later force can be computed again.
bool JournalReplay::stops_at_a_gap(const msg::JournalTick& recorded) {
  if (recorded.tick() == verdict_.ticks) return false;
  verdict_.stopped = numbered("tick", verdict_.ticks) + " is missing: the next one in the journal is " +
                     numbered("tick", recorded.tick());
  return true;
}

/// False: the tick's surface has not come yet.
bool JournalReplay::tick(const msg::JournalTick& recorded) {
  std::optional<loop::TickIn> in = tick_in(recorded);
  if (!in) {
    verdict_.stopped = numbered("tick", recorded.tick()) + " is malformed";
    return false;
  }
  if (stops_at_a_gap(recorded)) return false;
  loop::TouchableSurface newer;
  if (recorded.surface() != 0) {
    Surfaces& made = for_ticks();
    const auto found = made.find(recorded.surface());
    if (found == made.end()) {
      if (broken_) stop_at(recorded);
      return false;
    }
    newer = found->second;
    in->surface = &newer;
    made.erase(made.begin(), found);
  }
  const loop::TickOut out = loop_.tick(*in);
  if (in->surface != nullptr) adopted_ = std::move(newer);
  compare(recorded, out);
  return true;
}

void JournalReplay::compare(const msg::JournalTick& recorded, const loop::TickOut& out) {
  const bool force = same_bits(recorded.force(), out.force.N) && same_bits(recorded.torque(), out.torque.N_m);
  const bool phase = recorded.phase() == static_cast<std::uint32_t>(out.control.phase);
  const bool proxy = same_bits(recorded.proxy(), out.contact.proxy.m);
  ++verdict_.ticks;
  verdict_.forces_differ += force ? 0 : 1;
  verdict_.phases_differ += phase ? 0 : 1;
  verdict_.proxies_differ += proxy ? 0 : 1;
  if (!verdict_.first_difference && !(force && phase && proxy)) verdict_.first_difference = recorded.tick();
  if (on_tick_) on_tick_(recorded, out.force.N);
}

}  // namespace telepalp::core
