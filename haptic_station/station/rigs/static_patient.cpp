#include "haptic_station/station/rigs/static_patient.h"

#include <algorithm>

#include "haptic_station/station/rigs/model_cache.h"
#include "haptic_station/surface/cloud/static_model.h"
#include "proto/words/numbers/quantile.h"
#include "support/models/text_cursor.h"
#include "support/program/log.h"

namespace telepalp::station {
namespace {

using Eigen::Vector3d;
using models::TextCursor;

constexpr std::string_view kModel = "model:";
constexpr double kBesideAxis_m = 0.015;

/// The highest point (H's y is up) near the vertical through the middle of `skin`, or the highest of all points if
/// none is near it.
Vector3d skin_on_top(const std::vector<SkinPoint>& skin) {
  std::vector<double> across;
  std::vector<double> along;
  for (const SkinPoint& point : skin) {
    across.push_back(point.at_m.x());
    along.push_back(point.at_m.z());
  }
  const double x = median_of(across);
  const double z = median_of(along);
  const auto higher = [&](const SkinPoint& a, const SkinPoint& b) {
    const bool a_near = std::hypot(a.at_m.x() - x, a.at_m.z() - z) < kBesideAxis_m;
    const bool b_near = std::hypot(b.at_m.x() - x, b.at_m.z() - z) < kBesideAxis_m;
    return a_near != b_near ? b_near : a.at_m.y() < b.at_m.y();
  };
  return std::max_element(skin.begin(), skin.end(), higher)->at_m;
}

std::vector<SkinPoint> skin_of(const surface::CloudSnapshot& snapshot, const Eigen::Isometry3d& haptic_from_model) {
  std::vector<SkinPoint> skin;
  for (const surface::CloudPoint& point : snapshot.cloud())
    skin.push_back({haptic_from_model * (snapshot.shape().origin_m + point.at_m.cast<double>()),
                    haptic_from_model.linear() * point.normal.cast<double>()});
  return skin;
}

}  // namespace

Result<StaticPatient> open_static_patient(const scenes::Scene& scene, const std::filesystem::path& folder,
                                          bool anyway) {
  const scenes::PatientModel& asked = *scene.model;
  const std::filesystem::path file = folder / asked.file;
  surface::StaticModelSettings settings;
  settings.unit_m = asked.unit_m;
  settings.samples = asked.samples.value_or(0);
  settings.flip_normals = asked.flip_normals;
  settings.anyway = anyway;
  settings.on_progress = [](const std::string& text) { program::log("telepalp-station", "model: " + text); };
  if (!(settings.unit_m > 0.0) || (settings.samples > 0 && settings.samples < 100) || settings.samples > 1'000'000)
    return Error{
        .what = "unit_m or samples of the patient model (static_model) is out of range",
        .where = scene.name,
        .fix =
            "give, in --surface or in the scene, unit_m above 0 (metres per unit of the file), and samples 0 (as "
            "many as the shape needs) or 100 to 1000000"};
  Result<surface::StaticModel> made = sampled_once(file, settings, ModelCache(default_model_cache()));
  if (!made) {
    Error error = made.error();
    error.where = file.string();
    return error;
  }
  const std::string between = made->remarks.empty() || made->sampling.empty() ? "" : "; ";
  StaticPatient patient{made->snapshot, {}, made->remarks + between + made->sampling, {}};
  patient.haptic_from_model.iso = asked.haptic_from_model;
  patient.skin = skin_of(*made->snapshot, patient.haptic_from_model.iso);
  if (!scene.center_on_surface) return patient;
  const Vector3d origin = skin_on_top(patient.skin);
  patient.haptic_from_model.iso.pretranslate(-origin);
  for (SkinPoint& point : patient.skin) point.at_m -= origin;
  return patient;
}

Result<void> ask_for_surface(const std::string& word, scenes::Scene& scene) {
  if (word.empty()) return {};
  if (!word.starts_with(kModel)) {
    scene.surface = word;
    return {};
  }
  if (!scene.model) scene.model.emplace();
  std::string_view rest = std::string_view(word).substr(kModel.size());
  const auto take = [&rest] {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view part = rest.substr(0, comma);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    return part;
  };
  scene.model->file = std::filesystem::absolute(take()).string();
  while (!rest.empty()) {
    const std::string_view part = take();
    const std::string_view value = part.substr(std::min(part.find('=') + 1, part.size()));
    const auto metres = TextCursor::number<double>(value);
    const auto count = TextCursor::number<std::uint32_t>(value);
    if (part.starts_with("unit_m=") && metres)
      scene.model->unit_m = *metres;
    else if (part.starts_with("samples=") && count)
      scene.model->samples = *count;
    else
      return Error{.what = "'" + std::string(part) + "' is not understood",
                   .where = "--surface",
                   .fix =
                       "write model:FILE,unit_m=0.001,samples=16000; unit_m: metres per unit of the file; samples: "
                       "number of points"};
  }
  return {};
}

}  // namespace telepalp::station
