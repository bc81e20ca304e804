#pragma once

#include <functional>
#include <string>
#include <vector>

#include "haptic_station/core/outbox/outbox.h"
#include "haptic_station/station/threads/haptic_thread.h"

namespace telepalp::station {

/// Publishes what the core's outbox makes of the ticks in the ring and of events. Owner: network thread.
class TelemetryPublisher {
 public:
  using Publish = std::function<void(wire::Message)>;
  using OnTick = std::function<void(const loop::TickSample&)>;  ///< called with every tick, in order

  TelemetryPublisher(TickRing& ticks, Publish publish, OnTick on_tick);

  /// Publishes all ticks in the ring. Call it about 100 times a second.
  void drain(SessionTime now);
  void publish(wire::Message message) { publish_(std::move(message)); }
  void publish_event(SessionTime now, msg::EventKind kind, const std::string& text) {
    publish_(outbox_.event(kind, text, now));
  }
  [[nodiscard]] core::Outbox& outbox() noexcept { return outbox_; }

 private:
  TickRing& ticks_;
  Publish publish_;
  OnTick on_tick_;
  core::Outbox outbox_;
  std::vector<loop::TickSample> batch_;
};

}  // namespace telepalp::station
