#include "tools/codec_tool/pgm.h"

#include <charconv>

#include "proto/words/rgbd_frame.h"

namespace telepalp::codec_tool {
namespace {

bool is_space(char letter) noexcept { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

/// Removes the next number from the header, after white space and comments; -1 when there is none.
int take_number(std::string_view& rest) {
  while (!rest.empty() && (is_space(rest.front()) || rest.front() == '#'))
    rest.remove_prefix(rest.front() == '#' ? std::min(rest.find('\n'), rest.size()) : 1);
  int value = -1;
  const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (problem != std::errc{}) return -1;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return value;
}

}  // namespace

Result<images::GrayImage16> decode_pgm(std::string_view bytes, const std::string& name) {
  const auto refused = [&](const std::string& what) {
    return Error{.what = what, .where = name, .fix = "give a whole binary PGM (P5) of 16 bits a pixel"};
  };
  if (!bytes.starts_with("P5")) return refused("is not a binary PGM");
  std::string_view rest = bytes.substr(2);
  images::GrayImage16 image{.width = take_number(rest), .height = take_number(rest), .samples = {}};
  const int most = take_number(rest);
  if (image.width < 1 || image.height < 1 || image.width > kMaxImageSide || image.height > kMaxImageSide)
    return refused("does not declare a width and a height from 1 to " + std::to_string(kMaxImageSide) + " pixels");
  if (most < 256 || most > 65535 || rest.empty()) return refused("has no 16-bit pixels");
  rest.remove_prefix(1);
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (rest.size() < 2 * count) return refused("ends before its last pixel");
  image.samples.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    image.samples[i] = static_cast<std::uint16_t>(static_cast<unsigned char>(rest[2 * i]) << 8 |
                                                  static_cast<unsigned char>(rest[2 * i + 1]));
  return image;
}

std::string encode_pgm(const images::GrayImage16& image) {
  std::string bytes = "P5\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n65535\n";
  for (const std::uint16_t sample : image.samples) {
    bytes.push_back(static_cast<char>(sample >> 8));
    bytes.push_back(static_cast<char>(sample & 0xff));
  }
  return bytes;
}

}  // namespace telepalp::codec_tool
