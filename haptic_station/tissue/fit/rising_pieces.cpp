#include "haptic_station/tissue/fit/rising_pieces.h"

#include <algorithm>
#include <limits>

namespace telepalp::tissue {

RisingPieces::RisingPieces(std::span<const double> samples, double step, int pieces, std::size_t least) : step_(step) {
  const std::size_t count = samples.size();
  y_.assign(count + 1, 0.0);
  yy_ = xy_ = y_;
  for (std::size_t i = 0; i < count; ++i) {
    y_[i + 1] = y_[i] + samples[i];
    yy_[i + 1] = yy_[i] + samples[i] * samples[i];
    xy_[i + 1] = xy_[i] + samples[i] * step * static_cast<double>(i);
  }
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<Best> one(count + 1, {kNone, count});
  for (std::size_t i = 0; i + least <= count; ++i) one[i].squares = squares_of(i, count);
  best_.push_back(one);
  for (int k = 1; k < pieces; ++k) {
    std::vector<Best> more = best_.back();
    for (std::size_t i = 0; i + 2 * least <= count; ++i)
      for (std::size_t next = i + least; next + least <= count; ++next) {
        const double squares = squares_of(i, next) + best_.back()[next].squares;
        if (squares < more[i].squares) more[i] = {squares, next};
      }
    best_.push_back(std::move(more));
  }
}

double RisingPieces::squares_of(std::size_t begin, std::size_t end) const noexcept {
  const auto n = static_cast<double>(end - begin);
  const double middle = step_ * (static_cast<double>(begin) + 0.5 * (n - 1.0));
  const double y = y_[end] - y_[begin];
  const double about_mean = std::max(0.0, yy_[end] - yy_[begin] - y * y / n);
  const double xy = xy_[end] - xy_[begin] - middle * y;
  const double xx = step_ * step_ * n * (n * n - 1.0) / 12.0;
  return xy > 0.0 && xx > 0.0 ? std::max(0.0, about_mean - xy * xy / xx) : about_mean;
}

std::vector<std::size_t> RisingPieces::begins_from(std::size_t begin) const {
  std::vector<std::size_t> begins;
  std::size_t at = begin;
  for (std::size_t k = best_.size(); k-- > 0 && at < y_.size() - 1;) {
    begins.push_back(at);
    // The best cut into at most k + 1 lines may have fewer: the lowest level with the same sum has its number of lines.
    std::size_t level = k;
    while (level > 0 && best_[level - 1][at].squares == best_[level][at].squares) --level;
    at = best_[level][at].next;
    k = level;
  }
  return begins;
}

}  // namespace telepalp::tissue
