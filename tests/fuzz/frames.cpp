#include <cstdint>
#include <vector>

#include "proto/wire/frame.h"
#include "proto/words/demand.h"

namespace {

using namespace telepalp;

constexpr std::size_t kLimit = 1 << 16;

struct Parsed {
  std::vector<wire::Frame> frames;
  bool refused = false;
};

/// Parses `stream` in pieces of `piece_bytes`.
Parsed parse(std::span<const std::byte> stream, std::size_t piece_bytes) {
  wire::FrameParser parser(kLimit);
  Parsed parsed;
  while (!stream.empty() && !parsed.refused) {
    std::span<const std::byte> piece = stream.first(std::min(piece_bytes, stream.size()));
    stream = stream.subspan(piece.size());
    while (true) {
      Result<std::optional<wire::Frame>> frame = parser.next(piece);
      parsed.refused = !frame.ok();
      if (!frame || !*frame) break;
      parsed.frames.push_back(std::move(**frame));
    }
  }
  return parsed;
}

}  // namespace

/// Any bytes from a peer: frames are within their limits, agree with their headers, encode to the same bytes, and do
/// not depend on how the stream was cut.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::span<const std::byte> stream = std::as_bytes(std::span(data + 1, size - 1));
  const Parsed whole = parse(stream, stream.size());
  const Parsed pieces = parse(stream, 1 + data[0]);
  demand(whole.refused == pieces.refused && whole.frames.size() == pieces.frames.size(), "cuts change nothing");
  std::size_t at = 0;
  for (std::size_t i = 0; i < whole.frames.size(); ++i) {
    const wire::Frame& frame = whole.frames[i];
    demand(frame.payload == pieces.frames[i].payload, "cuts change no payload");
    demand(frame.payload.size() == frame.header.payload_bytes && frame.payload.size() <= kLimit, "limits hold");
    const wire::HeaderBytes header = wire::encode_header(frame.header);
    demand(std::equal(header.begin(), header.end(), stream.begin() + static_cast<std::ptrdiff_t>(at)),
           "a header that is taken is written back to the same bytes");
    at += wire::kFrameHeaderBytes + frame.payload.size();
  }
  return 0;
}
