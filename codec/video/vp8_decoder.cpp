#include <vpx/vp8dx.h>
#include <vpx/vpx_decoder.h>

#include <cstdint>

#include "codec/video.h"
#include "codec/video/vp8_header.h"
#include "codec/video/yuv_planes.h"
#include "proto/words/demand.h"

namespace telepalp::codec {

struct ColorVideoDecoder::State {
  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { close(); }

  void close() {
    if (open) vpx_codec_destroy(&codec);
    open = false;
    frame = nullptr;
  }
  bool begin() {
    close();
    const vpx_codec_dec_cfg_t config{.threads = 1, .w = 0, .h = 0};
    open = vpx_codec_dec_init(&codec, vpx_codec_vp8_dx(), &config, 0) == VPX_CODEC_OK;
    return open;
  }
  /// nullptr: the frame cannot be decoded, or libvpx filled a part of it by guessing.
  const vpx_image_t* decoded(std::span<const std::byte> packet) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(packet.data());
    if (vpx_codec_decode(&codec, bytes, static_cast<unsigned>(packet.size()), nullptr, 0) != VPX_CODEC_OK)
      return nullptr;
    int guessed = 0;
    if (vpx_codec_control(&codec, VP8D_GET_FRAME_CORRUPTED, &guessed) != VPX_CODEC_OK || guessed != 0) return nullptr;
    vpx_codec_iter_t at = nullptr;
    return vpx_codec_get_frame(&codec, &at);
  }

  vpx_codec_ctx_t codec{};
  bool open = false;                   // false: the next frame must be a key frame
  const vpx_image_t* frame = nullptr;  // libvpx's, until the next packet
  int width = 0;                       // of the last key frame
  int height = 0;
  mutable YuvConverter converter;  // its buffers alone change
};

ColorVideoDecoder::ColorVideoDecoder() : state_(std::make_unique<State>()) {}
ColorVideoDecoder::~ColorVideoDecoder() = default;
ColorVideoDecoder::ColorVideoDecoder(ColorVideoDecoder&&) noexcept = default;
ColorVideoDecoder& ColorVideoDecoder::operator=(ColorVideoDecoder&&) noexcept = default;

void ColorVideoDecoder::lose_frame() noexcept { state_->close(); }

Result<void> ColorVideoDecoder::take(std::span<const std::byte> packet) {
  State& s = *state_;
  s.frame = nullptr;
  const Result<Vp8Header> header = read_vp8_header(packet);
  const auto refuse = [&](Error why) -> Result<void> {
    s.close();
    return why;
  };
  if (!header) return refuse(header.error());
  if (!header->key_frame && !s.open) return damaged_video("it is predicted from a frame that is missing");
  const bool same_size = header->width == s.width && header->height == s.height;
  if (header->key_frame && !(s.open && same_size) && !s.begin()) return damaged_video("libvpx has no VP8 decoder");
  if (header->key_frame) {
    s.width = header->width;
    s.height = header->height;
  }
  s.frame = s.decoded(packet);
  if (s.frame == nullptr) return refuse(damaged_video("it is damaged or cut short"));
  if (static_cast<int>(s.frame->d_w) != s.width || static_cast<int>(s.frame->d_h) != s.height ||
      s.frame->fmt != VPX_IMG_FMT_I420)
    return refuse(damaged_video("its size is not the one that its key frame declares"));
  return {};
}

ColorImage ColorVideoDecoder::picture() const {
  const State& s = *state_;
  demand(s.frame != nullptr, "a picture follows a frame that was taken in");
  return s.converter.color_of({.first = {s.frame->planes[0], s.frame->planes[1], s.frame->planes[2]},
                               .stride = {s.frame->stride[0], s.frame->stride[1], s.frame->stride[2]}},
                              s.width, s.height);
}

Result<ColorImage> ColorVideoDecoder::decode(std::span<const std::byte> packet) {
  const Result<void> taken = take(packet);
  if (!taken) return taken.error();
  return picture();
}

}  // namespace telepalp::codec
