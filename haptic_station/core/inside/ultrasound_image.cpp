#include "haptic_station/core/inside/ultrasound_image.h"

#include "codec/color.h"
#include "proto/wire/vector_message.h"

namespace telepalp::core {
namespace {

constexpr int kJpegQuality = 80;

}  // namespace

msg::UltrasoundImage probe_message(const HeldProbe& probe, const ultrasound::BModeSettings& settings,
                                   const Transform<HapticBase, DepthCamera>& haptic_from_camera) {
  const Transform<DepthCamera, HapticBase> camera_from_haptic = haptic_from_camera.inverse();
  msg::UltrasoundImage message;
  message.set_width_m(settings.width_m);
  message.set_depth_m(settings.depth_m);
  if (!probe.on_skin) return message;
  const Eigen::Isometry3d& to_camera = camera_from_haptic.iso;
  wire::set_vector(*message.mutable_face_camera(), (to_camera * probe.pose.at).eval());
  wire::set_vector(*message.mutable_into_body_camera(), (to_camera.linear() * probe.pose.into_body).eval());
  wire::set_vector(*message.mutable_across_camera(), (to_camera.linear() * probe.pose.across).eval());
  return message;
}

void set_image(msg::UltrasoundImage& message, const ultrasound::BModeImage& image) {
  message.set_on_skin(true);
  message.set_jpeg(codec::encode_gray(image.gray, image.side_px, image.side_px, kJpegQuality));
}

}  // namespace telepalp::core
