#pragma once

#include <string>

#include "proto/words/result.h"

namespace telepalp::wire {

/// The error for a peer that breaks the protocol. The connection puts the peer's address before it.
[[nodiscard]] inline Error bad_peer(std::string what) {
  return {.what = std::move(what),
          .where = {},
          .fix = "install the same version of telepalp at both ends; other programs must follow proto/WIRE.md"};
}

}  // namespace telepalp::wire
