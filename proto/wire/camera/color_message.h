#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/wire/message.h"
#include "proto/words/result.h"

namespace telepalp::wire {

/// A compressed colour image, from a message of /camera/color or /camera/color/video.
struct CompressedColor {
  std::int64_t captured_ns = 0;  ///< session time of the exposure
  std::string frame_id;
  std::string format;  ///< "jpeg", or a video coding such as "vp8"
  std::string data;
  std::uint64_t number = 0;  ///< of the message within its topic; 0: not known
};

/// True for the topics that compressed_color() reads.
[[nodiscard]] bool carries_color(const Topic& topic) noexcept;

/// The colour image in `message`. nullopt: the message is of another topic, or not of its topic's type.
[[nodiscard]] std::optional<CompressedColor> compressed_color(const Message& message);

/// How a client takes colour.
enum class ColorCoding : std::uint8_t {
  Pictures,  ///< /camera/color: JPEG, each image by itself
  Video,     ///< /camera/color/video: VP8, a fraction of the bytes
};

/// The coding that a user names: "jpeg" or "vp8". Error: another word. `option`: where it was given.
[[nodiscard]] Result<ColorCoding> color_coding(std::string_view word, const std::string& option);

/// What to subscribe to instead of `topics` (names, and prefixes that end in '*') to take colour as `coding`. For video,
/// each prefix that covers /camera/color becomes prefixes of all other topics that it covers, so that the server sends
/// no picture.
[[nodiscard]] std::vector<std::string> subscription_for(ColorCoding coding, std::vector<std::string> topics);

}  // namespace telepalp::wire
