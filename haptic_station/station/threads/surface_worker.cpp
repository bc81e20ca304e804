#include "haptic_station/station/threads/surface_worker.h"

#include <boost/asio/post.hpp>
#include <utility>

#include "haptic_station/core/journal/journal_words.h"
#include "haptic_station/station/threads/journal_thread.h"

namespace telepalp::station {

SurfaceWorker::SurfaceWorker(const surface::SurfaceSettings& settings, core::SurfaceStage::Placement placement,
                             Handlers handlers, LatestValue<loop::TouchableSurface>& to_haptic,
                             LatestValue<Point<HapticBase>>& device, const effects::EffectBank& effects)
    : stage_(settings, std::move(placement), effects, std::move(handlers.on_image)),
      handlers_(std::move(handlers)),
      to_haptic_(to_haptic),
      device_(device),
      stay_(boost::asio::make_work_guard(io_)),
      thread_([this] { io_.run(); }) {}

SurfaceWorker::~SurfaceWorker() {
  io_.stop();
  thread_.join();
}

/// The messages that came during a run are all in the stage before the next run begins.
void SurfaceWorker::offer(core::ArrivedDepth work) {
  if (!stage_.admit(work.depth.payload->size())) return;
  ++posted_;
  boost::asio::post(io_, [this, work = std::move(work)]() mutable {
    stage_.arrived(std::move(work));
    if (--posted_ == 0) work_off();
  });
}

void SurfaceWorker::accept_object() {
  boost::asio::post(io_, [this] { stage_.accept_object(); });
}

void SurfaceWorker::work_off() {
  device_known_ |= device_.take();
  const auto job = stage_.take(handlers_.now(), device_known_ ? std::optional(device_.current()) : std::nullopt);
  if (!job) return;
  core::StepTimes times;
  const core::SurfaceStage::Result result =
      stage_.run(*job, [&](core::StageStep step) { return times.keep(step, handlers_.now()); });
  if (journal_ != nullptr) journal_->add(message_of(*job, times, result));  // before a tick can adopt the surface
  hand_over(result);
}

void SurfaceWorker::hand_over(const core::SurfaceStage::Result& result) {
  if (result.surface) to_haptic_.put(*result.surface);
  if (result.surface) handlers_.on_report(result.report);
  if (result.error) handlers_.on_bad_frame(*result.error);
  if (result.unreadable) handlers_.request_key_frame(*result.unreadable);
}

}  // namespace telepalp::station
