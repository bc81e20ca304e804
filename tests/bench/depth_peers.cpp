#include "tests/bench/depth_peers.h"

#include <zstd.h>

#include <cstring>

#include "server/capture/images/image_file.h"

#if defined(TELEPALP_HAVE_CHARLS)
#include <charls/charls.h>
#endif
#if defined(TELEPALP_HAVE_JXL)
#include <jxl/decode.h>
#include <jxl/encode.h>
#endif

namespace telepalp::bench {
namespace {

std::size_t raw_bytes(const DepthImage& depth) { return depth.samples.size() * sizeof(std::uint16_t); }

DepthPeer zstd_peer(int level) {
  return {
      .name = "zstd-" + std::to_string(level),
      .encode =
          [level](const DepthImage& depth) {
            std::string packet(ZSTD_compressBound(raw_bytes(depth)), '\0');
            packet.resize(ZSTD_compress(packet.data(), packet.size(), depth.samples.data(), raw_bytes(depth), level));
            return packet;
          },
      .decode =
          [](const std::string& packet, DepthImage& depth) {
            return ZSTD_decompress(depth.samples.data(), raw_bytes(depth), packet.data(), packet.size()) ==
                   raw_bytes(depth);
          }};
}

DepthPeer png_peer() {
  return {.name = "PNG-16",
          .encode =
              [](const DepthImage& depth) {
                return server::encode_png(server::GrayImage16{depth.width, depth.height, depth.samples});
              },
          .decode =
              [](const std::string& packet, DepthImage& depth) {
                Result<server::AnyImage> image = server::decode_png(std::as_bytes(std::span(packet)), "png");
                auto* const gray = image ? std::get_if<server::GrayImage16>(&*image) : nullptr;
                if (gray != nullptr) depth.samples = std::move(gray->samples);
                return gray != nullptr;
              }};
}

#if defined(TELEPALP_HAVE_CHARLS)
DepthPeer charls_peer() {
  return {.name = "JPEG-LS (CharLS)",
          .encode =
              [](const DepthImage& depth) {
                charls::jpegls_encoder encoder;
                encoder.frame_info(
                    {static_cast<std::uint32_t>(depth.width), static_cast<std::uint32_t>(depth.height), 16, 1});
                std::string packet(encoder.estimated_destination_size(), '\0');
                encoder.destination(packet);
                packet.resize(encoder.encode(depth.samples));
                return packet;
              },
          .decode =
              [](const std::string& packet, DepthImage& depth) {
                charls::jpegls_decoder decoder(packet, true);
                decoder.decode(depth.samples);
                return true;
              }};
}
#endif

#if defined(TELEPALP_HAVE_JXL)
constexpr JxlPixelFormat kGray16{1, JXL_TYPE_UINT16, JXL_LITTLE_ENDIAN, 0};

std::string encode_jxl(const DepthImage& depth) {
  JxlEncoder* const encoder = JxlEncoderCreate(nullptr);
  JxlBasicInfo info;
  JxlEncoderInitBasicInfo(&info);
  info.xsize = static_cast<std::uint32_t>(depth.width);
  info.ysize = static_cast<std::uint32_t>(depth.height);
  info.bits_per_sample = 16;
  info.num_color_channels = 1;
  info.uses_original_profile = JXL_TRUE;
  JxlEncoderSetBasicInfo(encoder, &info);
  JxlColorEncoding color;
  JxlColorEncodingSetToLinearSRGB(&color, JXL_TRUE);
  JxlEncoderSetColorEncoding(encoder, &color);
  JxlEncoderFrameSettings* const frame = JxlEncoderFrameSettingsCreate(encoder, nullptr);
  JxlEncoderSetFrameLossless(frame, JXL_TRUE);
  JxlEncoderFrameSettingsSetOption(frame, JXL_ENC_FRAME_SETTING_EFFORT, 1);
  JxlEncoderAddImageFrame(frame, &kGray16, depth.samples.data(), raw_bytes(depth));
  JxlEncoderCloseInput(encoder);
  std::string packet(2 * raw_bytes(depth) + 4096, '\0');
  auto* next = reinterpret_cast<std::uint8_t*>(packet.data());
  std::size_t room = packet.size();
  JxlEncoderProcessOutput(encoder, &next, &room);
  packet.resize(packet.size() - room);
  JxlEncoderDestroy(encoder);
  return packet;
}

bool decode_jxl(const std::string& packet, DepthImage& depth) {
  JxlDecoder* const decoder = JxlDecoderCreate(nullptr);
  JxlDecoderSubscribeEvents(decoder, JXL_DEC_FULL_IMAGE);
  JxlDecoderSetInput(decoder, reinterpret_cast<const std::uint8_t*>(packet.data()), packet.size());
  JxlDecoderCloseInput(decoder);
  JxlDecoderStatus status = JxlDecoderProcessInput(decoder);
  if (status == JXL_DEC_NEED_IMAGE_OUT_BUFFER) {
    JxlDecoderSetImageOutBuffer(decoder, &kGray16, depth.samples.data(), raw_bytes(depth));
    status = JxlDecoderProcessInput(decoder);
  }
  JxlDecoderDestroy(decoder);
  return status == JXL_DEC_FULL_IMAGE;
}
#endif

}  // namespace

std::vector<DepthPeer> depth_peers() {
  std::vector<DepthPeer> peers{zstd_peer(1), zstd_peer(3), png_peer()};
#if defined(TELEPALP_HAVE_CHARLS)
  peers.push_back(charls_peer());
#endif
#if defined(TELEPALP_HAVE_JXL)
  peers.push_back({.name = "JPEG XL, effort 1", .encode = encode_jxl, .decode = decode_jxl});
#endif
  return peers;
}

std::string missing_depth_peers() {
  std::string missing;
#if !defined(TELEPALP_HAVE_CHARLS)
  missing += " CharLS";
#endif
#if !defined(TELEPALP_HAVE_JXL)
  missing += " JPEG XL";
#endif
  return missing;
}

}  // namespace telepalp::bench
