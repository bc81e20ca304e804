#include "tests/bench/depth/depth_peer_ffv1.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/frame.h>
#include <libavutil/opt.h>
}

#include <cstring>
#include <memory>

#include "codec/levels/level_palette.h"
#include "proto/words/demand.h"

namespace telepalp::bench {
namespace {

struct Free {
  void operator()(AVCodecContext* context) const noexcept { avcodec_free_context(&context); }
  void operator()(AVFrame* frame) const noexcept { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const noexcept { av_packet_free(&packet); }
};
using Context = std::unique_ptr<AVCodecContext, Free>;
using Frame = std::unique_ptr<AVFrame, Free>;
using Packet = std::unique_ptr<AVPacket, Free>;

Context open(const AVCodec* codec, int width, int height) {
  Context context(avcodec_alloc_context3(codec));
  context->width = width;
  context->height = height;
  context->pix_fmt = AV_PIX_FMT_GRAY16LE;
  context->time_base = {1, 30};
  context->thread_count = 1;
  context->level = 3;
  context->gop_size = 1;  // every frame stands alone
  context->strict_std_compliance = FF_COMPLIANCE_EXPERIMENTAL;
  av_opt_set_int(context->priv_data, "slicecrc", 0, 0);  // compare() checks the samples instead
  demand(avcodec_open2(context.get(), codec, nullptr) == 0, "libavcodec opens FFV1");
  return context;
}

/// One context for each direction and run: opening costs more than coding.
struct Ffv1 {
  Context encoder, decoder;

  void prepare(int width, int height) {
    if (encoder && encoder->width == width && encoder->height == height) return;
    encoder = open(avcodec_find_encoder(AV_CODEC_ID_FFV1), width, height);
    decoder.reset(avcodec_alloc_context3(avcodec_find_decoder(AV_CODEC_ID_FFV1)));
    decoder->thread_count = 1;
    decoder->extradata = static_cast<std::uint8_t*>(
        av_mallocz(static_cast<std::size_t>(encoder->extradata_size) + AV_INPUT_BUFFER_PADDING_SIZE));
    std::memcpy(decoder->extradata, encoder->extradata, static_cast<std::size_t>(encoder->extradata_size));
    decoder->extradata_size = encoder->extradata_size;
    decoder->width = width;
    decoder->height = height;
    demand(avcodec_open2(decoder.get(), decoder->codec, nullptr) == 0, "libavcodec opens FFV1");
  }

  std::string encode(const DepthImage& depth) {
    prepare(depth.width, depth.height);
    const codec::LevelPalette palette = codec::palette_of(depth.samples);
    const std::vector<std::uint16_t> ranks = codec::ranks_by(codec::ranks_of(palette), depth.samples);
    const Frame frame(av_frame_alloc());
    frame->width = depth.width;
    frame->height = depth.height;
    frame->format = AV_PIX_FMT_GRAY16LE;
    demand(av_frame_get_buffer(frame.get(), 0) == 0, "memory for a frame");
    const auto row_bytes = static_cast<std::size_t>(depth.width) * sizeof(std::uint16_t);
    for (int row = 0; row < depth.height; ++row)
      std::memcpy(frame->data[0] + static_cast<std::ptrdiff_t>(row) * frame->linesize[0],
                  ranks.data() + static_cast<std::ptrdiff_t>(row) * depth.width, row_bytes);
    const Packet packet(av_packet_alloc());
    demand(
        avcodec_send_frame(encoder.get(), frame.get()) == 0 && avcodec_receive_packet(encoder.get(), packet.get()) == 0,
        "FFV1 encodes a frame");
    std::string out;
    codec::append_palette(out, palette);
    const auto levels_bytes = static_cast<std::uint32_t>(out.size());
    out.insert(0, reinterpret_cast<const char*>(&levels_bytes), sizeof levels_bytes);
    return out.append(reinterpret_cast<const char*>(packet->data), static_cast<std::size_t>(packet->size));
  }

  bool decode(const std::string& bytes, DepthImage& depth) {
    std::uint32_t levels_bytes = 0;
    std::memcpy(&levels_bytes, bytes.data(), sizeof levels_bytes);
    const std::string_view levels(bytes.data() + sizeof levels_bytes, levels_bytes);
    codec::ByteReader reader(std::as_bytes(std::span(levels)));
    const auto palette = codec::read_palette(reader);
    const std::size_t start = sizeof levels_bytes + levels_bytes;
    const Packet packet(av_packet_alloc());
    if (!palette || av_new_packet(packet.get(), static_cast<int>(bytes.size() - start)) != 0) return false;
    std::memcpy(packet->data, bytes.data() + start, bytes.size() - start);
    const Frame frame(av_frame_alloc());
    if (avcodec_send_packet(decoder.get(), packet.get()) != 0 || avcodec_receive_frame(decoder.get(), frame.get()) != 0)
      return false;
    for (int row = 0; row < depth.height; ++row) {
      const auto* ranks = reinterpret_cast<const std::uint16_t*>(frame->data[0] +
                                                                 static_cast<std::ptrdiff_t>(row) * frame->linesize[0]);
      std::uint16_t* const out = depth.samples.data() + static_cast<std::ptrdiff_t>(row) * depth.width;
      for (int x = 0; x < depth.width; ++x) {
        if (ranks[x] >= palette->size()) return false;
        out[x] = palette->levels[ranks[x]];
      }
    }
    return true;
  }
};

}  // namespace

DepthPeer ffv1_peer() {
  const auto ffv1 = std::make_shared<Ffv1>();
  return {.name = "rank + FFV1",
          .encode = [ffv1](const DepthImage& depth) { return ffv1->encode(depth); },
          .decode = [ffv1](const std::string& packet, DepthImage& depth) { return ffv1->decode(packet, depth); }};
}

}  // namespace telepalp::bench
