#pragma once

#include <cstdint>

#include "proto/wire/topics.h"

namespace telepalp::wire {

/// Which messages a sender of datagrams takes now: any, or only those of urgent topics.
enum class Wanted : std::uint8_t { Any, Urgent };

/// True for the deadline topics that are no images: speech, the viewer's hand and the station's state. Their messages
/// are short, so they overtake the unsent datagrams of an image that has begun.
[[nodiscard]] constexpr bool is_urgent(const Topic& topic) noexcept {
  return topic.has_deadline() && topic.publisher != Publisher::Server;
}

}  // namespace telepalp::wire
