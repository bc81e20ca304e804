#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <vector>

#include "proto/wire/frame.h"
#include "where.h"

namespace telepalp::wire {
namespace {

std::string read_golden(const std::string& name) {
  std::ifstream file(TELEPALP_SOURCE_DIR "/tests/proto/golden/" + name, std::ios::binary);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string encoded(const Frame& frame) {
  const HeaderBytes header = encode_header(frame.header);
  return std::string(reinterpret_cast<const char*>(header.data()), header.size()) + frame.payload;
}

Frame data_frame(std::uint32_t channel, std::uint64_t sequence, std::int64_t published_ns, std::string payload) {
  return {{.payload_bytes = static_cast<std::uint32_t>(payload.size()),
           .kind = FrameKind::Data,
           .sequence = sequence,
           .published = session_time(published_ns),
           .channel = channel},
          std::move(payload)};
}

/// The frames of golden/frames.txt: one a line, `version kind channel sequence published_ns payload-in-hex`.
std::vector<Frame> frames_of_the_twin() {
  std::istringstream lines(read_golden("frames.txt"));
  std::vector<Frame> frames;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string kind, hex;
    unsigned version = 0;
    std::uint32_t channel = 0;
    std::uint64_t sequence = 0;
    std::int64_t published_ns = 0;
    words >> version >> kind >> channel >> sequence >> published_ns >> hex;
    std::string payload;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
      payload += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    Frame frame = data_frame(channel, sequence, published_ns, payload);
    frame.header.version = static_cast<std::uint8_t>(version);
    frame.header.predicted = kind == "predicted";
    if (kind == "control") frame.header.kind = FrameKind::Control;
    frames.push_back(std::move(frame));
  }
  return frames;
}

void expect_equal(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.header.kind, b.header.kind);
  EXPECT_EQ(a.header.channel, b.header.channel);
  EXPECT_EQ(a.header.sequence, b.header.sequence);
  EXPECT_EQ(a.header.published, b.header.published);
  EXPECT_EQ(a.header.version, b.header.version);
  EXPECT_EQ(a.header.predicted, b.header.predicted);
  EXPECT_EQ(a.payload, b.payload);
}

/// Feeds `stream` in pieces that end at `cuts`, and returns what comes out. Fails the test on an error.
std::vector<Frame> parse_in_pieces(const std::string& stream, const std::vector<std::size_t>& cuts) {
  FrameParser parser;
  std::vector<Frame> frames;
  std::size_t from = 0;
  for (const std::size_t to : cuts) {
    std::span<const std::byte> piece = std::as_bytes(std::span(stream)).subspan(from, to - from);
    from = to;
    while (true) {
      Result<std::optional<Frame>> frame = parser.next(piece);
      EXPECT_TRUE(frame.ok()) << to_string(frame.error());
      if (!frame || !*frame) break;
      frames.push_back(std::move(**frame));
    }
  }
  return frames;
}

/// The error of decoding the header `bytes`; empty if it is accepted.
std::string refusal(const HeaderBytes& bytes, std::size_t most = kMaxPayloadBytes) {
  const Result<FrameHeader> header = decode_header(bytes, most);
  return header ? "" : header.error().what;
}

TEST(Frame, GoldenBytesAreWhatTheReadableTwinSays) {
  // Both are rebuilt by: TELEPALP_REBUILD_GOLDEN=1 bin/wire_frame_test --gtest_filter='*Golden*'
  std::string stream;
  for (const Frame& frame : frames_of_the_twin()) stream += encoded(frame);
  if (std::getenv("TELEPALP_REBUILD_GOLDEN") != nullptr)
    std::ofstream(TELEPALP_SOURCE_DIR "/tests/proto/golden/frames.bin", std::ios::binary) << stream;
  EXPECT_EQ(stream, read_golden("frames.bin"));
}

TEST(Frame, GoldenBytesParseToWhatTheReadableTwinSays) {
  const std::string stream = read_golden("frames.bin");
  const std::vector<Frame> expected = frames_of_the_twin();
  const std::vector<Frame> frames = parse_in_pieces(stream, {stream.size()});
  ASSERT_EQ(frames.size(), expected.size());
  ASSERT_GE(frames.size(), 9u);
  for (std::size_t i = 0; i < frames.size(); ++i) expect_equal(frames[i], expected[i]);
}

TEST(FrameParser, EveryCutInTwoGivesTheSameFrames) {
  const std::string stream = read_golden("frames.bin");
  const std::vector<Frame> whole = parse_in_pieces(stream, {stream.size()});
  for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
    const std::vector<Frame> frames = parse_in_pieces(stream, {cut, stream.size()});
    ASSERT_EQ(frames.size(), whole.size()) << "cut at " << cut;
    for (std::size_t i = 0; i < frames.size(); ++i) expect_equal(frames[i], whole[i]);
  }
}

TEST(FrameParser, RandomFramesInRandomPiecesComeOutAsTheyWentIn) {
  const std::uint32_t seed = 20240611;
  std::mt19937 random(seed);
  for (int round = 0; round < 200; ++round) {
    std::vector<Frame> sent;
    std::string stream;
    for (unsigned i = 0; i < 1 + random() % 6; ++i) {
      std::string payload(random() % 4 == 0 ? 0 : random() % 5000, '\0');
      for (char& byte : payload) byte = static_cast<char>(random());
      sent.push_back(data_frame(static_cast<std::uint32_t>(1 + random() % 9), random(),
                                static_cast<std::int64_t>(random()), payload));
      sent.back().header.version = random() % 2 == 0 ? kOldestProtocolVersion : kProtocolVersion;
      sent.back().header.predicted = sent.back().header.version == kProtocolVersion && random() % 2 == 0;
      stream += encoded(sent.back());
    }
    std::vector<std::size_t> cuts;
    for (std::size_t at = 0; at < stream.size();) cuts.push_back(at = std::min(stream.size(), at + 1 + random() % 700));
    const std::vector<Frame> frames = parse_in_pieces(stream, cuts);
    ASSERT_EQ(frames.size(), sent.size()) << "seed " << seed << " round " << round;
    for (std::size_t i = 0; i < frames.size(); ++i) expect_equal(frames[i], sent[i]);
  }
}

TEST(FrameParser, ALengthBeyondTheLimitIsRefusedBeforeItsPayloadComes) {
  for (const std::uint32_t declared : {std::uint32_t{kMaxPayloadBytes} + 1, 0x80000000u, 0xffffffffu}) {
    const HeaderBytes header = encode_header({.payload_bytes = declared, .kind = FrameKind::Data, .channel = 1});
    FrameParser parser;
    std::span<const std::byte> bytes(header);
    const auto frame = parser.next(bytes);
    ASSERT_FALSE(frame.ok());
    EXPECT_NE(frame.error().what.find(std::to_string(declared)), std::string::npos);
  }
}

TEST(FrameParser, ExactlyTheLimitIsTaken) {
  const Frame most = data_frame(1, 1, 1, std::string(kMaxPayloadBytes, 'x'));
  const std::string stream = encoded(most);
  const std::vector<Frame> frames = parse_in_pieces(stream, {stream.size()});
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].payload.size(), kMaxPayloadBytes);
}

TEST(FrameParser, StaysRefusedOnceTheStreamIsOutOfStep) {
  FrameParser parser;
  const std::string garbage(100, 'G');
  std::span<const std::byte> bytes = std::as_bytes(std::span(garbage));
  ASSERT_FALSE(parser.next(bytes).ok());
  const std::string good = encoded(data_frame(1, 1, 1, "good"));
  std::span<const std::byte> later = std::as_bytes(std::span(good));
  EXPECT_FALSE(parser.next(later).ok());
}

/// The refusal of `good` with the byte at `at` replaced.
std::string refusal_with(HeaderBytes good, std::size_t at, int value) {
  good[at] = static_cast<std::byte>(value);
  return refusal(good);
}

TEST(FrameHeader, EachFieldThatVersionOneDoesNotKnowIsRefusedByName) {
  const HeaderBytes good = encode_header({.payload_bytes = 5, .kind = FrameKind::Data, .channel = 3, .version = 1});
  ASSERT_EQ(refusal(good), "");
  const auto with = [&](std::size_t at, int value) { return refusal_with(good, at, value); };
  EXPECT_EQ(with(4, 3), "it has version 3 of the wire protocol instead of 1 or 2");
  EXPECT_EQ(with(4, 0), "it has version 0 of the wire protocol instead of 1 or 2");
  EXPECT_EQ(with(5, 0), "its kind 0 is unknown");
  EXPECT_EQ(with(5, 3), "its kind 3 is unknown");
  EXPECT_EQ(with(6, 1), "it sets flags that a frame of kind 2 does not have in version 1 of the wire protocol");
  EXPECT_EQ(with(7, 128), "it sets flags that a frame of kind 2 does not have in version 1 of the wire protocol");
  EXPECT_EQ(with(5, 1), "channel 3 does not fit its kind: a control frame has channel 0, a data frame another channel");
  EXPECT_EQ(with(24, 0),
            "channel 0 does not fit its kind: a control frame has channel 0, a data frame another channel");
}

TEST(FrameHeader, VersionTwoMarksPredictedDataAndKnowsNoOtherFlag) {
  const HeaderBytes data = encode_header({.payload_bytes = 5, .kind = FrameKind::Data, .channel = 3, .version = 2});
  HeaderBytes marked = data;
  marked[6] = std::byte{1};
  const Result<FrameHeader> header = decode_header(marked, kMaxPayloadBytes);
  ASSERT_TRUE(header.ok());
  EXPECT_TRUE(header->predicted);
  EXPECT_EQ(refusal_with(data, 6, 2),
            "it sets flags that a frame of kind 2 does not have in version 2 of the wire protocol");
  EXPECT_EQ(refusal_with(data, 7, 1),
            "it sets flags that a frame of kind 2 does not have in version 2 of the wire protocol");
  const HeaderBytes control = encode_header({.payload_bytes = 5, .kind = FrameKind::Control, .version = 2});
  EXPECT_EQ(refusal_with(control, 6, 1),
            "it sets flags that a frame of kind 1 does not have in version 2 of the wire protocol");
}

TEST(FrameHeader, AnOldPeerGetsNoFlagThatItWouldRefuse) {
  const HeaderBytes bytes =
      encode_header({.payload_bytes = 5, .kind = FrameKind::Data, .channel = 3, .version = 1, .predicted = true});
  EXPECT_EQ(bytes[6], std::byte{0});
  EXPECT_EQ(bytes[7], std::byte{0});
}

TEST(FrameHeader, ControlIsHeldToItsOwnSmallerLimit) {
  const HeaderBytes header = encode_header({.payload_bytes = kMaxControlBytes + 1, .kind = FrameKind::Control});
  EXPECT_EQ(refusal(header), "it declares a payload of 16385 B, but at most 16384 B are accepted");
}

}  // namespace
}  // namespace telepalp::wire
