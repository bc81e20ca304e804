#pragma once

#include <memory>

#include "tools/study/person/operator.h"
#include "tools/study/task/arm.h"
#include "tools/study/task/insertion.h"

namespace telepalp::study {

/// All that one penetration by a simulated operator depends on.
struct Penetration {
  HeldTool& tool;
  const std::shared_ptr<const tissue::TissueModel>& tissue;
  const Operator& person;
  Condition condition;
};

/// The hand of a simulated operator: it decides, and the arm follows. Pure.
class SimulatedHand final : public HandMotion {
 public:
  SimulatedHand(const Penetration& one, const Learned& learned, device::Random& random) noexcept;
  [[nodiscard]] Eigen::Vector3d next_m(const Insertion& insertion) noexcept override;
  [[nodiscard]] const Decisions& decisions() const noexcept { return decisions_; }

 private:
  Condition condition_;
  Decisions decisions_;
  Arm arm_;
  double way_m_ = 0.0;  // of the arm's far end, on the path of the hand
};

/// Runs at 2 kHz; `learned` gets the depth of this puncture, as the operator sensed it. Pure.
[[nodiscard]] Outcome penetrate(const Penetration& one, Learned& learned, device::Random& random) noexcept;

}  // namespace telepalp::study
