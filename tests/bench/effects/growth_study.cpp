#include "tests/bench/effects/growth_study.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "haptic_station/solids/polish.h"
#include "haptic_station/solids/solid_proxy.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using solids::SolidTree;
using Places = std::vector<Vector3d>;

/// `count` balls of 0.2 m radius, 1 m apart, in a cube.
std::shared_ptr<const SolidTree> balls(int count, int side) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += std::string(i + 1 < count ? "+ " : "") + "tr " + std::to_string(i % side) + " " +
            std::to_string(i / side % side) + " " + std::to_string(i / side / side) + " sphere 0.2 ";
  return *solids::build_tree(*solids::parse_polish(text, "bench"));
}

/// Mean processor time of `cost` at these places [us], the median over rounds.
template <class Cost>
double mean_us(const Places& places, Cost&& cost) {
  Distribution us;
  double sum = 0.0;
  for (int round = 0; round < 15; ++round) {
    const double before = thread_us();
    sum += cost(places);
    us.add((thread_us() - before) / static_cast<double>(places.size()));
  }
  return std::isfinite(sum) ? us.p50() : HUGE_VAL;
}

double evaluation_us(const SolidTree& tree, const Places& places) {
  return mean_us(places, [&](const Places& at) {
    double sum = 0.0;
    for (const Vector3d& place : at) sum += solids::solid_at(tree, place).m;
    return sum;
  });
}

double proxy_us(const SolidTree& tree, const Places& places) {
  return mean_us(places, [&](const Places& at) {
    solids::SolidProxy proxy;
    double sum = 0.0;
    for (const Vector3d& place : at) sum += proxy.step(tree, place).depth_m;
    return sum;
  });
}

/// A finger that moves 0.1 mm from one tick to the next, past two balls; `off_m`: its height above their centres. At
/// 0.15 m it presses into each.
Places finger_path(int side, double off_m) {
  Places places;
  for (int i = 0; i < 20'000; ++i) places.emplace_back(1e-4 * i, side / 2 + off_m, side / 2 + 0.05);
  return places;
}

/// `distinct` places near the surfaces of balls that are chosen at random, repeated up to `kScattered` places.
Places scattered(int count, int side, int distinct) {
  constexpr int kScattered = 1000;
  std::mt19937_64 random(7);
  Places places;
  for (int i = 0; i < distinct; ++i) {
    const int k = std::uniform_int_distribution(0, count - 1)(random);
    std::uniform_real_distribution off(-0.25, 0.25);
    places.emplace_back(k % side + off(random), k / side % side + off(random), k / side / side + off(random));
  }
  while (static_cast<int>(places.size()) < kScattered)
    places.push_back(places[places.size() - static_cast<std::size_t>(distinct)]);
  return places;
}

/// The cost for the most solids, as a multiple of the cost for the fewest.
class Growth {
 public:
  void add(double us) noexcept {
    least_ = std::min(least_, us);
    most_ = std::max(most_, us);
  }
  [[nodiscard]] double factor() const noexcept { return most_ / least_; }

 private:
  double least_ = HUGE_VAL;
  double most_ = 0.0;
};

}  // namespace

void measure_growth(Report& report) {
  struct Kind {
    const char* name;
    bool of_a_hand;  ///< the cost that is asked for; a hand does not jump between scattered places
    double (*us)(const SolidTree& tree, int count, int side);
    Growth growth;
  };
  Kind kinds[] = {
      {"proxy step, finger that slides past balls",
       true,
       [](const SolidTree& t, int, int side) { return proxy_us(t, finger_path(side, 0.15)); },
       {}},
      {"distance to the balls, finger that slides past them",
       true,
       [](const SolidTree& t, int, int side) { return evaluation_us(t, finger_path(side, 0.1)); },
       {}},
      {"distance to the balls, 30 scattered places, repeated",
       false,
       [](const SolidTree& t, int count, int side) { return evaluation_us(t, scattered(count, side, 30)); },
       {}},
      {"distance to the balls, 1000 scattered places",
       false,
       [](const SolidTree& t, int count, int side) { return evaluation_us(t, scattered(count, side, 1000)); },
       {}}};
  for (const int count : {10, 100, 1000, 10'000}) {
    const int side = static_cast<int>(std::lround(std::cbrt(count)));
    const auto tree = balls(count, side);
    for (Kind& kind : kinds) {
      const double us = kind.us(*tree, count, side);
      kind.growth.add(us);
      report.rows.push_back(
          measured(std::string(kind.name) + ": time, " + std::to_string(count) + " balls", 1e3 * us, "ns"));
    }
  }
  constexpr double kLogGrows = 4.0;  // log 10 000 / log 10
  for (const Kind& kind : kinds) {
    const std::string name = std::string(kind.name) + ": longest over shortest time, 10 to 10 000 balls";
    report.rows.push_back(kind.of_a_hand ? at_most(name, kind.growth.factor(), "", kLogGrows)
                                         : measured(name, kind.growth.factor(), ""));
  }
}

}  // namespace telepalp::bench
