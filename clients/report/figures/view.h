#pragma once

#include <cstdint>
#include <optional>

#include "clients/ar/augmented_view.h"
#include "clients/report/session/session.h"

namespace telepalp::report {

/// The instant to be pictured, in session time [ns]: the greatest indentation; without contact, the last state
/// for which ar::is_drawable() is true; without such a state, the middle of the session.
[[nodiscard]] std::int64_t deepest_moment_ns(const Session& session);

/// Renders the augmented view: `frame`, and the drawable state nearest to session time `at_ns` [ns].
[[nodiscard]] ColorImage draw_view(const Session& session, const RgbdFrame& frame, std::int64_t at_ns);

}  // namespace telepalp::report
