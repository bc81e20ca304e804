#pragma once

#include <span>
#include <vector>

#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

/// Force on a needle that goes straight in, at one speed. Depths ascend; they begin before the contact.
struct InsertionCurve {
  std::vector<double> depth_m;
  std::vector<double> force_N;
};

struct InsertionFitSettings {
  int layers = 10;          ///< below the surface, 1 to 12
  double contact_N = 0.05;  ///< the depth is counted from the first place with more force than this
  double cell_m = 0.0005;   ///< curves are averaged over cells of this depth
  double speed_m_per_s = 0.005;
  double deepest_surface_m = 0.025;  ///< the surface is punctured above this depth
};

/// A tissue that is fitted to measured insertions, as paper S4 (docs/sources.md), section 6.4, proposes.
///
/// The first layer has a surface, which rises as a_1 d + a_2 d^2 until it is punctured (Mahvash and Dupont 2010). Each
/// layer has a bulk, with a force of cutting and a friction for each metre of the needle inside. The depths of the
/// puncture and of the layers' borders minimise the sum of squares, by dynamic programming over straight lines that do
/// not fall (RisingPieces). All forces come from a non-negative least-squares fit.
struct InsertionFit {
  TissueSettings tissue;
  double punctured_at_m = 0.0;  ///< depth of the tip below the contact
  double left_m = 0.0;          ///< depth below the contact that all curves reach
};

/// Fits one tissue to the mean of `curves`, weighted so that it minimises relative errors. Error: a curve has fewer than 40
/// samples, a value that is not finite, depths that do not ascend, no contact, or less than 30 mm behind it.
[[nodiscard]] Result<InsertionFit> fit_insertion(std::span<const InsertionCurve> curves,
                                                 const InsertionFitSettings& settings = {});

/// Root mean square of the difference between a curve and a needle in `fit.tissue` at the fit's speed, over the curve's
/// greatest force. Cells behind the end of the curve or of the fit are left out. Same errors as fit_insertion().
[[nodiscard]] Result<double> relative_error(const InsertionFit& fit, const InsertionCurve& curve,
                                            const InsertionFitSettings& settings = {});

}  // namespace telepalp::tissue
