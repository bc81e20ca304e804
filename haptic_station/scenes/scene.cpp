#include "haptic_station/scenes/scene.h"

#include <algorithm>
#include <numbers>

#include "haptic_station/effects/tissue_presets.h"
#include "haptic_station/organs/organ_shape.h"
#include "haptic_station/scenes/field_check.h"
#include "haptic_station/scenes/layer.h"
#include "proto/words/rotation_vector.h"
#include "support/program/files/shipped.h"
#include "support/program/text_format.h"

namespace telepalp::scenes {
namespace {

/// Reads an optional field. If it is missing, the value keeps its default.
#define TELEPALP_READ(check, prefix, message, field, into, ...) \
  if ((message).has_##field()) (check).number(prefix #field, (message).field(), Range __VA_ARGS__, into)

Eigen::Vector3d read_xyz(FieldCheck& check, std::string_view field, const msg::Vec3& xyz, const Range& range) {
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  const std::string name(field);
  check.number(name + ".x", xyz.x(), range, out.x());
  check.number(name + ".y", xyz.y(), range, out.y());
  check.number(name + ".z", xyz.z(), range, out.z());
  return out;
}

Eigen::Isometry3d read_transform(FieldCheck& check, const std::string& field, const msg::RigidTransform& message) {
  const Eigen::Vector3d translation_m =
      read_xyz(check, field + ".translation_m", message.translation_m(), {-10, 10, "m"});
  const Eigen::Vector3d turn =
      read_xyz(check, field + ".rotation_vector_rad", message.rotation_vector_rad(), {-6.3, 6.3, "rad"});
  return isometry_of(turn, translation_m);
}

std::string tissue_names() {
  std::string names;
  for (const effects::TissuePreset& preset : effects::kTissuePresets)
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  return names;
}

/// Reads a law that replaces S1's: a linear spring, a curve, or the curve of a tissue.
void read_tissue(FieldCheck& check, const msg::SkinEffect& message, effects::SkinLaw& law) {
  if (int{message.has_linear_stiffness_n_per_m()} + int{message.has_tissue()} + int{message.has_measured()} > 1)
    check.complain("skin gives more than one of linear_stiffness_N_per_m, tissue and measured", "give one of them");
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
  else
    law = preset->law;
}

effects::Skin::Settings read_skin_settings(FieldCheck& check, const msg::SkinEffect& message) {
  effects::Skin::Settings skin;
  double stiffness = 160.0;
  double at_m = 0.06;
  TELEPALP_READ(check, "skin.", message, stiffness_n_per_m, stiffness, {1, 5000, "N/m"});
  TELEPALP_READ(check, "skin.", message, at_indentation_m, at_m, {0.001, 0.2, "m"});
  double alpha = effects::alpha_for(stiffness, at_m);
  if (message.has_alpha_n_per_m2()) {
    if (message.has_stiffness_n_per_m() || message.has_at_indentation_m())
      check.complain("skin gives both alpha_N_per_m2 and a stiffness", "give one of the two");
    TELEPALP_READ(check, "skin.", message, alpha_n_per_m2, alpha, {1, 1e6, "N/m^2"});
  }
  skin.law = effects::paper_law(alpha);
  read_tissue(check, message, skin.law);
  skin.law.by_axis = message.stiffness_by_axis();
  if (message.anchor() == msg::SkinEffect::ANCHOR_FIXED) skin.anchor = effects::SkinAnchor::Fixed;
  if (message.anchor() == msg::SkinEffect::ANCHOR_SLIDING) skin.anchor = effects::SkinAnchor::Sliding;
  return skin;
}

effects::InnerCylinder read_cylinder(FieldCheck& check, const msg::CylinderEffect& message) {
  effects::InnerCylinder::Settings cylinder;
  cylinder.top_center.m = read_xyz(check, "cylinder.top_center_m", message.top_center_m(), {-1, 1, "m"});
  TELEPALP_READ(check, "cylinder.", message, radius_m, cylinder.radius_m, {0.001, 0.3, "m"});
  TELEPALP_READ(check, "cylinder.", message, height_m, cylinder.height_m, {0.001, 0.5, "m"});
  TELEPALP_READ(check, "cylinder.", message, stiffness_n_per_m, cylinder.stiffness_N_per_m, {0, 5000, "N/m"});
  TELEPALP_READ(check, "cylinder.", message, around_m, cylinder.around_m, {0, 0.1, "m"});
  return effects::InnerCylinder(cylinder);
}

effects::InnerSphere read_sphere(FieldCheck& check, const msg::SphereEffect& message) {
  effects::InnerSphere::Settings sphere;
  sphere.center.m = read_xyz(check, "sphere.center_m", message.center_m(), {-1, 1, "m"});
  TELEPALP_READ(check, "sphere.", message, radius_m, sphere.radius_m, {0.001, 0.3, "m"});
  TELEPALP_READ(check, "sphere.", message, stiffness_n_per_m, sphere.stiffness_N_per_m, {0, 5000, "N/m"});
  TELEPALP_READ(check, "sphere.", message, around_m, sphere.around_m, {0, 0.1, "m"});
  return effects::InnerSphere(sphere);
}

/// The load is the force of the first skin in the scene, at any position in the file.
effects::Friction read_friction(FieldCheck& check, const msg::FrictionEffect& message, const msg::Scene& scene) {
  effects::Friction::Settings friction;
  TELEPALP_READ(check, "friction.", message, coefficient, friction.coefficient, {0, 3, ""});
  TELEPALP_READ(check, "friction.", message, bristle_stiffness_n_per_m, friction.bristle_stiffness_N_per_m,
                {10, 3000, "N/m"});
  const auto skin = std::ranges::find_if(scene.effects(), [](const msg::Effect& effect) { return effect.has_skin(); });
  if (skin == scene.effects().end())
    check.complain("friction needs a skin effect", "add effects { skin { anchor: ANCHOR_SLIDING } }");
  else
    friction.load = read_skin_settings(check, skin->skin()).law;
  return effects::Friction(friction);
}

effects::StiffRegions read_regions(FieldCheck& check, const msg::RegionsEffect& message) {
  effects::StiffRegions regions;
  if (message.region().empty()) check.complain("regions names no region", "add region { center_m { x: 0 z: 0 } }");
  for (const msg::RegionsEffect::Region& given : message.region()) {
    effects::StiffRegion region;
    region.center.m = read_xyz(check, "region.center_m", given.center_m(), {-1, 1, "m"});
    TELEPALP_READ(check, "region.", given, radius_m, region.radius_m, {0, 0.3, "m"});
    TELEPALP_READ(check, "region.", given, fade_m, region.fade_m, {0.001, 0.3, "m"});
    TELEPALP_READ(check, "region.", given, added_n_per_m, region.added_N_per_m, {0, 3000, "N/m"});
    if (!regions.add(region))
      check.complain("regions names more than " + std::to_string(effects::StiffRegions::kMostRegions) + " regions",
                     "leave some out, or add a second effect");
  }
  return regions;
}

/// The mesh file is read only when the numbers of the message are valid.
effects::Organ read_organ(FieldCheck& check, const msg::OrganEffect& message, const std::filesystem::path& folder) {
  organs::OrganShapeSettings shape;
  effects::Organ::Settings organ;
  TELEPALP_READ(check, "organ.", message, unit_m, shape.unit_m, {1e-6, 1000, "m"});
  TELEPALP_READ(check, "organ.", message, stiffness_n_per_m, organ.stiffness_N_per_m, {0, 5000, "N/m"});
  TELEPALP_READ(check, "organ.", message, around_m, organ.around_m, {0, 0.1, "m"});
  TELEPALP_READ(check, "organ.", message, cell_m, shape.cell_m, {0.001, 0.02, "m"});
  shape.haptic_from_model = read_transform(check, "organ.haptic_from_model", message.haptic_from_model());
  shape.margin_m = organ.around_m + 3.0 * shape.cell_m;
  if (message.file().empty()) check.complain("organ.file is empty", "name a closed mesh, .ply or .obj");
  if (check.error()) return effects::Organ(organ);
  const auto read = organs::read_organ_shape(folder / message.file(), shape);
  if (!read) {
    check.fail(read.error());
    return effects::Organ(organ);
  }
  organ.shape = *read;
  return effects::Organ(organ);
}

bool add_layer(const effects::Solid& layer, Scene& scene) {
  if (layer.layer()) scene.layers.push_back({layer.layer(), static_cast<std::uint32_t>(scene.effects.size())});
  return scene.effects.add(layer);
}

void read_effects(FieldCheck& check, const msg::Scene& message, const std::filesystem::path& folder, Scene& scene) {
  effects::EffectBank& bank = scene.effects;
  if (message.effects().empty()) check.complain("names no effect", "add at least effects { skin {} }");
  for (const msg::Effect& effect : message.effects()) {
    bool room = true;
    if (effect.has_skin())
      room = bank.add(effects::Skin(read_skin_settings(check, effect.skin())));
    else if (effect.has_cylinder())
      room = bank.add(read_cylinder(check, effect.cylinder()));
    else if (effect.has_sphere())
      room = bank.add(read_sphere(check, effect.sphere()));
    else if (effect.has_friction())
      room = bank.add(read_friction(check, effect.friction(), message));
    else if (effect.has_regions())
      room = bank.add(read_regions(check, effect.regions()));
    else if (effect.has_organ())
      room = bank.add(read_organ(check, effect.organ(), folder));
    else if (effect.has_solid())
      room = add_layer(read_layer(check, effect.solid(), folder), scene);
    else
      check.complain("an effect without a kind", "name it, as in effects { skin {} }");
    if (!room)
      check.complain("more than " + std::to_string(effects::EffectBank::kMostEffects) + " effects", "name fewer");
  }
}

void read_plane_and_transitions(FieldCheck& check, const msg::Scene& message, control::ControlSettings& control) {
  const msg::Plane& plane = message.plane();
  TELEPALP_READ(check, "plane.", plane, height_m, control.plane.height_m, {-0.5, 0.5, "m"});
  TELEPALP_READ(check, "plane.", plane, clearance_m, control.plane.clearance_m, {0.002, 0.3, "m"});
  TELEPALP_READ(check, "plane.", plane, offset_m, control.plane.offset_m, {0, 0.02, "m"});
  TELEPALP_READ(check, "plane.", plane, speed_m_per_s, control.plane.speed_m_per_s, {0, 1, "m/s"});
  const msg::Transitions& change = message.transitions();
  TELEPALP_READ(check, "transitions.", change, dwell_s, control.transitions.dwell_s, {0, 5, "s"});
  TELEPALP_READ(check, "transitions.", change, offset_fade_s, control.transitions.offset_fade_s, {0.02, 5, "s"});
  TELEPALP_READ(check, "transitions.", change, hand_rose_m, control.transitions.hand_rose_m, {0.005, 0.3, "m"});
  TELEPALP_READ(check, "transitions.", change, force_fade_n_per_s, control.transitions.force_fade_N_per_s,
                {1, 1000, "N/s"});
}

void read_position_control(FieldCheck& check, const msg::PositionControl& message,
                           control::PositionControlSettings& position) {
  TELEPALP_READ(check, "position_control.", message, stiffness_n_per_m, position.stiffness_N_per_m, {1, 5000, "N/m"});
  TELEPALP_READ(check, "position_control.", message, damping_n_s_per_m, position.damping_N_s_per_m, {0, 100, "N s/m"});
  TELEPALP_READ(check, "position_control.", message, most_n, position.most_N, {0.1, 10, "N"});
  TELEPALP_READ(check, "position_control.", message, fastest_m_per_s, position.fastest_m_per_s, {0.01, 3, "m/s"});
  TELEPALP_READ(check, "position_control.", message, lift_speed_m_per_s, position.lift_speed_m_per_s,
                {0.005, 0.5, "m/s"});
  TELEPALP_READ(check, "position_control.", message, lift_damping_n_s_per_m, position.lift_damping_N_s_per_m,
                {0.1, 100, "N s/m"});
  TELEPALP_READ(check, "position_control.", message, lift_most_n, position.lift_most_N, {0.1, 5, "N"});
}

void read_limits(FieldCheck& check, const msg::Scene& message, control::ControlSettings& control) {
  const msg::AgeLimit& age = message.age_limits();
  TELEPALP_READ(check, "age_limits.", age, tracker_s, control.ages.tracker_s, {0.01, 10, "s"});
  TELEPALP_READ(check, "age_limits.", age, tracker_in_contact_s, control.ages.tracker_in_contact_s, {0.01, 10, "s"});
  TELEPALP_READ(check, "age_limits.", age, surface_s, control.ages.surface_s, {0.01, 10, "s"});
  TELEPALP_READ(check, "age_limits.", age, device_s, control.ages.device_s, {0.001, 1, "s"});
  const msg::ForceLimit& limit = message.limits();
  TELEPALP_READ(check, "limits.", limit, peak_n, control.limits.peak_N, {0, 10, "N"});
  TELEPALP_READ(check, "limits.", limit, continuous_n, control.limits.continuous_N, {0, 10, "N"});
  TELEPALP_READ(check, "limits.", limit, thermal_time_s, control.limits.thermal_time_s, {0.1, 600, "s"});
  TELEPALP_READ(check, "limits.", limit, slew_n_per_s, control.limits.slew_N_per_s, {10, 5000, "N/s"});
  if (control.limits.continuous_N > control.limits.peak_N)
    check.complain("limits.continuous_N is above limits.peak_N", "give a peak at least as large");
}

void read_workspace(FieldCheck& check, const msg::Scene& message, control::IndexingSettings& indexing) {
  indexing.on = message.has_workspace();
  const msg::Workspace& workspace = message.workspace();
  TELEPALP_READ(check, "workspace.", workspace, touch_radius_m, indexing.touch_radius_m, {0.01, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, center_x_m, indexing.center_x_m, {-1, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, center_z_m, indexing.center_z_m, {-1, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, recall_n_per_m, indexing.recall_N_per_m, {1, 1000, "N/m"});
  TELEPALP_READ(check, "workspace.", workspace, recall_most_n, indexing.recall_most_N, {0.1, 5, "N"});
  TELEPALP_READ(check, "workspace.", workspace, shift_m_per_s_per_n, indexing.shift_m_per_s_per_N, {0, 0.5, "m/s/N"});
  TELEPALP_READ(check, "workspace.", workspace, most_shift_x_m, indexing.most_shift_x_m, {0, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, most_shift_z_m, indexing.most_shift_z_m, {0, 1, "m"});
}

void read_probe(FieldCheck& check, const msg::Scene& message, Scene& scene) {
  if (!message.has_probe()) return;
  Probe& probe = scene.probe.emplace();
  TELEPALP_READ(check, "probe.", message.probe(), width_m, probe.width_m, {0.01, 0.3, "m"});
  TELEPALP_READ(check, "probe.", message.probe(), depth_m, probe.depth_m, {0.01, 0.3, "m"});
}

void read_simulation(FieldCheck& check, const msg::Scene& message, const std::filesystem::path& folder, Scene& scene) {
  const msg::SimulatedDevice& device = message.simulated_device();
  TELEPALP_READ(check, "simulated_device.", device, mass_kg, scene.simulated_device.mass_kg, {0.01, 10, "kg"});
  TELEPALP_READ(check, "simulated_device.", device, damping_n_s_per_m, scene.simulated_device.damping_N_s_per_m,
                {0, 100, "N s/m"});
  TELEPALP_READ(check, "simulated_device.", device, encoder_step_m, scene.simulated_device.encoder_step_m,
                {0, 0.001, "m"});
  TELEPALP_READ(check, "simulated_device.", device, peak_n, scene.simulated_device.peak_N, {0.1, 50, "N"});
  scene.control.coupling.device_damping_N_s_per_m = scene.simulated_device.damping_N_s_per_m;
  const msg::HandIntention& hand = message.hand();
  TELEPALP_READ(check, "hand.", hand, arm_stiffness_n_per_m, scene.simulated_hand.stiffness_N_per_m, {1, 5000, "N/m"});
  TELEPALP_READ(check, "hand.", hand, arm_damping_n_s_per_m, scene.simulated_hand.damping_N_s_per_m, {0, 200, "N s/m"});
  TELEPALP_READ(check, "hand.", hand, hand_mass_kg, scene.simulated_hand.mass_kg, {0.05, 10, "kg"});
  if (hand.trial() >= msg::HandIntention::TRIAL_INDENT_SEVERAL_POINTS)
    scene.trial = static_cast<device::Trial>(hand.trial() - msg::HandIntention::TRIAL_INDENT_SEVERAL_POINTS);
  if (!hand.has_trace()) return;
  if (hand.trace().file().empty()) check.complain("hand.trace.file is empty", "name a CSV file");
  scene.hand_trace = folder / hand.trace().file();
  TELEPALP_READ(check, "hand.trace.", hand.trace(), deepest_m, scene.trace_deepest_m, {0, 0.2, "m"});
}

#undef TELEPALP_READ

}  // namespace

Result<Scene> make_scene(const msg::Scene& message, const std::filesystem::path& name,
                         const program::NumberPlaces& places) {
  FieldCheck check(name.string(), places);
  Scene scene;
  scene.message = message;
  scene.name = message.name().empty() ? name.stem().string() : message.name();
  if (!message.has_haptic_from_camera())
    check.complain("haptic_from_camera is missing", "copy it from palpation.scene.textproto");
  scene.haptic_from_camera.iso = read_transform(check, "haptic_from_camera", message.haptic_from_camera());
  scene.center_on_surface = message.center_on_surface();
  scene.haptic_from_tracker.iso.linear() =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();  // S1 eq. (4)
  if (message.has_haptic_from_tracker())
    scene.haptic_from_tracker.iso = read_transform(check, "haptic_from_tracker", message.haptic_from_tracker());
  read_effects(check, message, name.parent_path(), scene);
  read_plane_and_transitions(check, message, scene.control);
  read_position_control(check, message.position_control(), scene.control.position);
  read_limits(check, message, scene.control);
  read_workspace(check, message, scene.control.indexing);
  read_probe(check, message, scene);
  read_simulation(check, message, name.parent_path(), scene);
  if (check.error()) return *check.error();
  return scene;
}

Result<Scene> parse_scene(const std::string& text, const std::filesystem::path& name) {
  msg::Scene message;
  const Result<program::NumberPlaces> parsed = program::parse_text_format(text, name.string(), message);
  if (!parsed) return parsed.error();
  return make_scene(message, name, *parsed);
}

std::vector<std::shared_ptr<const effects::SolidLayer>> Scene::solids() const {
  std::vector<std::shared_ptr<const effects::SolidLayer>> solids;
  for (const SceneLayer& layer : layers) solids.push_back(layer.solid);
  return solids;
}

Result<std::filesystem::path> find_scene(const std::string& scene) {
  std::error_code failed;
  if (std::filesystem::exists(scene, failed)) return std::filesystem::path(scene);
  if (scene.find('/') == std::string::npos)
    if (const auto shipped = program::shipped_file("haptic_station/scenes/" + scene + ".scene.textproto"))
      return *shipped;
  return Error{.what = "is neither a file nor a scene that ships",
               .where = scene,
               .fix = "give a *.scene.textproto, or a name such as skin or palpation"};
}

Result<Scene> read_scene(const std::filesystem::path& file) {
  msg::Scene message;
  const Result<program::NumberPlaces> read = program::read_text_format(file, message);
  if (!read) return read.error();
  return make_scene(message, file, *read);
}

}  // namespace telepalp::scenes
