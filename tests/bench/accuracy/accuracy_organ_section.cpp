#include <algorithm>
#include <chrono>
#include <cmath>

#include "haptic_station/organs/organ_shape.h"
#include "proto/words/numbers/quantile.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/ms_since.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kCells_m[] = {0.002, 0.003, 0.004, 0.006, 0.008};
const double kUsualCell_m = organs::OrganShapeSettings{}.cell_m;
constexpr double kTruthCell_m = 0.0053;  // few of its nodes coincide with those of the table's lattices
constexpr double kDeepest_m = 0.02;      // as deep as a finger pushes into an organ

struct OrganPrice {
  double cell_m;
  double rms_m;
  double p99_m;
  double normal_deg;  ///< RMS angle to the true normal
  double load_ms;
  double megabytes;
  double step_us;
};

Result<std::shared_ptr<const solids::DistanceLattice>> liver(double cell_m) {
  return organs::read_organ_shape(TELEPALP_SOURCE_DIR "/deploy/demo_data/organs/visible_human_liver.ply",
                                  {.cell_m = cell_m});
}

/// A point inside the organ, its true distance, and the true direction outwards where that is well defined.
struct Place {
  Eigen::Vector3d at_m;
  double distance_m;
  Eigen::Vector3d outwards;
};

/// Points at the nodes of a lattice, whose distances are exact. Their differences are exact where the distance is
/// linear between nodes.
std::vector<Place> places_in(const solids::DistanceLattice& truth) {
  std::vector<Place> places;
  for (int k = 1; k + 1 < truth.size[2]; ++k)
    for (int j = 1; j + 1 < truth.size[1]; ++j)
      for (int i = 1; i + 1 < truth.size[0]; ++i) {
        const double distance_m = truth.nodes_m[truth.index(i, j, k)];
        if (distance_m >= 0.0 || distance_m < -kDeepest_m) continue;
        const auto node = [&](int x, int y, int z) { return double{truth.nodes_m[truth.index(x, y, z)]}; };
        const Eigen::Vector3d slope =
            Eigen::Vector3d{node(i + 1, j, k) - node(i - 1, j, k), node(i, j + 1, k) - node(i, j - 1, k),
                            node(i, j, k + 1) - node(i, j, k - 1)} /
            (2.0 * truth.spacing_m);
        const bool smooth = std::abs(slope.norm() - 1.0) < 0.005;
        places.push_back({truth.origin_m + truth.spacing_m * Eigen::Vector3d(i, j, k), distance_m,
                          smooth ? Eigen::Vector3d(slope.normalized()) : Eigen::Vector3d::Zero()});
      }
  return places;
}

Result<OrganPrice> price_of(double cell_m, const std::vector<Place>& places) {
  const auto start = Clock::now();
  const auto shape = liver(cell_m);
  if (!shape) return shape.error();
  OrganPrice price{.cell_m = cell_m,
                   .rms_m = 0.0,
                   .p99_m = 0.0,
                   .normal_deg = 0.0,
                   .load_ms = ms_since(start),
                   .megabytes = 1e-6 * static_cast<double>((*shape)->nodes_m.size() * sizeof(float)),
                   .step_us = 0.0};
  std::vector<double> errors;
  double angles = 0.0;
  std::size_t smooth = 0;
  const auto walk = Clock::now();
  std::vector<solids::DistanceAt> felt;
  felt.reserve(places.size());
  for (const Place& place : places) felt.push_back(solids::distance_at(**shape, place.at_m));
  price.step_us = 1e3 * ms_since(walk) / static_cast<double>(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    errors.push_back(std::abs(felt[i].m - places[i].distance_m));
    price.rms_m += errors.back() * errors.back() / static_cast<double>(places.size());
    if (places[i].outwards.isZero()) continue;
    const double cosine = felt[i].gradient.normalized().dot(places[i].outwards);
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    angles += angle * angle;
    ++smooth;
  }
  price.rms_m = std::sqrt(price.rms_m);
  price.normal_deg = std::sqrt(angles / static_cast<double>(std::max<std::size_t>(smooth, 1))) * 57.29577951308232;
  price.p99_m = quantile_of(errors, 0.99);
  return price;
}

}  // namespace

Result<Section> organ_section() {
  const auto truth = liver(kTruthCell_m);
  if (!truth) return truth.error();
  const std::vector<Place> places = places_in(**truth);
  Section section;
  PageTable table{.head = {"`cell_m`, mm", "depth error mm, RMS", "p99", "normal error °, RMS", "to read, ms",
                           "memory MB", "step µs"},
                  .rows = {}};
  for (const double cell_m : kCells_m) {
    const Result<OrganPrice> price = price_of(cell_m, places);
    if (!price) return price.error();
    const std::string name = "organ, cells of " + cell(1e3 * cell_m) + " mm: ";
    section.rows.push_back(measured(name + "depth error, RMS", 1e3 * price->rms_m, "mm"));
    section.rows.push_back(measured(name + "depth error, p99", 1e3 * price->p99_m, "mm"));
    section.rows.push_back(measured(name + "error of the normal, RMS", price->normal_deg, "deg"));
    section.rows.push_back(measured(name + "time to read the mesh", price->load_ms, "ms"));
    section.rows.push_back(measured(name + "time of a step", price->step_us, "us"));
    const std::string size = cell(1e3 * cell_m);
    table.rows.push_back({cell_m == kUsualCell_m ? "**" + size + "**" : size, cell(1e3 * price->rms_m),
                          cell(1e3 * price->p99_m), cell(price->normal_deg), cell(price->load_ms),
                          cell(price->megabytes), cell(price->step_us)});
  }
  section.parts = {{"organ", to_markdown(table)}};
  return section;
}

}  // namespace telepalp::bench
