#include "tools/export_tool/foxglove_messages.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "codec/color.h"
#include "codec/color_reader.h"
#include "foxglove/CompressedImage.pb.h"
#include "messages/inside.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/inside/inside_message.h"
#include "server/views/depth_views.h"
#include "server/views/inside_views.h"
#include "server/views/station_views.h"
#include "server/views/view_topics.h"

namespace telepalp::export_tool {
namespace {

/// Makes the views of a station's messages, and gives them on with the messages that plots need.
class StationViews {
 public:
  explicit StationViews(const TakeMessage& take) : take_(take) {}

  Result<void> add(const wire::Message& message) {
    const std::string_view topic = message.topic.name;
    if (topic == wire::kStationUltrasound.name) return add_ultrasound(message);
    if (topic == wire::kStationInside.name) return add_inside(message);
    if (topic == wire::kStationCompensation.name) (void)read(message, compensation_);
    const Result<void> copied = take_(message);
    return copied && topic == wire::kStationState.name ? add_state(message) : copied;
  }

  /// Number of messages that are not of their topic's type.
  [[nodiscard]] std::uint64_t unreadable() const noexcept { return unreadable_; }

 private:
  template <class Proto>
  bool read(const wire::Message& message, Proto& proto) {
    const bool readable = proto.ParseFromString(*message.payload);
    unreadable_ += readable ? 0 : 1;
    return readable;
  }
  template <class Proto>
  Result<void> give(const wire::Topic& topic, SessionTime at, const Proto& proto) {
    return take_(wire::make_message(topic, at, proto));
  }
  Result<void> add_ultrasound(const wire::Message& message) {
    msg::UltrasoundImage image;
    const auto view = read(message, image) ? views::ultrasound_view(image) : std::nullopt;
    return view ? give(views::kUltrasoundView, message.published, *view) : Result<void>{};
  }
  Result<void> add_inside(const wire::Message& message) {
    msg::InnerStructures inside;
    if (!read(message, inside) || !wire::is_valid(inside)) return {};
    inside_ = std::move(inside);
    return give(views::kInsideView, message.published, views::inside_view(inside_));
  }
  Result<void> add_state(const wire::Message& message) {
    msg::StationState state;
    if (!read(message, state)) return {};
    foxglove::FrameTransforms transforms = views::transforms_view(state, message.published);
    views::add_inside_transforms(transforms, inside_, compensation_, message.published);
    Result<void> given = give(views::kTransformsView, message.published, transforms);
    if (given) given = give(views::kSceneView, message.published, views::scene_view(state));
    if (given) given = give(views::kPhaseView, message.published, views::phase_view(state));
    if (const auto hand = views::hand_view(state); given && hand)
      given = give(views::kHandView, message.published, *hand);
    return given;
  }

  const TakeMessage& take_;
  msg::InnerStructures inside_;
  msg::StationCompensation compensation_;
  std::uint64_t unreadable_ = 0;
};

bool is_of_camera(std::string_view topic) { return topic.starts_with("/camera/"); }

std::vector<std::string> topics_of(const FoxgloveParts& parts) {
  std::vector<std::string> topics{std::string(wire::kCameraInfo.name)};
  if (parts.color)
    for (const wire::Topic& topic : {wire::kCameraColor, wire::kCameraColorVideo, wire::kCameraColorInfo})
      topics.emplace_back(topic.name);
  if (parts.station)
    for (const wire::Topic& topic :
         {wire::kStationState, wire::kStationCompensation, wire::kStationSurface, wire::kStationEvents,
          wire::kStationStats, wire::kStationUltrasound, wire::kStationInside})
      topics.emplace_back(topic.name);
  return topics;
}

/// Gives on the colour images that are chosen, as pictures: Foxglove does not decode VP8.
class ColorPictures {
 public:
  /// `has_pictures`: the session has pictures, beside which its video is left out.
  ColorPictures(const TakeMessage& take, Thinning thinning, bool has_pictures)
      : take_(take), thinning_(thinning), has_pictures_(has_pictures) {}

  Result<void> add(const wire::Message& message) {
    const bool is_video = message.topic.predicted;
    if (is_video && has_pictures_) return {};
    const std::optional<wire::CompressedColor> color = wire::compressed_color(message);
    if (!is_video) return color && !takes(*color) ? Result<void>{} : take_(message);
    if (!color) {
      ++unreadable_;
      return {};
    }
    return add_video(message, *color);
  }
  [[nodiscard]] std::uint64_t unreadable() const noexcept { return unreadable_; }

 private:
  bool takes(const wire::CompressedColor& color) { return thinning_.takes(session_time(color.captured_ns)); }
  Result<void> add_video(const wire::Message& message, const wire::CompressedColor& color) {
    const auto bytes = std::as_bytes(std::span(color.data));
    if (!takes(color)) {
      reader_.skip(color.format, bytes, color.number);
      return {};
    }
    const Result<ColorImage> image = reader_.read(color.format, bytes, color.number);
    if (!image) {
      ++unreadable_;
      return {};
    }
    foxglove::CompressedImage picture;
    wire::set_stamp(*picture.mutable_timestamp(), session_time(color.captured_ns));
    picture.set_frame_id(color.frame_id);
    picture.set_format("jpeg");
    picture.set_data(codec::encode_color(*image));
    return take_(wire::make_message(wire::kCameraColor, message.published, picture));
  }

  const TakeMessage& take_;
  Thinning thinning_;
  bool has_pictures_;
  codec::ColorReader reader_;
  std::uint64_t unreadable_ = 0;
};

bool has_topic(const wire::McapReader& session, const wire::Topic& wanted) {
  const auto& channels = session.summary().channels.all();
  return std::any_of(channels.begin(), channels.end(), [&](const auto& channel) {
    return channel.second.topic && channel.second.topic->name == wanted.name;
  });
}

}  // namespace

bool Thinning::takes(SessionTime captured) {
  if (!(images_per_s_ > 0.0)) return true;
  const auto place = static_cast<std::int64_t>(std::floor(to_seconds(captured - begin_) * images_per_s_));
  return std::exchange(last_, place) != place;
}

Result<std::uint64_t> give_station_and_color(wire::McapReader& session, const FoxgloveParts& parts,
                                             const TakeMessage& take) {
  session.select({.topics = topics_of(parts)});
  const auto begin = static_cast<std::int64_t>(session.summary().statistics.message_start_time);
  ColorPictures pictures(take, Thinning(session_time(begin), parts.images_per_s),
                         has_topic(session, wire::kCameraColor));
  StationViews station(take);
  std::uint64_t damaged_chunks = 0;
  for (;;) {
    const Result<std::optional<wire::Message>> message = session.next();
    damaged_chunks += message ? 0 : 1;
    if (!message) continue;  // the reader continues after the damaged chunk
    if (!*message) return damaged_chunks + station.unreadable() + pictures.unreadable();
    const wire::Topic& topic = (*message)->topic;
    const Result<void> given = wire::carries_color(topic) ? pictures.add(**message)
                               : is_of_camera(topic.name) ? take(**message)
                                                          : station.add(**message);
    if (!given) return given.error();
  }
}

std::vector<wire::Message> frame_messages(const RgbdFrame& frame, const FoxgloveParts& parts) {
  std::vector<wire::Message> messages;
  if (parts.depth)
    messages.push_back(
        wire::make_message(views::kDepthView, frame.captured, views::depth_view(frame.depth, frame.captured)));
  if (parts.points) messages.push_back(wire::make_message(views::kCloudView, frame.captured, views::cloud_view(frame)));
  return messages;
}

}  // namespace telepalp::export_tool
