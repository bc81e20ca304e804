#include "tools/codec_tool/depth_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace telepalp::codec_tool {
namespace {

double depth_mm(const DepthImage& depth, std::size_t pixel) {
  return 1000.0 * depth.unit_m * static_cast<double>(depth.samples[pixel]);
}

std::string place(std::size_t frame, const DepthImage& depth, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(depth.width);
  return "frame " + std::to_string(frame) + ", column " + std::to_string(pixel % width) + ", row " +
         std::to_string(pixel / width) + " (counted from 0)";
}

std::string in_mm(double before, double after, double allowed) {
  char text[96];
  if (before == 0.0)
    std::snprintf(text, sizeof text, ": not measured in the first input, %.3f mm in the second", after);
  else if (after == 0.0)
    std::snprintf(text, sizeof text, ": %.3f mm in the first input, not measured in the second", before);
  else
    std::snprintf(text, sizeof text, " at %.3f mm: off by %.3f mm, %.3f mm allowed", before, std::abs(after - before),
                  allowed);
  return text;
}

}  // namespace

void DepthDifference::add(const DepthImage& original, const DepthImage& other) {
  for (std::size_t i = 0; i < original.samples.size(); ++i) {
    if (bound_) hold(original, other, i);
    const bool was = original.samples[i] != 0;
    const bool is = other.samples[i] != 0;
    if (was != is) ++flips_;
    if (!was || !is) continue;
    const double error_mm = std::abs(depth_mm(original, i) - depth_mm(other, i));
    worst_mm_ = std::max(worst_mm_, error_mm);
    squares_mm2_ += error_mm * error_mm;
    ++measured_;
  }
  ++frames_;
}

void DepthDifference::hold(const DepthImage& original, const DepthImage& other, std::size_t pixel) {
  constexpr double kRounding_mm = 1e-6;  // rounding of the sums, far below any camera's unit
  const double before = depth_mm(original, pixel);
  const double after = depth_mm(other, pixel);
  const double allowed = 1000.0 * bound_->at(before / 1000.0);
  const bool is_held = (before == 0.0) == (after == 0.0) && std::abs(after - before) <= allowed + kRounding_mm;
  if (is_held) return;
  if (beyond_++ == 0) first_beyond_ = place(frames_, original, pixel) + in_mm(before, after, allowed);
}

double DepthDifference::rms_mm() const {
  return measured_ == 0 ? 0.0 : std::sqrt(squares_mm2_ / static_cast<double>(measured_));
}

}  // namespace telepalp::codec_tool
