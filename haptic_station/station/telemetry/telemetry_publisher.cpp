#include "haptic_station/station/telemetry/telemetry_publisher.h"

#include <utility>

namespace telepalp::station {

TelemetryPublisher::TelemetryPublisher(TickRing& ticks, Publish publish, OnTick on_tick)
    : ticks_(ticks), publish_(std::move(publish)), on_tick_(std::move(on_tick)) {
  batch_.reserve(core::Outbox::kMostInBatch);
}

void TelemetryPublisher::drain(SessionTime now) {
  for (bool more = true; more;) {
    batch_.clear();
    loop::TickSample sample;
    while (batch_.size() < core::Outbox::kMostInBatch && (more = ticks_.try_pop(sample))) {
      on_tick_(sample);
      batch_.push_back(sample);
    }
    for (wire::Message& message : outbox_.ticks(batch_, now)) publish_(std::move(message));
  }
}

}  // namespace telepalp::station
