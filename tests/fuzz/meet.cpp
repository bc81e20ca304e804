// Two parsers of what strangers send to the meeting point: the TLS greeting of a caller, and the messages between a
// site and the meeting point. The first byte of the input chooses the parser.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "messages/meet.pb.h"
#include "server/meet/caller/client_hello.h"
#include "server/meet/words/meet_frames.h"

namespace {

using namespace telepalp::meet;

void must(bool holds) {
  if (!holds) std::abort();
}

/// The result for the first half of a greeting, unless it is Incomplete, is also the result for the whole.
void read_greeting(std::span<const std::byte> bytes) {
  using State = HelloRead::State;
  const HelloRead whole = read_client_hello(bytes);
  must(whole.hello.server_name.size() <= 255);
  const HelloRead half = read_client_hello(bytes.first(bytes.size() / 2));
  must(half.state == State::Incomplete || half.state == whole.state);
  must(half.state != State::Whole || half.hello.server_name == whole.hello.server_name);
}

/// No message that is read, or written again, is larger than kMostFrameBytes.
void read_frames(std::span<const std::byte> bytes) {
  FrameReader reader;
  for (; !bytes.empty() && !reader.is_bad(); bytes = bytes.subspan(std::min<std::size_t>(bytes.size(), 7))) {
    const auto part = bytes.first(std::min<std::size_t>(bytes.size(), 7));
    reader.append({reinterpret_cast<const char*>(part.data()), part.size()});
    while (const auto frame = reader.next()) {
      must(frame->size() <= kMostFrameBytes);
      telepalp::msg::SiteToMeet site;
      telepalp::msg::MeetToSite meet;
      if (site.ParseFromString(*frame) && site.ByteSizeLong() <= kMostFrameBytes)
        must(framed(site).size() <= kMostFrameBytes + 2);
      (void)meet.ParseFromString(*frame);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto bytes = std::as_bytes(std::span(data + 1, size - 1));
  if (data[0] % 2 == 0)
    read_greeting(bytes);
  else
    read_frames(bytes);
  return 0;
}
