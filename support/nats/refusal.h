#pragma once

#include <nats/nats.h>

#include <string>

#include "proto/words/result.h"

namespace telepalp::nats {

/// The error of a call of libnats that returned `status`, with what the library adds to it. Call it on the thread of
/// the failed call, before another one.
[[nodiscard]] Error refused(natsStatus status, const std::string& where, const std::string& fix);

/// The error of a call to JetStream. `about`: the stream or subject. `code`: zero if the call gives none.
[[nodiscard]] Error refused_by_jetstream(natsStatus status, jsErrCode code, const std::string& about);

}  // namespace telepalp::nats
