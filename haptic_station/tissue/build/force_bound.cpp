#include "haptic_station/tissue/force_bound.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace telepalp::tissue {
namespace {

constexpr double kDeepest_m = 0.3;  // no layer begins deeper

/// Depth at which a fully relaxed net, `share` times as stiff as at its middle, is punctured. At most kDeepest_m: a
/// slow tip never punctures a net whose force relaxes to zero.
double bends_m(const LayerSettings& layer, double share) noexcept {
  double left = 1.0;
  for (int i = 0; i < layer.relaxation.branches; ++i) left -= layer.relaxation.share[i];
  const double a1 = share * std::max(0.0, left) * layer.surface->stiffness_N_per_m;
  const double a2 = share * layer.surface->stiffening_N_per_m2;
  const double at_N = layer.surface->punctures_at_N;
  // The root of a1 d + a2 d^2 = at_N, in the form that does not cancel.
  const double below = a1 + std::sqrt(a1 * a1 + 4.0 * a2 * at_N);
  return 2.0 * at_N < kDeepest_m * below ? 2.0 * at_N / below : kDeepest_m;
}

/// The most force of a net that is pushed `deep_m` deep and is not punctured. A tip that leans as far as the net's grip
/// allows adds its sideways force.
double pushed_N(const SurfaceSettings& surface, double share, double deep_m) noexcept {
  if (deep_m <= 0.0) return 0.0;
  const double lean = std::hypot(1.0, surface.side_grip);
  return share * lean * deep_m * (surface.stiffness_N_per_m + surface.stiffening_N_per_m2 * lean * deep_m);
}

/// The sum of the forces of all nets that the tip pushes when it punctures the net `first`. From outside, the tip also
/// pushes each inner net that lies within the depth by which `first` bends; none of them is punctured before `first`.
/// From inside, it also pushes outer nets, of which each is punctured by its own force. For an upper bound, `first` is
/// relaxed, so that it bends as far as it can, and the other nets have not relaxed.
double group_N(std::span<const LayerSettings> layers, std::size_t first, double share, bool from_inside) noexcept {
  const LayerSettings& met = layers[first];
  const double bends = bends_m(met, share);
  double sum_N = met.surface->punctures_at_N;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!layers[i].surface || (from_inside ? i >= first : i <= first)) continue;
    const double gap_m = std::abs(layers[i].top_m - met.top_m);
    const double force_N = pushed_N(*layers[i].surface, share, bends - gap_m);
    sum_N += from_inside ? std::min(force_N, layers[i].surface->punctures_at_N) : force_N;
  }
  return sum_N;
}

/// The greatest sum of the forces of all nets that one tip can push at once [N]. A stiffer net pushes more, but bends
/// less, so the greatest sum may lie within the range: the range is sampled.
double pushed_at_once_N(std::span<const LayerSettings> layers, const StiffnessRange& range) noexcept {
  constexpr int kSamples = 8;
  double most_N = 0.0;
  for (int k = 0; k <= kSamples; ++k) {
    const double share = range.least * std::pow(range.most / range.least, static_cast<double>(k) / kSamples);
    for (std::size_t i = 0; i < layers.size(); ++i)
      if (layers[i].surface)
        most_N = std::max({most_N, group_N(layers, i, share, false), group_N(layers, i, share, true)});
  }
  return most_N;
}

}  // namespace

double most_force_N(const TissueSettings& settings, const StiffnessRange& range) noexcept {
  double sum_N = pushed_at_once_N(settings.layers, range);
  for (const LayerSettings& layer : settings.layers) {
    if (layer.surface) sum_N += layer.surface->friction_N;
    if (layer.bulk)
      sum_N += layer.bulk->slips_at_N + layer.bulk->slips_at_N_per_m * layer.thickness_m + layer.bulk->cuts_at_N;
  }
  if (settings.shaft.side_N_per_m > 0.0)
    sum_N += settings.shaft.tears_at_N_per_m * (settings.layers.back().top_m + settings.layers.back().thickness_m);
  return sum_N;
}

}  // namespace telepalp::tissue
