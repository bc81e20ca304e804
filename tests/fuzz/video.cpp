#include <cstdint>

#include "codec/color_reader.h"
#include "proto/words/demand.h"

/// Any bytes as frames of video give errors or whole pictures, also after frames that were taken in. The input is a
/// sequence of frames: two bytes with the frame's size, little-endian, then the frame.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp;
  codec::ColorReader reader;
  const auto bytes = std::as_bytes(std::span(data, size));
  std::size_t at = 0;
  for (std::uint64_t number = 1; at + 2 <= size; ++number) {
    const std::size_t asked = data[at] | std::size_t{data[at + 1]} << 8;
    at += 2;
    const std::size_t length = asked < size - at ? asked : size - at;
    const Result<ColorImage> color = reader.read(codec::kVideoFormat, bytes.subspan(at, length), number);
    if (color) demand(is_well_formed(*color) && !color->rgb.empty(), "what is decoded is a whole picture");
    at += length;
  }
  return 0;
}
