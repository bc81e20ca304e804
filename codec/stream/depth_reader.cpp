#include <utility>
#include <vector>

#include "codec/depth_stream.h"
#include "codec/stream/packet_decoder.h"

namespace telepalp::codec {
namespace {

// One second of frames. Beyond either bound, skipped frames are decoded instead of kept.
constexpr std::size_t kMostSkipped = 32;
constexpr std::size_t kMostSkippedBytes = std::size_t{16} << 20;

std::span<const std::byte> bytes_of(const std::string& packet) { return std::as_bytes(std::span(packet)); }

bool is_key(const Packet& packet) noexcept { return packet.header.coding != Coding::Dependent; }

}  // namespace

struct DepthReader::State {
  PacketDecoder decoder;
  std::vector<std::string> skipped;  // since the last key frame, or the last frame read; bounded
  std::size_t skipped_bytes = 0;

  void decode_skipped() {
    for (const std::string& bytes : skipped)
      if (const Result<Packet> packet = read_packet(bytes_of(bytes))) (void)decoder.decode(*packet);
    forget_skipped();
  }
  void forget_skipped() {
    skipped.clear();
    skipped_bytes = 0;
  }
};

DepthReader::DepthReader() : state_(std::make_unique<State>()) {}
DepthReader::~DepthReader() = default;
DepthReader::DepthReader(DepthReader&&) noexcept = default;
DepthReader& DepthReader::operator=(DepthReader&&) noexcept = default;

void DepthReader::skip(std::string packet) {
  State& state = *state_;
  if (is_key_frame(bytes_of(packet))) state.forget_skipped();
  state.skipped_bytes += packet.size();
  state.skipped.push_back(std::move(packet));
  if (state.skipped.size() > kMostSkipped || state.skipped_bytes > kMostSkippedBytes) state.decode_skipped();
}

Result<DecodedDepth> DepthReader::read(std::span<const std::byte> bytes) {
  State& state = *state_;
  const Result<Packet> packet = read_packet(bytes);
  if (packet && is_key(*packet)) state.forget_skipped();
  state.decode_skipped();
  if (!packet) return packet.error();
  Result<DepthImage> image = state.decoder.decode(*packet);
  if (!image) return image.error();
  return DecodedDepth{.image = std::move(*image),
                      .mode = packet->header.mode,
                      .key_frame = is_key(*packet),
                      .window = packet->header.window};
}

}  // namespace telepalp::codec
