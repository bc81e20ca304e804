#include "proto/wire/depth_loss.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace telepalp::wire {
namespace {

constexpr std::string_view kMovingMode = "bounded";
constexpr std::size_t kLongestMode = 32;  // limits the name, because a peer chooses it and logs show it

/// Also false for NaN.
bool is_credible(double bound) noexcept { return bound >= 0.0 && bound <= 1.0; }

DepthFidelity stated(const std::string& mode, bool has_bound, const msg::DepthBound& bound) {
  DepthFidelity depth{.mode = mode.substr(0, kLongestMode), .moved = has_bound || mode == kMovingMode};
  if (has_bound && is_credible(bound.least_m()) && is_credible(bound.per_m()))
    depth.within = DepthErrorBound{.least_m = bound.least_m(), .per_m = bound.per_m()};
  return depth;
}

/// For comparison [mm at 1 m]: unstated is largest, lossless is negative.
double distance(const DepthFidelity& fidelity) noexcept {
  if (!fidelity.moved) return fidelity.mode.empty() ? -2.0 : -1.0;
  return fidelity.within ? at_1_m_mm(*fidelity.within) : std::numeric_limits<double>::infinity();
}

}  // namespace

DepthFidelity depth_fidelity(const msg::DepthImage& image) {
  return stated(image.format(), image.has_bound(), image.bound());
}

DepthFidelity depth_fidelity(const msg::SurfaceReport& report) {
  return stated(report.depth_mode(), report.has_depth_bound(), report.depth_bound());
}

std::optional<DepthErrorBound> loss_of(const DepthFidelity& fidelity) noexcept {
  if (!fidelity.moved) return std::nullopt;
  return fidelity.within.value_or(DepthErrorBound::unknown());
}

DepthFidelity less_exact(const DepthFidelity& older, const DepthFidelity& newer) {
  return distance(older) > distance(newer) ? older : newer;
}

std::string how_far(const DepthFidelity& fidelity) {
  if (!fidelity.moved) return fidelity.mode.empty() ? "not stated" : "lossless";
  if (!fidelity.within) return "off by an unknown amount";
  char text[64];
  std::snprintf(text, sizeof text, "off by up to %.3g mm at 1 m", at_1_m_mm(*fidelity.within));
  return text;
}

std::string in_words(const DepthFidelity& fidelity) {
  return (fidelity.mode.empty() ? "" : fidelity.mode + ", ") + how_far(fidelity);
}

double at_1_m_mm(const DepthErrorBound& bound) noexcept { return 1000.0 * bound.at(1.0); }

}  // namespace telepalp::wire
