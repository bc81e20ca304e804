#include "tools/export_tool/foxglove_session.h"

#include <algorithm>

#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/writer.h"
#include "server/views/view_topics.h"

namespace telepalp::export_tool {
namespace {

class FoxgloveFile {
 public:
  explicit FoxgloveFile(wire::McapWriter writer) : writer_(std::move(writer)) {}

  [[nodiscard]] Result<void> add(const wire::Message& message) {
    const bool is_view =
        std::ranges::find(views::kViewTopics, message.topic.name, &wire::Topic::name) != views::kViewTopics.end();
    const Result<void> written = is_view ? add_view(message) : writer_.write(message);
    messages_ += written ? 1 : 0;
    return written;
  }
  [[nodiscard]] Result<std::uint64_t> close(const Result<void>& written) {
    const Result<void> finished = writer_.finish(written);
    if (!finished) return finished.error();
    return messages_;
  }

 private:
  Result<void> add_view(const wire::Message& message) {
    const wire::mcap::Schema schema{.id = 1,
                                    .name = std::string(message.topic.schema),
                                    .encoding = "protobuf",
                                    .data = wire::file_descriptor_set(*views::descriptor_of_view(message.topic))};
    const wire::mcap::StoredChannel channel{.channel = {.id = 0,
                                                        .schema_id = 1,
                                                        .topic = std::string(message.topic.name),
                                                        .message_encoding = "protobuf",
                                                        .metadata = {}},
                                            .schema = &schema,
                                            .topic = {},
                                            .key_frames = {}};
    const auto time = static_cast<std::uint64_t>(to_nanoseconds(message.published));
    return writer_.copy(
        {.channel = &channel,
         .record = {.channel_id = 0, .sequence = 0, .log_time = time, .publish_time = time, .data = *message.payload}});
  }

  wire::McapWriter writer_;
  std::uint64_t messages_ = 0;
};

/// Adds depth images and clouds. Returns the number of damaged parts that are left out.
Result<std::uint64_t> add_frames(const std::filesystem::path& file, SessionTime begin, const FoxgloveParts& parts,
                                 FoxgloveFile& out) {
  if (!parts.depth && !parts.points) return std::uint64_t{0};
  Result<Frames> frames = Frames::open(file);
  if (!frames) return frames.error();
  Thinning thinning(begin, parts.images_per_s);
  const Result<void> done = frames->for_each([&](const RgbdFrame& frame) -> Result<bool> {
    if (!thinning.takes(frame.captured)) return true;
    for (const wire::Message& message : frame_messages(frame, parts))
      if (const Result<void> added = out.add(message); !added) return added.error();
    return true;
  });
  return done ? Result<std::uint64_t>(frames->damaged()) : Result<std::uint64_t>(done.error());
}

}  // namespace

Result<Exported> write_foxglove(const std::filesystem::path& file, const std::filesystem::path& out,
                                const FoxgloveParts& parts) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  Result<wire::McapWriter> writer = wire::McapWriter::open(out, *session, {}, wire::mcap::Protection::None);
  if (!writer) return writer.error();
  FoxgloveFile made(std::move(*writer));
  const auto begin = static_cast<std::int64_t>(reader->summary().statistics.message_start_time);
  const Result<std::uint64_t> station =
      give_station_and_color(*reader, parts, [&](const wire::Message& message) { return made.add(message); });
  const Result<std::uint64_t> frames =
      station ? add_frames(file, session_time(begin), parts, made) : Result<std::uint64_t>(station.error());
  const Result<std::uint64_t> written = made.close(frames ? Result<void>{} : Result<void>(frames.error()));
  if (!written) return written.error();
  return Exported{.written = *written, .left_out = *station + *frames};
}

}  // namespace telepalp::export_tool
