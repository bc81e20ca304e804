#pragma once

#include <Eigen/Core>
#include <string_view>
#include <variant>

#include "haptic_station/mechanism/felt_linkage.h"
#include "proto/words/result.h"
#include "tools/study/search/search_box.h"
#include "tools/study/task/design.h"

namespace telepalp::study {

/// A new linkage, on whole tissue.
struct ChooseDesign {
  Configuration design;
};
/// The hand takes hold of a part at the point of its axis nearest to a place in the plane z = 0 of the tissue's frame.
struct TakePart {
  mechanism::LinkPart part;
  Eigen::Vector2d at_m;
};
/// The page's own button for a hand at a haptic device.
struct PressButton {
  bool pressed = false;
};
/// The hand moves to a place in the plane z = 0 of the tissue's frame [m].
struct AimHand {
  Eigen::Vector2d at_m;
};
/// The hand goes on along the handle's way by this angle about pivot O [rad].
struct TurnHandle {
  double by_rad = 0.0;
};
/// Whole tissue, and the needle outside.
struct RenewTissue {};
/// The overshoot of the linkage that was chosen last.
struct AskPrediction {};
struct BeginSearch {
  SearchBox box;
  int evaluations = 0;
};
struct EndSearch {};

/// What the designer's page asks of the program.
using Command = std::variant<ChooseDesign, TakePart, AimHand, PressButton, TurnHandle, RenewTissue, AskPrediction,
                             BeginSearch, EndSearch>;

/// A longer message is refused before it is read.
inline constexpr std::size_t kMostCommandBytes = 1024;
inline constexpr int kMostEvaluations = 2000;

/// Reads a message of the page: one line, such as `design l1=80 l2=150 l4=131` (mm and rad, as in a list of
/// mechanisms), `take link1 10.5 120` (mm), `hand 10.5 120` (mm), `press 1`, `turn 0.01` (rad), `renew`, `predict`,
/// `search 120 l1=60:120 l2=150`, `cancel`. Error: another word, a number that is not finite or out of bounds, or a
/// linkage that cannot be built.
[[nodiscard]] Result<Command> parse_command(std::string_view message);

}  // namespace telepalp::study
