#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace telepalp::plan {

/// A coding of the camera's images for some of the subscribers. Each grade is coded once, and only while a subscriber
/// takes it.
enum class Grade : std::uint8_t {
  Full,   ///< as the server's options say: for recorders, programs at the patient's site, and lines with room for it
  Touch,  ///< for all stations, while the line of one of them has no room for Full
  View,   ///< for viewers on lines without room for Full; while the hand's line has none, for all viewers
};
inline constexpr std::array kGrades{Grade::Full, Grade::Touch, Grade::View};
[[nodiscard]] constexpr std::size_t index_of(Grade grade) noexcept { return static_cast<std::size_t>(grade); }

/// Target rate of colour as video, unless the server's options say otherwise.
inline constexpr int kFullVideo_kbit_per_s = 800;

/// How the images of a grade differ from what the server's options say. The default: not at all.
struct ImageSettings {
  std::size_t level = 0;  ///< of link::ContentLevel, by which whole depth images and colour are made smaller
  /// 0: whole depth images are as exact as `level` says. Else they are near-lossless, within this many times the
  /// server's own bound, or codec::kOneDisparityStep if the server's depth is lossless.
  double whole_factor = 0.0;
  double depth_share = 1.0;     ///< of the camera's images whose depth is sent, above 0 to 1
  double outside_factor = 1.0;  ///< bounds of depth around a window, over those that the station asked for
  /// One of this many images has these bounds around the window. The others have the coarsest ones (GradeStage).
  int outside_every = 1;
  double color_share = 1.0;                                ///< of the camera's images whose colour is sent
  int jpeg_quality = 100;                                  ///< at most
  int video_kbit_per_s = std::numeric_limits<int>::max();  ///< at most

  friend bool operator==(const ImageSettings&, const ImageSettings&) = default;
};

/// True if a stream that sends `share` of the camera's images sends image `number`. The sent images are evenly spaced.
[[nodiscard]] constexpr bool sends(double share, std::uint64_t number) noexcept {
  const auto sent_by = [share](std::uint64_t images) {
    return static_cast<std::uint64_t>(share * static_cast<double>(images) + 1e-6);
  };
  return share >= 1.0 || sent_by(number + 1) > sent_by(number);
}

}  // namespace telepalp::plan
