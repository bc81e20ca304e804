#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace telepalp::plan {

/// For whom images are coded. Each grade is coded once, and only while a subscriber takes it.
enum class Grade : std::uint8_t {
  Full,   ///< as the server's options say: recorders, programs at the patient's site, and lines that have room
  Touch,  ///< stations, while a station's line has no room for Full
  View,   ///< viewers whose line has no room for Full
};
inline constexpr std::array kGrades{Grade::Full, Grade::Touch, Grade::View};
[[nodiscard]] constexpr std::size_t index_of(Grade grade) noexcept { return static_cast<std::size_t>(grade); }

/// How the images of a grade differ from what the server's options say. The default: not at all.
struct ImageSettings {
  std::size_t level = 0;  ///< link::ContentLevel::level(), of whole depth images and of colour
  /// Whole depth images are near-lossless within so many times codec::kOneDisparityStep; 0: as exact as level says.
  double whole_factor = 0.0;
  double depth_share = 1.0;     ///< of the camera's images whose depth is sent, above 0 to 1
  double outside_factor = 1.0;  ///< the bounds that a station asks for around its window grow by this factor
  int outside_every = 1;        ///< one of so many images has these bounds; the others are as coarse as can be there
  double color_share = 1.0;     ///< of the camera's images whose colour is sent
  int jpeg_quality = 100;       ///< at most
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
