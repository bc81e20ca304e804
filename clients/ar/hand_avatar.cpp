#include "clients/ar/hand_avatar.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "clients/ar/isosurface.h"
#include "clients/ar/shapes.h"

namespace telepalp::ar {
namespace {

/// A capsule whose radius changes from one end to the other [mm].
struct Bone {
  Eigen::Vector3f from, to;
  float from_radius, to_radius;
};

/// Distance to a bone, exact for equal radii and close enough for slight tapers [mm].
float distance(const Bone& bone, const Eigen::Vector3f& at) {
  const Eigen::Vector3f axis = bone.to - bone.from;
  const float along = std::clamp((at - bone.from).dot(axis) / axis.squaredNorm(), 0.0F, 1.0F);
  return (at - bone.from - along * axis).norm() - (bone.from_radius + along * (bone.to_radius - bone.from_radius));
}

/// Union of two bodies with a fillet of about `fillet`. Source: Quilez, "smooth minimum", polynomial form.
float smooth_union(float a, float b, float fillet) {
  const float overlap = std::max(fillet - std::abs(a - b), 0.0F) / fillet;
  return std::min(a, b) - overlap * overlap * fillet * 0.25F;
}

/// Joints from knuckle to tip [mm], of a hand of average length (wrist to middle finger tip: about 190 mm).
std::vector<std::vector<Bone>> digits() {
  const auto finger = [](std::vector<Eigen::Vector3f> joints, float root, float tip) {
    std::vector<Bone> bones;
    const auto count = static_cast<float>(joints.size() - 1);
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
      const float near = root + (tip - root) * static_cast<float>(i) / count;
      const float far = root + (tip - root) * static_cast<float>(i + 1) / count;
      bones.push_back({joints[i], joints[i + 1], near, far});
    }
    return bones;
  };
  return {
      finger({{-27, -92, 56}, {-24, -51, 47}, {-19, -25, 27}, {-16, -7, 9}}, 9.8F, 7.2F),      // index
      finger({{-5, -88, 60}, {-3, -42, 51}, {-1, -13, 29}, {1, 5, 9}}, 10.0F, 7.4F),           // middle
      finger({{16, -92, 57}, {17, -50, 47}, {18, -22, 27}, {19, -5, 9}}, 9.4F, 7.0F),          // ring
      finger({{35, -101, 50}, {37, -69, 41}, {37, -47, 24}, {36, -32, 10}}, 8.2F, 6.2F),       // little
      finger({{-31, -158, 50}, {-52, -125, 40}, {-60, -93, 28}, {-57, -67, 17}}, 13.0F, 8.0F)  // thumb
  };
}

std::vector<Bone> palm() {
  const Eigen::Vector3f wrist(2, -178, 62);
  return {{{-14, -172, 60}, {-26, -95, 54}, 15.0F, 12.0F},
          {{-3, -172, 62}, {-5, -92, 57}, 15.0F, 12.5F},
          {{9, -172, 61}, {15, -95, 54}, 14.0F, 12.0F},
          {{18, -170, 58}, {34, -104, 48}, 13.0F, 10.5F},
          {wrist, {8, -262, 92}, 24.0F, 27.0F}};
}

float hand_distance(const std::vector<std::vector<Bone>>& fingers, const std::vector<Bone>& hand,
                    const Eigen::Vector3f& at) {
  float body = 1e6F;
  for (const Bone& bone : hand) body = smooth_union(body, distance(bone, at), 14.0F);
  // Fingers blend with the palm but not with one another, so each finger is joined only to the palm.
  float all = body;
  for (const auto& bones : fingers) {
    float finger = 1e6F;
    for (const Bone& bone : bones) finger = smooth_union(finger, distance(bone, at), 3.0F);
    all = std::min(all, smooth_union(body, finger, 12.0F));
  }
  return all;
}

}  // namespace

HandAvatar hand_avatar() {
  const auto fingers = digits();
  const auto hand = palm();
  const Eigen::AlignedBox3f box(Eigen::Vector3f(-90, -300, -12), Eigen::Vector3f(70, 30, 135));
  Mesh skin = isosurface([&](const Eigen::Vector3f& at) { return hand_distance(fingers, hand, at); }, box, 2.5F);
  for (Mesh::Vertex& vertex : skin.vertices) vertex.at *= 1e-3F;
  const Eigen::Vector3f cuff(0.0062F, -0.235F, 0.083F), elbow(0.029F, -0.62F, 0.222F);
  Mesh sleeve = frustum(cuff, elbow, 0.036F, 0.052F);
  return {std::move(skin), painted(std::move(sleeve), linear_from_srgb(236, 240, 245))};
}

Eigen::Vector3f avatar_color(double indentation_m) noexcept {
  const auto deep = static_cast<float>(std::clamp(indentation_m / 0.06, 0.0, 1.0));
  const Eigen::Vector3f skin = linear_from_srgb(226, 184, 158), red = linear_from_srgb(214, 40, 40);
  return skin + deep * (red - skin);
}

}  // namespace telepalp::ar
