#include "server/capture/synthetic/source/patient_model.h"

#include "server/capture/synthetic/source/synthetic_spec.h"
#include "support/program/files/shipped.h"

namespace telepalp::capture {
namespace {

constexpr const char* kShippedTorso = "deploy/demo_data/torso/visible_human_torso.ply";

Result<std::filesystem::path> file_of(const std::string& model) {
  if (model != "torso") return std::filesystem::path{model};
  if (const auto file = program::shipped_file(kShippedTorso)) return *file;
  return Error{
      .what =
          "the synthetic torso is missing: it is not below TELEPALP_HOME or, if TELEPALP_HOME is not set, in the "
          "program's folder and those above",
      .where = kShippedTorso,
      .fix = "keep the program in its build or installation folder, or set TELEPALP_HOME to the repository's folder"};
}

}  // namespace

Result<TriangleMesh> shipped_torso() {
  const Result<std::filesystem::path> file = file_of("torso");
  if (!file) return file.error();
  return read_mesh(*file);
}

Result<NamedPatient> open_patient(const std::string& text) {
  const Result<SyntheticSpec> spec = parse_synthetic_spec(text);
  if (!spec) return spec.error();
  const Result<std::filesystem::path> file = file_of(spec->model);
  if (!file) return file.error();
  const Result<TriangleMesh> mesh = read_mesh(*file);
  if (!mesh) return mesh.error();
  Result<SyntheticPatient> patient = SyntheticPatient::make(*mesh, spec->settings, file->string());
  if (!patient) return patient.error();
  return NamedPatient{std::move(*patient), file->filename().string()};
}

}  // namespace telepalp::capture
