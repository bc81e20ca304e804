#pragma once

#include <cstdint>
#include <optional>

#include "clients/ar/augmented_view.h"
#include "clients/report/session/session.h"

namespace telepalp::report {

/// The instant to be pictured, in session time [ns]: the greatest indentation; without contact, the last state; without
/// a station, the middle of the session.
[[nodiscard]] std::int64_t deepest_moment_ns(const Session& session);

/// Renders the augmented view at session time `at_ns` over `frame`.
[[nodiscard]] ColorImage draw_view(const Session& session, const RgbdFrame& frame, std::int64_t at_ns);

}  // namespace telepalp::report
