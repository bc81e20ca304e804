// What a peer's datagrams hold once they are authenticated, and the opener that authenticates them. The first byte of
// the input chooses the parser; what follows are records of a length byte pair and bytes.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "proto/link/format/fragment.h"
#include "proto/link/frames/frame_receiver.h"
#include "proto/link/seal/sealed_channel.h"

namespace {

using namespace telepalp;
using namespace telepalp::link;
using namespace std::chrono_literals;

using Bytes = std::span<const std::byte>;

void must(bool holds) {
  if (!holds) std::abort();
}

/// Takes a record of at most 65535 bytes from the front of `rest`.
Bytes take_record(Bytes& rest) {
  if (rest.size() < 2) return std::exchange(rest, {});
  const std::size_t size = std::min<std::size_t>(get_little_endian<std::uint16_t>(rest.data()), rest.size() - 2);
  const Bytes record = rest.subspan(2, size);
  rest = rest.subspan(2 + size);
  return record;
}

/// Fragments reach a receiver: memory stays bounded, and a delivered frame has the announced size.
void receive_fragments(Bytes rest) {
  FrameReceiver receiver(100ms);
  SessionTime now{1s};
  while (!rest.empty()) {
    now += 1ms;
    const auto fragment = read_fragment(take_record(rest));
    if (fragment && fragment->header.frame_bytes <= 65'536) receiver.add(*fragment, now);
    must(receiver.assembling_B() <= FrameReceiver::kMostAssembling_B);
    must(receiver.missing(now + 10ms).size() <= kMostMissing);
    receiver.step(now);
    while (const auto frame = receiver.take()) must(!frame->bytes.empty() && frame->bytes.size() <= kMostFrameBytes);
  }
}

/// Feedback that is accepted is written as it was read, and moves a sender and a path.
void read_reports(Bytes rest) {
  FrameSender sender(100ms);
  PathEstimate path;
  SessionTime now{1s};
  sender.offer({.channel = 1, .number = 1, .captured = now, .bytes = std::vector<std::byte>(5000)});
  std::uint64_t sequence = 0;
  const auto transmit = [&] {
    for (int i = 0; i < 300; ++i)
      if (const auto payload = sender.next(now, path)) path.sent(sequence++, payload->bytes(), now);
  };
  transmit();
  while (!rest.empty()) {
    const Bytes record = take_record(rest);
    const auto feedback = read_feedback(record);
    if (!feedback) continue;
    const std::vector<std::byte> written = write_feedback(*feedback);
    must(std::equal(written.begin(), written.end(), record.begin(), record.end()));
    now += 1ms;
    path.on_feedback(*feedback, now);
    sender.on_missing(feedback->missing, now, path);
    transmit();
    must(path.loss() >= 0.0 && path.loss() <= 1.0 && path.in_flight_B() <= sequence * kDatagramBytes);
  }
}

/// No datagram is opened without the key.
void open_datagrams(Bytes rest) {
  Opener opener({.number = 7}, Direction::ClientToServer);
  while (!rest.empty()) must(!opener.open(take_record(rest)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Bytes rest(reinterpret_cast<const std::byte*>(data + 1), size - 1);
  if (data[0] == 0)
    receive_fragments(rest);
  else if (data[0] == 1)
    read_reports(rest);
  else
    open_datagrams(rest);
  return 0;
}
