#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <functional>
#include <thread>

#include "haptic_station/core/surface_stage.h"
#include "proto/words/latest_value.h"

namespace telepalp::station {

class JournalThread;

/// The surface thread: drives the surface stage with the depth messages that the network thread offers and with the
/// session clock. The haptic thread never waits for it.
class SurfaceWorker {
 public:
  struct Handlers {
    std::function<SessionTime()> now;                          ///< session clock; called on the surface thread
    std::function<void(const msg::SurfaceReport&)> on_report;  ///< called on the surface thread
    std::function<void(const Error&)> on_bad_frame;            ///< called on the surface thread
    /// Called on the surface thread when `unreadable` and the frames after it cannot be decoded without a key frame.
    std::function<void(const wire::Message& unreadable)> request_key_frame;
    core::SurfaceStage::OnImage on_image{};  ///< called on the surface thread; may be empty
  };

  /// `placement`: called on the surface thread. `device`: its position in H. `effects`: the scene's.
  SurfaceWorker(const surface::SurfaceSettings& settings, core::SurfaceStage::Placement placement, Handlers handlers,
                LatestValue<loop::TouchableSurface>& to_haptic, LatestValue<Point<HapticBase>>& device,
                const effects::EffectBank& effects);
  ~SurfaceWorker();
  SurfaceWorker(const SurfaceWorker&) = delete;
  SurfaceWorker& operator=(const SurfaceWorker&) = delete;

  /// Keeps each run in `journal`, which must outlive this object. Call it before the first offer().
  void write_to(JournalThread& journal) noexcept { journal_ = &journal; }

  /// Queues a message. Network thread only.
  void offer(core::ArrivedDepth work);

  /// The doctor accepts the object over the device's place as skin (SurfaceStage). Network thread only.
  void accept_object();

  /// Number of messages that have given no surface: dropped, damaged or still waiting. Network thread only.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return stage_.dropped(); }

 private:
  void work_off();
  void hand_over(const core::SurfaceStage::Result& result);

  core::SurfaceStage stage_;  // owner: surface thread; the network thread calls admit()
  Handlers handlers_;
  LatestValue<loop::TouchableSurface>& to_haptic_;
  LatestValue<Point<HapticBase>>& device_;  // position in H, written by: haptic thread
  bool device_known_ = false;               // owner: surface thread
  JournalThread* journal_ = nullptr;        // nullptr: no journal is written
  std::atomic<int> posted_{0};              // messages that the surface thread has not put into the stage yet
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stay_;
  std::thread thread_;
};

}  // namespace telepalp::station
