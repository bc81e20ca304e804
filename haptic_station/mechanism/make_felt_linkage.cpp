#include "haptic_station/mechanism/felt_linkage.h"
#include "haptic_station/mechanism/planar_designs.h"

namespace telepalp::mechanism {

Result<FeltLinkage> FeltLinkage::make(const HeldLinkage& at, const FeltSettings& settings) {
  const PlanarDesign design = four_bar_design(at.bar(), at.link3_rad(), at.branch() == Branch::Open);
  const Result<HeldMechanism> mechanism = assembled(design.mechanism, design.near);
  if (!mechanism) return mechanism.error();
  return FeltLinkage(at, *mechanism, solids::Rods(kLinkParts), settings);
}

}  // namespace telepalp::mechanism
