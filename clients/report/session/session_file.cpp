#include "clients/report/session/session_file.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "clients/ar/messages/from_messages.h"
#include "codec/color_reader.h"
#include "codec/depth_stream.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/topics.h"
#include "support/speech/session_speech.h"

namespace telepalp::report {
namespace {

/// Longest time from a frame's capture to its log time. It limits the part of a long file that is read again for one
/// picture.
constexpr Nanoseconds kReach = std::chrono::seconds(2);

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// Index in `times` of the time nearest to `at`.
std::optional<std::size_t> nearest(const std::vector<std::int64_t>& times, std::int64_t at) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!best || std::abs(times[i] - at) < std::abs(times[*best] - at)) best = i;
  return best;
}

std::optional<std::int64_t> nearest_time(const std::vector<std::int64_t>& times, std::int64_t at) {
  const auto found = nearest(times, at);
  if (!found) return std::nullopt;
  return times[*found];
}

/// Calibration of the frame of reference `name`, or the only calibration of the session.
std::optional<Intrinsics> camera_named(const Session& session, const std::string& name) {
  const auto found = session.calibrations.find(name);
  if (found != session.calibrations.end()) return wire::intrinsics_of(found->second);
  if (session.calibrations.size() == 1) return wire::intrinsics_of(session.calibrations.begin()->second);
  return std::nullopt;
}

void take_depth(RgbdFrame& frame, msg::DepthImage& image, std::int64_t wanted_ns, codec::DepthReader& reader) {
  if (static_cast<std::int64_t>(image.captured_ns()) != wanted_ns) return reader.skip(std::move(*image.mutable_data()));
  Result<codec::DecodedDepth> depth = reader.read(bytes_of(image.data()));
  if (!depth) return;
  frame.captured = session_time(wanted_ns);
  frame.sequence = image.sequence();
  frame.depth = std::move(depth->image);
}

void take_color(RgbdFrame& frame, const wire::Message& message, std::optional<std::int64_t> wanted_ns,
                codec::ColorReader& reader) {
  const std::optional<wire::CompressedColor> color = wire::compressed_color(message);
  if (!color) return;
  if (color->captured_ns != wanted_ns) return reader.skip(color->format, bytes_of(color->data), color->number);
  Result<ColorImage> image = reader.read(color->format, bytes_of(color->data), color->number);
  if (image) frame.color = std::move(image).value();
}

}  // namespace

Result<Session> read_session(const std::filesystem::path& file) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  Session session;
  session.name = file.filename().string();
  if (Result<wire::SessionInfo> info = reader->session()) session.info = std::move(*info);
  session.origin = session.info.source;
  const std::optional<speech::Speech> recorded = speech::recorded_speech(*reader);
  speech::SpeechSurvey survey;  // of a file without a record of where people speak
  for (;;) {
    Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!message.value()) break;
    add(session, **message);
    if (!recorded) survey.add(**message);
  }
  session.spoken = recorded ? *recorded : survey.speech();
  settle(session);
  if (session.messages == 0)
    return Error{
        .what = "holds no message of telepalp",
        .where = file.string(),
        .fix = "give a session file of telepalp, or record one while the server runs: see telepalp-record --help"};
  return session;
}

Result<std::optional<RgbdFrame>> read_frame(const std::filesystem::path& file, const Session& session,
                                            std::int64_t at_ns) {
  const auto nearest_depth = nearest(session.depth_captured_ns, at_ns);
  const auto camera = camera_named(session, wire::kDepthFrameId);
  if (!nearest_depth || !camera) return std::optional<RgbdFrame>();
  const std::int64_t depth_ns = session.depth_captured_ns[*nearest_depth];
  const std::int64_t key_ns = session.depth_key_ns[*nearest_depth];
  const auto color_ns = nearest_time(session.color_captured_ns, depth_ns);

  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const SessionTime from = std::min(session_time(depth_ns) - kReach, session_time(key_ns));
  const auto video_key = reader->last_key_frame(wire::kCameraColorVideo, session_time(depth_ns));
  reader->select({.topics = {std::string(wire::kCameraDepth.name), std::string(wire::kCameraColor.name),
                             std::string(wire::kCameraColorVideo.name)},
                  .from = std::min(from, video_key.value_or(from)),
                  .until = session_time(depth_ns) + kReach});
  codec::DepthReader depth_reader;
  codec::ColorReader color_reader;
  RgbdFrame frame;
  for (;;) {
    Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!message.value()) break;
    const std::string& payload = *(**message).payload;
    msg::DepthImage depth;
    if ((**message).topic.name == wire::kCameraDepth.name) {
      if (depth.ParseFromString(payload)) take_depth(frame, depth, depth_ns, depth_reader);
    } else {
      take_color(frame, **message, color_ns, color_reader);
    }
  }
  if (frame.depth.samples.empty()) return std::optional<RgbdFrame>();
  frame.camera.depth = ar::scaled_to(*camera, frame.depth.width, frame.depth.height);
  const auto color_camera = camera_named(session, wire::kColorFrameId);
  frame.camera.color = frame.color.rgb.empty()
                           ? frame.camera.depth
                           : ar::scaled_to(color_camera.value_or(*camera), frame.color.width, frame.color.height);
  frame.camera.color_registered = !session.capture || session.capture->color_registered();
  return std::optional(std::move(frame));
}

}  // namespace telepalp::report
