#include "haptic_station/scenes/scene_warnings.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/scenes/inside_search.h"
#include "haptic_station/scenes/scene_objects.h"

namespace telepalp::scenes {
namespace {

using Eigen::Vector3d;
using solids::Box;

constexpr double kHuge_m = 2.0;  // longer than a patient
constexpr double kFar_m = 1.0;   // from the origin: beyond the reach of workspace indexing
constexpr double kDeep_m = 0.2;  // below the skin: no hand presses so far
constexpr double kAbove_m = 0.002;
constexpr double kSoft_N_per_m = 10.0;  // 1 N of force would need 0.1 m of depth

/// The message of the effect's kind, for its place in the file.
const google::protobuf::Message& message_of_kind(const msg::Effect& effect) {
  switch (effect.kind_case()) {
    case msg::Effect::kCylinder:
      return effect.cylinder();
    case msg::Effect::kSphere:
      return effect.sphere();
    case msg::Effect::kOrgan:
      return effect.organ();
    case msg::Effect::kSolid:
      return effect.solid();
    default:
      return effect;
  }
}

std::string millimetres(double m) { return number_text(std::round(1e4 * m) / 10.0) + " mm"; }

/// Warnings about one object inside the body.
class ObjectWarnings {
 public:
  ObjectWarnings(FieldCheck& check, const Scene& scene, const msg::Effect& effect, const SceneObject& object)
      : check_(check), scene_(scene), effect_(effect), object_(object), box_(object.tree->box()) {}

  void warn() {
    if (is_huge() || is_empty() || is_far()) return;  // what else is wrong follows from it
    if (scene_.center_on_surface) about_the_skin();
  }

 private:
  bool is_huge() {
    if (!box_.bounded()) return false;
    const double longest_m = (box_.high - box_.low).maxCoeff();
    if (longest_m <= kHuge_m) return false;
    complain("is " + number_text(std::round(10.0 * longest_m) / 10.0) + " m long",
             "give lengths in metres, as in sphere 0.01 for a radius of 10 mm, or put sc 0.001 before a solid in "
             "millimetres");
    return true;
  }

  bool is_empty() {
    if (!box_.bounded() || find_inside(*object_.tree, box_) != Search::NothingInside) return false;
    complain("is empty: it encloses no volume",
             "check its intersections, differences and clips: their operands may not meet");
    return true;
  }

  bool is_far() {
    const double away_m = std::sqrt(box_.squared_distance_m2(Vector3d::Zero()));
    if (away_m <= kFar_m) return false;
    complain("is " + number_text(std::round(10.0 * away_m) / 10.0) + " m from the origin, which no hand reaches",
             "move it to within " + number_text(kFar_m) + " m of the origin" +
                 (scene_.center_on_surface ? ", which is on the skin" : ""));
    return true;
  }

  /// H's origin is on the skin, and y points out of the body.
  void about_the_skin() {
    if (box_.low.y() >= 0.0)
      return complain("lies above the skin, in the air", "give a negative y: y points out of the body");
    if (-box_.high.y() > kDeep_m)
      return complain("begins " + millimetres(-box_.high.y()) + " below the skin, deeper than a hand presses",
                      "give its top a y between " + number_text(-kDeep_m) + " and 0");
    if (solid_at(*object_.tree, Vector3d::Zero()).m < 0.0)
      return complain("contains the origin, the point of the skin above which the hand starts",
                      "move it below the skin, or turn round the normal of its plane");
    Box above = box_;
    above.low.y() = kAbove_m;
    if (above.bounded() && above.high.y() > kAbove_m && find_inside(*object_.tree, above) == Search::Inside)
      complain("rises more than " + millimetres(kAbove_m) + " above the skin's height at the origin",
               "lower it: y points out of the body, and the skin is at y = 0");
  }

  void complain(const std::string& what, std::string fix) {
    check_.in(message_of_kind(effect_));
    check_.warn((effect_.has_solid() ? "layer " : "") + object_.name + " " + what, std::move(fix), check_.place());
  }

  FieldCheck& check_;
  const Scene& scene_;
  const msg::Effect& effect_;
  const SceneObject& object_;
  const Box& box_;
};

void warn_about_stiffness(FieldCheck& check, const google::protobuf::Message& part, const std::string& name, bool given,
                          double stiffness_N_per_m) {
  if (!given || stiffness_N_per_m >= kSoft_N_per_m) return;
  check.in(part);
  check.warn(name + " has a stiffness of " + number_text(stiffness_N_per_m) + " N/m, which no hand feels",
             "give N/m: 1 N/mm is 1000 N/m",
             check.places().where(check.file(), part, "stiffness_N_per_m", stiffness_N_per_m));
}

void warn_about_stiffnesses(FieldCheck& check, const msg::Effect& effect) {
  const auto warn = [&](const auto& part, const std::string& name) {
    warn_about_stiffness(check, part, name, part.has_stiffness_n_per_m(), part.stiffness_n_per_m());
  };
  if (effect.has_cylinder()) warn(effect.cylinder(), "cylinder");
  if (effect.has_sphere()) warn(effect.sphere(), "sphere");
  if (effect.has_organ()) warn(effect.organ(), "organ");
  if (effect.has_solid()) warn(effect.solid(), "layer " + effect.solid().name());
}

/// The layer's shape and place as text; equal texts are equal solids.
std::string shape_of(const msg::SolidEffect& layer) {
  return layer.polish() + '\n' + layer.polish_file() + '\n' + layer.solid().SerializeAsString() + '\n' +
         layer.haptic_from_solid().SerializeAsString();
}

void warn_about_copies(FieldCheck& check, const msg::Scene& message) {
  for (int i = 0; i < message.effects_size(); ++i)
    for (int j = 0; j < i; ++j) {
      const msg::SolidEffect& one = message.effects(j).solid();
      const msg::SolidEffect& other = message.effects(i).solid();
      if (!message.effects(i).has_solid() || !message.effects(j).has_solid() || shape_of(one) != shape_of(other))
        continue;
      check.in(other);
      check.warn("layer " + other.name() + " has the shape and place of layer " + one.name() + "; their forces add up",
                 "remove one of them, or move it", check.place());
    }
}

void warn_about_camera(FieldCheck& check, const msg::Scene& message, const Scene& scene) {
  if (message.patient_surface().has_static_model() || !message.has_haptic_from_camera()) return;
  const Vector3d axis = scene.haptic_from_camera.iso.linear() * Vector3d::UnitZ();
  constexpr double kDown = -0.3;
  if (axis.y() < kDown) return;
  check.in(message.haptic_from_camera());
  check.warn("the camera does not look down on the patient: its axis is (" +
                 number_text(std::round(100.0 * axis.x()) / 100.0) + ", " +
                 number_text(std::round(100.0 * axis.y()) / 100.0) + ", " +
                 number_text(std::round(100.0 * axis.z()) / 100.0) +
                 ") in the haptic base's frame, whose y points out of the body",
             "for a camera 0.8 m above the patient that looks straight down, give translation_m { y: 0.8 } "
             "rotation_vector_rad { x: 1.5708 }",
             check.place());
}

void warn_about_friction(FieldCheck& check, const msg::Scene& message) {
  const auto& effects = message.effects();
  const auto friction = std::ranges::find_if(effects, [](const msg::Effect& one) { return one.has_friction(); });
  const bool slides = std::ranges::any_of(
      effects, [](const msg::Effect& one) { return one.skin().anchor() == msg::SkinEffect::ANCHOR_SLIDING; });
  if (friction == effects.end() || slides) return;
  check.in(friction->friction());
  check.warn("friction acts on a hand that slides, and the scene's skin holds the hand where it touched",
             "give the skin anchor: ANCHOR_SLIDING", check.place());
}

}  // namespace

void warn_about_scene(FieldCheck& check, const msg::Scene& message, const Scene& scene) {
  for (const SceneObject& object : objects_of(scene)) {
    const msg::Effect& effect = message.effects(static_cast<int>(object.effect));
    if (!effect.has_regions()) ObjectWarnings(check, scene, effect, object).warn();
  }
  for (const msg::Effect& effect : message.effects()) warn_about_stiffnesses(check, effect);
  warn_about_copies(check, message);
  warn_about_camera(check, message, scene);
  warn_about_friction(check, message);
}

}  // namespace telepalp::scenes
