#include "haptic_station/surface/depth/disparity_levels.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "codec/levels/disparity_law.h"

namespace telepalp::surface {
namespace {

constexpr double kFarthest_m = 3.0;      // a patient is nearer; far samples of a stereo camera are often errors
constexpr std::size_t kFewest = 40;      // least number of levels
constexpr double kLeastOnLevels = 0.95;  // share of the pixels
constexpr double kLeastMissing = 0.2;    // share of the values of the range that are no level
constexpr double kLeastBend = 1.5;       // least deviation of the levels from ones evenly spaced in z [unit]
constexpr double kNearLevel = 0.7;       // a sample farther from its level does not take part in the fit [unit]
constexpr int kRounds = 60;              // iterations of Lawson's algorithm

/// A sample and the number of its level.
struct Numbered {
  double sample;
  double level;
};

std::vector<std::uint16_t> samples_up_to(const SampleCounts& counts, double farthest) {
  const auto end = std::min<std::size_t>(counts.size(), static_cast<std::size_t>(std::min(farthest, 65535.0)) + 1);
  std::vector<std::uint16_t> samples;
  for (std::size_t sample = 1; sample < end; ++sample)
    if (counts[sample] > 0) samples.push_back(static_cast<std::uint16_t>(sample));
  return samples;
}

double number_of(const DisparityLevels& levels, double sample) {
  return std::round((1.0 / sample - levels.farthest_per_unit) / levels.step_per_unit);
}

double depth_at(const DisparityLevels& levels, double number) {
  return 1.0 / (levels.farthest_per_unit + levels.step_per_unit * number);
}

/// Weighted least squares of 1/z over the level's number. An error of z changes 1/z in proportion to 1/z².
DisparityLevels fit_of(std::span<const Numbered> all, std::span<const double> weights) {
  double w = 0.0, wn = 0.0, wnn = 0.0, wi = 0.0, wni = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [sample, level] = all[i];
    const double weight = weights[i] * sample * sample * sample * sample;
    w += weight;
    wn += weight * level;
    wnn += weight * level * level;
    wi += weight / sample;
    wni += weight * level / sample;
  }
  const double step = (w * wni - wn * wi) / (w * wnn - wn * wn);
  return {(wi - step * wn) / w, step};
}

/// The levels whose largest distance from a sample is the least, by Lawson's algorithm. Rounding bounds each distance
/// by half a unit; many such bounds locate the levels far better than a mean over the distances does.
DisparityLevels sharpened(DisparityLevels levels, std::span<const std::uint16_t> samples) {
  std::vector<Numbered> near;
  for (const std::uint16_t sample : samples)
    if (levels.miss_of(sample) < kNearLevel) near.push_back({static_cast<double>(sample), number_of(levels, sample)});
  if (near.size() < kFewest) return levels;
  std::vector<double> weights(near.size(), 1.0);
  for (int round = 0; round < kRounds; ++round) {
    const DisparityLevels better = fit_of(near, weights);
    if (!(better.step_per_unit > 0.0) || !(better.farthest_per_unit > 0.0)) return levels;
    levels = better;
    double sum = 0.0;
    for (std::size_t i = 0; i < near.size(); ++i) {
      weights[i] *= std::abs(depth_at(levels, near[i].level) - near[i].sample) + 1e-6;
      sum += weights[i];
    }
    for (double& weight : weights) weight /= sum;
  }
  return levels;
}

/// True if too many values are missing for a sensor that gives every value.
bool leaves_gaps(std::span<const std::uint16_t> samples) {
  const double range = samples.back() - samples.front() + 1.0;
  return static_cast<double>(samples.size()) <= (1.0 - kLeastMissing) * range;
}

/// True if enough values of [nearest, farthest] have no level, and the levels are spaced unevenly enough in z, that
/// samples of another sensor would not fit them.
bool is_telling(const DisparityLevels& levels, double nearest, double farthest) {
  double missing = 0.0;
  for (double value = nearest; value <= farthest; value += 1.0)
    missing += levels.miss_of(value) > DisparityLevels::kMostMiss ? 1.0 : 0.0;
  const double middle = 2.0 / (1.0 / nearest + 1.0 / farthest);
  const double steps = (1.0 / nearest - 1.0 / farthest) / levels.step_per_unit;
  const double bend = std::pow(middle, 3.0) * std::pow(levels.step_per_unit * steps, 2.0) / 4.0;
  return missing >= kLeastMissing * (farthest - nearest + 1.0) && bend >= kLeastBend;
}

}  // namespace

double DisparityLevels::miss_of(double sample) const noexcept {
  return std::abs(depth_at(*this, number_of(*this, sample)) - sample);
}

double DisparityLevels::depth_of(double sample) const noexcept {
  const double nearest = number_of(*this, sample);
  double sum = 0.0;
  double count = 0.0;
  for (const double way : {1.0, -1.0})
    for (double level = way > 0.0 ? nearest : nearest - 1.0;; level += way) {
      const double depth = depth_at(*this, level);
      if (!(std::abs(depth - sample) <= kMostMiss)) break;
      sum += depth;
      count += 1.0;
    }
  return count > 0.0 ? sum / count : sample;
}

double DisparityLevels::share_on_levels(const SampleCounts& counts) const noexcept {
  double on = 0.0;
  double all = 0.0;
  for (std::size_t sample = 1; sample < counts.size(); ++sample) {
    if (counts[sample] == 0) continue;
    const double count = counts[sample];
    all += count;
    on += miss_of(static_cast<double>(sample)) <= kMostMiss ? count : 0.0;
  }
  return all > 0.0 ? on / all : 0.0;
}

SampleCounts counts_of(const DepthImage& depth) {
  SampleCounts counts(65536, 0);
  for (const std::uint16_t sample : depth.samples) ++counts[sample];
  counts[0] = 0;
  return counts;
}

/// Near levels may be less than a unit apart and then cannot be numbered. So the fit also starts from the farther half
/// and the farthest quarter of the levels, and goes on to all.
std::optional<DisparityLevels> disparity_levels_of(const SampleCounts& counts, double unit_m) {
  const std::vector<std::uint16_t> samples = samples_up_to(counts, kFarthest_m / unit_m);
  if (samples.size() < kFewest || !leaves_gaps(samples)) return std::nullopt;
  const SampleCounts used(counts.begin(), counts.begin() + samples.back() + 1);
  for (const std::size_t quarters : {std::size_t{0}, std::size_t{2}, std::size_t{3}}) {
    const auto far = std::span(samples).subspan(samples.size() * quarters / 4);
    if (far.size() < kFewest) break;
    const auto law = codec::fit_disparity_law(far);
    if (!law) continue;
    constexpr double kOne = static_cast<double>(codec::DisparityLaw::kOne);
    DisparityLevels levels{static_cast<double>(law->farthest) / kOne, static_cast<double>(law->step) / kOne};
    for (const auto part : {far, std::span(samples)}) levels = sharpened(levels, part);
    if (levels.share_on_levels(used) >= kLeastOnLevels && is_telling(levels, samples.front(), samples.back()))
      return levels;
  }
  return std::nullopt;
}

}  // namespace telepalp::surface
