#include <utility>

#include "server/capture/pacing/frame_pacer.h"
#include "server/capture/sources.h"
#include "server/capture/synthetic/source/synthetic_spec.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "support/program/files/shipped.h"

namespace telepalp::capture {
namespace {

constexpr Nanoseconds kPeriod{33'333'333};  // 30 Hz
constexpr const char* kShippedTorso = "deploy/demo_data/torso/visible_human_torso.ply";

/// The synthetic patient as a camera at 30 Hz.
class SyntheticSource final : public CaptureSource {
 public:
  SyntheticSource(SyntheticPatient patient, std::string model, const SourceOptions& options)
      : patient_(std::move(patient)), model_(std::move(model)), pacer_(options.clock, kPeriod, options.paced) {}

  std::optional<RgbdFrame> next(Nanoseconds patience) override {
    const std::optional<FrameSlot> slot = pacer_.next(patience);
    if (!slot) return std::nullopt;
    state_ = CaptureState::Live;
    return patient_.frame_at(slot->due, sequence_++);
  }
  CaptureState state() const override { return state_; }
  std::string detail() const override { return "synthetic patient from " + model_ + ", 30 Hz"; }

 private:
  SyntheticPatient patient_;
  std::string model_;
  FramePacer pacer_;
  CaptureState state_ = CaptureState::Waiting;
  std::uint64_t sequence_ = 0;
};

}  // namespace

Result<std::unique_ptr<CaptureSource>> open_synthetic(const std::string& model, const SourceOptions& options) {
  const Result<SyntheticSpec> spec = parse_synthetic_spec(model);
  if (!spec) return spec.error();
  const std::optional<std::filesystem::path> file =
      spec->model == "torso" ? program::shipped_file(kShippedTorso) : std::filesystem::path{spec->model};
  if (!file)
    return Error{.what = "does not lie in or above the program's folder",
                 .where = kShippedTorso,
                 .fix = "run from the source tree or an installation, or set TELEPALP_HOME to one"};
  const Result<TriangleMesh> mesh = read_mesh(*file);
  if (!mesh) return mesh.error();
  Result<SyntheticPatient> patient = SyntheticPatient::make(*mesh, spec->settings, file->string());
  if (!patient) return patient.error();
  return std::unique_ptr<CaptureSource>{
      std::make_unique<SyntheticSource>(std::move(*patient), file->filename().string(), options)};
}

}  // namespace telepalp::capture
