#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "tools/replay/scenario/scenario.h"

namespace telepalp::replay {

// The words in which a command line describes a network and faults. Each error names the option.

/// "5%" or "0.05": a share from 0 to 1.
[[nodiscard]] Result<double> parse_share(std::string_view text, std::string_view option);

/// Rounded to a nanosecond, so that the same number always gives the same time.
[[nodiscard]] inline Nanoseconds from_milliseconds(double milliseconds) noexcept {
  return Nanoseconds{std::llround(milliseconds * 1e6)};
}

/// "500ms" or "1.5s"; a minus sign is allowed; at most 24 h.
[[nodiscard]] Result<Nanoseconds> parse_span(std::string_view text, std::string_view option);

/// "10s+500ms,30s+1s": windows by their begin and length. At most 64.
[[nodiscard]] Result<std::vector<Window>> parse_windows(std::string_view text, std::string_view option);

/// "10s+4ms:20": a window, and the encoder's error along each axis [mm].
[[nodiscard]] Result<std::vector<EncoderGlitch>> parse_glitches(std::string_view text, std::string_view option);

/// "10s+2s:-300ms": a window, and the error of the station's clock (negative: behind).
[[nodiscard]] Result<std::vector<ClockStep>> parse_clock_steps(std::string_view text, std::string_view option);

/// The inverse of parse_span() and of one window of parse_windows(), for a command line that repeats a run.
[[nodiscard]] std::string span_in_words(Nanoseconds span);
[[nodiscard]] std::string window_in_words(const Window& window);

/// "examine", "tap" or "search".
[[nodiscard]] std::string_view name(HandScript script) noexcept;
/// nullopt: no script has this name.
[[nodiscard]] std::optional<HandScript> hand_script(std::string_view name) noexcept;

}  // namespace telepalp::replay
