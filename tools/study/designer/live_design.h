#pragma once

#include <optional>
#include <string>

#include "tools/study/designer/live/live_tool.h"
#include "tools/study/designer/live/reach.h"

namespace telepalp::study {

/// The linkage on the page, and the answers of the program about it, as JSON (mm, N, rad). A linkage that cannot be
/// used is refused with a sentence, and the last one that could be used stays. Pure. Owner: the connection of one page.
class LiveDesign {
 public:
  /// The linkage is S4's first one, on Plant{}. Error: the tissue cannot be made.
  [[nodiscard]] static Result<LiveDesign> make();

  /// Takes `wanted`. Its needle goes in as deep as the needle of the last linkage was, so that forces can be compared
  /// while a length changes. Returns `design` with its survey, or `refused` with the sentence.
  [[nodiscard]] std::string choose(const Configuration& wanted);
  /// Takes `wanted` while a hand at a device holds the linkage as `now` has it, with the needle where it is. Returns
  /// `design` or `refused`, as choose().
  [[nodiscard]] std::string change(const Configuration& wanted, const LiveFrame& now);
  void take(mechanism::LinkPart part, const Eigen::Vector2d& at_m) noexcept { tool_.take(part, at_m); }
  void aim(const Eigen::Vector2d& hand_m) noexcept { tool_.aim(hand_m); }
  void turn(double by_rad) noexcept { tool_.turn(by_rad); }
  /// Whole tissue, and the needle outside. Returns `design`, as choose().
  [[nodiscard]] std::string renew();
  /// Goes on by `seconds`. Returns `frame`; nullopt: at rest, so nothing changed.
  [[nodiscard]] std::optional<std::string> step(double seconds);

  [[nodiscard]] const Configuration& design() const noexcept { return design_; }
  [[nodiscard]] const LiveTool& tool() const noexcept { return tool_; }

 private:
  LiveDesign(Configuration design, LiveTool tool, LiveTool::Model tissue);
  [[nodiscard]] std::string answer(const std::vector<TracePoint>& trace) const;
  void use(LiveTool tool);

  Configuration design_;
  LiveTool tool_;
  std::optional<LiveTool> next_;  ///< of the linkage that change() took; renew() needs it
  LiveTool::Model tissue_;
  Reach reach_;
  double put_in_m_ = 0.0;  ///< depth to which the hand put the tip; a change of the linkage leaves it
};

}  // namespace telepalp::study
