#pragma once

#include <cstdint>
#include <optional>

#include "clients/ar/augmented_view.h"
#include "clients/report/session/session.h"

namespace telepalp::report {

/// The instant that says most about a run: the greatest indentation; without contact the last known state; without a
/// station the middle of the session. [ns of session time]
[[nodiscard]] std::int64_t telling_moment_ns(const Session& session);

/// The augmented view at `at_ns` over `frame`.
[[nodiscard]] ColorImage draw_view(const Session& session, const RgbdFrame& frame, std::int64_t at_ns);

}  // namespace telepalp::report
