#pragma once

#include "tools/study/protocol/hands/person_trial.h"
#include "tools/study/task/arm.h"

namespace telepalp::study {

/// The arm of a person at a browser. A mouse is not pushed back, so an arm is simulated between the pointer and the
/// handle, with Operator's middle values: the person moves its far end along the path of the handle, and the force
/// moves the hand, as that of a simulated operator.
[[nodiscard]] inline Operator browser_arm() noexcept { return {}; }

/// The hand of a person at a browser. Pure.
class BrowserHand final : public HandMotion {
 public:
  /// Fastest motion of the arm's far end. A pointer jumps; faster tips would be no penetration.
  static constexpr double kFastest_m_per_s = 0.3;
  /// Bounds of the arm's far end on the path, from where the hand begins.
  static constexpr double kLeast_m = -0.02;
  static constexpr double kMost_m = 0.6;

  BrowserHand(const HeldTool& tool, Condition condition) noexcept
      : condition_(condition), arm_(browser_arm(), tool.on_the_way_m(0.0)) {}
  /// The person moves the arm's far end by `way_m` along the path. A number that is not finite is ignored.
  void push(double way_m) noexcept;
  /// The far end goes evenly to its place within the next `ticks` ticks, at most as fast as kFastest_m_per_s.
  void begin_step(int ticks) noexcept;
  [[nodiscard]] Eigen::Vector3d next_m(const Insertion& insertion) noexcept override;
  [[nodiscard]] double way_m() const noexcept { return way_m_; }

 private:
  Condition condition_;
  Arm arm_;
  double way_m_ = 0.0;
  double aim_m_ = 0.0;
  double each_tick_m_ = 0.0;
};

/// One penetration by a person at a browser, in real time. Owner: the network thread.
class BrowserTrial final : public PersonTrial {
 public:
  BrowserTrial(Prepared prepared, Condition condition) noexcept
      : prepared_(std::move(prepared)), hand_(*prepared_.tool, condition), condition_(condition) {}

  void push(double way_m) noexcept override;
  /// The part of the motion along the path counts.
  void move(const Eigen::Vector2d& by_m) noexcept override;
  /// More than kLongestStep_s is lost, so that a program that was late gives a slow hand and not a fast one.
  void step(double seconds, Ticks& ticks) override;
  static constexpr double kLongestStep_s = 0.05;

  [[nodiscard]] TrialView view() const noexcept override;
  [[nodiscard]] const Insertion& insertion() const noexcept { return *prepared_.insertion; }

 private:
  Prepared prepared_;
  BrowserHand hand_;
  Condition condition_;
  bool moved_ = false;
  double left_s_ = 0.0;  // time that no tick has covered yet
  double held_up_s_ = 0.0;
};

}  // namespace telepalp::study
