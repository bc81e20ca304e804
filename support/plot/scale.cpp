#include "support/plot/scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/plot/number.h"

namespace telepalp::plot {
namespace {

double nice_step(double rough) {
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double lead = rough / decade;
  return decade * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

}  // namespace

Range range_of(std::span<const double> values, Range otherwise) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values)
    if (std::isfinite(value)) range = {std::min(range.least, value), std::max(range.most, value)};
  return range.least <= range.most ? range : otherwise;
}

Range united(Range a, Range b) noexcept { return {std::min(a.least, b.least), std::max(a.most, b.most)}; }

std::vector<Tick> nice_ticks(Range range, int wanted) {
  const double span = range.most - range.least;
  if (!std::isfinite(span) || span <= 0.0 || wanted < 1) return {};
  const double step = nice_step(span / wanted);
  const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 12);
  std::vector<Tick> ticks;
  const double slack = step * 1e-9;  // so that rounding does not remove a tick at the end of the range
  for (double index = std::ceil((range.least - slack) / step); index * step <= range.most + slack; index += 1.0)
    ticks.push_back({std::clamp(index * step, range.least, range.most), number(index * step, decimals)});
  return ticks;
}

std::vector<Tick> decade_ticks(Range range) {
  if (!(range.least > 0.0) || !std::isfinite(range.most)) return {};
  std::vector<Tick> ticks;
  const int last = static_cast<int>(std::floor(std::log10(range.most) + 1e-9));
  for (int power = static_cast<int>(std::ceil(std::log10(range.least) - 1e-9)); power <= last; ++power)
    ticks.push_back({std::pow(10.0, power), number(std::pow(10.0, power), 6)});
  return ticks;
}

double Scale::operator()(double value) const noexcept {
  const double span = logarithmic ? std::log(data.most / data.least) : data.most - data.least;
  const double along = logarithmic ? std::log(value / data.least) : value - data.least;
  if (logarithmic && !(value > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return pixels.least + along / span * (pixels.most - pixels.least);
}

}  // namespace telepalp::plot
