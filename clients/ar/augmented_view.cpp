#include "clients/ar/augmented_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "clients/ar/canvas.h"
#include "clients/ar/depth_mesh.h"
#include "clients/ar/hand_avatar.h"
#include "clients/ar/shapes.h"
#include "clients/ar/view_choice.h"
#include "proto/words/drawn_sizes.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::ar {
namespace {

constexpr images::Ink kProxyInk{0, 158, 115}, kDeviceInk{0, 114, 178}, kForceInk{240, 228, 66};

Eigen::Vector3f linear(const images::Ink& ink) { return linear_from_srgb(ink.red, ink.green, ink.blue); }

bool is_finite(const Touch& touch) {
  return touch.hand.m.allFinite() && touch.proxy.m.allFinite() && touch.device.m.allFinite() &&
         touch.force.N.allFinite() && std::isfinite(touch.indentation_m);
}

/// The middle of the visible mesh: the median in each direction, because stray pixels do not change it.
Eigen::Vector3f middle_of(const Mesh& mesh) {
  std::vector<float> values;
  Eigen::Vector3f middle(0.0F, 0.0F, 1.0F);
  for (int axis = 0; axis < 3; ++axis) {
    values.clear();
    for (const auto& triangle : mesh.triangles) values.push_back(mesh.vertices[triangle[0]].at[axis]);
    if (values.empty()) return middle;
    middle[axis] = median_of(values);
  }
  return middle;
}

/// Mean normal of the surface within `reach` of `at`; the direction to the camera if no surface is near.
Eigen::Vector3f surface_normal(const Mesh& mesh, const Eigen::Vector3f& at, float reach) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const auto& triangle : mesh.triangles) {
    const Mesh::Vertex& vertex = mesh.vertices[triangle[0]];
    if ((vertex.at - at).squaredNorm() < reach * reach) sum += vertex.normal;
  }
  return sum.norm() > 1e-3F ? sum.normalized() : Eigen::Vector3f(0.0F, 0.0F, -1.0F);
}

/// Removes the vertices between the eye and the touch, and brightens a dark room: the median colour near `target`
/// becomes a mid grey. The gain is at most 2, so that black stays dark.
Mesh cleared(Mesh mesh, const ViewCamera& camera, const Eigen::Vector3f& target) {
  constexpr float kRoom_m = 0.5F, kMidGrey = 0.2F, kMostGain = 2.0F;
  const Eigen::Vector3f forward = camera.view_from_scene.row(2).transpose();
  const float nearest = (target - camera.eye).norm() - kRoom_m;
  std::vector<float> brightness;
  std::erase_if(mesh.triangles, [&](const auto& triangle) {
    const Mesh::Vertex& vertex = mesh.vertices[triangle[0]];
    if ((vertex.at - target).squaredNorm() < kRoom_m * kRoom_m) brightness.push_back(vertex.color.mean());
    return forward.dot(vertex.at - camera.eye) < nearest;
  });
  if (brightness.empty()) return mesh;
  const float gain = std::clamp(kMidGrey / std::max(median_of(brightness), 1e-3F), 1.0F, kMostGain);
  for (Mesh::Vertex& vertex : mesh.vertices) vertex.color *= gain;
  return mesh;
}

/// Places the avatar on the surface. Its fingers point up in the image. Its back points halfway between the surface's
/// normal and the direction to the camera, so that a steep flank does not turn the hand over.
Eigen::Matrix3f scene_from_hand(const Eigen::Vector3f& surface_normal) {
  const Eigen::Vector3f z = (surface_normal + Eigen::Vector3f(0.0F, 0.0F, -1.0F)).normalized();
  const Eigen::Vector3f ahead(0.25F, -1.0F, 0.0F);
  const Eigen::Vector3f y = (ahead - z * ahead.dot(z)).normalized();
  Eigen::Matrix3f rotation;
  rotation << y.cross(z), y, z;
  return rotation;
}

struct Scene {
  Canvas& canvas;
  const ViewCamera& camera;
  const Lights& lights;
  ShadowMap& shadow;

  void draw(const Mesh& mesh, const Paint& paint) const { canvas.draw(mesh, camera, lights, shadow, paint); }
};

/// Draws the touch over the body, which is already on the canvas. Parts below the skin show through it.
void draw_touch(const Scene& scene, const Touch& touch, const Mesh& skin, const Mesh& sleeve) {
  const Eigen::Vector3f proxy = touch.proxy.m.cast<float>(), device = touch.device.m.cast<float>();
  const Eigen::Vector3f force = touch.force.N.cast<float>();
  scene.draw(skin, {.shine = 0.10F});
  scene.draw(sleeve, {.shine = 0.04F});
  scene.draw(painted(ball(device, static_cast<float>(kBallRadius_m)), linear(kDeviceInk)),
             {.opacity = 0.38F, .behind = 0.44F, .shine = 0.6F, .rim = 0.6F, .takes_shadow = false});
  const Mesh rod = painted(frustum(device, proxy, 0.0022F, 0.0022F), linear({255, 255, 255}));
  const Mesh tip = painted(ball(proxy, 0.0075F), linear(kProxyInk));
  const Mesh push =
      painted(arrow(proxy, proxy + static_cast<float>(kArrow_m_per_N) * force, 0.0048F), linear(kForceInk));
  scene.draw(rod, {.behind = 0.75F, .takes_shadow = false});
  scene.draw(push, {.behind = 0.45F, .shine = 0.25F, .takes_shadow = false});
  scene.draw(tip, {.behind = 0.6F, .shine = 0.3F, .takes_shadow = false});
}

std::string rounded(double value) { return std::to_string(std::lround(value)); }

std::vector<PanelLine> key_to_colours(const Touch& touch) {
  const Eigen::Vector3f skin = avatar_color(touch.indentation_m);
  const images::Ink hand{srgb_from_linear(skin.x()), srgb_from_linear(skin.y()), srgb_from_linear(skin.z())};
  return {{"doctor's hand (redder when deeper)", "", hand},
          {"haptic device's ball, " + rounded(200.0 * kBallRadius_m) + " cm", "", kDeviceInk},
          {"proxy on the skin", "", kProxyInk},
          {"force (" + rounded(1e3 * kArrow_m_per_N) + " mm long for 1 N)", "", kForceInk}};
}

}  // namespace

ColorImage draw(const AugmentedView& view) {
  const Mesh body = depth_mesh(view.frame);
  const Eigen::Vector3f middle = middle_of(body);
  const Touch* const touch = view.touch && is_finite(*view.touch) ? &*view.touch : nullptr;
  const Eigen::Vector3f target = touch ? Eigen::Vector3f(touch->proxy.m.cast<float>()) : middle;
  const ViewCamera camera =
      chosen_view(body, target, touch ? std::clamp(0.85F * target.z(), 0.6F, 1.1F) : 0.95F * target.z(), view.width_px,
                  view.height_px);
  const Lights lights{Eigen::Vector3f(-0.45F, -0.30F, -0.84F).normalized(), Eigen::Vector3f(0.0F, 0.0F, -1.0F)};
  ShadowMap shadow(target, lights.key, 0.5F);
  Canvas canvas(view.width_px, view.height_px, linear_from_srgb(226, 233, 240), linear_from_srgb(150, 163, 177));

  Mesh skin, sleeve;
  if (touch) {
    const HandAvatar avatar = hand_avatar();
    const Eigen::Vector3f at = touch->hand.m.cast<float>();
    const Eigen::Matrix3f pose = touch->attitude ? touch->attitude->toRotationMatrix().cast<float>().eval()
                                                 : scene_from_hand(surface_normal(body, target, 0.04F));
    skin = painted(moved(avatar.skin, pose, at), avatar_color(touch->indentation_m));
    sleeve = moved(avatar.sleeve, pose, at);
    shadow.add(skin);
    shadow.add(sleeve);
  }
  const Scene scene{canvas, camera, lights, shadow};
  scene.draw(cleared(body, camera, target), {.two_sided = true});
  if (touch) draw_touch(scene, *touch, skin, sleeve);

  ColorImage image = canvas.resolved();
  draw_panel(image, Corner::TopLeft, view.figures);
  if (touch) draw_panel(image, Corner::BottomRight, key_to_colours(*touch));
  return image;
}

}  // namespace telepalp::ar
