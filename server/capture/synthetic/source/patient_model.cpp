#include "server/capture/synthetic/source/patient_model.h"

#include "server/capture/synthetic/source/synthetic_spec.h"
#include "support/program/files/shipped.h"

namespace telepalp::capture {
namespace {

constexpr const char* kShippedTorso = "deploy/demo_data/torso/visible_human_torso.ply";

}  // namespace

Result<NamedPatient> open_patient(const std::string& text) {
  const Result<SyntheticSpec> spec = parse_synthetic_spec(text);
  if (!spec) return spec.error();
  const std::optional<std::filesystem::path> file =
      spec->model == "torso" ? program::shipped_file(kShippedTorso) : std::filesystem::path{spec->model};
  if (!file)
    return Error{.what = "is neither in the program's folder nor in a folder above it",
                 .where = kShippedTorso,
                 .fix = "run from the source tree or an installation, or set TELEPALP_HOME to one"};
  const Result<TriangleMesh> mesh = read_mesh(*file);
  if (!mesh) return mesh.error();
  Result<SyntheticPatient> patient = SyntheticPatient::make(*mesh, spec->settings, file->string());
  if (!patient) return patient.error();
  return NamedPatient{std::move(*patient), file->filename().string()};
}

}  // namespace telepalp::capture
