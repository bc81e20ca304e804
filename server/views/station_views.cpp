#include "server/views/station_views.h"

#include <Eigen/Geometry>
#include <cmath>

#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/station/contact_force.h"
#include "proto/wire/vector_message.h"
#include "proto/words/drawn_sizes.h"
#include "proto/words/phase_names.h"

namespace telepalp::views {
namespace {

struct Rgba {
  double r, g, b, a;
};
constexpr Rgba kHand{0.90, 0.72, 0.60, 0.8};
constexpr Rgba kDevice{0.6, 0.6, 0.65, 1.0};
constexpr Rgba kProxy{0.2, 0.6, 1.0, 1.0};
constexpr Rgba kForce{0.9, 0.2, 0.2, 1.0};

SessionTime stamp_of(const msg::StationState& station) {
  return session_time(static_cast<std::int64_t>(station.stamp_ns()));
}

std::string words_of(const msg::StationState& station) {
  return std::string(phase_name(static_cast<int>(station.phase())).words);
}

void set(foxglove::Color& color, const Rgba& rgba) {
  color.set_r(rgba.r);
  color.set_g(rgba.g);
  color.set_b(rgba.b);
  color.set_a(rgba.a);
}

void set(foxglove::Quaternion& out, const Eigen::Quaterniond& q) {
  wire::set_vector(out, q.vec());
  out.set_w(q.w());
}

void set(foxglove::Pose& pose, const Eigen::Vector3d& at, const Eigen::Quaterniond& turned) {
  wire::set_vector(*pose.mutable_position(), at);
  set(*pose.mutable_orientation(), turned);
}

void add_transform(foxglove::FrameTransforms& all, SessionTime now, const char* parent, const char* child,
                   const Eigen::Vector3d& at, const Eigen::Quaterniond& turned) {
  foxglove::FrameTransform& one = *all.add_transforms();
  wire::set_stamp(*one.mutable_timestamp(), now);
  one.set_parent_frame_id(parent);
  one.set_child_frame_id(child);
  wire::set_vector(*one.mutable_translation(), at);
  set(*one.mutable_rotation(), turned);
}

void remove(foxglove::SceneUpdate& scene, const msg::StationState& station, const char* id) {
  foxglove::SceneEntityDeletion& deletion = *scene.add_deletions();
  wire::set_stamp(*deletion.mutable_timestamp(), stamp_of(station));
  deletion.set_type(foxglove::SceneEntityDeletion::MATCHING_ID);
  deletion.set_id(id);
}

foxglove::SceneEntity& add(foxglove::SceneUpdate& scene, const msg::StationState& station, const char* id) {
  foxglove::SceneEntity& entity = *scene.add_entities();
  wire::set_stamp(*entity.mutable_timestamp(), stamp_of(station));
  entity.set_frame_id(wire::kDepthFrameId);
  entity.set_id(id);
  entity.mutable_lifetime()->set_seconds(1);
  return entity;
}

void add_ball(foxglove::SceneUpdate& scene, const msg::StationState& station, const char* id, bool known,
              const msg::Vec3& at, const Eigen::Vector3d& size_m, const Rgba& color) {
  if (!known) return remove(scene, station, id);
  foxglove::SpherePrimitive& ball = *add(scene, station, id).add_spheres();
  set(*ball.mutable_pose(), wire::vector_of(at), Eigen::Quaterniond::Identity());
  wire::set_vector(*ball.mutable_size(), size_m);
  set(*ball.mutable_color(), color);
}

/// The arrow of the contact's force; no arrow while the device is driven.
void add_force(foxglove::SceneUpdate& scene, const msg::StationState& station) {
  constexpr double kLeast_N = 1e-3;
  const Eigen::Vector3d force_N = wire::vector_of(station.force_camera_n());
  if (!station.has_proxy_camera() || !wire::is_contact(station) || !(force_N.norm() > kLeast_N))
    return remove(scene, station, "force");
  foxglove::ArrowPrimitive& arrow = *add(scene, station, "force").add_arrows();
  set(*arrow.mutable_pose(), wire::vector_of(station.proxy_camera()),
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), force_N));  // an arrow points along its x
  const double length_m = kArrow_m_per_N * force_N.norm();
  arrow.set_shaft_length(0.7 * length_m);
  arrow.set_shaft_diameter(0.006);
  arrow.set_head_length(0.3 * length_m);
  arrow.set_head_diameter(0.014);
  set(*arrow.mutable_color(), kForce);
}

/// The phase in a doctor's words, above the device as the camera sees it.
void add_phase(foxglove::SceneUpdate& scene, const msg::StationState& station) {
  if (!station.has_device_camera()) return remove(scene, station, "phase");
  constexpr double kAbove_m = 0.06, kLetters_m = 0.02;
  foxglove::TextPrimitive& text = *add(scene, station, "phase").add_texts();
  set(*text.mutable_pose(), wire::vector_of(station.device_camera()) - kAbove_m * Eigen::Vector3d::UnitY(),
      Eigen::Quaterniond::Identity());
  text.set_billboard(true);
  text.set_font_size(kLetters_m);
  set(*text.mutable_color(), kDevice);
  text.set_text(words_of(station));
}

/// The hand's attitude as a unit quaternion; the identity when the station sent none, or one that is not a rotation.
Eigen::Quaterniond attitude(const msg::StationState& station) {
  const msg::Rotation& rotation = station.hand_attitude_camera();
  const Eigen::Quaterniond q(rotation.w(), rotation.x(), rotation.y(), rotation.z());
  return std::abs(q.norm() - 1.0) < 0.01 ? q.normalized() : Eigen::Quaterniond::Identity();
}

}  // namespace

foxglove::FrameTransforms transforms_view(const std::optional<msg::StationState>& station, SessionTime now) {
  const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond half_turn_about_x(0.0, 1.0, 0.0, 0.0);
  foxglove::FrameTransforms all;
  add_transform(all, now, "patient_site", wire::kDepthFrameId, Eigen::Vector3d::Zero(), half_turn_about_x);
  if (!station) return all;
  if (station->has_displayed_hand_camera())
    add_transform(all, now, wire::kDepthFrameId, "hand", wire::vector_of(station->displayed_hand_camera()),
                  attitude(*station));
  if (station->has_proxy_camera())
    add_transform(all, now, wire::kDepthFrameId, "proxy", wire::vector_of(station->proxy_camera()), none);
  if (station->has_device_camera())
    add_transform(all, now, wire::kDepthFrameId, "device", wire::vector_of(station->device_camera()), none);
  return all;
}

std::optional<foxglove::PoseInFrame> hand_view(const msg::StationState& station) {
  if (!station.has_displayed_hand_camera()) return std::nullopt;
  foxglove::PoseInFrame hand;
  wire::set_stamp(*hand.mutable_timestamp(), stamp_of(station));
  hand.set_frame_id(wire::kDepthFrameId);
  set(*hand.mutable_pose(), wire::vector_of(station.displayed_hand_camera()), attitude(station));
  return hand;
}

foxglove::KeyValuePair phase_view(const msg::StationState& station) {
  foxglove::KeyValuePair phase;
  phase.set_key("phase");
  phase.set_value(words_of(station));
  return phase;
}

std::optional<foxglove::CompressedImage> ultrasound_view(const msg::UltrasoundImage& image) {
  if (!image.on_skin()) return std::nullopt;
  foxglove::CompressedImage view;
  wire::set_stamp(*view.mutable_timestamp(), session_time(static_cast<std::int64_t>(image.stamp_ns())));
  view.set_frame_id("probe");
  view.set_format("jpeg");
  view.set_data(image.jpeg());
  return view;
}

foxglove::SceneUpdate scene_view(const msg::StationState& station) {
  foxglove::SceneUpdate scene;
  add_ball(scene, station, "hand", station.has_displayed_hand_camera(), station.displayed_hand_camera(),
           {0.09, 0.09, 0.03}, kHand);
  add_ball(scene, station, "device", station.has_device_camera(), station.device_camera(),
           Eigen::Vector3d::Constant(2.0 * kBallRadius_m), kDevice);
  add_ball(scene, station, "proxy", station.has_proxy_camera(), station.proxy_camera(), {0.012, 0.012, 0.012}, kProxy);
  add_force(scene, station);
  add_phase(scene, station);
  return scene;
}

}  // namespace telepalp::views
