#include "proto/wire/camera/color_message.h"

#include <utility>

#include "foxglove/CompressedImage.pb.h"
#include "foxglove/CompressedVideo.pb.h"
#include "proto/wire/camera/camera_stamp.h"

namespace telepalp::wire {
namespace {

template <class Proto>
std::optional<CompressedColor> read(const Message& message) {
  Proto color;
  if (!color.ParseFromString(*message.payload)) return std::nullopt;
  return CompressedColor{.captured_ns = stamp_ns(color.timestamp()),
                         .frame_id = std::move(*color.mutable_frame_id()),
                         .format = std::move(*color.mutable_format()),
                         .data = std::move(*color.mutable_data()),
                         .number = message.sequence};
}

}  // namespace

bool carries_color(const Topic& topic) noexcept {
  return topic.name == kCameraColor.name || topic.name == kCameraColorVideo.name;
}

std::optional<CompressedColor> compressed_color(const Message& message) {
  if (message.topic.name == kCameraColor.name) return read<foxglove::CompressedImage>(message);
  if (message.topic.name == kCameraColorVideo.name) return read<foxglove::CompressedVideo>(message);
  return std::nullopt;
}

Result<ColorCoding> color_coding(std::string_view word, const std::string& option) {
  if (word == "jpeg") return ColorCoding::Pictures;
  if (word == "vp8") return ColorCoding::Video;
  return Error{.what = "'" + std::string(word.substr(0, 64)) + "' is not a coding of colour",
               .where = option,
               .fix = "give jpeg for pictures, or vp8 for video, which needs a fraction of the bytes"};
}

std::vector<std::string> subscription_for(ColorCoding coding, std::vector<std::string> topics) {
  if (coding == ColorCoding::Pictures) return topics;
  std::vector<std::string> names;
  bool covers_color = false;
  for (const std::string& wanted : topics) {
    const bool is_prefix = wanted.ends_with('*');
    const std::string_view prefix = std::string_view(wanted).substr(0, wanted.size() - (is_prefix ? 1 : 0));
    const bool covers = is_prefix ? kCameraColor.name.starts_with(prefix) : wanted == kCameraColor.name;
    covers_color = covers_color || covers;
    if (!covers) names.push_back(wanted);
    if (!covers || !is_prefix) continue;
    for (const Topic& topic : kTopics)
      if (topic.name.starts_with(prefix) && topic.name != kCameraColor.name && !topic.only_by_name)
        names.push_back(std::string(topic.name) + "*");  // with '*', because Hub::is_taken() counts full names alone
  }
  if (covers_color) names.emplace_back(kCameraColorVideo.name);
  return names;
}

}  // namespace telepalp::wire
