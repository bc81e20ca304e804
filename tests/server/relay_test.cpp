// A relay: a client of one hub that publishes in another hub what it receives. It is what stands between two sites that
// do not see each other.

#include <optional>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "tests/server/loopback_site.h"

namespace telepalp::server {
namespace {

constexpr int kKeyEvery = 1000;  // no key frame comes by itself

/// A camera at the first hub. It makes a key frame when the hub asks for one.
struct Camera {
  hub::Hub& hub;
  codec::DepthEncoder encoder{{.mode = codec::DepthMode::Temporal, .key_every = kKeyEvery}};
  DepthImage image{.width = 32, .height = 24, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(32 * 24, 800)};
  int frames = 0;

  explicit Camera(hub::Hub& to) : hub(to) {
    hub.on_key_frame_request([this](std::string_view) { encoder.request_key_frame(); });
  }
  void publish() {
    image.samples[static_cast<std::size_t>(frames)] = 700;
    const codec::EncodedDepth encoded = encoder.encode(image);
    msg::DepthImage depth;
    depth.set_data(encoded.bytes);
    hub.publish(wire::make_message(wire::kCameraDepth, session_time(++frames), depth, encoded.key_frame));
  }
};

struct Relay {
  hub::Hub hub;
  std::optional<wire::Message> last;
  int received = 0;
  int lose = 0;  // that many of the next messages are lost within the relay
  wire::ClientLink link;

  explicit Relay(Site& site)
      : link(site.io,
             {.port = site.listener->port(), .name = "relay", .subscribes = {"/camera/depth"}, .datagrams = false},
             {.on_message = [this](const wire::Message& message) { take(message); }, .on_state = {}}) {
    hub.on_key_frame_request([this](std::string_view) {
      if (last) link.request_key_frame(*last);
    });
    link.start();
  }
  void take(const wire::Message& message) {
    ++received;
    last = message;
    if (lose > 0) return void(--lose);
    hub.publish(message);
  }
};

/// A subscriber that decodes each frame that it gets.
struct Onlooker {
  hub::Hub& hub;
  hub::SubscriberId id;
  codec::DepthDecoder decoder;
  int decoded = 0;
  int undecodable = 0;

  explicit Onlooker(hub::Hub& at) : hub(at), id(at.join("onlooker", "", [] {})) {
    hub.subscribe(id, {"/camera/depth"});
  }
  void read() {
    while (const auto message = hub.next(id)) {
      msg::DepthImage depth;
      const bool good =
          depth.ParseFromString(*message->payload) && decoder.decode(std::as_bytes(std::span(depth.data()))).ok();
      ++(good ? decoded : undecodable);
    }
  }
};

/// The camera, the relay, and all that lies between them.
struct Way {
  Site site;
  Camera camera{site.hub};
  Relay relay{site};

  [[nodiscard]] bool connected() {
    return site.run_until([&] { return relay.link.state() == wire::LinkState::Connected; });
  }
  /// Publishes frames until the relay has `count` more of them; false if it does not get them.
  [[nodiscard]] bool pass(int count) {
    const int wanted = relay.received + count;
    for (int tries = 0; tries < 3 * count && relay.received < wanted; ++tries) {
      const int before = relay.received;
      camera.publish();
      (void)site.run_until([&] { return relay.received > before; }, 200ms);
    }
    return relay.received >= wanted;
  }
};

TEST(Relay, WhoJoinsItInTheMiddleOfAGroupGetsNothingThatCannotBeDecoded) {
  Way way;
  ASSERT_TRUE(way.connected());
  ASSERT_TRUE(way.pass(5));  // a key frame and four that are predicted
  Onlooker late(way.relay.hub);
  for (int image = 0; image < 6; ++image) {
    ASSERT_TRUE(way.pass(1));
    late.read();
  }
  EXPECT_EQ(late.undecodable, 0);
  EXPECT_GE(late.decoded, 3) << "the relay passes the request for a key frame on to the camera";
}

TEST(Relay, ThatJoinsInTheMiddleItselfBeginsWithAKeyFrame) {
  Site site;
  Camera camera(site.hub);
  for (int image = 0; image < 5; ++image) camera.publish();
  Relay relay(site);
  Onlooker onlooker(relay.hub);
  ASSERT_TRUE(site.run_until([&] { return relay.link.state() == wire::LinkState::Connected; }));
  for (int image = 0; image < 6; ++image) {
    camera.publish();
    (void)site.run_until([&] { return relay.received > image; }, 200ms);
    onlooker.read();
  }
  EXPECT_EQ(onlooker.undecodable, 0);
  EXPECT_GE(onlooker.decoded, 3);
}

TEST(Relay, AfterALossInItNothingIsPassedOnUntilAKeyFrame) {
  Way way;
  ASSERT_TRUE(way.connected());
  Onlooker onlooker(way.relay.hub);
  for (int image = 0; image < 3; ++image) {
    ASSERT_TRUE(way.pass(1));
    onlooker.read();
  }
  EXPECT_EQ(onlooker.decoded, 3);
  way.relay.lose = 1;
  for (int image = 0; image < 6; ++image) {
    ASSERT_TRUE(way.pass(1));
    onlooker.read();
  }
  EXPECT_EQ(onlooker.undecodable, 0) << "the relay's own numbers have no gap, so the numbers it received must tell";
  EXPECT_GE(onlooker.decoded, 6);
}

}  // namespace
}  // namespace telepalp::server
