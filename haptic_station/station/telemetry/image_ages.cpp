#include "haptic_station/station/telemetry/image_ages.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "proto/words/counted.h"

namespace telepalp::station {
namespace {

std::string in_ms(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, seconds < 0.01 ? "%.1f ms" : "%.0f ms", 1e3 * seconds);
  return text;
}

}  // namespace

void ImageAges::add(const msg::SurfaceReport& report, double clock_error_s) {
  const auto age_ns = static_cast<std::int64_t>(report.touchable_ns() - report.captured_ns());
  ages_.add(static_cast<std::uint64_t>(std::max<std::int64_t>(0, age_ns)));  // below 0: within the clock's error
  clock_error_s_ = std::max(clock_error_s_, clock_error_s);
}

std::string ImageAges::in_words() const {
  if (ages_.total() == 0) return "";
  const std::string text = counted(ages_.total(), "image: its surface was", "images: their surfaces were") +
                           " touchable " + in_ms(1e-9 * ages_.quantile_ns(0.5)) + " (median) and " +
                           in_ms(1e-9 * ages_.quantile_ns(0.99)) + " (99th percentile) after capture; ";
  if (!std::isfinite(clock_error_s_))
    return text + "the error of both is unknown, because the server's clock is not known";
  return text + "the error of both is at most " + in_ms(clock_error_s_);
}

}  // namespace telepalp::station
