#include "tools/study/figures/paper_table.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/device/random.h"
#include "proto/words/numbers/fixed_text.h"
#include "tools/study/figures/statistics.h"

namespace telepalp::study {
namespace {

// linkage, phi, h, l_h; the last one changes fastest. S4, Table 2.
constexpr std::array<PaperCell, 36> kTable{{
    {7.9, 6.2},   {9.5, 9.4},  {7.7, 9.6},   {11.4, 14.9},  // linkage 1, phi 0
    {13.4, 10.8}, {11.9, 9.0}, {11.2, 7.6},  {10.3, 9.5},   // phi pi/2
    {13.2, 11.0}, {8.0, 5.3},  {31.0, 21.1}, {21.8, 18.2},  // phi 5pi/6
    {9.2, 9.0},   {8.3, 11.7}, {4.1, 1.6},   {7.3, 8.0},    // linkage 2
    {10.4, 11.0}, {10.0, 9.7}, {7.3, 4.9},   {3.9, 2.1},   {7.7, 6.3}, {4.6, 3.2}, {15.2, 7.0},  {17.8, 14.6},
    {9.1, 7.4},   {5.0, 3.3},  {4.9, 2.4},   {4.7, 2.8},  // linkage 3
    {12.2, 15.1}, {7.6, 6.8},  {7.1, 7.6},   {4.8, 4.1},   {6.5, 3.4}, {6.4, 3.6}, {20.0, 12.6}, {14.5, 3.2},
}};

/// Mean over the cells whose levels are given; -1: all levels.
double mean_at(std::span<const double> values, int linkage, int phi, int h) {
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < 36; ++i) {
    const bool in = (linkage < 0 || i / 12 == linkage) && (phi < 0 || i / 4 % 3 == phi) && (h < 0 || i / 2 % 2 == h);
    sum += in ? values[static_cast<std::size_t>(i)] : 0.0;
    count += in ? 1 : 0;
  }
  return sum / count;
}

int longer_handles_better(std::span<const double> values) {
  int better = 0;
  for (std::size_t i = 0; i < 36; i += 2) better += values[i + 1] < values[i] ? 1 : 0;
  return better;
}

/// How many of the three best and three worst cells have h = 80 mm.
int extremes_far_out(std::span<const double> values) {
  std::vector<std::size_t> order(36);
  for (std::size_t i = 0; i < 36; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  int far = 0;
  for (const std::size_t place : {0, 1, 2, 33, 34, 35}) far += order[place] / 2 % 2 == 1 ? 1 : 0;
  return far;
}

std::string by_phi(std::span<const double> values, int h) {
  return fixed_text(mean_at(values, -1, 0, h)) + " / " + fixed_text(mean_at(values, -1, 1, h)) + " / " +
         fixed_text(mean_at(values, -1, 2, h)) + " mm";
}

}  // namespace

const std::array<PaperCell, 36>& paper_table() noexcept { return kTable; }

std::vector<double> paper_overshoots_mm() {
  std::vector<double> out;
  for (const PaperCell& cell : kTable) out.push_back(cell.overshoot_mm);
  return out;
}

double noise_ceiling(double of, std::uint64_t seed) {
  constexpr int kDraws = 2000;
  const std::vector<double> measured = paper_overshoots_mm();
  const double middle = mean_of(measured);
  double variance = 0.0;
  double noise = 0.0;
  for (const PaperCell& cell : kTable) {
    variance += (cell.overshoot_mm - middle) * (cell.overshoot_mm - middle) / 35.0;
    noise += cell.deviation_mm * cell.deviation_mm / of / 36.0;
  }
  const double keep = std::sqrt(std::max(0.0, 1.0 - noise / variance));
  std::vector<double> truth = measured;
  for (double& value : truth) value = middle + keep * (value - middle);
  device::Random random(seed);
  std::vector<double> drawn(36);
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    for (std::size_t k = 0; k < 36; ++k) drawn[k] = truth[k] + kTable[k].deviation_mm / std::sqrt(of) * random.normal();
    sum += rank_correlation(truth, drawn);
  }
  return sum / kDraws;
}

std::vector<Pattern> patterns_of(std::span<const double> here) {
  const std::vector<double> paper = paper_overshoots_mm();
  const auto worst_phi = [](std::span<const double> values, int h, int phi) {
    bool worst = true;
    for (int other = 0; other < 3; ++other) worst &= mean_at(values, -1, other, h) <= mean_at(values, -1, phi, h);
    return worst;
  };
  const auto by_linkage = [](std::span<const double> values) {
    return fixed_text(mean_at(values, 0, -1, -1)) + " / " + fixed_text(mean_at(values, 1, -1, -1)) + " / " +
           fixed_text(mean_at(values, 2, -1, -1)) + " mm";
  };
  const bool first_is_worst =
      mean_at(here, 0, -1, -1) > mean_at(here, 1, -1, -1) && mean_at(here, 0, -1, -1) > mean_at(here, 2, -1, -1);
  const bool h_helps_but_there =
      mean_at(here, -1, 0, 1) < mean_at(here, -1, 0, 0) && mean_at(here, -1, 2, 1) > mean_at(here, -1, 2, 0);
  return {
      {"h = 80 mm makes phi = 0 better and phi = 5pi/6 worse: h and phi interact",
       fixed_text(mean_at(paper, -1, 0, 0)) + " to " + fixed_text(mean_at(paper, -1, 0, 1)) + ", " +
           fixed_text(mean_at(paper, -1, 2, 0)) + " to " + fixed_text(mean_at(paper, -1, 2, 1)) + " mm",
       fixed_text(mean_at(here, -1, 0, 0)) + " to " + fixed_text(mean_at(here, -1, 0, 1)) + ", " +
           fixed_text(mean_at(here, -1, 2, 0)) + " to " + fixed_text(mean_at(here, -1, 2, 1)) + " mm",
       h_helps_but_there},
      {"with h = 80 mm, phi = 5pi/6 is the worst of 0, pi/2, 5pi/6", by_phi(paper, 1), by_phi(here, 1),
       worst_phi(here, 1, 2)},
      {"with h = 0, phi = pi/2 is the worst of 0, pi/2, 5pi/6", by_phi(paper, 0), by_phi(here, 0),
       worst_phi(here, 0, 1)},
      {"l_h = 180 mm is better than 140 mm in most of the 18 pairs",
       std::to_string(longer_handles_better(paper)) + " of 18", std::to_string(longer_handles_better(here)) + " of 18",
       longer_handles_better(here) >= 12},
      {"linkages 2 and 3 are better than linkage 1", by_linkage(paper), by_linkage(here), first_is_worst},
      {"the three best and the three worst have h = 80 mm", std::to_string(extremes_far_out(paper)) + " of 6",
       std::to_string(extremes_far_out(here)) + " of 6", extremes_far_out(here) >= 5},
  };
}

std::string_view verdict(const Pattern& pattern) noexcept {
  if (pattern.certainty >= 0.95) return "appears";
  return pattern.certainty <= 0.05 ? "does not appear" : "not certain";
}

std::vector<Pattern> patterns_of(const Factorial& by_operator, std::uint64_t seed) {
  constexpr int kResamples = 1000;
  const auto operators = static_cast<double>(by_operator.size());
  const auto mean_over = [&](const std::vector<std::size_t>& people) {
    std::vector<double> means(36, 0.0);
    for (const std::size_t person : people)
      for (std::size_t i = 0; i < means.size(); ++i) means[i] += by_operator[person][i] / operators;
    return means;
  };
  std::vector<std::size_t> people(by_operator.size());
  for (std::size_t i = 0; i < people.size(); ++i) people[i] = i;
  std::vector<Pattern> out = patterns_of(mean_over(people));
  std::vector<int> holds(out.size(), 0);
  device::Random random(seed);
  for (int i = 0; i < kResamples; ++i) {
    for (std::size_t& person : people) person = static_cast<std::size_t>(random.uniform() * operators);
    const std::vector<Pattern> resampled = patterns_of(mean_over(people));
    for (std::size_t k = 0; k < out.size(); ++k) holds[k] += resampled[k].holds ? 1 : 0;
  }
  for (std::size_t k = 0; k < out.size(); ++k) out[k].certainty = static_cast<double>(holds[k]) / kResamples;
  return out;
}

}  // namespace telepalp::study
