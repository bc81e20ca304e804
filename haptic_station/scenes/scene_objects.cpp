#include "haptic_station/scenes/scene_objects.h"

#include <algorithm>

#include "haptic_station/tissue/fem/prism_model.h"
#include "haptic_station/tissue/tissue_settings.h"
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

std::array<double, 7> numbers_of(const Eigen::Vector3d& at) { return {at.x(), at.y(), at.z()}; }

/// The objects of an effect; most effects have one or none.
struct Objects {
  std::vector<SceneObject> all;

  void operator()(const effects::InnerCylinderSettings& cylinder) {
    const Eigen::Vector3d middle = cylinder.top_center.m - Eigen::Vector3d(0.0, 0.5 * cylinder.height_m, 0.0);
    all.push_back(object(
        "cylinder", {node("tr", numbers_of(middle)), node("cylindery", {cylinder.radius_m, 0.5 * cylinder.height_m})}));
  }
  void operator()(const effects::InnerSphereSettings& sphere) {
    all.push_back(object("sphere", {node("tr", numbers_of(sphere.center.m)), node("sphere", {sphere.radius_m})}));
  }
  /// Each region as far as its full stiffness reaches.
  void operator()(const effects::StiffRegionsSettings& regions) {
    constexpr double kLeast_m = 0.001;  // a region may be a point with a rim
    for (const auto& [name, region] : regions.regions)
      all.push_back(
          object(name.empty() ? "region" : name, {node("tr", {region.center.m.x(), 0.0, region.center.m.z()}),
                                                  node("cylindery", {std::max(region.radius_m, kLeast_m), kDisc_m})}));
  }
  /// A membrane has no edge; the picture shows a part of it.
  void operator()(const effects::MembraneSettings& membrane) {
    constexpr double kShown_m = 0.03;
    all.push_back(object("membrane", {node("tr", numbers_of(membrane.at.m)), node("cylindery", {kShown_m, kDisc_m})}));
  }
  /// Each layer as far as its net reaches, with its thickness.
  void operator()(const effects::LayeredTissueSettings& given) {
    if (!given.model) return;
    const tissue::TissueSettings& settings = tissue::settings_of(*given.model);
    for (const tissue::LayerSettings& layer : settings.layers) {
      const double half_m = std::max(kDisc_m, 0.5 * layer.thickness_m);
      const Eigen::Vector3d middle = settings.at_m - Eigen::Vector3d(0.0, layer.top_m + half_m, 0.0);
      all.push_back(
          object(layer.name, {node("tr", numbers_of(middle)), node("cylindery", {settings.net_radius_m, half_m})}));
    }
  }
  void operator()(const effects::FemPrismSettings& given) {
    if (!given.model) return;
    const tissue::PrismSettings& prism = given.model->settings;
    const Eigen::Vector3d half_m = 0.5 * prism.grid.size_m;
    const Eigen::Vector3d middle_m = prism.foot_m + Eigen::Vector3d(0.0, half_m.y(), 0.0);
    all.push_back(object(prism.name.empty() ? "prism" : prism.name,
                         {node("tr", numbers_of(middle_m)), node("box", numbers_of(half_m))}));
  }
  void operator()(const effects::OrganSettings& organ) {
    if (!organ.shape) return;
    Node mesh = node("mesh", {1.0, organ.shape->spacing_m});
    mesh.file = "organ";
    mesh.lattice = organ.shape;
    all.push_back(object("organ", {mesh}));
  }
  void operator()(const effects::SolidSettings& solid) {
    if (solid.layer) all.push_back({.name = solid.layer->name, .tree = solid.layer->tree});
  }
  void operator()(const effects::SkinSettings&) {}
  void operator()(const effects::FrictionSettings&) {}
};

}  // namespace

std::vector<SceneObject> objects_of(const Scene& scene) {
  Objects objects;
  for (std::size_t i = 0; i < scene.effects.size(); ++i) {
    const std::size_t before = objects.all.size();
    std::visit(objects, scene.effects[i]);
    for (std::size_t k = before; k < objects.all.size(); ++k) objects.all[k].effect = static_cast<std::uint32_t>(i);
  }
  return objects.all;
}

std::optional<SceneNeedle> needle_of(const Scene& scene) {
  constexpr double kLong_m = 0.1;
  for (const effects::Recipe& recipe : scene.effects) {
    const auto* given = std::get_if<effects::LayeredTissueSettings>(&recipe);
    if (given == nullptr || !given->model) continue;
    const tissue::TissueSettings& settings = tissue::settings_of(*given->model);
    double deep_m = settings.layers.back().top_m + settings.layers.back().thickness_m;
    for (const tissue::LayerSettings& layer : settings.layers)
      if (layer.surface) deep_m = layer.top_m;
    const Eigen::Vector3d tip_m = settings.at_m - deep_m * Eigen::Vector3d::UnitY();
    const Eigen::Vector3d along_m = given->tip_m.isZero() ? Eigen::Vector3d(0.0, -kLong_m, 0.0) : given->tip_m;
    return SceneNeedle{tip_m, tip_m - along_m};
  }
  return std::nullopt;
}

}  // namespace telepalp::scenes
