#include "support/isosurface/cells/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/isosurface/cells/cell_check.h"

namespace telepalp::isosurface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

using Features = std::vector<const Feature*>;

class Refiner {
 public:
  Refiner(const Field& field, const Grid& grid, const Lattice& lattice)
      : field_(field),
        grid_(grid),
        lattice_(lattice),
        sampler_(field, lattice, grid.examine),
        out_{.tree = CellTree(lattice)} {}

  bool run(const Vector3i& cells) {
    cells_in_all_ = cells.cast<double>().prod();
    Features features;
    for (const Feature& one : field_.features)
      if (one.size_m < grid_.cell_m) features.push_back(&one);
    return block(Vector3i::Zero(), cells, features);
  }
  Refined take() { return std::move(out_); }

 private:
  [[nodiscard]] Eigen::AlignedBox3d box_of(const Vector3i& low, const Vector3i& high) const {
    return {lattice_.at(low), lattice_.at(high)};
  }
  [[nodiscard]] static Features within(const Features& features, const Eigen::AlignedBox3d& box) {
    Features kept;
    for (const Feature* one : features)
      if (one->box.intersects(box)) kept.push_back(one);
    return kept;
  }

  /// A block of largest cells: skipped if the surface cannot reach it, else halved. False: too many cells, or stopped.
  bool block(const Vector3i& low, const Vector3i& high, const Features& features) {
    if (grid_.stop.stop_requested()) return false;
    const int side = lattice_.side(0);
    const Eigen::AlignedBox3d box = box_of(side * low, side * high);
    if (std::abs(field_.m_at(box.center())) > 0.5 * field_.steepest * box.diagonal().norm()) return done(low, high);
    const Features near = within(features, box);
    int axis = 0;
    const int longest = (high - low).maxCoeff(&axis);
    if (longest <= 1) return cell(side * low, 0, near) && done(low, high);
    Vector3i cut_high = high;
    Vector3i cut_low = low;
    cut_high[axis] = cut_low[axis] = low[axis] + longest / 2;
    return block(low, cut_high, near) && block(cut_low, high, near);
  }

  bool done(const Vector3i& low, const Vector3i& high) {
    done_ += (high - low).cast<double>().prod();
    if (grid_.progress) grid_.progress(done_ / cells_in_all_);
    return true;
  }

  bool cell(const Vector3i& low, int level, const Features& features) {
    if (grid_.stop.stop_requested()) return false;
    const int side = lattice_.side(level);
    const double side_m = side * lattice_.step_m;
    const double middle_m = sampler_.at(low + Vector3i::Constant(side / 2)).m;
    if (std::abs(middle_m) > 0.5 * std::sqrt(3.0) * field_.steepest * side_m) return true;
    if (!grid_.examine) return leaf(low, level);
    const Features near = within(features, box_of(low, low + Vector3i::Constant(side)));
    bool divide = false;
    for (const Feature* one : near) divide = divide || one->size_m < side_m;
    if (divide && level < grid_.halvings) return children(low, level, near);
    const CellSamples samples = sampler_.of_cell(low, side);
    const CellCheck check = check_cell(samples);
    if (check.sure() && check.flat) return leaf(low, level);
    if (level < grid_.halvings) return children(low, level, near);
    if (check.apart_m && (!out_.tightest || *check.apart_m < out_.tightest->apart_m))
      out_.tightest = Tight{samples.place(13), *check.apart_m};
    if (!check.sure()) ++out_.unsure;
    return leaf(low, level);
  }

  bool children(const Vector3i& low, int level, const Features& features) {
    out_.tree.divide(low, level);
    for (int c = 0; c < 8; ++c)
      if (!cell(low + lattice_.side(level + 1) * corner(c), level + 1, features)) return false;
    return true;
  }

  bool leaf(const Vector3i& low, int level) {
    Leaf made{.low = low, .level = static_cast<std::uint8_t>(level)};
    for (int c = 0; c < 8; ++c)
      if (sampler_.at(low + lattice_.side(level) * corner(c)).m < 0.0)
        made.inside |= static_cast<std::uint8_t>(1U << c);
    out_.tree.add(made);
    return out_.tree.leaves().size() <= grid_.most_cells;
  }

  const Field& field_;
  const Grid& grid_;
  const Lattice& lattice_;
  Sampler sampler_;
  Refined out_;
  double cells_in_all_ = 0.0;
  double done_ = 0.0;
};

/// States the smallest cell so far, because its size and place show what asks for so many.
Error too_many(const CellTree& tree, const Grid& grid) {
  const Leaf& finest = *std::ranges::max_element(tree.leaves(), {}, &Leaf::level);
  const Vector3d at = tree.lattice().at(finest.low);
  char text[160];
  std::snprintf(text, sizeof text,
                "the surface needs more than %zu cells; the smallest, of %.3g mm, are near (%.4f, %.4f, %.4f)",
                grid.most_cells, 1e3 * std::ldexp(grid.cell_m, -finest.level), at.x(), at.y(), at.z());
  return {.what = text, .where = "isosurface", .fix = "use larger cells"};
}

}  // namespace

Error stopped() { return {.what = "the extraction was stopped", .where = "isosurface", .fix = "start it again"}; }

void CellTree::add(const Leaf& leaf) {
  *cells_.insert(key_of(leaf.low, leaf.level)).first = static_cast<std::int32_t>(leaves_.size());
  leaves_.push_back(leaf);
}

std::int32_t CellTree::cell(const Vector3i& low, int level) const noexcept {
  const std::int32_t* found = cells_.find(key_of(low, level));
  return found == nullptr ? kAbsent : *found;
}

std::int32_t CellTree::leaf_over(const Vector3i& low, int level) const noexcept {
  for (int at = level; at >= 0; --at) {
    const int side = lattice_.side(at);
    const std::int32_t found = cell({low.x() / side * side, low.y() / side * side, low.z() / side * side}, at);
    if (found != kAbsent) return found == kDivided && at < level ? kAbsent : found;
  }
  return kAbsent;
}

Result<Refined> refine(const Field& field, const Grid& grid, const Lattice& lattice, const Eigen::Vector3i& cells) {
  Refiner refiner(field, grid, lattice);
  const bool done = refiner.run(cells);
  if (grid.stop.stop_requested()) return stopped();
  if (!done) return too_many(refiner.take().tree, grid);
  return refiner.take();
}

}  // namespace telepalp::isosurface
