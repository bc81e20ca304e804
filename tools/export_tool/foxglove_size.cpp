#include "tools/export_tool/foxglove_size.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proto/wire/mcap/writer.h"
#include "proto/wire/topics.h"
#include "server/views/view_topics.h"

namespace telepalp::export_tool {
namespace {

constexpr std::size_t kInstants = 4;

/// The size of messages in the chunks of a file.
class ChunkedSize {
 public:
  void add(const wire::Message& message) {
    std::uint16_t& channel = channels_[message.topic.name];
    if (channel == 0)
      channel = encoder_.add(encoded_, wire::mcap::Channel{.id = 0,
                                                           .schema_id = 0,
                                                           .topic = std::string(message.topic.name),
                                                           .message_encoding = {},
                                                           .metadata = {}});
    const auto time = static_cast<std::uint64_t>(to_nanoseconds(message.published));
    encoder_.add(encoded_, wire::mcap::MessageRecord{channel, 0, time, time, *message.payload});
    bytes_ += std::exchange(encoded_, {}).size();
  }
  [[nodiscard]] std::uint64_t finish() {
    encoder_.flush(encoded_);
    return bytes_ + std::exchange(encoded_, {}).size();
  }

 private:
  wire::mcap::Encoder encoder_{wire::mcap::ChunkLimits{}};
  std::map<std::string_view, std::uint16_t> channels_;
  std::string encoded_;
  std::uint64_t bytes_ = 0;
};

/// The times of the depth images that are chosen, in order.
std::vector<SessionTime> depth_times(wire::McapReader& session, double images_per_s) {
  const auto begin = static_cast<std::int64_t>(session.summary().statistics.message_start_time);
  Thinning thinning(session_time(begin), images_per_s);
  std::vector<SessionTime> times;
  session.select({.topics = {std::string(wire::kCameraDepth.name)}});
  for (;;) {
    const auto message = session.next_stored();
    if (!message) continue;  // the reader continues after the damaged chunk
    if (!*message) return times;
    const SessionTime at = session_time(static_cast<std::int64_t>((*message)->record.log_time));
    if (thinning.takes(at)) times.push_back(at);
  }
}

/// The mean sizes of a depth image and a cloud, at instants spread over `times`.
FoxgloveSize mean_frame(const std::filesystem::path& file, const std::vector<SessionTime>& times, SessionTime begin,
                        const FoxgloveParts& parts) {
  ChunkedSize depth, points;
  std::uint64_t instants = 0;
  for (std::size_t instant = 0; instant < kInstants && !times.empty(); ++instant) {
    const SessionTime at = times[times.size() * (2 * instant + 1) / (2 * kInstants)];
    Result<Frames> frames = Frames::open(file);
    if (!frames) continue;
    const Result<RgbdFrame> frame = frames->at(to_seconds(at - begin));
    if (!frame) continue;
    for (const wire::Message& message : frame_messages(*frame, parts))
      (message.topic.name == views::kDepthView.name ? depth : points).add(message);
    ++instants;
  }
  instants = std::max<std::uint64_t>(instants, 1);
  return {.color = 0, .depth = depth.finish() / instants, .points = points.finish() / instants, .station = 0};
}

}  // namespace

Result<FoxgloveSize> estimated_size(const std::filesystem::path& file, const FoxgloveParts& parts) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const auto begin = static_cast<std::int64_t>(reader->summary().statistics.message_start_time);
  const std::vector<SessionTime> times = depth_times(*reader, parts.images_per_s);
  FoxgloveSize size = mean_frame(file, times, session_time(begin), parts);
  size.depth *= times.size();
  size.points *= times.size();
  ChunkedSize color, station;
  const Result<std::uint64_t> read =
      give_station_and_color(*reader, parts, [&](const wire::Message& message) -> Result<void> {
        (message.topic.name.starts_with("/camera/") ? color : station).add(message);
        return {};
      });
  if (!read) return read.error();
  size.color = color.finish();
  size.station = station.finish();
  return size;
}

}  // namespace telepalp::export_tool
