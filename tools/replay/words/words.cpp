#include "tools/replay/words/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "proto/words/number_word.h"

namespace telepalp::replay {
namespace {

constexpr std::array<std::string_view, 4> kHandScripts{"examine", "tap", "search",
                                                       "scene"};  // in the order of HandScript

constexpr std::size_t kMostWindows = 64;
constexpr double kLongest_s = 86400.0;
constexpr double kFarthest_mm = 1000.0;

Error refused(std::string_view text, std::string_view option, std::string_view form) {
  return {.what = "'" + std::string(text) + "' is not valid",
          .where = "--" + std::string(option),
          .fix = "give " + std::string(form)};
}

Result<Window> parse_window(std::string_view text, std::string_view option) {
  const std::size_t plus = text.find('+');
  if (plus == std::string_view::npos) return refused(text, option, "BEGIN+LENGTH, such as 10s+500ms");
  const Result<Nanoseconds> from = parse_span(text.substr(0, plus), option);
  if (!from) return from.error();
  const Result<Nanoseconds> length = parse_span(text.substr(plus + 1), option);
  if (!length) return length.error();
  if (*from < Nanoseconds{0} || *length <= Nanoseconds{0})
    return refused(text, option, "BEGIN+LENGTH with BEGIN 0 or more and LENGTH above 0");
  return Window{*from, *length};
}

/// Calls `add` with each part between commas until one fails.
template <class Add>
Result<void> for_each_part(std::string_view text, std::string_view option, Add&& add) {
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == kMostWindows)
      return Error{.what = "more than 64 windows of time are given",
                   .where = "--" + std::string(option),
                   .fix = "give at most 64 windows"};
    const std::size_t comma = text.find(',');
    if (const Result<void> added = add(text.substr(0, comma)); !added) return added;
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return {};
}

struct WindowWithValue {
  Window window;
  std::string_view value;
};
Result<WindowWithValue> parse_with_value(std::string_view text, std::string_view option, std::string_view form) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return refused(text, option, form);
  const Result<Window> window = parse_window(text.substr(0, colon), option);
  if (!window) return window.error();
  return WindowWithValue{*window, text.substr(colon + 1)};
}

}  // namespace

Result<double> parse_share(std::string_view text, std::string_view option) {
  const bool percent = text.ends_with('%');
  const std::optional<double> value = finite_number_of(percent ? text.substr(0, text.size() - 1) : text);
  const double share = value ? (percent ? *value / 100.0 : *value) : -1.0;
  if (share < 0.0 || share > 1.0) return refused(text, option, "a share from 0% to 100%, such as 5% or 0.05");
  return share;
}

Result<Nanoseconds> parse_span(std::string_view text, std::string_view option) {
  const bool milliseconds = text.ends_with("ms");
  const std::size_t unit = milliseconds ? 2 : (text.ends_with('s') ? 1 : 0);
  const std::optional<double> value = finite_number_of(text.substr(0, text.size() - unit));
  const double span_s = value ? *value * (milliseconds ? 1e-3 : 1.0) : kLongest_s + 1.0;
  if (unit == 0 || std::abs(span_s) > kLongest_s)
    return refused(text, option, "a time of at most 86400s, such as 500ms or 1.5s");
  return Nanoseconds{std::llround(span_s * 1e9)};
}

Result<std::vector<Window>> parse_windows(std::string_view text, std::string_view option) {
  std::vector<Window> windows;
  const Result<void> parsed = for_each_part(text, option, [&](std::string_view part) -> Result<void> {
    const Result<Window> window = parse_window(part, option);
    if (!window) return window.error();
    windows.push_back(*window);
    return {};
  });
  if (!parsed) return parsed.error();
  return windows;
}

Result<std::vector<EncoderGlitch>> parse_glitches(std::string_view text, std::string_view option) {
  constexpr std::string_view kForm = "BEGIN+LENGTH:MILLIMETRES with at most 1000 mm, such as 10s+4ms:20";
  std::vector<EncoderGlitch> glitches;
  const Result<void> parsed = for_each_part(text, option, [&](std::string_view part) -> Result<void> {
    const Result<WindowWithValue> glitch = parse_with_value(part, option, kForm);
    if (!glitch) return glitch.error();
    const std::optional<double> off_mm = finite_number_of(glitch->value);
    if (!off_mm || std::abs(*off_mm) > kFarthest_mm) return refused(part, option, kForm);
    glitches.push_back({glitch->window, *off_mm * 1e-3});
    return {};
  });
  if (!parsed) return parsed.error();
  return glitches;
}

Result<std::vector<ClockStep>> parse_clock_steps(std::string_view text, std::string_view option) {
  std::vector<ClockStep> steps;
  const Result<void> parsed = for_each_part(text, option, [&](std::string_view part) -> Result<void> {
    const Result<WindowWithValue> step = parse_with_value(part, option, "BEGIN+LENGTH:STEP, such as 10s+2s:-300ms");
    if (!step) return step.error();
    const Result<Nanoseconds> by = parse_span(step->value, option);
    if (!by) return by.error();
    steps.push_back({step->window, *by});
    return {};
  });
  if (!parsed) return parsed.error();
  return steps;
}

std::string span_in_words(Nanoseconds span) {
  std::string text(32, '\0');
  const double value_ms = to_milliseconds(span);
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value_ms).ptr;
  text.resize(static_cast<std::size_t>(end - text.data()));
  return text + "ms";
}

std::string window_in_words(const Window& window) {
  return span_in_words(window.from) + "+" + span_in_words(window.length);
}

std::string_view name(HandScript script) noexcept { return kHandScripts[static_cast<std::size_t>(script)]; }

std::optional<HandScript> hand_script(std::string_view name) noexcept {
  const auto found = std::find(kHandScripts.begin(), kHandScripts.end(), name);
  if (found == kHandScripts.end()) return std::nullopt;
  return static_cast<HandScript>(found - kHandScripts.begin());
}

}  // namespace telepalp::replay
