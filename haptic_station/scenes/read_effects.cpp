#include "haptic_station/scenes/read_effects.h"

#include <algorithm>
#include <optional>
#include <type_traits>

#include "haptic_station/effects/presets/tissue_presets.h"
#include "haptic_station/organs/organ_shape.h"
#include "haptic_station/scenes/layer.h"
#include "haptic_station/scenes/read_tissue.h"
#include "proto/words/demand.h"

namespace telepalp::scenes {
namespace {

/// What reading an effect needs, besides its own message.
struct Reading {
  FieldCheck& check;
  const msg::Scene& message;
  const std::filesystem::path& folder;
  MeshDetail detail;
  const std::vector<effects::Recipe>& before;  ///< the recipes of the effects that precede this one in the file
};

/// Read<Kind>::from() reads the recipe of an effect of one kind from its message. Each kind of effects::Effect needs
/// one.
template <class Kind>
struct Read;

std::string tissue_names() {
  std::string names;
  for (const effects::TissuePreset& preset : effects::kTissuePresets)
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  return names;
}

/// Reads a law that replaces S1's: a linear spring, a curve, or the curve of a tissue.
void read_tissue(FieldCheck& check, const msg::SkinEffect& message, effects::Skin::Settings& skin) {
  effects::SkinLaw& law = skin.law;
  check.in(message);
  if (int{message.has_linear_stiffness_n_per_m()} + int{message.has_tissue()} + int{message.has_measured()} > 1)
    check.complain("skin gives more than one of linear_stiffness_N_per_m, tissue and measured",
                   "give only one of them");
  if (message.has_measured()) {
    const msg::SkinEffect::Curve& curve = message.measured();
    law = effects::linear_law(0.0);
    check.number("skin.measured.constant_N_per_m", curve.constant_n_per_m(), {0, 5000, "N/m"}, law.constant_N_per_m);
    check.number("skin.measured.slope_N_per_m2", curve.slope_n_per_m2(), {0, 1e6, "N/m^2"}, law.slope_N_per_m2);
    check.number("skin.measured.curve_N_per_m3", curve.curve_n_per_m3(), {0, 1e8, "N/m^3"}, law.curve_N_per_m3);
  }
  if (message.has_linear_stiffness_n_per_m()) {
    law = effects::linear_law(0.0);
    TELEPALP_READ(check, "skin.", message, linear_stiffness_n_per_m, law.constant_N_per_m, {0, 5000, "N/m"});
  }
  if (!message.has_tissue()) return;
  const effects::TissuePreset* preset = effects::find_tissue(message.tissue());
  if (preset == nullptr)
    check.complain("skin.tissue \"" + message.tissue() + "\" is not known", "use one of: " + tissue_names());
  else {
    law = preset->law;
    skin.tissue = preset;
  }
}

effects::Skin::Settings read_skin_settings(FieldCheck& check, const msg::SkinEffect& message) {
  effects::Skin::Settings skin;
  check.in(message);
  double stiffness = 160.0;
  double at_m = 0.06;
  TELEPALP_READ(check, "skin.", message, stiffness_n_per_m, stiffness, {1, 5000, "N/m"});
  TELEPALP_READ(check, "skin.", message, at_indentation_m, at_m, {0.001, 0.2, "m"});
  double alpha = effects::alpha_for(stiffness, at_m);
  if (message.has_alpha_n_per_m2()) {
    if (message.has_stiffness_n_per_m() || message.has_at_indentation_m())
      check.complain("skin gives alpha_N_per_m2 beside stiffness_N_per_m or at_indentation_m",
                     "give alpha_N_per_m2 alone, or the other two");
    TELEPALP_READ(check, "skin.", message, alpha_n_per_m2, alpha, {1, 1e6, "N/m^2"});
  }
  skin.law = effects::paper_law(alpha);
  read_tissue(check, message, skin);
  skin.law.by_axis = message.stiffness_by_axis();
  if (message.anchor() == msg::SkinEffect::ANCHOR_FIXED) skin.anchor = effects::SkinAnchor::Fixed;
  if (message.anchor() == msg::SkinEffect::ANCHOR_SLIDING) skin.anchor = effects::SkinAnchor::Sliding;
  return skin;
}

template <>
struct Read<effects::Skin> {
  static effects::Skin::Settings from(const Reading& reading, const msg::SkinEffect& message) {
    return read_skin_settings(reading.check, message);
  }
};

template <>
struct Read<effects::InnerCylinder> {
  static effects::InnerCylinder::Settings from(const Reading& reading, const msg::CylinderEffect& message) {
    FieldCheck& check = reading.check;
    effects::InnerCylinder::Settings cylinder;
    cylinder.top_center.m = read_xyz(check, "cylinder.top_center_m", message.top_center_m(), {-1, 1, "m"});
    TELEPALP_READ(check, "cylinder.", message, radius_m, cylinder.radius_m, {0.001, 0.3, "m"});
    TELEPALP_READ(check, "cylinder.", message, height_m, cylinder.height_m, {0.001, 0.5, "m"});
    TELEPALP_READ(check, "cylinder.", message, stiffness_n_per_m, cylinder.stiffness_N_per_m, {0, 5000, "N/m"});
    return cylinder;
  }
};

template <>
struct Read<effects::InnerSphere> {
  static effects::InnerSphere::Settings from(const Reading& reading, const msg::SphereEffect& message) {
    FieldCheck& check = reading.check;
    effects::InnerSphere::Settings sphere;
    sphere.center.m = read_xyz(check, "sphere.center_m", message.center_m(), {-1, 1, "m"});
    TELEPALP_READ(check, "sphere.", message, radius_m, sphere.radius_m, {0.001, 0.3, "m"});
    TELEPALP_READ(check, "sphere.", message, stiffness_n_per_m, sphere.stiffness_N_per_m, {0, 5000, "N/m"});
    return sphere;
  }
};

/// The load is the force of the first skin in the scene, at any position in the file.
template <>
struct Read<effects::Friction> {
  static effects::Friction::Settings from(const Reading& reading, const msg::FrictionEffect& message) {
    FieldCheck& check = reading.check;
    const auto& all = reading.message.effects();
    effects::Friction::Settings friction;
    TELEPALP_READ(check, "friction.", message, coefficient, friction.coefficient, {0, 3, "N/N"});
    TELEPALP_READ(check, "friction.", message, bristle_stiffness_n_per_m, friction.bristle_stiffness_N_per_m,
                  {10, 3000, "N/m"});
    const auto skin = std::ranges::find_if(all, [](const msg::Effect& effect) { return effect.has_skin(); });
    if (skin == all.end())
      check.in(message).complain("friction needs a skin effect", "add effects { skin { anchor: ANCHOR_SLIDING } }");
    else
      friction.load = read_skin_settings(check, skin->skin()).law;
    return friction;
  }
};

template <>
struct Read<effects::StiffRegions> {
  static effects::StiffRegions::Settings from(const Reading& reading, const msg::RegionsEffect& message) {
    FieldCheck& check = reading.check;
    effects::StiffRegionsSettings regions;
    if (message.region().empty())
      check.in(message).complain("regions names no region", "add region { center_m { x: 0 z: 0 } }");
    for (const msg::RegionsEffect::Region& given : message.region()) {
      effects::StiffRegion region;
      region.center.m = read_xyz(check, "region.center_m", given.center_m(), {-1, 1, "m"});
      TELEPALP_READ(check, "region.", given, radius_m, region.radius_m, {0, 0.3, "m"});
      TELEPALP_READ(check, "region.", given, fade_m, region.fade_m, {0.001, 0.3, "m"});
      TELEPALP_READ(check, "region.", given, added_n_per_m, region.added_N_per_m, {0, 3000, "N/m"});
      if (regions.regions.size() == effects::StiffRegions::kMostRegions)
        check.in(given).complain(
            "regions names more than " + std::to_string(effects::StiffRegions::kMostRegions) + " regions",
            "leave some out, or add a second regions effect");
      regions.regions.push_back({given.name(), region});
    }
    return regions;
  }
};

/// The mesh file is read only when the numbers of the message are valid.
template <>
struct Read<effects::Organ> {
  static effects::Organ::Settings from(const Reading& reading, const msg::OrganEffect& message) {
    FieldCheck& check = reading.check;
    organs::OrganShapeSettings shape;
    effects::Organ::Settings organ;
    TELEPALP_READ(check, "organ.", message, unit_m, shape.unit_m, {1e-6, 1000, "m"});
    TELEPALP_READ(check, "organ.", message, stiffness_n_per_m, organ.stiffness_N_per_m, {0, 5000, "N/m"});
    TELEPALP_READ(check, "organ.", message, cell_m, shape.cell_m, {0.001, 0.02, "m"});
    shape.haptic_from_model = read_transform(check, "organ.haptic_from_model", message.haptic_from_model());
    shape.cell_m = cell_with(reading.detail, shape.cell_m);
    shape.margin_m = effects::kAround_m + 3.0 * shape.cell_m;
    if (message.file().empty()) check.in(message).complain("organ.file is empty", "name a closed mesh, .ply or .obj");
    if (check.error()) return organ;
    const auto read = organs::read_organ_shape(reading.folder / message.file(), shape);
    if (!read) {
      check.in(message).fail_in_file("organ: ", read.error());
      return organ;
    }
    organ.shape = *read;
    return organ;
  }
};

template <>
struct Read<effects::Solid> {
  static effects::Solid::Settings from(const Reading& reading, const msg::SolidEffect& message) {
    const auto has_its_name = [&](const effects::Recipe& one) {
      const auto* layer = std::get_if<effects::SolidSettings>(&one);
      return layer != nullptr && layer->layer && layer->layer->name == message.name();
    };
    effects::SolidSettings layer = read_layer(reading.check, message, reading.folder, reading.detail);
    if (std::ranges::any_of(reading.before, has_its_name))
      reading.check.in(message).complain("an earlier layer has the name " + message.name(),
                                         "give each layer a name of its own, as in name: \"" + message.name() + " 2\"");
    return layer;
  }
};

template <>
struct Read<effects::Membrane> {
  static effects::Membrane::Settings from(const Reading& reading, const msg::MembraneEffect& message) {
    FieldCheck& check = reading.check;
    effects::Membrane::Settings membrane;
    membrane.at.m = read_xyz(check, "membrane.at_m", message.at_m(), {-1, 1, "m"});
    membrane.tip_m = read_xyz(check, "membrane.tip_m", message.tip_m(), {-0.3, 0.3, "m"});
    TELEPALP_READ(check, "membrane.", message, stiffness_n_per_m, membrane.stiffness_N_per_m, {10, 5000, "N/m"});
    TELEPALP_READ(check, "membrane.", message, tears_at_n, membrane.tears_at_N, {0.1, 20, "N"});
    TELEPALP_READ(check, "membrane.", message, friction_n, membrane.friction_N, {0, 3, "N"});
    TELEPALP_READ(check, "membrane.", message, skin_left, membrane.skin_left, {0, 1, "N/N"});
    return membrane;
  }
};

template <>
struct Read<effects::LayeredTissue> {
  static effects::LayeredTissue::Settings from(const Reading& reading, const msg::LayeredTissueEffect& message) {
    return read_layered_tissue(reading.check, message);
  }
};

template <>
struct Read<effects::FemPrism> {
  static effects::FemPrism::Settings from(const Reading& reading, const msg::FemPrismEffect& message) {
    return read_prism(reading.check, message);
  }
};

template <class Settings, class Message>
effects::Recipe read_with(Settings (*from)(const Reading&, const Message&), const Reading& reading,
                          const google::protobuf::Message& message) {
  return from(reading, static_cast<const Message&>(message));
}

/// The recipe of the kind whose kName is `name`.
template <class... Kinds>
effects::Recipe read_kind(std::type_identity<std::variant<Kinds...>>, const Reading& reading, const std::string& name,
                          const google::protobuf::Message& message) {
  std::optional<effects::Recipe> recipe;
  const bool known =
      ((name == Kinds::kName && (recipe = read_with(&Read<Kinds>::from, reading, message)).has_value()) || ...);
  demand(known, "each field of msg::Effect has the kName of an effect");
  return std::move(*recipe);
}

/// The field of `effect` that names its kind; nullptr: none is set.
const google::protobuf::FieldDescriptor* kind_field_of(const msg::Effect& effect) {
  return effect.GetReflection()->GetOneofFieldDescriptor(effect, effect.GetDescriptor()->FindOneofByName("kind"));
}

}  // namespace

std::vector<effects::Recipe> read_effects(FieldCheck& check, const msg::Scene& message,
                                          const std::filesystem::path& folder, MeshDetail detail) {
  std::vector<effects::Recipe> recipes;
  const Reading reading{check, message, folder, detail, recipes};
  if (message.effects().empty())
    check.in(message).complain("the scene names no effect", "add at least effects { skin {} }");
  for (const msg::Effect& effect : message.effects()) {
    const google::protobuf::FieldDescriptor* kind = kind_field_of(effect);
    if (kind == nullptr) {
      check.in(effect).complain("the effect has no kind", "name its kind, as in effects { skin {} }");
      continue;
    }
    if (recipes.size() == effects::kMostEffects)
      check.in(effect).complain("the scene names more than " + std::to_string(effects::kMostEffects) + " effects",
                                "leave some effects out");
    recipes.push_back(read_kind(std::type_identity<effects::Effect>(), reading, std::string(kind->name()),
                                effect.GetReflection()->GetMessage(effect, kind)));
  }
  return recipes;
}

}  // namespace telepalp::scenes
