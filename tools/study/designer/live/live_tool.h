#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "haptic_station/mechanism/felt_linkage.h"
#include "haptic_station/mechanism/held_linkage.h"
#include "haptic_station/tissue/layered_tissue.h"
#include "tools/study/task/design.h"
#include "tools/study/task/linkage_places.h"
#include "tools/study/task/plant.h"

namespace telepalp::study {

/// Depth and forces at one instant of an insertion.
struct TracePoint {
  double depth_m = 0.0;  ///< of the tip below the skin
  double needle_N = 0.0;
  double hand_N = 0.0;
};

/// A puncture of a layer, as it was felt.
struct Puncture {
  std::size_t layer = 0;
  double depth_m = 0.0;
  double before_N = 0.0;  ///< force on the hand at the tick before
  double after_N = 0.0;   ///< least force on the hand in the 0.1 s after it
};

/// What is drawn at one instant. Places [m] and forces [N] are in the plane z = 0 of the tissue's frame, in which the
/// skin is y = 0 and the body is below it.
struct LiveFrame {
  LinkagePlaces at{};
  double link3_rad = 0.0;
  bool open = true;            ///< the linkage is on its open branch
  bool at_dead_point = false;  ///< links 1 and 2 lie on one line, nearly
  std::optional<mechanism::LinkPart> held{};
  std::optional<mechanism::LinkPart> touched{};
  Eigen::Vector2d grasp_m = Eigen::Vector2d::Zero();    ///< the held or touched point; the hand, if there is none
  Eigen::Vector2d needle_N = Eigen::Vector2d::Zero();   ///< of the tissue on the needle
  Eigen::Vector2d hand_N = Eigen::Vector2d::Zero();     ///< of the needle on the hand, through the linkage
  Eigen::Vector2d contact_N = Eigen::Vector2d::Zero();  ///< of the touched part, or of the grasp, on the hand
  std::array<tissue::LayerState, 3> layers{};
  std::array<Puncture, 3> punctures{};
  std::size_t punctured = 0;  ///< how many of `punctures` there are
};

/// A linkage that a hand turns while its needle is in tissue_of() of a plant: the code of the study and of the station,
/// at 2 kHz. A page moves the hand in virtual time, by step(); a haptic device moves and feels, by feel(). Pure. Owner:
/// the connection of one page, or the device's thread.
class LiveTool {
 public:
  using Model = std::shared_ptr<const tissue::TissueModel>;
  /// Fastest motion of the hand. A mouse jumps; faster tips would be no penetration.
  static constexpr double kFastest_m_per_s = 0.3;

  /// `tissue`: made of tissue_of(plant). The tip begins kAbove_m above the skin, and the hand is at the handle's end.
  /// Error: as of placed_linkage().
  [[nodiscard]] static Result<LiveTool> make(const Configuration& configuration, const Plant& plant, Model tissue);

  /// The place to which the hand moves. A place that is not finite is ignored.
  void aim(const Eigen::Vector2d& hand_m) noexcept;
  /// The hand takes hold of `part` at the point of its axis nearest to `at_m`.
  void take(mechanism::LinkPart part, const Eigen::Vector2d& at_m) noexcept;
  /// Moves the hand along the circle of the handle's end, by `by_rad` about pivot O. It takes hold there first.
  void turn(double by_rad) noexcept;
  /// The hand moves evenly to its place in `seconds`, at most as fast as kFastest_m_per_s. Returns a point of the trace
  /// for each 5 ms.
  std::vector<TracePoint> step(double seconds);
  /// Puts the needle in along the handle's way at 40 mm/s until its tip is `depth_m` below the skin, or it can go no
  /// deeper, and waits 0.2 s.
  std::vector<TracePoint> insert(double depth_m);
  /// Whole tissue, and the needle outside, held at the handle's end.
  void renew();

  /// Changes the linkage while it is in use: FeltLinkage::set().
  void change(const mechanism::FourBar& bar) noexcept { linkage_.set(bar); }
  /// Nobody holds the linkage, and where the hand is is not known: FeltLinkage::forget_hand().
  void forget_hand() noexcept { linkage_.forget_hand(); }
  /// One tick with a hand that feels: it is at `hand_m` and presses its button or not. Returns the force on it.
  [[nodiscard]] Force<HapticBase> feel(const Eigen::Vector3d& hand_m, bool pressed) noexcept;

  /// True while another step() would change neither forces nor pose: the hand is at its place, and nothing relaxes.
  [[nodiscard]] bool at_rest() const noexcept { return at_rest_; }
  [[nodiscard]] LiveFrame frame() const noexcept;
  [[nodiscard]] double depth_m() const noexcept { return -linkage_.tip().m.y(); }
  [[nodiscard]] TracePoint trace_point() const noexcept;
  [[nodiscard]] const mechanism::FeltLinkage& linkage() const noexcept { return linkage_; }
  [[nodiscard]] const mechanism::HeldLinkage& outside() const noexcept { return outside_; }

 private:
  LiveTool(const mechanism::HeldLinkage& outside, mechanism::FeltLinkage linkage, Model tissue);
  void tick(const Eigen::Vector3d& hand_m, bool pressed) noexcept;
  void note_punctures(double before_N) noexcept;
  void take_the_end() noexcept;
  [[nodiscard]] double hand_N() const noexcept;

  mechanism::HeldLinkage outside_;  ///< as it begins, held at the handle's end
  Model model_;
  mechanism::FeltLinkage fresh_;  ///< as it begins
  mechanism::FeltLinkage linkage_;
  tissue::LayeredTissue tissue_;
  Eigen::Vector3d hand_m_;
  Eigen::Vector3d aim_m_;
  std::array<Puncture, 3> punctures_{};
  std::size_t punctured_ = 0;
  int since_puncture_ = 0;  ///< ticks
  int ticks_ = 0;
  bool at_the_end_ = true;  ///< the hand holds the handle's end
  bool at_rest_ = true;
};

}  // namespace telepalp::study
