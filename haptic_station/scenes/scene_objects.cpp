#include "haptic_station/scenes/scene_objects.h"

#include <algorithm>

#include "proto/words/demand.h"

namespace telepalp::scenes {
namespace {

using solids::Node;
using solids::Solid;

constexpr double kDisc_m = 0.0005;  // half the thickness of a region of the skin or of a membrane in a picture

Node node(std::string_view word, std::array<double, 7> numbers) {
  return {.word = *solids::find_word(word), .numbers = numbers};
}

SceneObject object(std::string name, const Solid& solid) {
  auto tree = solids::build_tree(solid);
  demand(tree.ok(), "the numbers of a scene are checked when it is read");
  return {.name = std::move(name), .tree = std::move(tree).value()};
}

SceneObject cylinder(const msg::CylinderEffect& message) {
  effects::InnerCylinderSettings cylinder;
  if (message.has_radius_m()) cylinder.radius_m = message.radius_m();
  if (message.has_height_m()) cylinder.height_m = message.height_m();
  const msg::Vec3& top = message.top_center_m();
  return object("cylinder", {node("tr", {top.x(), top.y() - 0.5 * cylinder.height_m, top.z()}),
                             node("cylindery", {cylinder.radius_m, 0.5 * cylinder.height_m})});
}

SceneObject sphere(const msg::SphereEffect& message) {
  effects::InnerSphereSettings sphere;
  if (message.has_radius_m()) sphere.radius_m = message.radius_m();
  const msg::Vec3& center = message.center_m();
  return object("sphere", {node("tr", {center.x(), center.y(), center.z()}), node("sphere", {sphere.radius_m})});
}

/// A region as far as its full stiffness reaches.
SceneObject region(const msg::RegionsEffect::Region& message) {
  effects::StiffRegion region;
  if (message.has_radius_m()) region.radius_m = message.radius_m();
  constexpr double kLeast_m = 0.001;  // a region may be a point with a rim
  return object(message.name().empty() ? "region" : message.name(),
                {node("tr", {message.center_m().x(), 0.0, message.center_m().z()}),
                 node("cylindery", {std::max(region.radius_m, kLeast_m), kDisc_m})});
}

/// A membrane has no edge; the picture shows a part of it.
SceneObject membrane(const msg::MembraneEffect& message) {
  constexpr double kShown_m = 0.03;
  const msg::Vec3& at = message.at_m();
  return object("membrane", {node("tr", {at.x(), at.y(), at.z()}), node("cylindery", {kShown_m, kDisc_m})});
}

SceneObject organ(const SceneOrgan& organ) {
  Node mesh = node("mesh", {1.0, organ.shape->spacing_m});
  mesh.file = "organ";
  mesh.lattice = organ.shape;
  return object("organ", {mesh});
}

}  // namespace

std::vector<SceneObject> objects_of(const Scene& scene) {
  std::vector<SceneObject> objects;
  for (int i = 0; i < scene.message.effects_size(); ++i) {
    const msg::Effect& effect = scene.message.effects(i);
    const auto index = static_cast<std::uint32_t>(i);
    const std::size_t before = objects.size();
    if (effect.has_cylinder()) objects.push_back(cylinder(effect.cylinder()));
    if (effect.has_sphere()) objects.push_back(sphere(effect.sphere()));
    if (effect.has_membrane()) objects.push_back(membrane(effect.membrane()));
    for (const msg::RegionsEffect::Region& given : effect.regions().region()) objects.push_back(region(given));
    for (const SceneOrgan& given : scene.organs)
      if (given.effect == index) objects.push_back(organ(given));
    for (const SceneLayer& layer : scene.layers)
      if (layer.effect == index) objects.push_back({.name = layer.solid->name, .tree = layer.solid->tree});
    for (std::size_t k = before; k < objects.size(); ++k) objects[k].effect = index;
  }
  return objects;
}

}  // namespace telepalp::scenes
