#include "haptic_station/surface/build/object_regions.h"

#include <array>
#include <cmath>
#include <optional>

namespace telepalp::surface {
namespace {

constexpr float kEdge_m = 0.008F;       // a finger's side steps by half its thickness at least
constexpr float kSteepSkin_m = 0.025F;  // from one block to the next: a silhouette, where depth changes by any shift

constexpr float kObjectSlope_m = 0.012F;  // over two blocks: 45 degrees

struct Step {
  int column;
  int row;
};
constexpr std::array kAround{Step{1, 0}, Step{0, 1}, Step{-1, 0}, Step{0, -1}};

/// Where a rim is crossed: a block inside of it, the first measured block outside, and one further out.
struct Crossing {
  std::size_t inner;
  std::size_t outer;
  std::size_t beyond;
  float apart;  ///< from `inner` to `outer`, over that from `outer` to `beyond`

  /// How much the surface steps up from outside to inside, beyond its slope outside [m].
  [[nodiscard]] float step_m(std::span<const float> z_m) const noexcept {
    return z_m[outer] - z_m[inner] - apart * (z_m[beyond] - z_m[outer]);
  }
  /// False where a block is not known, or the surface outside is too steep, as at a silhouette, to tell its slope.
  [[nodiscard]] bool is_known(std::span<const float> z_m) const noexcept {
    return z_m[inner] > 0.0F && z_m[outer] > 0.0F && z_m[beyond] > 0.0F &&
           std::abs(z_m[beyond] - z_m[outer]) < kObjectSlope_m;
  }
};

constexpr int kShadow = 5;   // so many blocks beside an object may be unmeasured: its shadow
constexpr int kFurther = 2;  // from `outer` to `beyond`

class Finder {
 public:
  Finder(const BlockLattice& lattice, const SeenBlocks& seen)
      : lattice_(lattice), seen_(seen), region_of_(lattice.size(), 0) {}

  std::vector<NearerRegion> all() {
    std::vector<NearerRegion> found;
    for (std::size_t at = 0; at < lattice_.size(); ++at) {
      if (region_of_[at] != 0 || !is_seed(at)) continue;
      found.push_back(grown_from(at, static_cast<std::uint32_t>(found.size() + 1)));
    }
    for (std::size_t i = 0; i < found.size(); ++i) look_at_rim(found[i], static_cast<std::uint32_t>(i + 1));
    return found;
  }

 private:
  [[nodiscard]] float nearer_m(std::size_t at) const noexcept {
    const float z = seen_.depth_m[at];
    const float skin = seen_.remembered_m[at];
    return z > 0.0F && skin > 0.0F ? skin - z : 0.0F;
  }

  [[nodiscard]] bool is_seed(std::size_t at) const noexcept {
    return nearer_m(at) > static_cast<float>(seen_.hidden[at] != 0 ? kStaysNearer_m : kNearer_m) && !is_steep(at);
  }

  /// The skin under the block, as remembered, is a silhouette: a small shift of the body changes its depth at once.
  [[nodiscard]] bool is_steep(std::size_t at) const noexcept {
    const int column = static_cast<int>(at % static_cast<std::size_t>(lattice_.columns));
    const int row = static_cast<int>(at / static_cast<std::size_t>(lattice_.columns));
    for (const Step& step : kAround) {
      if (!lattice_.contains(column + step.column, row + step.row)) continue;
      const float beside = seen_.remembered_m[lattice_.at(column + step.column, row + step.row)];
      if (beside > 0.0F && std::abs(beside - seen_.remembered_m[at]) > kSteepSkin_m) return true;
    }
    return false;
  }

  NearerRegion grown_from(std::size_t seed, std::uint32_t number) {
    NearerRegion region;
    region.blocks.push_back(static_cast<std::uint32_t>(seed));
    region_of_[seed] = number;
    for (std::size_t next = 0; next < region.blocks.size(); ++next) {
      const std::size_t at = region.blocks[next];
      region.hidden += seen_.hidden[at] != 0 ? 1 : 0;
      const int column = static_cast<int>(at % static_cast<std::size_t>(lattice_.columns));
      const int row = static_cast<int>(at / static_cast<std::size_t>(lattice_.columns));
      for (const Step& step : kAround) {
        if (!lattice_.contains(column + step.column, row + step.row)) continue;
        const std::size_t beside = lattice_.at(column + step.column, row + step.row);
        if (region_of_[beside] != 0 || nearer_m(beside) < static_cast<float>(kGrown_m)) continue;
        region_of_[beside] = number;
        region.blocks.push_back(static_cast<std::uint32_t>(beside));
      }
    }
    return region;
  }

  /// The crossing of the rim from the block `at` of region `number` in the direction `step`; nullopt: there is no rim,
  /// or the image does not show what lies beyond it.
  [[nodiscard]] std::optional<Crossing> crossing(std::size_t at, const Step& step,
                                                 std::uint32_t number) const noexcept {
    const int column = static_cast<int>(at % static_cast<std::size_t>(lattice_.columns));
    const int row = static_cast<int>(at / static_cast<std::size_t>(lattice_.columns));
    const auto beside = [&](int steps) -> std::optional<std::size_t> {
      const Step to{column + steps * step.column, row + steps * step.row};
      if (!lattice_.contains(to.column, to.row)) return std::nullopt;
      return lattice_.at(to.column, to.row);
    };
    // A block on the rim has the mean depth of both sides, so the block before it counts, if there is one.
    const std::optional<std::size_t> before = beside(-1);
    const bool thick = before && region_of_[*before] == number;
    for (int steps = 1; steps <= kShadow; ++steps) {
      const std::optional<std::size_t> outer = beside(steps);
      if (!outer || region_of_[*outer] != 0) return std::nullopt;   // of another region: the same hand, beyond a shadow
      if (seen_.remembered_m[*outer] <= 0.0F) return std::nullopt;  // it may be a part of the region
      if (seen_.depth_m[*outer] <= 0.0F) continue;
      const std::optional<std::size_t> beyond = beside(steps + kFurther);
      if (!beyond || region_of_[*beyond] != 0) return std::nullopt;
      const auto apart = static_cast<float>(steps + (thick ? 1 : 0)) / kFurther;
      return Crossing{thick ? *before : at, *outer, *beyond, apart};
    }
    return std::nullopt;
  }

  void look_at_rim(NearerRegion& region, std::uint32_t number) const noexcept {
    for (const std::uint32_t at : region.blocks)
      for (const Step& step : kAround) {
        const std::optional<Crossing> rim = crossing(at, step, number);
        if (!rim || !rim->is_known(seen_.depth_m)) continue;
        if (rim->step_m(seen_.depth_m) <= kEdge_m)
          ++region.smooth;
        else if (!rim->is_known(seen_.remembered_m) || rim->step_m(seen_.remembered_m) <= kEdge_m)
          ++region.edges;
      }
  }

  const BlockLattice& lattice_;
  const SeenBlocks& seen_;
  std::vector<std::uint32_t> region_of_;  ///< number of the block's region, from 1; 0: none
};

}  // namespace

std::vector<NearerRegion> nearer_regions(const BlockLattice& lattice, const SeenBlocks& seen) {
  return Finder(lattice, seen).all();
}

}  // namespace telepalp::surface
