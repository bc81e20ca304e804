#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

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
  LinkagePlaces at;
  double link3_rad = 0.0;
  bool at_dead_point = false;  ///< links 1 and 2 lie on one line, nearly
  Eigen::Vector2d needle_N;    ///< of the tissue on the needle
  Eigen::Vector2d hand_N;      ///< of the needle on the hand, through the linkage
  std::array<tissue::LayerState, 3> layers{};
};

/// A linkage that a hand turns while its needle is in tissue_of() of a plant: the code of the study and of the station,
/// at 2 kHz in virtual time. Pure. Owner: the connection of one page.
class LiveTool {
 public:
  using Model = std::shared_ptr<const tissue::TissueModel>;
  /// Fastest motion of the hand. A mouse jumps; faster tips would be no penetration.
  static constexpr double kFastest_m_per_s = 0.3;

  /// `tissue`: made of tissue_of(plant). The tip begins kAbove_m above the skin. Error: as of placed_linkage().
  [[nodiscard]] static Result<LiveTool> make(const Configuration& configuration, const Plant& plant, Model tissue);

  /// The place to which the hand moves. A place that is not finite is ignored.
  void aim(const Eigen::Vector2d& hand_m) noexcept;
  /// Moves this place along the circle of the handle's end, by `by_rad` about pivot O.
  void turn(double by_rad) noexcept;
  /// The hand moves evenly to its place in `seconds`, at most as fast as kFastest_m_per_s. Returns a point of the trace
  /// for each 5 ms.
  std::vector<TracePoint> step(double seconds);
  /// Puts the needle in along the handle's way at 40 mm/s until its tip is `depth_m` below the skin, or it can go no
  /// deeper, and waits 0.2 s.
  std::vector<TracePoint> insert(double depth_m);
  /// Whole tissue, and the needle outside.
  void renew();

  /// True while another step() would change neither forces nor pose: the hand is at its place, and nothing relaxes.
  [[nodiscard]] bool at_rest() const noexcept { return at_rest_; }
  [[nodiscard]] LiveFrame frame() const noexcept;
  [[nodiscard]] double depth_m() const noexcept { return -held_.tip().m.y(); }
  [[nodiscard]] const std::vector<Puncture>& punctures() const noexcept { return punctures_; }
  [[nodiscard]] const mechanism::HeldLinkage& held() const noexcept { return held_; }

 private:
  LiveTool(const mechanism::HeldLinkage& held, Model tissue);
  void tick();
  void note_punctures(double before_N);
  [[nodiscard]] double hand_N() const noexcept;

  mechanism::HeldLinkage outside_;  ///< as it begins
  Model model_;
  mechanism::HeldLinkage held_;
  tissue::LayeredTissue tissue_;
  Eigen::Vector3d hand_m_;
  Eigen::Vector3d aim_m_;
  std::vector<Puncture> punctures_;
  int since_puncture_ = 0;  ///< ticks
  int ticks_ = 0;
  bool at_rest_ = true;
};

}  // namespace telepalp::study
