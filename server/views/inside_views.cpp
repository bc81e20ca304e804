#include "server/views/inside_views.h"

#include <Eigen/Geometry>
#include <array>
#include <string>

#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/vector_message.h"
#include "proto/words/little_endian.h"

namespace telepalp::views {
namespace {

/// Colours that colour-blind people can tell apart (Okabe and Ito 2008), as on the web page.
constexpr std::array<std::array<int, 3>, 7> kColors{{{0xe6, 0x9f, 0x00},
                                                     {0x56, 0xb4, 0xe9},
                                                     {0x00, 0x9e, 0x73},
                                                     {0xf0, 0xe4, 0x42},
                                                     {0xcc, 0x79, 0xa7},
                                                     {0x00, 0x72, 0xb2},
                                                     {0xd5, 0x5e, 0x00}}};

std::string frame_of(const msg::InnerStructure& structure) {
  return "inside/" + structure.name() + "/" + std::to_string(structure.effect());
}

/// Number `place` of a string of unsigned 16-bit numbers, little-endian.
std::uint32_t number_at(const std::string& numbers, std::size_t place) noexcept {
  return get_little_endian<std::uint16_t>(numbers.data() + 2 * place);
}

void set_color(foxglove::Color& color, const std::array<int, 3>& rgb) {
  color.set_r(rgb[0] / 255.0);
  color.set_g(rgb[1] / 255.0);
  color.set_b(rgb[2] / 255.0);
  color.set_a(1.0);
}

void set_triangles(foxglove::TriangleListPrimitive& mesh, const msg::InnerStructure& structure) {
  const Eigen::Vector3d least = wire::vector_of(structure.least());
  mesh.mutable_pose()->mutable_position();
  mesh.mutable_pose()->mutable_orientation()->set_w(1.0);
  for (std::size_t place = 0; place + 2 < structure.points().size() / 2; place += 3) {
    const Eigen::Vector3d steps(number_at(structure.points(), place), number_at(structure.points(), place + 1),
                                number_at(structure.points(), place + 2));
    wire::set_vector(*mesh.add_points(), (least + structure.step_m() * steps).eval());
  }
  for (std::size_t place = 0; place < structure.triangles().size() / 2; ++place)
    mesh.add_indices(number_at(structure.triangles(), place));
}

Eigen::Vector3d moved_by(const msg::StationCompensation& moved, std::uint32_t effect) {
  for (const msg::ObjectPlacement& object : moved.objects())
    if (object.effect() == effect && object.has_moved()) return wire::vector_of(object.moved());
  return Eigen::Vector3d::Zero();
}

}  // namespace

foxglove::SceneUpdate inside_view(const msg::InnerStructures& inside) {
  const SessionTime stamp = session_time(static_cast<std::int64_t>(inside.stamp_ns()));
  foxglove::SceneUpdate scene;
  foxglove::SceneEntityDeletion& earlier = *scene.add_deletions();
  wire::set_stamp(*earlier.mutable_timestamp(), stamp);
  earlier.set_type(foxglove::SceneEntityDeletion::ALL);
  for (int i = 0; i < inside.structures_size(); ++i) {
    foxglove::SceneEntity& entity = *scene.add_entities();
    wire::set_stamp(*entity.mutable_timestamp(), stamp);
    entity.set_frame_id(frame_of(inside.structures(i)));
    entity.set_id(frame_of(inside.structures(i)));
    entity.set_frame_locked(true);
    foxglove::TriangleListPrimitive& mesh = *entity.add_triangles();
    set_triangles(mesh, inside.structures(i));
    set_color(*mesh.mutable_color(), kColors[static_cast<std::size_t>(i) % kColors.size()]);
  }
  return scene;
}

void add_inside_transforms(foxglove::FrameTransforms& all, const msg::InnerStructures& inside,
                           const msg::StationCompensation& moved, SessionTime now) {
  const msg::Rotation& turn = inside.camera_from_haptic();
  const Eigen::Quaterniond camera_from_haptic = Eigen::Quaterniond(turn.w(), turn.x(), turn.y(), turn.z()).normalized();
  for (const msg::InnerStructure& structure : inside.structures()) {
    foxglove::FrameTransform& one = *all.add_transforms();
    wire::set_stamp(*one.mutable_timestamp(), now);
    one.set_parent_frame_id(wire::kDepthFrameId);
    one.set_child_frame_id(frame_of(structure));
    const Eigen::Vector3d origin = wire::vector_of(inside.haptic_origin_camera());
    wire::set_vector(*one.mutable_translation(),
                     (origin + camera_from_haptic * moved_by(moved, structure.effect())).eval());
    wire::set_vector(*one.mutable_rotation(), camera_from_haptic.vec());
    one.mutable_rotation()->set_w(camera_from_haptic.w());
  }
}

}  // namespace telepalp::views
