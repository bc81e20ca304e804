#include "tools/replay/workers/time_left.h"

#include <algorithm>
#include <cmath>

namespace telepalp::replay {
namespace {

constexpr std::size_t kWindow = 32;  // cells

}  // namespace

void TimeLeft::finished(double now_s) {
  times_s_.push_back(std::max(now_s, times_s_.back()));
  if (times_s_.size() > kWindow + 1) times_s_.pop_front();
}

std::optional<double> TimeLeft::left_s(std::size_t cells, double now_s) const {
  const auto made = static_cast<double>(times_s_.size() - 1);
  if (made < 1.0) return std::nullopt;
  const double last_s = times_s_.back() - times_s_.front();
  // If the next cell is late, each one takes longer than the last ones did.
  const double per_cell_s = std::max(last_s / made, (now_s - times_s_.front()) / (made + 1.0));
  return per_cell_s * static_cast<double>(cells);
}

std::string span_of_time(double seconds) {
  const auto whole = [](double value) { return std::to_string(std::llround(value)); };
  if (seconds < 90.0) return whole(std::max(seconds, 0.0)) + " s";
  const double minutes = std::round(seconds / 60.0);
  if (minutes < 90.0) return whole(minutes) + " min";
  return whole(std::floor(minutes / 60.0)) + " h " + whole(std::fmod(minutes, 60.0)) + " min";
}

}  // namespace telepalp::replay
