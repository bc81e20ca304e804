// Peers that speak version 1 of the wire protocol, whose frames do not say which messages are predicted. Their bytes
// are made here, so that they stay as they were.

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "tests/server/loopback_site.h"

namespace telepalp::server {
namespace {

using boost::asio::ip::tcp;

constexpr std::size_t kVersionAt = 4;
constexpr std::size_t kFlagsAt = 6;

/// Depth in groups of four frames, as serialised messages.
std::vector<msg::DepthImage> depth_in_groups(int frames) {
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 4});
  DepthImage image{.width = 32, .height = 24, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(32 * 24, 800)};
  std::vector<msg::DepthImage> all;
  for (int frame = 0; frame < frames; ++frame) {
    image.samples[static_cast<std::size_t>(frame)] = 700;
    all.emplace_back().set_data(encoder.encode(image).bytes);
  }
  return all;
}

std::string hello_of_version_1(const std::string& role) {
  msg::Control control;
  control.mutable_hello()->set_protocol(1);
  control.mutable_hello()->set_name("old");
  control.mutable_hello()->set_role(role);
  return control_frame(control);
}

/// The headers in `stream`, each with its payload behind it.
std::vector<std::string> frames_in(const std::string& stream) {
  std::vector<std::string> frames;
  for (std::size_t at = 0; at + wire::kFrameHeaderBytes <= stream.size();) {
    std::uint32_t payload_bytes = 0;
    std::memcpy(&payload_bytes, stream.data() + at, sizeof payload_bytes);
    const std::size_t bytes = wire::kFrameHeaderBytes + payload_bytes;
    if (at + bytes > stream.size()) break;
    frames.push_back(stream.substr(at, bytes));
    at += bytes;
  }
  return frames;
}

/// What a server sends to a peer that sends `bytes` and nothing else.
struct OldClient {
  tcp::socket socket;
  std::array<char, 4096> buffer{};
  std::string heard;

  OldClient(Site& site, std::string bytes) : socket(site.io) {
    socket.connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
    boost::asio::write(socket, boost::asio::buffer(bytes));
    read();
  }
  void read() {
    socket.async_read_some(boost::asio::buffer(buffer),
                           [this](const boost::system::error_code& code, std::size_t bytes) {
                             heard.append(buffer.data(), bytes);
                             if (!code) read();
                           });
  }
  [[nodiscard]] std::size_t data_frames() const {
    const std::vector<std::string> frames = frames_in(heard);
    return static_cast<std::size_t>(std::ranges::count_if(
        frames, [](const std::string& frame) { return frame[5] == static_cast<char>(wire::FrameKind::Data); }));
  }
};

TEST(OldPeer, AClientOfVersion1GetsOnlyWhatVersion1Knows) {
  Site site;
  msg::Control subscribe;
  subscribe.mutable_subscribe()->add_topics("/camera/depth");
  OldClient old(site, hello_of_version_1("viewer") + control_frame(subscribe));
  ASSERT_TRUE(site.run_until([&] { return site.hub.is_wanted(wire::kCameraDepth.name); }));
  for (const bool is_key : {true, false, false}) {
    const std::size_t before = old.data_frames();
    site.hub.publish({wire::kCameraDepth, site.clock.now(), std::make_shared<const std::string>("d"), 0, is_key});
    ASSERT_TRUE(site.run_until([&] { return old.data_frames() == before + 1; }));
  }
  for (const std::string& frame : frames_in(old.heard)) {
    EXPECT_EQ(frame[kVersionAt], 1);
    EXPECT_EQ(frame.substr(kFlagsAt, 2), std::string(2, '\0'));
  }
  old.socket.close();
}

/// A server of version 1 with depth, for one client.
struct OldServer {
  tcp::acceptor acceptor;
  tcp::socket peer;
  std::string bytes;

  explicit OldServer(Site& site) : acceptor(site.io, {boost::asio::ip::make_address("127.0.0.1"), 0}), peer(site.io) {
    msg::Control advertise;
    msg::Advertise::Topic& depth = *advertise.mutable_advertise()->add_topics();
    depth.set_channel(1);
    depth.set_name("/camera/depth");
    depth.set_schema("telepalp.msg.DepthImage");
    bytes = hello_of_version_1("server") + control_frame(advertise);
    for (const msg::DepthImage& image : depth_in_groups(6)) bytes += data_frame(1, image.SerializeAsString());
    bytes += data_frame(1, "\xff no depth image");
    acceptor.async_accept(peer, [this](const boost::system::error_code& code) {
      if (!code) boost::asio::write(peer, boost::asio::buffer(bytes));
    });
  }
};

TEST(OldPeer, ImagesOfAServerOfVersion1ArriveAsWhatTheyAre) {
  Site site;
  OldServer old(site);
  Client client(site, {"/camera/depth"}, "test", old.acceptor.local_endpoint().port());
  ASSERT_TRUE(site.run_until([&] { return client.messages.size() == 7; }));
  std::vector<bool> key_frames;
  for (const wire::Message& message : client.messages) key_frames.push_back(message.key_frame);
  EXPECT_EQ(key_frames, (std::vector<bool>{true, false, false, false, true, false, false}));
}

TEST(OldPeer, PeersOfTheSameVersionMarkPredictedMessages) {
  Site site;
  Client client(site, {"/camera/depth", "/station/state"});
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  for (const bool is_key : {true, false, false, true, false}) {
    const std::size_t before = client.messages.size();
    site.hub.publish({wire::kCameraDepth, site.clock.now(), std::make_shared<const std::string>("d"), 0, is_key});
    ASSERT_TRUE(site.run_until([&] { return client.messages.size() == before + 1; }));
    EXPECT_EQ(client.messages.back().key_frame, is_key);
  }
  site.hub.publish(station_state(1));
  ASSERT_TRUE(site.run_until([&] { return client.messages.size() == 6; }));
  EXPECT_TRUE(client.messages.back().key_frame);
}

TEST(OldPeer, APredictedMessageOfATopicWithoutPredictionEndsTheConnection) {
  Site site;
  tcp::socket station(site.io);
  station.connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
  msg::Control hello, advertise;
  hello.mutable_hello()->set_protocol(wire::kOldestProtocolVersion);
  hello.mutable_hello()->set_newest_protocol(wire::kProtocolVersion);
  hello.mutable_hello()->set_role("doctor");
  msg::Advertise::Topic& state = *advertise.mutable_advertise()->add_topics();
  state.set_channel(1);
  state.set_name("/station/state");
  state.set_schema("telepalp.msg.StationState");
  boost::asio::write(
      station,
      boost::asio::buffer(
          control_frame(hello) + control_frame(advertise) +
          frame_bytes(
              {.kind = wire::FrameKind::Data, .channel = 1, .version = wire::kProtocolVersion, .predicted = true},
              "")));
  EXPECT_TRUE(site.run_until([&] {
    return std::ranges::any_of(site.notes, [](const std::string& note) {
      return note.find("a predicted message of /station/state, a topic without predicted messages") !=
             std::string::npos;
    });
  }));
}

}  // namespace
}  // namespace telepalp::server
