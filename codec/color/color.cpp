#include "codec/color.h"

#include <turbojpeg.h>

#include <memory>

#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

struct CloseTurbo {
  void operator()(void* handle) const noexcept { tjDestroy(handle); }
};
using Turbo = std::unique_ptr<void, CloseTurbo>;

struct FreeTurbo {
  void operator()(unsigned char* bytes) const noexcept { tjFree(bytes); }
};

Error damaged_color(std::string what) {
  return {.what = std::move(what), .where = "colour image", .fix = "send or record the image again"};
}

std::string compressed(const std::uint8_t* pixels, int width, int height, TJPF format, TJSAMP chroma, int quality) {
  const Turbo turbo(tjInitCompress());
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const int failed =
      tjCompress2(turbo.get(), pixels, width, 0, height, format, &bytes, &size, chroma, quality, TJFLAG_FASTDCT);
  const std::unique_ptr<unsigned char, FreeTurbo> owned(bytes);
  demand(failed == 0, "libjpeg-turbo compresses any well-formed image");
  return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace

std::string encode_color(const ColorImage& color, int quality) {
  demand(is_well_formed(color) && !color.rgb.empty(), "encode_color is given a well-formed image");
  return compressed(color.rgb.data(), color.width, color.height, TJPF_RGB, TJSAMP_420, quality);
}

std::string encode_gray(std::span<const std::uint8_t> gray, int width, int height, int quality) {
  demand(width > 0 && height > 0 && gray.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
         "encode_gray is given a well-formed image");
  return compressed(gray.data(), width, height, TJPF_GRAY, TJSAMP_GRAY, quality);
}

Result<ColorImage> decode_color(std::span<const std::byte> jpeg) {
  const Turbo turbo(tjInitDecompress());
  const auto* bytes = reinterpret_cast<const unsigned char*>(jpeg.data());
  ColorImage color;
  int subsampling = 0;
  int colorspace = 0;
  if (tjDecompressHeader3(turbo.get(), bytes, jpeg.size(), &color.width, &color.height, &subsampling, &colorspace) != 0)
    return damaged_color("its JPEG header cannot be read");
  if (color.width < 1 || color.height < 1 || color.width > kMaxImageSide || color.height > kMaxImageSide)
    return damaged_color("it declares " + std::to_string(color.width) + " x " + std::to_string(color.height) +
                         " pixels, not 1 to " + std::to_string(kMaxImageSide) + " a side");
  color.rgb.resize(3 * static_cast<std::size_t>(color.width) * static_cast<std::size_t>(color.height));
  // libjpeg only warns of a truncated picture and fills the rest with grey: a warning is an error here. A progressive
  // picture of thousands of scans takes minutes to decode: TurboJPEG refuses more than 500.
  if (tjDecompress2(turbo.get(), bytes, jpeg.size(), color.rgb.data(), color.width, 0, color.height, TJPF_RGB,
                    TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0)
    return damaged_color(std::string("it is damaged: ") + tjGetErrorStr2(turbo.get()));
  return color;
}

}  // namespace telepalp::codec
