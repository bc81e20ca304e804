#pragma once

#include <memory>
#include <optional>

#include "haptic_station/tissue/fem/elastic_motion.h"
#include "haptic_station/tissue/fem/local_plane.h"
#include "haptic_station/tissue/fem/prism_model.h"
#include "haptic_station/tissue/fem/prism_surface.h"

namespace telepalp::tissue {

/// Where the tool is. Passed: it pressed harder than PrismSettings::lets_go_N, or was inside from the beginning; it
/// feels nothing until it is outside.
enum class PrismContact { Free, Pressed, Passed };

/// A prism and the tool that pushes it, one step at a time: the slow computation behind the effect `fem_prism`. The
/// tool pushes the side through which it came in, until it leaves the prism through this side or beyond the side's
/// edge. Between tool and prism are S3's virtual coupling and a stiff spring (kPressed), in series; the plane that is
/// returned contains the coupling, but not this spring, so its force is that of a rigid contact. Owner: one thread.
class PrismTouch {
 public:
  explicit PrismTouch(std::shared_ptr<const PrismModel> model);

  /// The prism around the tool after a step of `dt_s`. nullopt: the tool's place is not a number, or the prism's motion
  /// diverged, after which the prism is at rest again and the tool has passed.
  [[nodiscard]] std::optional<LocalPlane> step(const Eigen::Vector3d& tool_m, double dt_s);

  [[nodiscard]] PrismContact contact() const noexcept { return contact_; }
  [[nodiscard]] double pressed_N() const noexcept { return pressed_N_; }  ///< force of the tool on the prism
  [[nodiscard]] const ElasticMotion& motion() const noexcept { return motion_; }
  [[nodiscard]] const StepOutcome& outcome() const noexcept { return outcome_; }  ///< of the last step
  /// Moves the nodes of the body: for tests of divergence.
  void disturb(const NodeField& at);

 private:
  static constexpr double kPressed = 20.0;  ///< stiffness of the contact over that of the prism's top
  void judge(const SidePoints& sides, const Eigen::Vector3d& tool_m);
  [[nodiscard]] bool meets(const SidePoints& sides, const Eigen::Vector3d& tool_m) const;
  bool move(double dt_s, const PatchContact* contact);
  [[nodiscard]] LocalPlane pushed(const SidePoint& spot, const Eigen::Vector3d& tool_m, double dt_s);
  [[nodiscard]] LocalPlane near(const SidePoints& sides, const Eigen::Vector3d& tool_m);
  [[nodiscard]] double felt_N_per_m(double compliance_m_per_N) const noexcept;

  std::shared_ptr<const PrismModel> model_;
  ElasticMotion motion_;
  PrismSurface surface_;
  PrismContact contact_ = PrismContact::Free;
  std::optional<PrismSide> side_;  ///< that is pressed, or that was nearest to the free tool; nullopt: not known yet
  bool at_rest_ = true;
  double pressed_N_ = 0.0;
  StepOutcome outcome_;
};

}  // namespace telepalp::tissue
