#include "tests/bench/users/gate_defects.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/writer.h"
#include "proto/wire/station/contact_force.h"
#include "proto/wire/topics.h"

namespace telepalp::bench {
namespace {

/// What becomes of a message; nullopt: it is left out.
using Change = std::function<std::optional<wire::Message>(wire::Message)>;

/// Copies a session with `change` applied to each message. `changed`: how many messages were changed.
Result<void> copy(const std::filesystem::path& from, const std::filesystem::path& to, const Change& change,
                  const std::size_t& changed) {
  Result<wire::McapReader> reader = wire::McapReader::open(from);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> info = reader->session();
  if (!info) return info.error();
  Result<wire::McapWriter> writer = wire::McapWriter::open(to, *info);
  if (!writer) return writer.error();
  for (;;) {
    Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    const std::optional<wire::Message> now = change(std::move(**message));
    if (!now) continue;
    if (const Result<void> written = writer->write(*now); !written) return written;
  }
  if (changed == 0)
    return Error{.what = "has nothing to plant the defect in", .where = from.string(), .fix = "make a longer session"};
  return writer->close();
}

/// A change of all messages of one topic; `edit` returns true if it changed the message.
template <class Proto>
Result<void> edit_each(const std::filesystem::path& from, const std::filesystem::path& to, const wire::Topic& topic,
                       const std::function<bool(Proto&)>& edit) {
  std::size_t changed = 0;
  const auto change = [&](wire::Message message) -> std::optional<wire::Message> {
    Proto proto;
    if (message.topic.name != topic.name || !proto.ParseFromString(*message.payload) || !edit(proto)) return message;
    ++changed;
    return wire::make_message(topic, message.published, proto, message.key_frame);
  };
  return copy(from, to, change, changed);
}

double force_N(const msg::StationTicks& ticks, int i) {
  return std::hypot(double{ticks.force_x(i)}, double{ticks.force_y(i)}, double{ticks.force_z(i)});
}

void scale_force(msg::StationTicks& ticks, int i, double scale) {
  for (auto* axis : {ticks.mutable_force_x(), ticks.mutable_force_y(), ticks.mutable_force_z()})
    axis->Set(i, static_cast<float>(scale * double{axis->Get(i)}));
}

}  // namespace

Result<void> clip_forces(const std::filesystem::path& from, const std::filesystem::path& to, double most_N) {
  return edit_each<msg::StationTicks>(from, to, wire::kStationTicks, [=](msg::StationTicks& ticks) {
    bool changed = false;
    for (int i = 0; i < ticks.force_x_size(); ++i)
      if (const double force = force_N(ticks, i); force > most_N) {
        scale_force(ticks, i, most_N / force);
        changed = true;
      }
    return changed;
  });
}

Result<void> begin_contacts_late(const std::filesystem::path& from, const std::filesystem::path& to, double late_m) {
  bool in_contact = false, late = false;
  double began_y_m = 0.0;
  return edit_each<msg::StationTicks>(from, to, wire::kStationTicks, [=](msg::StationTicks& ticks) mutable {
    bool changed = false;
    for (int i = 0; i < ticks.phase_size(); ++i) {
      const bool contact = wire::is_contact(ticks.phase(i));
      if (contact && !in_contact) began_y_m = double{ticks.device_y(i)};
      if (contact != in_contact) late = contact;
      in_contact = contact;
      late = late && began_y_m - double{ticks.device_y(i)} < late_m;
      if (!late) continue;
      ticks.set_phase(i, msg::PHASE_PLANE_TO_BODY);
      scale_force(ticks, i, 0.0);
      changed = true;
    }
    return changed;
  });
}

Result<void> remove_images(const std::filesystem::path& from, const std::filesystem::path& to, double share) {
  std::size_t seen = 0, removed = 0;
  const auto change = [&](wire::Message message) -> std::optional<wire::Message> {
    if (message.topic.name != wire::kCameraDepth.name) return message;
    const bool remove = static_cast<double>(removed) < share * static_cast<double>(seen++);
    if (!remove) return message;
    ++removed;
    return std::nullopt;
  };
  return copy(from, to, change, removed);
}

Result<void> scale_depths(const std::filesystem::path& from, const std::filesystem::path& to, double scale) {
  codec::DepthDecoder decoder;
  return edit_each<msg::DepthImage>(from, to, wire::kCameraDepth, [&](msg::DepthImage& image) {
    Result<DepthImage> depth = decoder.decode(std::as_bytes(std::span(image.data())));
    if (!depth) return false;
    for (std::uint16_t& sample : depth->samples) sample = static_cast<std::uint16_t>(std::lround(scale * sample));
    image.set_data(codec::encode_depth(*depth, codec::DepthMode::Fast));
    image.set_format(std::string(codec::name(codec::DepthMode::Fast)));
    return true;
  });
}

Result<void> halve_intrinsics(const std::filesystem::path& from, const std::filesystem::path& to) {
  return edit_each<foxglove::CameraCalibration>(from, to, wire::kCameraInfo, [](foxglove::CameraCalibration& camera) {
    if (camera.frame_id() != "camera_depth") return false;
    for (const int entry : {0, 2, 4, 5}) camera.set_k(entry, 0.5 * camera.k(entry));
    return true;
  });
}

Result<void> remove_a_second(const std::filesystem::path& from, const std::filesystem::path& to) {
  Result<wire::McapReader> reader = wire::McapReader::open(from);
  if (!reader) return reader.error();
  const auto& summary = reader->summary();
  const std::uint64_t begin = summary.statistics.message_start_time, end = summary.statistics.message_end_time;
  const SessionTime gap = session_time(static_cast<std::int64_t>(begin + (end - begin) / 2));
  std::size_t removed = 0;
  const auto change = [&](wire::Message message) -> std::optional<wire::Message> {
    if (message.published < gap || message.published >= gap + std::chrono::seconds(1)) return message;
    ++removed;
    return std::nullopt;
  };
  return copy(from, to, change, removed);
}

Result<void> edit_scene(const std::filesystem::path& from, const std::filesystem::path& to, std::string_view old,
                        std::string_view now) {
  std::ifstream in(from);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t place = text.find(old);
  if (place == std::string::npos)
    return Error{.what = "lacks '" + std::string(old) + "'", .where = from.string(), .fix = "correct the bench"};
  text.replace(place, old.size(), now);
  if (!(std::ofstream(to) << text))
    return Error{.what = "cannot be written", .where = to.string(), .fix = "free space on the disk"};
  return {};
}

}  // namespace telepalp::bench
