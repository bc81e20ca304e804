#include "tests/bench/depth/depth_peers.h"

#include <png.h>
#include <zstd.h>

#include <cstring>

#include "support/images/image_file.h"
#include "tests/bench/depth/depth_peer_ffv1.h"

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

/// libpng with its usual settings: level 6 and automatic choice of filters.
std::string encode_png_6(const DepthImage& depth) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::string packet;
  png_set_write_fn(
      png, &packet,
      [](png_structp writer, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(writer))->append(reinterpret_cast<const char*>(bytes), count);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(depth.width), static_cast<png_uint_32>(depth.height), 16,
               PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 6);
  png_write_info(png, info);
  png_set_swap(png);
  for (int row = 0; row < depth.height; ++row)
    png_write_row(
        png, reinterpret_cast<png_const_bytep>(depth.samples.data() + static_cast<std::ptrdiff_t>(row) * depth.width));
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return packet;
}

DepthPeer png_peer() {
  return {.name = "PNG-6", .encode = encode_png_6, .decode = [](const std::string& packet, DepthImage& depth) {
            Result<images::AnyImage> image = images::decode_png(std::as_bytes(std::span(packet)), "png");
            auto* const gray = image ? std::get_if<images::GrayImage16>(&*image) : nullptr;
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
#if defined(TELEPALP_HAVE_FFV1)
  peers.push_back(ffv1_peer());
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
#if !defined(TELEPALP_HAVE_FFV1)
  missing += " FFV1";
#endif
#if !defined(TELEPALP_HAVE_JXL)
  missing += " JPEG XL";
#endif
  return missing;
}

}  // namespace telepalp::bench
