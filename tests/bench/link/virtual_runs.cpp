#include <cstring>

#include "proto/impaired/impaired_pair.h"
#include "tests/bench/link/camera_feed.h"

namespace telepalp::bench::link {
namespace {

using namespace std::chrono_literals;

/// Calls step(now) each kStep, and samples the age each millisecond.
template <class Step>
Outcome run(CameraFeed& feed, Step step) {
  for (Nanoseconds now = 0ns; !feed.finished(now); now += kStep) {
    step(now);
    if (now % 1ms == 0ns) feed.sample_age(now);
  }
  return feed.outcome();
}

telepalp::link::DatagramLinkSettings settings_of(const Scenario& scenario) {
  std::array<std::byte, 32> secret{};
  std::memcpy(secret.data(), &scenario.seed, sizeof scenario.seed);
  return {.seal = {.session = telepalp::link::Secret(secret),
                   .number = static_cast<std::uint32_t>(scenario.seed),
                   .cipher = telepalp::link::preferred_cipher()},
          .deadline = scenario.deadline};
}

/// Both ends of the link, and the path between them.
class TelepalpRun {
 public:
  explicit TelepalpRun(const Scenario& scenario)
      : scenario_(scenario),
        path_(SessionTime{}, {.name = {}, .down = scenario.down, .up = scenario.up}, scenario.seed,
              settings_of(scenario)),
        feed_(scenario) {}

  Outcome outcome() {
    return run(feed_, [this](Nanoseconds now) { step(now); });
  }

 private:
  void step(Nanoseconds now) {
    const SessionTime at{now};
    path_.deliver(at);
    if ((path_.server().key_frames_wanted() & (1U << kDepth)) != 0) next_depth_is_key_ = true;
    for (CameraImage& image : feed_.due(now)) offer(std::move(image));
    feed_.outcome().sent_B += static_cast<double>(path_.transmit_from_server(at));
    feed_.outcome().answered_B += static_cast<double>(path_.transmit_from_client(at));
    while (const auto frame = path_.client().take(at)) {
      if (frame->newest && frame->channel == kDepth) ++feed_.outcome().shown;
      feed_.complete(static_cast<Image>(frame->channel), frame->number, frame->captured.time_since_epoch(),
                     frame->bytes.size(), now);
    }
  }
  void offer(CameraImage image) {
    const bool depends = scenario_.depth_depends && image.image == kDepth && image.number > 0 && !next_depth_is_key_;
    if (image.image == kDepth && !depends) {
      ++feed_.outcome().key_frames;
      next_depth_is_key_ = false;
    }
    const auto replaced = path_.server().offer({.channel = image.image,
                                                .number = image.number,
                                                .key_frame = !depends,
                                                .captured = SessionTime{image.captured},
                                                .bytes = std::move(image.bytes)});
    if (replaced && image.image == kDepth && depends) next_depth_is_key_ = true;
  }

  Scenario scenario_;
  impaired::ImpairedPair path_;
  CameraFeed feed_;
  bool next_depth_is_key_ = false;
};

/// What a peer without sequence numbers of its own writes in front of each packet.
struct Label {
  std::uint32_t number;
  std::uint16_t packets;  ///< of the image
  std::uint8_t image;
  std::uint8_t padding;
  std::uint64_t image_B;
};

/// Cuts an image into labelled packets of at most 1200 B, and sends all of them. Returns the bytes.
double send_labelled(const CameraImage& image, bool stream, Nanoseconds now, impaired::ImpairedLink& to) {
  const std::size_t part_B = 1200 - sizeof(Label);
  const auto packets = static_cast<std::uint16_t>((image.bytes.size() + part_B - 1) / part_B);
  const Label label{image.number, packets, image.image, 0, image.bytes.size()};
  double sent_B = 0.0;
  for (std::size_t i = 0; i < packets; ++i) {
    std::vector<std::byte> packet(sizeof label + std::min(part_B, image.bytes.size() - i * part_B));
    std::memcpy(packet.data(), &label, sizeof label);
    sent_B += static_cast<double>(packet.size());
    to.send(now, {.bytes = std::move(packet), .stream = stream});
  }
  return sent_B;
}

/// A stream's images wait until the path's queue has room; a newer image replaces one that waits. Datagrams do not
/// wait.
Outcome run_labelled(const Scenario& scenario, bool stream) {
  impaired::ImpairedLink down(scenario.down, scenario.seed);
  CameraFeed feed(scenario);
  std::map<Image, CameraImage> waiting;
  std::map<std::pair<int, std::uint32_t>, std::uint16_t> arrived;
  return run(feed, [&](Nanoseconds now) {
    for (CameraImage& image : feed.due(now)) waiting.insert_or_assign(image.image, std::move(image));
    std::erase_if(waiting, [&](const auto& entry) {
      if (stream && !down.has_room(now, entry.second.bytes.size() * 11 / 10)) return false;
      feed.outcome().sent_B += send_labelled(entry.second, stream, now, down);
      return true;
    });
    while (const auto packet = down.receive(now)) {
      Label label{};
      std::memcpy(&label, packet->bytes.data(), sizeof label);
      if (++arrived[{label.image, label.number}] == label.packets)
        feed.complete(static_cast<Image>(label.image), label.number, from_seconds(label.number / scenario.frames_hz),
                      label.image_B, now);
    }
  });
}

}  // namespace

Outcome run_telepalp(const Scenario& scenario) { return TelepalpRun(scenario).outcome(); }
Outcome run_plain_udp(const Scenario& scenario) { return run_labelled(scenario, false); }
Outcome run_plain_tcp(const Scenario& scenario) { return run_labelled(scenario, true); }

}  // namespace telepalp::bench::link
