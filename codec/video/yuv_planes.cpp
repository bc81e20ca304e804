#include "codec/video/yuv_planes.h"

#include <turbojpeg.h>

#include <algorithm>

#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

constexpr int kLumaLeast = 16;     // BT.601: black
constexpr int kLumaRange = 219;    // BT.601: from black to white
constexpr int kChromaRange = 224;  // BT.601
constexpr int kFull = 255;         // JFIF: range of luma and of chroma
constexpr int kMiddle = 128;       // chroma of grey, in both

/// The samples of TurboJPEG's planes use the full range from 0 to 255 (JFIF), those of video the narrower ranges of
/// BT.601. A table maps one range to the other.
using Table = std::array<std::uint8_t, 256>;

template <class Value>
constexpr Table table_of(Value value) {
  Table table{};
  for (int i = 0; i < 256; ++i) table[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value(i));
  return table;
}

/// `a` / `b`, rounded to the nearest whole number. `b` > 0.
constexpr int rounded(int a, int b) { return (2 * a + (a < 0 ? -b : b)) / (2 * b); }

constexpr Table kLumaToVideo = table_of([](int full) { return kLumaLeast + rounded(full * kLumaRange, kFull); });
constexpr Table kChromaToVideo =
    table_of([](int full) { return kMiddle + rounded((full - kMiddle) * kChromaRange, kFull); });
constexpr Table kLumaFromVideo =
    table_of([](int video) { return std::clamp(rounded((video - kLumaLeast) * kFull, kLumaRange), 0, kFull); });
constexpr Table kChromaFromVideo = table_of(
    [](int video) { return std::clamp(kMiddle + rounded((video - kMiddle) * kFull, kChromaRange), 0, kFull); });

constexpr int half(int side) { return (side + 1) / 2; }

struct PlaneSize {
  int width = 0;
  int height = 0;
  [[nodiscard]] std::size_t samples() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// TurboJPEG pads the luma of an odd width or height to an even one.
PlaneSize size_of(std::size_t plane, int width, int height) {
  return plane == 0 ? PlaneSize{2 * half(width), 2 * half(height)} : PlaneSize{half(width), half(height)};
}

/// Copies a plane of video of `width` x `height` samples to TurboJPEG's plane `to`, which may have one column and one
/// row more: they repeat the last ones.
void copy_plane(const std::uint8_t* from, int stride, int width, int height, const Table& table, PlaneSize size,
                std::uint8_t* to) {
  for (int row = 0; row < size.height; ++row) {
    const std::uint8_t* video = from + static_cast<std::ptrdiff_t>(std::min(row, height - 1)) * stride;
    std::uint8_t* full = to + static_cast<std::ptrdiff_t>(row) * size.width;
    std::transform(video, video + width, full, [&](std::uint8_t sample) { return table[sample]; });
    if (size.width > width) full[width] = full[width - 1];
  }
}

}  // namespace

struct YuvConverter::Turbo {
  Turbo() = default;
  Turbo(const Turbo&) = delete;
  Turbo& operator=(const Turbo&) = delete;
  ~Turbo() {
    tjDestroy(compress);
    tjDestroy(decompress);
  }
  void* compress = tjInitCompress();
  void* decompress = tjInitDecompress();
};

YuvConverter::YuvConverter() : turbo_(std::make_unique<Turbo>()) {}
YuvConverter::~YuvConverter() = default;
YuvConverter::YuvConverter(YuvConverter&&) noexcept = default;
YuvConverter& YuvConverter::operator=(YuvConverter&&) noexcept = default;

PlaneRows YuvConverter::planes_of(const ColorImage& color) {
  std::array<unsigned char*, 3> rows{};
  PlaneRows planes;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    const PlaneSize size = size_of(plane, color.width, color.height);
    planes_[plane].resize(size.samples());
    rows[plane] = planes_[plane].data();
    planes.first[plane] = planes_[plane].data();
    planes.stride[plane] = size.width;
  }
  const int failed = tjEncodeYUVPlanes(turbo_->compress, color.rgb.data(), color.width, 0, color.height, TJPF_RGB,
                                       rows.data(), planes.stride.data(), TJSAMP_420, TJFLAG_FASTDCT);
  demand(failed == 0, "libjpeg-turbo converts any well-formed image");
  for (std::size_t plane = 0; plane < 3; ++plane) {
    const Table& table = plane == 0 ? kLumaToVideo : kChromaToVideo;
    for (std::uint8_t& sample : planes_[plane]) sample = table[sample];
  }
  return planes;
}

ColorImage YuvConverter::color_of(const PlaneRows& from, int width, int height) {
  std::array<const unsigned char*, 3> rows{};
  std::array<int, 3> strides{};
  for (std::size_t plane = 0; plane < 3; ++plane) {
    const PlaneSize size = size_of(plane, width, height);
    planes_[plane].resize(size.samples());
    rows[plane] = planes_[plane].data();
    strides[plane] = size.width;
    const bool luma = plane == 0;
    copy_plane(from.first[plane], from.stride[plane], luma ? width : half(width), luma ? height : half(height),
               luma ? kLumaFromVideo : kChromaFromVideo, size, planes_[plane].data());
  }
  ColorImage color{.width = width, .height = height, .rgb = {}};
  color.rgb.resize(3 * PlaneSize{width, height}.samples());
  const int failed = tjDecodeYUVPlanes(turbo_->decompress, rows.data(), strides.data(), TJSAMP_420, color.rgb.data(),
                                       width, 0, height, TJPF_RGB, 0);
  demand(failed == 0, "libjpeg-turbo converts planes of any size");
  return color;
}

}  // namespace telepalp::codec
