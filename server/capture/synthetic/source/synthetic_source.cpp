#include <utility>

#include "server/capture/pacing/frame_pacer.h"
#include "server/capture/sources.h"
#include "server/capture/synthetic/source/patient_model.h"
#include "server/capture/synthetic/source/synthetic_spec.h"

namespace telepalp::capture {
namespace {

/// The synthetic patient as a camera at 30 Hz.
class SyntheticSource final : public CaptureSource {
 public:
  SyntheticSource(NamedPatient named, const SourceOptions& options)
      : named_(std::move(named)), pacer_(options.clock, kSyntheticPeriod, options.paced) {}

  std::optional<RgbdFrame> next(Nanoseconds patience) override {
    const std::optional<FrameSlot> slot = pacer_.next(patience);
    if (!slot) return std::nullopt;
    state_ = CaptureState::Live;
    return named_.patient.frame_at(slot->due, sequence_++);
  }
  CaptureState state() const override { return state_; }
  std::string detail() const override { return "synthetic patient from " + named_.model + ", 30 Hz"; }

 private:
  NamedPatient named_;
  FramePacer pacer_;
  CaptureState state_ = CaptureState::Waiting;
  std::uint64_t sequence_ = 0;
};

}  // namespace

Result<void> check_synthetic(const std::string& model) {
  if (const Result<SyntheticSpec> spec = parse_synthetic_spec(model); !spec) return spec.error();
  return {};
}

Result<std::unique_ptr<CaptureSource>> open_synthetic(const std::string& model, const SourceOptions& options) {
  Result<NamedPatient> named = open_patient(model);
  if (!named) return named.error();
  return std::unique_ptr<CaptureSource>{std::make_unique<SyntheticSource>(std::move(*named), options)};
}

}  // namespace telepalp::capture
