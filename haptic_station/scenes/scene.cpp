#include "haptic_station/scenes/scene.h"

#include <numbers>

#include "haptic_station/scenes/field_check.h"
#include "haptic_station/scenes/read_effects.h"
#include "haptic_station/scenes/removed_fields.h"
#include "haptic_station/scenes/scene_warnings.h"
#include "support/program/files/shipped.h"
#include "support/program/text/text_format.h"

namespace telepalp::scenes {
namespace {

void read_plane_and_transitions(FieldCheck& check, const msg::Scene& message, control::ControlSettings& control) {
  const msg::Plane& plane = message.plane();
  TELEPALP_READ(check, "plane.", plane, height_m, control.plane.height_m, {-0.5, 0.5, "m"});
  TELEPALP_READ(check, "plane.", plane, clearance_m, control.plane.clearance_m, {0.002, 0.3, "m"});
  TELEPALP_READ(check, "plane.", plane, offset_m, control.plane.offset_m, {0, 0.02, "m"});
  TELEPALP_READ(check, "transitions.", message.transitions(), dwell_s, control.transitions.dwell_s, {0, 5, "s"});
}

void read_limits(FieldCheck& check, const msg::Scene& message, control::ControlSettings& control) {
  const msg::AgeLimit& age = message.age_limits();
  TELEPALP_READ(check, "age_limits.", age, tracker_s, control.ages.tracker_s, {0.01, 10, "s"});
  TELEPALP_READ(check, "age_limits.", age, surface_s, control.ages.surface_s, {0.01, 10, "s"});
  TELEPALP_READ(check, "age_limits.", age, device_s, control.ages.device_s, {0.001, 1, "s"});
  const msg::ForceLimit& limit = message.limits();
  TELEPALP_READ(check, "limits.", limit, peak_n, control.limits.peak_N, {0, 10, "N"});
  TELEPALP_READ(check, "limits.", limit, continuous_n, control.limits.continuous_N, {0, 10, "N"});
  TELEPALP_READ(check, "limits.", limit, thermal_time_s, control.limits.thermal_time_s, {0.1, 600, "s"});
  if (control.limits.continuous_N > control.limits.peak_N)
    check.in(limit).complain("limits.continuous_N, " + number_text(control.limits.continuous_N) +
                                 " N, is above limits.peak_N, " + number_text(control.limits.peak_N) + " N",
                             "give limits.peak_N at least the value of limits.continuous_N; a limit that the "
                             "scene does not give has its default");
}

void read_workspace(FieldCheck& check, const msg::Scene& message, control::IndexingSettings& indexing) {
  indexing.on = message.has_workspace();
  const msg::Workspace& workspace = message.workspace();
  TELEPALP_READ(check, "workspace.", workspace, touch_radius_m, indexing.touch_radius_m, {0.01, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, center_x_m, indexing.center_x_m, {-1, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, center_z_m, indexing.center_z_m, {-1, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, most_shift_x_m, indexing.most_shift_x_m, {0, 1, "m"});
  TELEPALP_READ(check, "workspace.", workspace, most_shift_z_m, indexing.most_shift_z_m, {0, 1, "m"});
}

void read_probe(FieldCheck& check, const msg::Scene& message, Scene& scene) {
  if (!message.has_probe()) return;
  Probe& probe = scene.probe.emplace();
  TELEPALP_READ(check, "probe.", message.probe(), width_m, probe.width_m, {0.01, 0.3, "m"});
  TELEPALP_READ(check, "probe.", message.probe(), depth_m, probe.depth_m, {0.01, 0.3, "m"});
}

/// A file that the station opens at its start, before it touches anything.
void check_file(FieldCheck& check, const std::string& field, const std::string& file,
                const std::filesystem::path& folder, const std::string& kind) {
  std::error_code code;
  if (file.empty()) return check.complain(field + " is empty", "name " + kind);
  (void)std::filesystem::file_size(folder / file, code);
  if (code)
    check.complain(field + ": " + (folder / file).string() + ": cannot be read: " + code.message(),
                   "give the path of " + kind + ", relative to the scene's folder");
}

void read_model(FieldCheck& check, const msg::PatientSurface& message, const std::filesystem::path& folder,
                Scene& scene) {
  if (!message.has_static_model()) return;
  const msg::PatientSurface::StaticModel& given = message.static_model();
  PatientModel& model = scene.model.emplace();
  check_file(check.in(given), "static_model.file", given.file(), folder, "a .ply, .obj or .pcd file");
  model.file = given.file();
  TELEPALP_READ(check, "static_model.", given, unit_m, model.unit_m, {1e-9, 1e6, "m"});
  if (given.has_samples()) model.samples = given.samples();
  model.haptic_from_model = read_transform(check, "static_model.haptic_from_model", given.haptic_from_model());
  model.flip_normals = given.flip_normals();
}

void read_hand(FieldCheck& check, const msg::HandIntention& hand, const std::filesystem::path& folder, Scene& scene) {
  if (hand.trial() >= msg::HandIntention::TRIAL_INDENT_SEVERAL_POINTS)
    scene.trial = static_cast<device::Trial>(hand.trial() - msg::HandIntention::TRIAL_INDENT_SEVERAL_POINTS);
  if (!hand.has_trace()) return;
  scene.hand_trace = folder / hand.trace().file();
  check_file(check.in(hand.trace()), "hand.trace.file", hand.trace().file(), folder, "a CSV file");
  TELEPALP_READ(check, "hand.trace.", hand.trace(), deepest_m, scene.trace_deepest_m, {0, 0.2, "m"});
}

/// Checks a message and converts it to plain values. `places`: positions in the file, for errors.
Result<Scene> make_scene(const msg::Scene& message, const std::filesystem::path& name,
                         const program::NumberPlaces& places, MeshDetail detail) {
  FieldCheck check(name.string(), places);
  Scene scene;
  scene.purpose = message.purpose();
  scene.surface = message.surface().name();
  scene.text = places.source();
  scene.name = message.name().empty() ? name.stem().string() : message.name();
  if (!message.has_haptic_from_camera())
    check.complain("haptic_from_camera, the pose of the camera in the haptic base's frame, is missing",
                   "for a camera 0.8 m above the patient that looks straight down, add haptic_from_camera { "
                   "translation_m { y: 0.8 } rotation_vector_rad { x: 1.5708 } }");
  scene.haptic_from_camera.iso = read_transform(check, "haptic_from_camera", message.haptic_from_camera());
  scene.center_on_surface = message.center_on_surface();
  read_model(check, message.patient_surface(), name.parent_path(), scene);
  scene.haptic_from_tracker.iso.linear() =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();  // S1 eq. (4)
  if (message.has_haptic_from_tracker())
    scene.haptic_from_tracker.iso = read_transform(check, "haptic_from_tracker", message.haptic_from_tracker());
  scene.effects = read_effects(check, message, name.parent_path(), detail);
  read_plane_and_transitions(check, message, scene.control);
  read_limits(check, message, scene.control);
  read_workspace(check, message, scene.control.indexing);
  read_probe(check, message, scene);
  read_hand(check, message.hand(), name.parent_path(), scene);
  if (check.error()) return *check.error();
  warn_about_scene(check, message, scene);
  scene.warnings = check.warnings();
  return scene;
}

}  // namespace

Result<Scene> parse_scene(const std::string& text, const std::filesystem::path& name, MeshDetail detail) {
  msg::Scene message;
  const Result<program::NumberPlaces> parsed = program::parse_text_format(text, name.string(), message);
  if (!parsed) return with_what_to_write_instead(parsed.error());
  return make_scene(message, name, *parsed, detail);
}

std::vector<SceneLayer> Scene::layers() const {
  std::vector<SceneLayer> layers;
  for (std::size_t i = 0; i < effects.size(); ++i)
    if (const auto* solid = std::get_if<effects::SolidSettings>(&effects[i]); solid != nullptr && solid->layer)
      layers.push_back({solid->layer, static_cast<std::uint32_t>(i)});
  return layers;
}

std::vector<std::shared_ptr<const effects::SolidLayer>> Scene::solids() const {
  std::vector<std::shared_ptr<const effects::SolidLayer>> solids;
  for (const SceneLayer& layer : layers()) solids.push_back(layer.solid);
  return solids;
}

const effects::SkinSettings* Scene::skin() const noexcept {
  for (const effects::Recipe& recipe : effects)
    if (const auto* skin = std::get_if<effects::SkinSettings>(&recipe)) return skin;
  return nullptr;
}

Result<std::filesystem::path> find_scene(const std::string& scene) {
  std::error_code failed;
  if (std::filesystem::exists(scene, failed)) return std::filesystem::path(scene);
  if (scene.find('/') == std::string::npos)
    if (const auto shipped = program::shipped_file("haptic_station/scenes/" + scene + ".scene.textproto"))
      return *shipped;
  return Error{
      .what = "is neither a file nor the name of one of telepalp's own scenes",
      .where = scene,
      .fix = "give a *.scene.textproto file, or the name of one of telepalp's own scenes, such as skin or palpation"};
}

Result<Scene> read_scene(const std::filesystem::path& file) {
  msg::Scene message;
  const Result<program::NumberPlaces> read = program::read_text_format(file, message);
  if (!read) return with_what_to_write_instead(read.error());
  return make_scene(message, file, *read, MeshDetail::AsGiven);
}

}  // namespace telepalp::scenes
