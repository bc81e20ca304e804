#include "haptic_station/surface/build/hidden_skin.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/build/body_motion.h"
#include "haptic_station/surface/build/camera_moved.h"
#include "haptic_station/surface/build/patch_terms.h"

namespace telepalp::surface {
namespace {

constexpr double kFits_m = 0.003;    // rms deviation of the rest of the body from rise and tilt; a breath stays below
constexpr float kJump_m = 0.012F;    // a patient who sits up comes 5 mm nearer from image to image
constexpr double kEdgeShare = 0.6;   // least share of steps on a new object's rim
constexpr double kStillEdges = 0.3;  // the same for a region that an object hid before
constexpr int kLeastRim = 4;  // places of a rim that decide; with fewer, one that was hidden, or jumped, is an object
constexpr std::size_t kLeastBlocks = 3;
constexpr double kMostShare = 0.5;  // of the measured blocks: if new objects cover more, too little of the body is left
constexpr float kDoubted_s = 0.3F;  // how long skin may differ from the memory before the memory follows
constexpr float kFelt_s = 1.0F;     // for so long the remembered skin is felt under an object
constexpr float kFades_s = 2.0F;    // after kFelt_s, it fades over this time
constexpr float kReturns_s = 1.0F;  // over this time it returns
// 2 % of the force: a contact under an object goes on, because its end would lift the hand off the body with up to 1 N.
constexpr float kLeastRoot = 0.14F;
constexpr double kLetsGo_s = 0.6;    // a contact whose surface is gone ends after 0.5 s
constexpr float kClear_m = 0.03F;    // a hand farther above an object than this may press it afterwards
constexpr float kPresses_m = 0.01F;  // at this height it presses the object
constexpr float kRests_m = 0.01F;    // most change of the object's depth in between: it did not come to the hand
constexpr int kPlace_blocks = 4;     // 24 mm around the device

/// The weight of a node whose coverage, a smooth step of it, is `share`.
float weight_of(float share) noexcept { return 0.5F - std::sin(std::asin(1.0F - 2.0F * share) / 3.0F); }

template <class Visit>
void for_neighbours(const BlockLattice& lattice, std::size_t at, int reach, const Visit& visit) {
  const int column = static_cast<int>(at % static_cast<std::size_t>(lattice.columns));
  const int row = static_cast<int>(at / static_cast<std::size_t>(lattice.columns));
  for (int r = std::max(0, row - reach); r <= std::min(lattice.rows - 1, row + reach); ++r)
    for (int c = std::max(0, column - reach); c <= std::min(lattice.columns - 1, column + reach); ++c)
      visit(lattice.at(c, r));
}

}  // namespace

void Hidden::blank(DepthField& depth) const {
  if (!any) return;
  constexpr int kBlock = BlockLattice::kBlock_px;
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column) {
      if (block[lattice.at(column, row)] == 0) continue;
      const int right = std::min(depth.width, (column + 1) * kBlock);
      for (int v = row * kBlock; v < std::min(depth.height, (row + 1) * kBlock); ++v)
        std::fill(&depth.z_m[depth.index(column * kBlock, v)], &depth.z_m[depth.index(0, v)] + right, 0.0F);
    }
}

void HiddenSkin::begin(const DepthField& seen) {
  lattice_ = hidden_.lattice = blocks_of(seen.width, seen.height);
  begin_again();
}

void HiddenSkin::begin_again() {
  const std::size_t size = lattice_.size();
  object_.assign(size, 0);
  doubted_s_.assign(size, 0.0F);
  covered_s_.assign(size, 0.0F);
  root_.assign(size, 1.0F);
  hidden_.block.assign(size, 0);
  hidden_.shown.assign(size, 1.0F);
  hidden_.any = hidden_.fades = hidden_.over_place = accepted_ = false;
  remembered_m_ = before_m_ = depth_m_;
  clear_over_m_.reset();
}

const Hidden& HiddenSkin::add(const DepthField& seen, const Intrinsics& camera, double dt_s,
                              const std::optional<Point<DepthCamera>>& device) {
  const BlockLattice lattice = blocks_of(seen.width, seen.height);
  block_depths(seen, lattice, depth_m_);
  if (lattice.columns != lattice_.columns || lattice.rows != lattice_.rows) {
    begin(seen);
    return hidden_;
  }
  look_at_place(camera, device);
  look_at_camera(dt_s);
  carry();
  judge();
  spread();
  remember(dt_s);
  fade(dt_s);
  before_m_ = depth_m_;
  return hidden_;
}

/// Moves the memory with the body. Blocks that an object hides do not count as the body.
void HiddenSkin::carry() {
  std::vector<float> body_m = remembered_m_;
  for (std::size_t at = 0; at < body_m.size(); ++at)
    if (object_[at] != 0) body_m[at] = 0.0F;
  const BodyMotion motion = body_motion(lattice_, body_m, depth_m_);
  fits_ = motion.off_m <= kFits_m;
  for (int row = 0; row < lattice_.rows; ++row)
    for (int column = 0; column < lattice_.columns; ++column) {
      float& skin_m = remembered_m_[lattice_.at(column, row)];
      if (skin_m > 0.0F) skin_m -= static_cast<float>(motion.at(column, row));
    }
}

bool HiddenSkin::is_object(const NearerRegion& region) const {
  const int known = region.edges + region.smooth;
  const bool was = 2 * region.hidden > static_cast<int>(region.blocks.size());
  if (region.blocks.size() < kLeastBlocks) return was;
  if (known < kLeastRim) return region.hidden > 0 || jumped(region);  // doubt: less force
  const double edges = static_cast<double>(region.edges) / known;
  if (region.hidden > 0) return edges >= kStillEdges;
  if (edges < kEdgeShare) return false;
  return fits_ || jumped(region);
}

bool HiddenSkin::jumped(const NearerRegion& region) const {
  const auto count = std::count_if(region.blocks.begin(), region.blocks.end(), [&](std::uint32_t at) {
    const float from_m = before_m_[at] > 0.0F ? before_m_[at] : remembered_m_[at];  // not measured: from the memory
    return from_m - depth_m_[at] > kJump_m;
  });
  return 2 * count > static_cast<std::ptrdiff_t>(region.blocks.size());
}

void HiddenSkin::judge() {
  const std::vector<NearerRegion> regions = nearer_regions(lattice_, {depth_m_, remembered_m_, object_});
  const auto measured =
      static_cast<double>(std::count_if(depth_m_.begin(), depth_m_.end(), [](float z_m) { return z_m > 0.0F; }));
  std::vector<std::uint8_t> is(regions.size(), 0);
  double covered = 0.0;  // by what was not an object before: an object that comes nearer may cover all
  for (std::size_t i = 0; i < regions.size(); ++i) {
    is[i] = is_object(regions[i]) ? 1 : 0;
    if (is[i] != 0) covered += static_cast<double>(regions[i].blocks.size()) - regions[i].hidden;
  }
  if (covered > kMostShare * measured) std::fill(is.begin(), is.end(), std::uint8_t{0});
  const std::vector<std::uint8_t> was = is;
  look_for_way_back(regions, is);
  look_for_accepted(regions, is);
  // Where nothing is measured, an object that lay there is still there: its silhouette is ragged.
  for (std::size_t at = 0; at < object_.size(); ++at)
    if (depth_m_[at] > 0.0F) object_[at] = 0;
  for (std::size_t i = 0; i < regions.size(); ++i)
    for (const std::uint32_t at : regions[i].blocks) {
      object_[at] = is[i];
      if (is[i] == 0 && regions[i].blocks.size() >= kLeastBlocks) remembered_m_[at] = depth_m_[at];
    }
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (was[i] != 0 && is[i] == 0) forget_silhouette(regions[i]);
}

/// An object became skin. Around it lie blocks that are not measured, and they were its silhouette: they are no object
/// now. Otherwise the page would go on saying that something lies over the place.
void HiddenSkin::forget_silhouette(const NearerRegion& region) {
  edge_.assign(region.blocks.begin(), region.blocks.end());
  while (!edge_.empty()) {
    const std::size_t at = edge_.back();
    edge_.pop_back();
    for_neighbours(lattice_, at, 1, [&](std::size_t beside) {
      if (object_[beside] == 0 || depth_m_[beside] > 0.0F) return;
      object_[beside] = 0;
      edge_.push_back(beside);
    });
  }
}

/// The doctor's hand was clear over the object, and comes down to it while the object rests: it presses the object.
void HiddenSkin::look_for_way_back(const std::vector<NearerRegion>& regions, std::vector<std::uint8_t>& is_object) {
  if (!place_) return clear_over_m_.reset();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (is_object[i] == 0) continue;
    const auto& blocks = regions[i].blocks;
    if (std::find(blocks.begin(), blocks.end(), static_cast<std::uint32_t>(*place_)) == blocks.end()) continue;
    const float over_m = depth_m_[*place_] - static_cast<float>(device_z_m_);
    if (over_m > kClear_m) clear_over_m_ = depth_m_[*place_];
    if (!clear_over_m_ || over_m > kPresses_m) return;
    if (std::abs(depth_m_[*place_] - *clear_over_m_) < kRests_m) is_object[i] = 0;
    return clear_over_m_.reset();
  }
  clear_over_m_.reset();
}

/// Height [m] of the object above the device, close to its place; nullopt: the object does not lie there.
std::optional<float> HiddenSkin::over_place_m(const NearerRegion& region) const {
  std::optional<float> over_m;
  // One block further than hidden_.over_place looks, because an object hides the blocks beside it, too (spread()).
  for_neighbours(lattice_, *place_, kPlace_blocks + 1, [&](std::size_t at) {
    if (std::find(region.blocks.begin(), region.blocks.end(), static_cast<std::uint32_t>(at)) == region.blocks.end())
      return;
    const float here_m = static_cast<float>(device_z_m_) - depth_m_[at];
    over_m = std::max(over_m.value_or(here_m), here_m);
  });
  return over_m;
}

/// An accepted object waits until the device is above it. Otherwise its surface would push the device out. It also
/// waits while only its shadow reaches the place: the page says that it lies there, so the doctor's press must not be
/// lost.
void HiddenSkin::look_for_accepted(const std::vector<NearerRegion>& regions, std::vector<std::uint8_t>& is_object) {
  if (!accepted_ || !place_) return;
  bool waits = false;
  bool is_near = false;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (is_object[i] == 0) continue;
    const std::optional<float> over_m = over_place_m(regions[i]);
    is_near = is_near || over_m;
    if (over_m && *over_m <= 0.0F)
      is_object[i] = 0;
    else
      waits = waits || over_m;
  }
  accepted_ = waits || (!is_near && hidden_.over_place);
}

/// After a move of the camera, all that was remembered lies elsewhere.
void HiddenSkin::look_at_camera(double dt_s) {
  lets_go_s_ = std::max(0.0, lets_go_s_ - dt_s);
  hidden_.camera_moved = camera_moved(lattice_, before_m_, depth_m_);
  if (!hidden_.camera_moved) return;
  begin_again();
  lets_go_s_ = kLetsGo_s;
}

/// Takes over what is skin. A block that is a little nearer than the memory may be the rim of an object that comes, so
/// the memory waits.
void HiddenSkin::remember(double dt_s) {
  for (std::size_t at = 0; at < remembered_m_.size(); ++at) {
    const float z_m = depth_m_[at];
    float& skin_m = remembered_m_[at];
    if (z_m <= 0.0F || object_[at] != 0 || (skin_m <= 0.0F && hidden_.block[at] != 0)) continue;
    const float nearer_m = skin_m - z_m;
    doubted_s_[at] =
        skin_m > 0.0F && nearer_m > static_cast<float>(kGrown_m) ? doubted_s_[at] + static_cast<float>(dt_s) : 0.0F;
    if (doubted_s_[at] > 0.0F && doubted_s_[at] < kDoubted_s) continue;
    doubted_s_[at] = 0.0F;
    skin_m = z_m;
  }
}

/// An object also hides the blocks beside it, which show a part of it, and all blocks connected to these that are
/// unmeasured now or have no remembered skin: they are in its shadow, the object is too near to the camera there, or
/// the skin there was never seen.
void HiddenSkin::spread() {
  std::vector<std::uint8_t>& block = hidden_.block;
  block = object_;
  edge_.clear();
  for (std::size_t at = 0; at < object_.size(); ++at) {
    if (object_[at] == 0) continue;
    edge_.push_back(at);
    for_neighbours(lattice_, at, 1, [&](std::size_t beside) {
      if (block[beside] == 0) edge_.push_back(beside);
      block[beside] = 1;
    });
  }
  hidden_.any = !edge_.empty();
  while (!edge_.empty()) {
    const std::size_t at = edge_.back();
    edge_.pop_back();
    for_neighbours(lattice_, at, 1, [&](std::size_t beside) {
      if (block[beside] != 0 || (depth_m_[beside] > 0.0F && remembered_m_[beside] > 0.0F)) return;
      block[beside] = 1;
      edge_.push_back(beside);
    });
  }
}

void HiddenSkin::fade(double dt_s) {
  const auto step_s = static_cast<float>(dt_s);
  hidden_.fades = false;
  for (std::size_t at = 0; at < hidden_.block.size(); ++at) {
    const bool hides = hidden_.block[at] != 0;
    float& root = root_[at];
    covered_s_[at] = hides ? covered_s_[at] + step_s : 0.0F;
    if (lets_go_s_ > 0.0)
      root = 0.0F;
    else if (!hides)
      root = std::min(1.0F, std::max(root, kLeastRoot) + step_s / kReturns_s);
    else if (covered_s_[at] > kFelt_s)
      root = std::max(kLeastRoot, root - step_s / kFades_s);
    hidden_.shown[at] = root > 0.0F ? weight_of(root * root) : 0.0F;
    hidden_.fades = hidden_.fades || root < 1.0F;
  }
  hidden_.over_place = false;
  if (place_)
    for_neighbours(lattice_, *place_, kPlace_blocks, [&](std::size_t at) {
      if (hidden_.block[at] != 0) hidden_.over_place = true;
    });
}

void HiddenSkin::look_at_place(const Intrinsics& camera, const std::optional<Point<DepthCamera>>& device) {
  place_.reset();
  if (!device || !device->m.allFinite() || device->m.z() <= 0.1) return;
  const Eigen::Vector2d pixel = pixel_of(camera, device->m);
  if (pixel.x() < 0.0 || pixel.y() < 0.0 || pixel.x() >= camera.width || pixel.y() >= camera.height) return;
  place_ = lattice_.at(static_cast<int>(pixel.x()) / BlockLattice::kBlock_px,
                       static_cast<int>(pixel.y()) / BlockLattice::kBlock_px);
  device_z_m_ = device->m.z();
}

}  // namespace telepalp::surface
