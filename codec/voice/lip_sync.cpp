#include "codec/lip_sync.h"

#include <algorithm>

#include "proto/words/numbers/quantile.h"

namespace telepalp::codec {

void LipSync::shown(Nanoseconds age) {
  if (ages_.size() < kPictures) {
    ages_.push_back(age);
    return;
  }
  newest_ = (newest_ + 1) % kPictures;
  ages_[newest_] = age;
}

Nanoseconds LipSync::delay(Nanoseconds fastest) const {
  if (ages_.empty()) return {};
  std::vector<Nanoseconds> ages = ages_;
  return std::clamp(median_of(ages) - fastest, Nanoseconds{}, kMostHeld);
}

}  // namespace telepalp::codec
