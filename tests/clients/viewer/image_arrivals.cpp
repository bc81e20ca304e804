// When the images of a camera arrive over one direction of an impaired network, in virtual time, as one TCP stream to a
// browser: telepalp-image-arrivals PROFILE SECONDS KILOBYTES. Prints one line for each image: its time of arrival [ms].
#include <charconv>
#include <cstdio>
#include <string_view>

#include "proto/impaired/impaired_link.h"
#include "proto/impaired/profiles.h"

namespace telepalp::impaired {
namespace {

constexpr std::size_t kSegment_B = 1400;
constexpr Nanoseconds kEvery{33'333'333};
constexpr std::uint64_t kSeed = 28;
constexpr std::byte kLastOfImage{1};

void print_arrivals(ImpairedLink& link, Nanoseconds until) {
  while (const auto at = link.next_arrival()) {
    if (*at > until) return;
    if (link.receive(*at)->bytes.front() == kLastOfImage) std::printf("%.3f\n", to_seconds(*at) * 1e3);
  }
}

/// Sends one image at `now`. TCP's sender waits while the bottleneck's queue is full.
void send_image(ImpairedLink& link, Nanoseconds now, std::size_t image_B) {
  const std::size_t segments = image_B / kSegment_B + 1;
  for (std::size_t segment = 1; segment <= segments; ++segment) {
    Packet packet{.bytes = std::vector<std::byte>(kSegment_B), .flow = 1, .stream = true};
    if (segment == segments) packet.bytes.front() = kLastOfImage;
    link.send(now, std::move(packet));
  }
}

int run(const Profile& profile, long seconds, long kilobytes) {
  ImpairedLink link(profile.down, kSeed);
  const Nanoseconds end = std::chrono::seconds(seconds);
  for (Nanoseconds now{0}; now < end; now += kEvery) {
    print_arrivals(link, now);
    send_image(link, now, static_cast<std::size_t>(kilobytes) * 1000);
  }
  print_arrivals(link, end);
  return 0;
}

}  // namespace
}  // namespace telepalp::impaired

int main(int count, char** words) {
  using namespace telepalp;
  const auto profile = impaired::profile_named(count == 4 ? words[1] : "");
  const auto number = [](std::string_view text) {
    long value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  };
  if (!profile) {
    std::fprintf(stderr, "error: %s\n", to_string(profile.error()).c_str());
    return 2;
  }
  return impaired::run(*profile, number(words[2]), number(words[3]));
}
