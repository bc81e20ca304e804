#include "clients/report/compare/image_comparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "clients/report/compare/tick_comparison.h"
#include "clients/report/session/session_file.h"

namespace telepalp::report {
namespace {

using Times = std::vector<std::int64_t>;

constexpr std::size_t kDecoded = 3;

Times surface_times(const Session& session) {
  Times times;
  for (const msg::SurfaceReport& surface : session.surfaces)
    times.push_back(static_cast<std::int64_t>(surface.captured_ns()));
  return times;
}

Times in_order(Times times) {
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Times common(const Times& a, const Times& b) {
  Times both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/// Images that are missing in a run with `own` images, where the other run's rate gives `expected` in its duration.
std::size_t lacking(std::size_t own, double expected) {
  return static_cast<std::size_t>(std::max(0.0, std::floor(expected - static_cast<double>(own))));
}

}  // namespace

double ImageComparison::missing_pct() const noexcept {
  const std::size_t most = std::max(a, b);
  const std::size_t missing = std::max(missing_in_a, missing_in_b);
  return most == 0 ? kUnknown : 100.0 * static_cast<double>(missing) / static_cast<double>(most);
}

ImageComparison compare_images(const Session& a, const Session& b) {
  ImageComparison result;
  result.surfaces = a.depth_captured_ns.empty() || b.depth_captured_ns.empty();
  const Times of_a = in_order(result.surfaces ? surface_times(a) : a.depth_captured_ns);
  const Times of_b = in_order(result.surfaces ? surface_times(b) : b.depth_captured_ns);
  result.a = of_a.size();
  result.b = of_b.size();
  const std::size_t both = share_time(a, b) ? common(of_a, of_b).size() : 0;
  result.matched = both > 0;
  if (result.matched) {
    result.missing_in_a = result.b - both;
    result.missing_in_b = result.a - both;
    return result;
  }
  const double longer = seconds(a) > 0.0 && seconds(b) > 0.0 ? seconds(b) / seconds(a) : 1.0;
  const double expected_b = static_cast<double>(result.a) * longer, expected_a = static_cast<double>(result.b) / longer;
  result.missing_in_a = lacking(result.a, expected_a);
  result.missing_in_b = lacking(result.b, expected_b);
  return result;
}

void add_depths(ImageComparison& comparison, const DepthImage& a, const DepthImage& b) {
  comparison.sizes_differ = comparison.sizes_differ || a.width != b.width || a.height != b.height;
  if (a.width != b.width || a.height != b.height) return;
  std::vector<double> ratios, apart_mm;
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const double of_a = a.unit_m * a.samples[i], of_b = b.unit_m * b.samples[i];
    if (!(of_a > 0.0) || !(of_b > 0.0)) continue;
    ratios.push_back(of_b / of_a);
    apart_mm.push_back(1e3 * std::abs(of_b - of_a));
  }
  if (ratios.size() <= comparison.pixels) return;  // the image with the most pixels counts
  comparison.pixels = ratios.size();
  comparison.depth_ratio = quantiles(std::move(ratios)).p50;
  comparison.depth_apart_mm = quantiles(std::move(apart_mm)).p50;
}

Result<void> compare_depths(ImageComparison& comparison, const std::filesystem::path& file_a, const Session& a,
                            const std::filesystem::path& file_b, const Session& b) {
  if (comparison.surfaces || !comparison.matched) return {};
  const Times both = common(in_order(a.depth_captured_ns), in_order(b.depth_captured_ns));
  for (std::size_t i = 0; i < kDecoded; ++i) {
    const std::int64_t at_ns = both[(2 * i + 1) * both.size() / (2 * kDecoded)];
    const auto of_a = read_frame(file_a, a, at_ns);
    if (!of_a) return of_a.error();
    const auto of_b = read_frame(file_b, b, at_ns);
    if (!of_b) return of_b.error();
    if (*of_a && *of_b) add_depths(comparison, (**of_a).depth, (**of_b).depth);
  }
  return {};
}

}  // namespace telepalp::report
