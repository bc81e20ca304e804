#include "clients/view/newest_instant.h"

#include <cstdlib>
#include <span>
#include <utility>

#include "foxglove/CameraCalibration.pb.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/topics.h"

namespace telepalp::view {
namespace {

constexpr std::size_t kMostColors = 4;
constexpr std::size_t kMostStates = 64;  // 0.6 s at 100 Hz
constexpr std::int64_t kSameInstant_ns = 20'000'000;

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

template <class Element>
void keep_newest(std::deque<Element>& elements, Element element, std::size_t most) {
  elements.push_back(std::move(element));
  if (elements.size() > most) elements.pop_front();
}

}  // namespace

NewestInstant::Taken NewestInstant::take(const wire::Message& message) {
  const auto read = [&]<class Proto>(Taken (NewestInstant::*use)(const Proto&)) {
    Proto proto;
    return proto.ParseFromString(*message.payload) ? (this->*use)(proto) : Taken::Unreadable;
  };
  const std::string_view topic = message.topic.name;
  if (topic == wire::kCameraDepth.name) return read(&NewestInstant::take_depth);
  if (wire::carries_color(message.topic)) return take_color(message);
  if (topic == wire::kCameraInfo.name) return read(&NewestInstant::take_camera);
  if (topic == wire::kCameraColorInfo.name) return read(&NewestInstant::take_color_camera);
  if (topic == wire::kStationState.name) return read(&NewestInstant::take_state);
  return Taken::NotNeeded;
}

NewestInstant::Taken NewestInstant::take_color(const wire::Message& message) {
  const std::optional<wire::CompressedColor> color = wire::compressed_color(message);
  if (!color) return Taken::Unreadable;
  Result<ColorImage> image = color_reader_.read(color->format, bytes_of(color->data), color->number);
  if (!image) return message.topic.predicted ? Taken::NeedsKeyFrame : Taken::Unreadable;
  keep_newest(colors_, Color{color->captured_ns, std::move(image).value()}, kMostColors);
  return Taken::Yes;
}

NewestInstant::Taken NewestInstant::take_camera(const foxglove::CameraCalibration& info) {
  if (const auto camera = wire::intrinsics_of(info)) depth_camera_ = camera;
  return Taken::Yes;
}

NewestInstant::Taken NewestInstant::take_color_camera(const foxglove::CameraCalibration& info) {
  if (const auto camera = wire::intrinsics_of(info)) color_camera_ = camera;
  color_registered_ = info.frame_id() != wire::kColorFrameId;
  return Taken::Yes;
}

NewestInstant::Taken NewestInstant::take_state(const msg::StationState& state) {
  if (ar::is_drawable(state)) keep_newest(states_, state, kMostStates);
  return Taken::Yes;
}

NewestInstant::Taken NewestInstant::take_depth(const msg::DepthImage& image) {
  Result<codec::DecodedDepth> depth = reader_.read(bytes_of(image.data()));
  if (!depth) return Taken::NeedsKeyFrame;
  captured_ns_ = static_cast<std::int64_t>(image.captured_ns());
  frame_.captured = session_time(captured_ns_);
  frame_.sequence = image.sequence();
  frame_.depth = std::move(depth->image);
  return Taken::Yes;
}

const msg::StationState* NewestInstant::state_at_capture() const {
  const msg::StationState* best = nullptr;
  const auto distance = [this](const msg::StationState& state) {
    return std::abs(static_cast<std::int64_t>(state.stamp_ns()) - captured_ns_);
  };
  for (const msg::StationState& state : states_)
    if (distance(state) <= kSameInstant_ns && (best == nullptr || distance(state) < distance(*best))) best = &state;
  return best;
}

const ColorImage* NewestInstant::color_at_capture() const {
  for (const Color& color : colors_)
    if (std::abs(color.captured_ns - captured_ns_) <= kSameInstant_ns) return &color.image;
  return nullptr;
}

bool NewestInstant::is_complete(bool with_touch) const {
  if (frame_.depth.samples.empty() || !depth_camera_ || color_at_capture() == nullptr) return false;
  return !with_touch || state_at_capture() != nullptr;
}

ColorImage NewestInstant::picture(int width_px, int height_px) const {
  RgbdFrame frame = frame_;
  frame.color = *color_at_capture();
  frame.camera.depth = ar::scaled_to(*depth_camera_, frame.depth.width, frame.depth.height);
  frame.camera.color = ar::scaled_to(color_camera_.value_or(*depth_camera_), frame.color.width, frame.color.height);
  frame.camera.color_registered = color_registered_;
  const msg::StationState* state = state_at_capture();
  if (state == nullptr)
    return ar::draw({.frame = frame,
                     .touch = std::nullopt,
                     .figures = {{"no hand position at this instant", ""}},
                     .width_px = width_px,
                     .height_px = height_px});
  return ar::draw({.frame = frame,
                   .touch = ar::touch_of(*state),
                   .figures = ar::panel_of(*state),
                   .width_px = width_px,
                   .height_px = height_px});
}

}  // namespace telepalp::view
