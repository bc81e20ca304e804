#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

#include "proto/words/counted.h"

#include "support/images/image_file.h"

namespace telepalp::images {
namespace {

/// The file in memory, in the form that libtiff needs.
struct Memory {
  std::span<const std::byte> bytes;
  std::size_t at = 0;
};

tmsize_t read_memory(thandle_t handle, void* to, tmsize_t count) {
  auto* memory = static_cast<Memory*>(handle);
  const std::size_t left = memory->bytes.size() - std::min(memory->at, memory->bytes.size());
  const std::size_t taken = std::min(left, static_cast<std::size_t>(std::max<tmsize_t>(count, 0)));
  std::memcpy(to, memory->bytes.data() + (memory->bytes.size() - left), taken);
  memory->at += taken;
  return static_cast<tmsize_t>(taken);
}
tmsize_t write_nothing(thandle_t /*handle*/, void* /*from*/, tmsize_t /*count*/) { return 0; }
toff_t seek_memory(thandle_t handle, toff_t offset, int whence) {
  auto* memory = static_cast<Memory*>(handle);
  const std::size_t base = whence == SEEK_CUR ? memory->at : whence == SEEK_END ? memory->bytes.size() : 0;
  memory->at = base + offset;
  return memory->at;
}
int close_memory(thandle_t /*handle*/) { return 0; }
toff_t size_of_memory(thandle_t handle) { return static_cast<Memory*>(handle)->bytes.size(); }

int keep_message(TIFF* /*tiff*/, void* to, const char* /*module*/, const char* format, va_list arguments) {
  char message[200];
  std::vsnprintf(message, sizeof message, format, arguments);
  auto& kept = *static_cast<std::string*>(to);
  if (kept.empty()) kept = message;
  return 1;
}
int ignore_message(TIFF* /*tiff*/, void* /*to*/, const char* /*module*/, const char* /*format*/, va_list /*args*/) {
  return 1;
}

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

Tiff open_memory(Memory& memory, std::string& message) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options{TIFFOpenOptionsAlloc(),
                                                                             TIFFOpenOptionsFree};
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &message);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
  return Tiff{TIFFClientOpenExt("memory", "rm", &memory, read_memory, write_nothing, seek_memory, close_memory,
                                size_of_memory, nullptr, nullptr, options.get())};
}

struct TiffHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t bits = 1;
  std::uint16_t channels = 1;
  std::uint16_t planes = PLANARCONFIG_CONTIG;
  std::uint16_t format = SAMPLEFORMAT_UINT;
  bool tiled = false;
};

TiffHeader header_of(TIFF* tiff) {
  TiffHeader header;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &header.width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &header.height);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &header.bits);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &header.channels);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &header.planes);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &header.format);
  header.tiled = TIFFIsTiled(tiff) != 0;
  return header;
}

bool read_gray16(TIFF* tiff, GrayImage16& image) {
  for (int row = 0; row < image.height; ++row)
    if (TIFFReadScanline(tiff, &image.samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width)],
                         static_cast<std::uint32_t>(row), 0) < 0)
      return false;
  return true;
}

bool read_color(TIFF* tiff, ColorImage& image) {
  const std::size_t width = static_cast<std::size_t>(image.width);
  std::vector<std::uint32_t> abgr(width * static_cast<std::size_t>(image.height));
  if (TIFFReadRGBAImageOriented(tiff, static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height),
                                abgr.data(), ORIENTATION_TOPLEFT, 1) == 0)
    return false;
  for (std::size_t i = 0; i < abgr.size(); ++i) {
    image.rgb[3 * i] = static_cast<std::uint8_t>(TIFFGetR(abgr[i]));
    image.rgb[3 * i + 1] = static_cast<std::uint8_t>(TIFFGetG(abgr[i]));
    image.rgb[3 * i + 2] = static_cast<std::uint8_t>(TIFFGetB(abgr[i]));
  }
  return true;
}

constexpr std::uint16_t kMostChannels = 4;

/// True when a strip or tile, which libtiff decodes at once, is no larger than the largest accepted image.
bool decodes_in_bounds(TIFF* tiff, const TiffHeader& header) {
  constexpr tmsize_t kMostBytes = tmsize_t{4} * kMaxImageSide * kMaxImageSide;
  const tmsize_t bytes = header.tiled ? TIFFTileSize(tiff) : TIFFStripSize(tiff);
  return bytes > 0 && bytes <= kMostBytes;
}

}  // namespace

Result<AnyImage> decode_tiff(std::span<const std::byte> bytes, const std::string& name) {
  const auto refuse = [&name](std::string what) {
    return Error{.what = std::move(what),
                 .where = name,
                 .fix = "give a whole TIFF, 16-bit grey for depth or 8-bit RGB for colour, at most " +
                        std::to_string(kMaxImageSide) + " pixels a side"};
  };
  Memory memory{bytes};
  std::string message;
  const Tiff tiff = open_memory(memory, message);
  if (!tiff) return refuse("is not a TIFF file: " + message);
  const TiffHeader header = header_of(tiff.get());
  if (header.width == 0 || header.height == 0 || header.width > kMaxImageSide || header.height > kMaxImageSide)
    return refuse("is " + std::to_string(header.width) + " x " + std::to_string(header.height) + " pixels, not 1 to " +
                  std::to_string(kMaxImageSide) + " a side");
  if (header.channels == 0 || header.channels > kMostChannels)
    return refuse("has " + std::to_string(header.channels) + " channels, not 1 to " + std::to_string(kMostChannels));
  if (!decodes_in_bounds(tiff.get(), header))
    return refuse("has strips or tiles that are empty or larger than the largest accepted image");
  const auto width = static_cast<int>(header.width);
  const auto height = static_cast<int>(header.height);
  const std::size_t pixels = std::size_t{header.width} * header.height;
  if (header.bits == 16 && header.channels == 1) {
    if (header.tiled) return refuse("is a 16-bit grey image in tiles, but only strips of rows can be read");
    if (header.format != SAMPLEFORMAT_UINT)
      return refuse("is a 16-bit grey image whose pixels are not unsigned integers");
    if (static_cast<std::size_t>(TIFFScanlineSize(tiff.get())) != 2 * std::size_t{header.width})
      return refuse("has rows that do not hold 2 bytes a pixel");
    GrayImage16 image{width, height, std::vector<std::uint16_t>(pixels)};
    if (!read_gray16(tiff.get(), image)) return refuse("cannot be decoded: " + message);
    return AnyImage{std::move(image)};
  }
  if (header.bits != 8)
    return refuse("has " + counted(header.channels, "channel of ", "channels of ") + std::to_string(header.bits) +
                  " bits, not one channel of 16 bits or channels of 8 bits");
  ColorImage image{width, height, std::vector<std::uint8_t>(3 * pixels)};
  if (!read_color(tiff.get(), image)) return refuse("cannot be decoded: " + message);
  return AnyImage{std::move(image)};
}

}  // namespace telepalp::images
