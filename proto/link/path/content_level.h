#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "proto/words/time.h"

namespace telepalp::link {

/// Share of the last images that a path had no room for. Pure.
class DropShare {
 public:
  /// `offered`, `dropped`: numbers of images since the path began. Returns the share, 0 to 1.
  double step(std::uint64_t offered, std::uint64_t dropped) noexcept {
    const std::uint64_t images = offered - std::exchange(offered_, offered);
    const std::uint64_t of_these = dropped - std::exchange(dropped_, dropped);
    const double keep = std::exp(-static_cast<double>(images) / kMemory_images);
    weight_ = weight_ * keep + static_cast<double>(images);
    lost_ = lost_ * keep + static_cast<double>(of_these);
    return weight_ >= 1.0 ? lost_ / std::max(weight_, kMemory_images / 2.0) : 0.0;
  }

 private:
  static constexpr double kMemory_images = 15.0;  ///< half a second of a camera
  std::uint64_t offered_ = 0, dropped_ = 0;
  double weight_ = 0.0, lost_ = 0.0;
};

/// Chooses how small a sender makes its images for a line that other flows use, or that is too thin for them, so that
/// the rate of images need not fall. Level 0: as asked. At level 1 and at level 2, images have about 0.6 of the bytes
/// of the level before. At level 3 the rate falls: every fourth image is left out, because an image that waits for room
/// is late. Pure.
class ContentLevel {
 public:
  static constexpr std::size_t kLast = 3;

  struct Line {
    std::optional<double> share_B_per_s{};  ///< rate that other flows leave; nullopt: no other flow was noticed
    double demand_B_per_s = 0.0;            ///< rate of all images at the present level
    double dropped = 0.0;                   ///< share of the last images that were dropped (DropShare)
  };

  /// True if image `number` of the camera is not sent at `level`.
  [[nodiscard]] static constexpr bool leaves_out(std::size_t level, std::uint64_t number) noexcept {
    return level == kLast && number % 4 == 0;
  }

  /// Images become smaller as soon as the line has no room for them, but stay at a level for at least 0.3 s. They
  /// become larger, level by level, after 2 s in which larger ones would have fitted. 2 s after the other flows have
  /// gone, they return to level 0 in one step. If larger images do not fit after all, the next try waits twice as long,
  /// at most 16 s.
  void step(const Line& line, SessionTime now) noexcept {
    const bool drops = line.dropped > kMostDropped;
    const bool bound = line.share_B_per_s.has_value();
    const bool tight = drops || (bound && *line.share_B_per_s < kMargin * line.demand_B_per_s);
    const bool roomy = !drops && (!bound || *line.share_B_per_s > kMargin * kStep * line.demand_B_per_s);
    if (!roomy) roomy_since_ = now;
    beside_ = beside_ || bound;
    if (tight && level_ < kLast && now - changed_at_ > kStays)
      shrink(now);
    else if (level_ > 0 && now - roomy_since_ > patience_)
      grow(!bound && std::exchange(beside_, false) ? 0 : level_ - 1, now);
  }
  [[nodiscard]] std::size_t level() const noexcept { return level_; }

 private:
  static constexpr double kMostDropped = 0.15;
  static constexpr double kMargin = 1.2;  ///< room for repairs and for images that are larger than the mean
  static constexpr double kStep = 1.75;   ///< bytes at a level over those at the next one
  static constexpr Nanoseconds kStays = std::chrono::milliseconds(300);
  static constexpr Nanoseconds kPatience = std::chrono::seconds(2);
  static constexpr Nanoseconds kMostPatience = std::chrono::seconds(16);

  void shrink(SessionTime now) noexcept {
    patience_ = now - grown_at_ < kPatience ? std::min(2 * patience_, kMostPatience) : kPatience;
    change(level_ + 1, now);
  }
  void grow(std::size_t to, SessionTime now) noexcept {
    grown_at_ = now;
    change(to, now);
  }
  void change(std::size_t to, SessionTime now) noexcept {
    level_ = to;
    changed_at_ = roomy_since_ = now;
  }

  std::size_t level_ = 0;
  bool beside_ = false;  ///< other flows were noticed since the images were as asked
  Nanoseconds patience_ = kPatience;
  SessionTime changed_at_{};
  SessionTime roomy_since_{};
  SessionTime grown_at_ = SessionTime{-kMostPatience};
};

}  // namespace telepalp::link
