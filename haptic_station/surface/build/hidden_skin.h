#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "haptic_station/surface/build/object_regions.h"
#include "haptic_station/surface/depth/block_depths.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::surface {

/// Which part of an image is not the patient's skin, but an object over it, such as another person's hand.
struct Hidden {
  BlockLattice lattice;
  std::vector<std::uint8_t> block;  ///< 1: an object lies over the block, or beside it
  std::vector<float> shown;         ///< weight of the skin's nodes; 1: felt as it is, 0: there is no surface
  bool any = false;
  bool fades = false;         ///< some weight in `shown` is below 1
  bool over_place = false;    ///< an object lies over the device's place
  bool camera_moved = false;  ///< bed and body jumped together in this image

  /// Sets the pixels of all hidden blocks to "not measured".
  void blank(DepthField& depth) const;
};

/// Decides in each image which part of it is an object over the patient's skin. It remembers the skin's depth by block,
/// moves the memory with the body (BodyMotion), and looks for regions that lie nearer than it (NearerRegion). Such a
/// region is an object if
///   - what is new in the image covers less than half of what is seen, and
///   - depth steps up to it over most of its rim, where the remembered skin has no step: what rises smoothly out of the
///     skin around it, as a body that sits up, is skin, and
///   - the rest follows the body's motion within 3 mm, or the region came nearer by more than 12 mm in one image.
/// It stays an object until its rim has no more steps, or the doctor presses it: lifts the hand more than 30 mm
/// above it and comes down on it, while the object rests; or until the doctor accepts it as skin. A surface deeper than
/// the remembered skin is skin at once.
///
/// Under an object the share of the skin's force is 1 for 1 s. Then it falls to 2 % in 2 s, as the square of a straight
/// line: so a hand on its arm sinks in at a nearly even speed. Without the object the share returns the same way in 1
/// s. If the camera moved (camera_moved.h), there is no surface for 0.6 s, and all contacts end. Owner: surface thread.
class HiddenSkin {
 public:
  /// Adds the image `seen`, `dt_s` after the last one. `device`: the device's position, which tells whether the
  /// hand presses an object.
  const Hidden& add(const DepthField& seen, const Intrinsics& camera, double dt_s,
                    const std::optional<Point<DepthCamera>>& device);
  void restart() noexcept { *this = {}; }
  /// Makes the object over the device's place skin as soon as the device is above it. Without an object there, or when
  /// it leaves, this has no effect.
  void accept_object() noexcept { accepted_ = true; }

  [[nodiscard]] const Hidden& hidden() const noexcept { return hidden_; }

 private:
  void begin(const DepthField& seen);
  void begin_again();
  void carry();
  void judge();
  void forget_silhouette(const NearerRegion& region);
  [[nodiscard]] bool is_object(const NearerRegion& region) const;
  [[nodiscard]] bool jumped(const NearerRegion& region) const;
  void remember(double dt_s);
  void spread();
  void fade(double dt_s);
  void look_for_way_back(const std::vector<NearerRegion>& regions, std::vector<std::uint8_t>& is_object);
  void look_for_accepted(const std::vector<NearerRegion>& regions, std::vector<std::uint8_t>& is_object);
  [[nodiscard]] std::optional<float> over_place_m(const NearerRegion& region) const;
  void look_at_camera(double dt_s);
  void look_at_place(const Intrinsics& camera, const std::optional<Point<DepthCamera>>& device);

  BlockLattice lattice_;
  std::vector<float> depth_m_;       ///< of this image
  std::vector<float> before_m_;      ///< of the last image
  std::vector<float> remembered_m_;  ///< of the skin
  std::vector<float> doubted_s_;     ///< time for which a block has been nearer than the memory, by more than kGrown_m,
                                     ///< outside all objects
  std::vector<std::uint8_t> object_;  ///< 1: an object lies over the block
  std::vector<float> covered_s_;      ///< time for which the block has been hidden
  std::vector<float> root_;           ///< square root of the share of the skin's force
  std::vector<std::size_t> edge_;     ///< scratch of spread() and forget_silhouette()
  bool fits_ = true;                  ///< the rest of the body followed its motion in this image
  std::optional<std::size_t> place_;  ///< the device's block
  double device_z_m_ = 0.0;
  std::optional<float> clear_over_m_;  ///< depth of the object over which the device was clear
  bool accepted_ = false;              ///< the doctor accepted the object over the place
  double lets_go_s_ = 0.0;             ///< time for which there is still no surface, because the camera moved
  Hidden hidden_;
};

}  // namespace telepalp::surface
