#include "haptic_station/scenes/layer.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "haptic_station/organs/organ_shape.h"
#include "haptic_station/scenes/layer_warnings.h"
#include "haptic_station/scenes/solid_text.h"
#include "haptic_station/solids/polish.h"

namespace telepalp::scenes {
namespace {

constexpr double kMeshMargin_m = 0.02;

solids::MeshReader mesh_reader(const std::filesystem::path& folder, MeshDetail detail) {
  return [folder, detail](const std::string& file, double unit_m, double given_m) {
    const double cell_m = cell_with(detail, given_m);
    return organs::read_organ_shape(folder / file,
                                    {.unit_m = unit_m, .cell_m = cell_m, .margin_m = kMeshMargin_m + 3.0 * cell_m});
  };
}

constexpr const char* kPolish = "polish";

/// Number of characters before a line and column, both from 1.
std::size_t offset_of(const std::string& text, int line, int column) {
  std::size_t start = 0;
  for (; line > 1; --line) start = std::min(text.find('\n', start), text.size() - 1) + 1;
  return start + static_cast<std::size_t>(std::max(column - 1, 0));
}

/// An error in the layer's Polish text, at its place in the scene's file.
Error in_scene(Error error, const msg::SolidEffect& message, const FieldCheck& check) {
  int line = 0;
  int column = 0;
  if (std::sscanf(error.where.c_str(), "polish:%d:%d", &line, &column) != 2) return error;
  const std::size_t offset = offset_of(message.polish(), line, column);
  const std::string place = check.places().where(check.file(), kPolish, message.polish(), offset);
  const bool known = place != check.file();  // a message that was not read from a text has no places
  error.where = known ? place : check.file() + ": " + error.where;
  return error;
}

Result<solids::Solid> polish_of(const msg::SolidEffect& message, const FieldCheck& check,
                                const solids::MeshReader& meshes) {
  const Result<solids::Solid> solid = solids::parse_polish(message.polish(), kPolish, meshes);
  if (!solid) return in_scene(solid.error(), message, check);
  return solid;
}

Result<solids::Solid> polish_file_of(const msg::SolidEffect& message, const FieldCheck& check,
                                     const std::filesystem::path& folder, const solids::MeshReader& meshes) {
  Result<solids::Solid> solid = solids::read_polish(folder / message.polish_file(), meshes);
  if (solid) return solid;
  Error unread = solid.error();
  unread.fix += "; " + check.places().where(check.file(), "polish_file", message.polish_file(), 0) + " names this file";
  return unread;
}

Result<solids::Solid> unnamed_tree_of(const msg::SolidEffect& message, const FieldCheck& check,
                                      const std::filesystem::path& folder, MeshDetail detail) {
  const solids::MeshReader meshes = mesh_reader(folder, detail);
  const auto where = [&](const google::protobuf::Message& part, std::string_view number, double value) {
    return number.empty() ? check.places().where(check.file(), part)
                          : check.places().where(check.file(), part, number, value);
  };
  switch (message.tree_case()) {
    case msg::SolidEffect::kPolish:
      return polish_of(message, check, meshes);
    case msg::SolidEffect::kPolishFile:
      return polish_file_of(message, check, folder, meshes);
    case msg::SolidEffect::kSolid:
      return solid_of(message.solid(), check.file(), meshes, where);
    case msg::SolidEffect::TREE_NOT_SET:
      break;
  }
  return Error{.what = "the layer has no solid",
               .where = check.place(),
               .fix = "give its shape by polish, polish_file or solid"};
}

/// The layer's tree. Its error names the layer.
Result<solids::Solid> tree_of(const msg::SolidEffect& message, const FieldCheck& check,
                              const std::filesystem::path& folder, MeshDetail detail) {
  Result<solids::Solid> solid = unnamed_tree_of(message, check, folder, detail);
  if (solid) return solid;
  Error error = solid.error();
  error.what = "layer " + message.name() + ": " + error.what;
  return error;
}

/// The solid, moved to its place in H.
solids::Solid placed(const msg::RigidTransform& place, solids::Solid solid) {
  const Eigen::Vector3d turn(place.rotation_vector_rad().x(), place.rotation_vector_rad().y(),
                             place.rotation_vector_rad().z());
  const double angle = turn.norm();
  const Eigen::Vector3d axis = angle > 0.0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  solids::Node node{.word = *solids::find_word("tx")};
  node.numbers = {place.translation_m().x(),
                  place.translation_m().y(),
                  place.translation_m().z(),
                  angle * 180.0 / std::numbers::pi,
                  axis.x(),
                  axis.y(),
                  axis.z()};
  solid.insert(solid.begin(), node);
  return solid;
}

effects::Echo read_echo(FieldCheck& check, const msg::SolidEffect::Echo& message) {
  effects::Echo echo;
  if (message.has_impedance_mrayl())
    check.number("solid.echo.impedance_MRayl", message.impedance_mrayl(), {0.1, 20, "MRayl"}, echo.impedance_MRayl);
  if (message.has_attenuation_db_per_cm())
    check.number("solid.echo.attenuation_dB_per_cm", message.attenuation_db_per_cm(), {0, 200, "dB/cm"},
                 echo.attenuation_dB_per_cm);
  if (message.has_scatter())
    check.number("solid.echo.scatter", message.scatter(), {0, 1, "parts of full brightness"}, echo.scatter);
  return echo;
}

void read_numbers(FieldCheck& check, const msg::SolidEffect& message, effects::SolidSettings& settings) {
  check.in(message);
  if (message.has_stiffness_n_per_m())
    check.number("solid.stiffness_N_per_m", message.stiffness_n_per_m(), {0, 5000, "N/m"}, settings.stiffness_N_per_m);
  if (message.has_tip_radius_m())
    check.number("solid.tip_radius_m", message.tip_radius_m(), {0, 0.02, "m"}, settings.tip_radius_m);
  if (message.has_pulse()) {
    double beats_per_min = 72.0;
    settings.pulse_m = 0.001;
    if (message.pulse().has_swell_m())
      check.number("solid.pulse.swell_m", message.pulse().swell_m(), {0, 0.01, "m"}, settings.pulse_m);
    if (message.pulse().has_beats_per_min())
      check.number("solid.pulse.beats_per_min", message.pulse().beats_per_min(), {10, 240, "1/min"}, beats_per_min);
    settings.pulses_per_s = beats_per_min / 60.0;
  }
}

}  // namespace

double cell_with(MeshDetail detail, double cell_m) noexcept {
  constexpr double kLeast_m = 0.001;
  return detail == MeshDetail::Finer ? std::max(kLeast_m, 0.5 * cell_m) : cell_m;
}

effects::SolidSettings read_layer(FieldCheck& check, const msg::SolidEffect& message,
                                  const std::filesystem::path& folder, MeshDetail detail) {
  effects::SolidSettings settings;
  read_numbers(check, message, settings);
  const effects::Echo echo = read_echo(check, message.echo());
  if (message.name().empty())
    check.complain("the layer has no name", "give the effect solid a name, as in name: \"ribs\"");
  if (check.error()) return settings;
  Result<solids::Solid> solid = tree_of(message, check, folder, detail);
  if (solid) warn_about_solid(check, message, *solid);
  if (solid && message.has_haptic_from_solid()) solid = placed(message.haptic_from_solid(), std::move(solid).value());
  const auto tree =
      solid ? solids::build_tree(*solid) : Result<std::shared_ptr<const solids::SolidTree>>(solid.error());
  if (!tree) {
    Error error = tree.error();
    if (solid) {  // an error of build_tree() names no place in the scene's file
      error.what = "layer " + message.name() + ": " + error.what;
      error.where = check.place();
    }
    check.fail(std::move(error));
    return settings;
  }
  settings.layer = std::make_shared<const effects::SolidLayer>(effects::SolidLayer{message.name(), *tree, echo});
  return settings;
}

}  // namespace telepalp::scenes
