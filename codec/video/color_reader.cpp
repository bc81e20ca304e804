#include "codec/color_reader.h"

#include "codec/color.h"

namespace telepalp::codec {

Result<void> ColorReader::take_video(std::span<const std::byte> bytes, std::uint64_t number) {
  // A session file keeps the low 32 bits of a number.
  const bool follows = static_cast<std::uint32_t>(number) == static_cast<std::uint32_t>(last_number_ + 1);
  if (number != 0 && last_number_ != 0 && !follows) video_.lose_frame();
  last_number_ = number;
  return video_.take(bytes);
}

Result<ColorImage> ColorReader::read(std::string_view format, std::span<const std::byte> bytes, std::uint64_t number) {
  if (format != kVideoFormat) return decode_color(bytes);
  const Result<void> taken = take_video(bytes, number);
  if (!taken) return taken.error();
  return video_.picture();
}

void ColorReader::skip(std::string_view format, std::span<const std::byte> bytes, std::uint64_t number) {
  if (format == kVideoFormat) (void)take_video(bytes, number);
}

}  // namespace telepalp::codec
