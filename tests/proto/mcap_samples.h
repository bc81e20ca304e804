#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "foxglove/CompressedImage.pb.h"
#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/writer.h"

/// Messages like those of a session, the same in every run.
namespace telepalp::wire::samples {

inline const SessionInfo kInfo{
    .program = "telepalp-test", .version = "0.1.0", .commit = "abc1234", .source = "synthetic", .scene = "skin { }"};

/// Session time at which the tests' sessions begin [ns].
inline constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;
inline constexpr std::int64_t kFrame_ns = 33'333'333;  ///< period of a camera's images

/// `seconds` of depth and colour at 30 Hz and station states at 100 Hz, in order of time. Payloads are noise of a
/// camera's sizes, divided by `thinner`.
inline std::vector<Message> session(double seconds, std::size_t thinner = 50, unsigned seed = 1) {
  std::mt19937 random(seed);
  const auto noise = [&](std::size_t bytes) {
    std::string text(bytes, '\0');
    for (char& letter : text) letter = static_cast<char>(random() & 0xff);
    return text;
  };
  std::vector<Message> messages;
  const auto centiseconds = static_cast<std::int64_t>(seconds * 100);
  for (std::int64_t cs = 0; cs < centiseconds; ++cs) {
    const std::int64_t now = kStart_ns + cs * 10'000'000;
    if (cs * 30 / 100 != (cs - 1) * 30 / 100 || cs == 0) {
      msg::DepthImage depth;
      depth.set_captured_ns(static_cast<std::uint64_t>(now - 9'000'000));
      depth.set_sequence(static_cast<std::uint64_t>(cs));
      depth.set_width(640);
      depth.set_height(480);
      depth.set_unit_m(0.001);
      depth.set_data(noise(150'000 / thinner));
      messages.push_back(make_message(kCameraDepth, session_time(now), depth, true));
      foxglove::CompressedImage color;
      color.mutable_timestamp()->set_seconds(now / 1'000'000'000);
      color.set_frame_id("camera_color");
      color.set_format("jpeg");
      color.set_data(noise(40'000 / thinner));
      messages.push_back(make_message(kCameraColor, session_time(now), color));
    }
    msg::StationState state;
    state.set_stamp_ns(static_cast<std::uint64_t>(now));
    state.set_phase(msg::PHASE_IN_BODY);
    state.set_indentation_m(0.001 * static_cast<double>(cs % 20));
    state.mutable_force_n()->set_y(0.25 * static_cast<double>(cs % 16));
    messages.push_back(make_message(kStationState, session_time(now), state));
  }
  return messages;
}

/// A path that does not exist yet, in gtest's temporary folder.
inline std::filesystem::path fresh_file(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
  std::filesystem::remove(file);
  std::filesystem::remove(file.string() + ".partial");
  return file;
}

inline Result<void> write_file(const std::filesystem::path& file, const std::vector<Message>& messages,
                               mcap::ChunkLimits limits = {}) {
  Result<McapWriter> writer = McapWriter::open(file, kInfo, limits);
  if (!writer) return writer.error();
  for (const Message& message : messages)
    if (const Result<void> written = writer->write(message); !written) return written;
  return writer->close();
}

/// Writes the layout of releases before the wire's version 2: each topic has one channel, which marks no key frames.
inline void write_unmarked_file(const std::filesystem::path& file, const std::vector<Message>& messages,
                                mcap::ChunkLimits limits = {}) {
  mcap::Encoder encoder(limits);
  std::string bytes;
  encoder.begin(bytes, {.profile = "", .library = "telepalp-test 0.1.0"});
  encoder.add(bytes,
              mcap::Metadata{std::string(kSessionMetadata), {{"program", kInfo.program}, {"source", kInfo.source}}});
  std::map<std::string_view, std::uint16_t> channels;
  for (const Message& message : messages) {
    std::uint16_t& id = channels[message.topic.name];
    if (id == 0) {
      const std::uint16_t schema =
          encoder.add(bytes, mcap::Schema{.id = 0,
                                          .name = std::string(message.topic.schema),
                                          .encoding = "protobuf",
                                          .data = file_descriptor_set(*descriptor_of(message.topic))});
      id = encoder.add(bytes, mcap::Channel{.id = 0,
                                            .schema_id = schema,
                                            .topic = std::string(message.topic.name),
                                            .message_encoding = "protobuf",
                                            .metadata = {}});
    }
    const auto at = static_cast<std::uint64_t>(to_nanoseconds(message.published));
    encoder.add(bytes, mcap::MessageRecord{id, static_cast<std::uint32_t>(message.sequence), at, at, *message.payload});
  }
  encoder.end(bytes);
  std::ofstream(file, std::ios::binary) << bytes;
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace telepalp::wire::samples
