#include "tools/export_tool/deidentify/color_mosaic.h"

#include <algorithm>
#include <array>
#include <span>

#include "codec/color.h"
#include "foxglove/CompressedImage.pb.h"
#include "foxglove/CompressedVideo.pb.h"
#include "proto/wire/camera/color_message.h"

namespace telepalp::export_tool {
namespace {

/// The columns and rows of one square of the mosaic, clipped by the image.
struct Square {
  int left, right, top, bottom;  // [left, right), [top, bottom)
};

std::size_t place_of(const ColorImage& color, int column, int row) {
  return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(color.width) + static_cast<std::size_t>(column));
}

void fill_with_mean(const ColorImage& from, ColorImage& to, const Square& square) {
  std::array<std::uint64_t, 3> sums{};
  for (int row = square.top; row < square.bottom; ++row)
    for (int column = square.left; column < square.right; ++column)
      for (std::size_t channel = 0; channel < 3; ++channel)
        sums[channel] += from.rgb[place_of(from, column, row) + channel];
  const auto pixels =
      static_cast<std::uint64_t>(square.right - square.left) * static_cast<std::uint64_t>(square.bottom - square.top);
  for (int row = square.top; row < square.bottom; ++row)
    for (int column = square.left; column < square.right; ++column)
      for (std::size_t channel = 0; channel < 3; ++channel)
        to.rgb[place_of(to, column, row) + channel] = static_cast<std::uint8_t>(sums[channel] / pixels);
}

template <class Proto>
std::string with_data(const std::string& payload, std::string format, std::string data) {
  Proto color;
  (void)color.ParseFromString(payload);  // compressed_color() has read it
  color.set_format(std::move(format));
  color.set_data(std::move(data));
  return color.SerializeAsString();
}

}  // namespace

ColorImage mosaic(const ColorImage& color) {
  ColorImage squares = color;
  const int side = std::max(1, (color.width + kMosaicColumns - 1) / kMosaicColumns);
  for (int top = 0; top < color.height; top += side)
    for (int left = 0; left < color.width; left += side)
      fill_with_mean(color, squares,
                     {left, std::min(left + side, color.width), top, std::min(top + side, color.height)});
  return squares;
}

std::optional<BlurredColor> ColorBlur::blurred(const wire::Message& message) {
  const std::optional<wire::CompressedColor> color = wire::compressed_color(message);
  if (!color) return std::nullopt;
  const bool is_video = message.topic.name == wire::kCameraColorVideo.name;
  const Result<ColorImage> image =
      (is_video ? video_ : pictures_).read(color->format, std::as_bytes(std::span(color->data)), color->number);
  if (!image || image->rgb.empty()) return std::nullopt;
  const ColorImage squares = mosaic(*image);
  if (!is_video)
    return BlurredColor{with_data<foxglove::CompressedImage>(*message.payload, "jpeg", codec::encode_color(squares)),
                        true};
  if (!codec::ColorVideoEncoder::can_encode(squares)) return std::nullopt;
  codec::EncodedVideo video = encoder_.encode(squares, session_time(color->captured_ns));
  return BlurredColor{
      with_data<foxglove::CompressedVideo>(*message.payload, codec::kVideoFormat, std::move(video.bytes)),
      video.key_frame};
}

}  // namespace telepalp::export_tool
