#include "proto/wire/depth_loss.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace telepalp::wire {
namespace {

constexpr std::string_view kMovingMode = "bounded";
constexpr std::size_t kLongestMode = 32;  // of a name that is shown

/// False for what is not a number, too.
bool is_credible(double bound) noexcept { return bound >= 0.0 && bound <= 1.0; }

DepthFidelity told(const std::string& mode, bool has_bound, const msg::DepthBound& bound) {
  DepthFidelity depth{.mode = mode.substr(0, kLongestMode), .moved = has_bound || mode == kMovingMode};
  if (has_bound && is_credible(bound.least_m()) && is_credible(bound.per_m())) depth.within = bound;
  return depth;
}

/// How far from what was measured [mm at 1 m], as far as that can be compared: unknown is further than any.
double distance(const DepthFidelity& told) noexcept {
  if (!told.moved) return told.mode.empty() ? -2.0 : -1.0;
  return told.within ? at_1_m_mm(*told.within) : std::numeric_limits<double>::infinity();
}

}  // namespace

DepthFidelity depth_fidelity(const msg::DepthImage& image) {
  return told(image.format(), image.has_bound(), image.bound());
}

DepthFidelity depth_fidelity(const msg::SurfaceReport& report) {
  return told(report.depth_mode(), report.has_depth_bound(), report.depth_bound());
}

std::optional<DepthLoss> loss_of(const DepthFidelity& told) noexcept {
  if (!told.moved) return std::nullopt;
  if (!told.within) return DepthLoss{};
  return DepthLoss{.least_m = told.within->least_m(), .per_m = told.within->per_m()};
}

DepthFidelity less_exact(const DepthFidelity& older, const DepthFidelity& newer) {
  return distance(older) > distance(newer) ? older : newer;
}

std::string how_far(const DepthFidelity& told) {
  if (!told.moved) return told.mode.empty() ? "not told" : "as measured";
  if (!told.within) return "off by an amount that is not told";
  char text[64];
  std::snprintf(text, sizeof text, "off by up to %.3g mm at 1 m", at_1_m_mm(*told.within));
  return text;
}

std::string in_words(const DepthFidelity& told) { return (told.mode.empty() ? "" : told.mode + ", ") + how_far(told); }

double at_1_m_mm(const msg::DepthBound& bound) noexcept { return 1000.0 * std::max(bound.least_m(), bound.per_m()); }

}  // namespace telepalp::wire
