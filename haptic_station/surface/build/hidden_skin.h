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
  std::vector<float> shown;  ///< share to which the remembered skin counts: 1 where nothing hides it, and for 1 s under
                             ///< an object; then it falls within 2 s, to 2 % of the force
  bool any = false;
  bool over_place = false;  ///< an object lies over the device's place

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
/// It stays an object until its rim has no more steps, or a way back is taken: the doctor's hand was more than 30 mm
/// clear over it and comes down to it, or admit() is called. What is farther than the memory is skin at once. Owner:
/// surface thread.
class HiddenSkin {
 public:
  /// Adds the image `seen`, `dt_s` after the last one. `device`: the device's position, for the way back.
  const Hidden& add(const DepthField& seen, const Intrinsics& camera, double dt_s,
                    const std::optional<Point<DepthCamera>>& device);
  /// From the next image on, all that is seen now counts as skin.
  void admit() noexcept { admits_ = true; }
  void restart() noexcept { *this = {}; }

  [[nodiscard]] const Hidden& hidden() const noexcept { return hidden_; }

 private:
  void begin(const DepthField& seen);
  void carry();
  void judge();
  [[nodiscard]] bool is_object(const NearerRegion& region) const;
  [[nodiscard]] bool jumped(const NearerRegion& region) const;
  void remember(double dt_s);
  void spread();
  void fade(double dt_s);
  void look_for_way_back(const std::vector<NearerRegion>& regions, std::vector<std::uint8_t>& is_object);
  void look_at_place(const Intrinsics& camera, const std::optional<Point<DepthCamera>>& device);

  BlockLattice lattice_;
  std::vector<float> depth_m_;       ///< of this image
  std::vector<float> before_m_;      ///< of the last image
  std::vector<float> remembered_m_;  ///< of the skin
  std::vector<float> doubted_s_;     ///< time for which a block has been nearer than the memory, by less than kNearer_m
  std::vector<std::uint8_t> object_;  ///< 1: an object lies over the block
  std::vector<float> covered_s_;      ///< time for which the block has been hidden
  std::vector<std::size_t> edge_;     ///< scratch of spread()
  bool fits_ = true;                  ///< the rest of the body followed its motion in this image
  bool admits_ = false;
  std::optional<std::size_t> place_;  ///< the device's block
  double device_z_m_ = 0.0;
  std::optional<float> clear_over_m_;  ///< depth of the object over which the device was clear
  Hidden hidden_;
};

}  // namespace telepalp::surface
