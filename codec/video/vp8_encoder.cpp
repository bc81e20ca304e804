#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

#include <algorithm>
#include <optional>

#include "codec/video.h"
#include "codec/video/yuv_planes.h"
#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

using namespace std::chrono_literals;

constexpr int kTicks_per_s = 90'000;  // of libvpx's clock
// Bounds of a frame's duration, the time since the capture of the frame before.
constexpr Nanoseconds kShortest = 1ms;
constexpr Nanoseconds kLongest = 1s;
constexpr Nanoseconds kUsual = 33'333'333ns;  // duration of the first frame

/// libvpx's speed in real time, 0 to -16. Measured on a noisy room at 800 kbit/s: -10 takes 3.8 ms an image, -8 takes
/// 7 % longer, and -16 takes 12 % less. The similarity to the camera's images (SSIM) differs by 0.003 from -8 to -16.
constexpr int kSpeed = -10;

std::int64_t ticks(Nanoseconds time) { return time.count() * kTicks_per_s / 1'000'000'000; }

vpx_codec_enc_cfg_t configuration(int width, int height, const ColorVideoSettings& settings) {
  vpx_codec_enc_cfg_t config;
  demand(vpx_codec_enc_config_default(vpx_codec_vp8_cx(), &config, 0) == VPX_CODEC_OK,
         "libvpx was built with its VP8 encoder");
  config.g_w = static_cast<unsigned>(width);
  config.g_h = static_cast<unsigned>(height);
  config.g_timebase = {1, kTicks_per_s};
  config.g_threads = 1;
  config.g_lag_in_frames = 0;
  config.g_pass = VPX_RC_ONE_PASS;
  config.rc_end_usage = VPX_CBR;
  config.rc_target_bitrate = static_cast<unsigned>(settings.kbit_per_s);
  config.rc_dropframe_thresh = 0;  // each colour image is a message
  config.rc_resize_allowed = 0;
  config.rc_min_quantizer = 2;
  config.rc_max_quantizer = 56;
  config.rc_undershoot_pct = 100;
  config.rc_overshoot_pct = 15;
  config.rc_buf_sz = 1000;  // ms
  config.rc_buf_initial_sz = 500;
  config.rc_buf_optimal_sz = 600;
  config.kf_mode = VPX_KF_DISABLED;  // encode() places them
  return config;
}

}  // namespace

struct ColorVideoEncoder::State {
  explicit State(const ColorVideoSettings& asked) : settings(asked) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { close(); }

  void close() {
    if (open) vpx_codec_destroy(&codec);
    open = false;
  }
  void begin(int width, int height) {
    close();
    config = configuration(width, height, settings);
    demand(vpx_codec_enc_init(&codec, vpx_codec_vp8_cx(), &config, 0) == VPX_CODEC_OK,
           "libvpx encodes any size that can_encode() allows");
    open = true;
    vpx_codec_control(&codec, VP8E_SET_CPUUSED, kSpeed);
    vpx_codec_control(&codec, VP8E_SET_TOKEN_PARTITIONS, 0);
    vpx_codec_control(&codec, VP8E_SET_STATIC_THRESHOLD, 1U);
    vpx_codec_control(&codec, VP8E_SET_MAX_INTRA_BITRATE_PCT, 900U);
    key_frame_wanted = true;
  }

  ColorVideoSettings settings;
  YuvConverter converter;
  vpx_codec_ctx_t codec{};
  vpx_codec_enc_cfg_t config{};
  bool open = false;
  bool key_frame_wanted = true;
  int since_key = 0;
  std::int64_t at_ticks = 0;
  std::optional<SessionTime> last;
};

ColorVideoEncoder::ColorVideoEncoder(const ColorVideoSettings& settings) : state_(std::make_unique<State>(settings)) {
  demand(settings.kbit_per_s > 0 && settings.key_every > 0, "the rate and the distance of key frames are positive");
}
ColorVideoEncoder::~ColorVideoEncoder() = default;
ColorVideoEncoder::ColorVideoEncoder(ColorVideoEncoder&&) noexcept = default;
ColorVideoEncoder& ColorVideoEncoder::operator=(ColorVideoEncoder&&) noexcept = default;

void ColorVideoEncoder::request_key_frame() noexcept { state_->key_frame_wanted = true; }

bool ColorVideoEncoder::can_encode(const ColorImage& color) noexcept {
  return static_cast<std::size_t>(color.width) * static_cast<std::size_t>(color.height) <= kMaxVideoPixels;
}

void ColorVideoEncoder::set_rate(int kbit_per_s) {
  State& s = *state_;
  if (s.settings.kbit_per_s == kbit_per_s) return;
  s.settings.kbit_per_s = kbit_per_s;
  s.config.rc_target_bitrate = static_cast<unsigned>(kbit_per_s);
  if (s.open) demand(vpx_codec_enc_config_set(&s.codec, &s.config) == VPX_CODEC_OK, "libvpx accepts another rate");
}

EncodedVideo ColorVideoEncoder::encode(const ColorImage& color, SessionTime captured) {
  demand(is_well_formed(color) && !color.rgb.empty() && can_encode(color), "a video frame is a well-formed image");
  State& s = *state_;
  if (!s.open || static_cast<int>(s.config.g_w) != color.width || static_cast<int>(s.config.g_h) != color.height)
    s.begin(color.width, color.height);
  const Nanoseconds since = s.last ? std::clamp<Nanoseconds>(captured - *s.last, kShortest, kLongest) : kUsual;
  s.last = captured;
  s.at_ticks += ticks(since);
  const bool key = s.key_frame_wanted || s.since_key + 1 >= s.settings.key_every;
  const PlaneRows planes = s.converter.planes_of(color);
  vpx_image_t image;
  vpx_img_wrap(&image, VPX_IMG_FMT_I420, s.config.g_w, s.config.g_h, 1, const_cast<std::uint8_t*>(planes.first[0]));
  for (std::size_t plane = 0; plane < 3; ++plane) {
    image.planes[plane] = const_cast<std::uint8_t*>(planes.first[plane]);  // libvpx only reads them
    image.stride[plane] = planes.stride[plane];
  }
  const vpx_codec_err_t failed =
      vpx_codec_encode(&s.codec, &image, s.at_ticks, static_cast<unsigned long>(ticks(since)),
                       key ? VPX_EFLAG_FORCE_KF : 0, VPX_DL_REALTIME);
  demand(failed == VPX_CODEC_OK, "libvpx encodes any well-formed image");
  EncodedVideo encoded;
  vpx_codec_iter_t at = nullptr;
  while (const vpx_codec_cx_pkt_t* packet = vpx_codec_get_cx_data(&s.codec, &at)) {
    if (packet->kind != VPX_CODEC_CX_FRAME_PKT) continue;
    encoded.bytes.assign(static_cast<const char*>(packet->data.frame.buf), packet->data.frame.sz);
    encoded.key_frame = (packet->data.frame.flags & VPX_FRAME_IS_KEY) != 0;
  }
  demand(!encoded.bytes.empty(), "libvpx drops no frame");
  s.key_frame_wanted = false;
  s.since_key = encoded.key_frame ? 0 : s.since_key + 1;
  return encoded;
}

}  // namespace telepalp::codec
