#include <cstdint>

#include "codec/color.h"
#include "proto/words/demand.h"

/// Any bytes as a JPEG give an error or a whole picture.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace telepalp;
  const Result<ColorImage> color = codec::decode_color(std::as_bytes(std::span(data, size)));
  if (color) demand(is_well_formed(*color) && !color->rgb.empty(), "what is decoded is a whole picture");
  return 0;
}
