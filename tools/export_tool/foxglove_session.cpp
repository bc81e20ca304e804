#include "tools/export_tool/foxglove_session.h"

#include "messages/station.pb.h"
#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/reader.h"
#include "server/views/depth_views.h"
#include "server/views/station_views.h"
#include "server/views/view_topics.h"
#include "tools/export_tool/frames.h"

namespace telepalp::export_tool {
namespace {

class FoxgloveFile {
 public:
  explicit FoxgloveFile(wire::McapWriter writer) : writer_(std::move(writer)) {}

  void copy(const wire::Message& message) { keep(writer_.write(message)); }
  template <class Proto>
  void add(const wire::Topic& topic, SessionTime at, const Proto& proto) {
    const wire::mcap::Schema schema{.id = 1,
                                    .name = std::string(topic.schema),
                                    .encoding = "protobuf",
                                    .data = wire::file_descriptor_set(*views::descriptor_of_view(topic))};
    const wire::mcap::Channel channel{
        .id = 0, .schema_id = 1, .topic = std::string(topic.name), .message_encoding = "protobuf", .metadata = {}};
    const auto time = static_cast<std::uint64_t>(to_nanoseconds(at));
    const std::string payload = proto.SerializeAsString();
    keep(writer_.copy(&schema, channel,
                      {.channel_id = 0, .sequence = 0, .log_time = time, .publish_time = time, .data = payload}));
  }
  [[nodiscard]] const Result<void>& state() const noexcept { return state_; }
  [[nodiscard]] Result<std::uint64_t> close() {
    state_ = writer_.finish(state_);
    if (!state_) return state_.error();
    return messages_;
  }

 private:
  void keep(const Result<void>& written) {
    if (state_ && !written) state_ = written;
    if (written) ++messages_;
  }
  wire::McapWriter writer_;
  Result<void> state_;
  std::uint64_t messages_ = 0;
};

void add_ultrasound(const wire::Message& message, FoxgloveFile& out) {
  msg::UltrasoundImage image;
  if (!image.ParseFromString(*message.payload)) return;
  if (const auto view = views::ultrasound_view(image)) out.add(views::kUltrasoundView, message.published, *view);
}

Result<void> add_station_and_color(wire::McapReader& reader, FoxgloveFile& out) {
  reader.select({.topics = {std::string(wire::kCameraColor.name), std::string(wire::kCameraInfo.name),
                            std::string(wire::kCameraColorInfo.name), std::string(wire::kStationState.name),
                            std::string(wire::kStationUltrasound.name)}});
  for (;;) {
    const Result<std::optional<wire::Message>> message = reader.next();
    if (!message) continue;  // the reader continues after the damaged chunk
    if (!*message || !out.state()) return out.state();
    if ((*message)->topic.name == wire::kStationUltrasound.name) {
      add_ultrasound(**message, out);
      continue;
    }
    if ((*message)->topic.name != wire::kStationState.name) {
      out.copy(**message);
      continue;
    }
    msg::StationState state;
    if (!state.ParseFromString(*(*message)->payload)) continue;
    out.add(views::kTransformsView, (*message)->published, views::transforms_view(state, (*message)->published));
    out.add(views::kSceneView, (*message)->published, views::scene_view(state));
  }
}

}  // namespace

Result<std::uint64_t> write_foxglove(const std::filesystem::path& file, const std::filesystem::path& out) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  Result<Frames> frames = Frames::open(file);
  if (!frames) return frames.error();
  Result<wire::McapWriter> writer = wire::McapWriter::open(out, *session);
  if (!writer) return writer.error();
  FoxgloveFile made(std::move(*writer));
  Result<void> done = add_station_and_color(*reader, made);
  if (done)
    done = frames->for_each([&](const RgbdFrame& frame) -> Result<bool> {
      made.add(views::kDepthView, frame.captured, views::depth_view(frame.depth, frame.captured));
      made.add(views::kCloudView, frame.captured, views::cloud_view(frame.depth, frame.camera.depth, frame.captured));
      return made.state() ? Result<bool>(true) : Result<bool>(made.state().error());
    });
  Result<std::uint64_t> closed = made.close();
  return done ? closed : Result<std::uint64_t>(done.error());
}

}  // namespace telepalp::export_tool
