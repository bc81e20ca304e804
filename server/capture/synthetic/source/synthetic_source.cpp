#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "server/capture/pacing/frame_pacer.h"
#include "server/capture/sources.h"
#include "server/capture/synthetic/source/patient_model.h"
#include "server/capture/synthetic/source/synthetic_spec.h"

namespace telepalp::capture {
namespace {

/// Exposure at a gain of 1 that gives the picture as it is painted. With the automatic exposure it is that one, too:
/// the synthetic light never changes.
constexpr double kAsPainted_ms = 10.0;
constexpr Exposure kAutomatic{.automatic = true, .exposure = kAsPainted_ms, .gain = 1.0};
const ExposureLimits kLimits{.unit = "ms", .least = 0.5, .most = 33.0, .least_gain = 0.25, .most_gain = 16.0};

/// `color` under `times` as much light; what is brighter than the sensor can state is clipped.
void expose(ColorImage& color, double times) {
  std::array<std::uint8_t, 256> exposed{};
  for (std::size_t value = 0; value < exposed.size(); ++value)
    exposed[value] = static_cast<std::uint8_t>(std::lround(std::min(255.0, times * static_cast<double>(value))));
  for (std::uint8_t& value : color.rgb) value = exposed[value];
}

/// The synthetic patient as a camera at 30 Hz.
class SyntheticSource final : public CaptureSource {
 public:
  SyntheticSource(NamedPatient named, const SourceOptions& options)
      : named_(std::move(named)), pacer_(options.clock, kSyntheticPeriod, options.paced) {}

  std::optional<RgbdFrame> next(Nanoseconds patience) override {
    const std::optional<FrameSlot> slot = pacer_.next(patience);
    if (!slot) return std::nullopt;
    state_ = CaptureState::Live;
    RgbdFrame frame = named_.patient.frame_at(slot->due, sequence_++);
    if (!exposure_.automatic) expose(frame.color, exposure_.exposure * exposure_.gain / kAsPainted_ms);
    return frame;
  }
  CaptureState state() const override { return state_; }
  std::optional<ExposureLimits> exposure_limits() const override { return kLimits; }
  Exposure exposure() const override { return exposure_; }
  Result<void> set_exposure(const Exposure& exposure) override {
    exposure_ = exposure.automatic ? kAutomatic : exposure;
    return {};
  }
  std::string detail() const override { return "synthetic patient from " + named_.model + ", 30 Hz"; }

 private:
  NamedPatient named_;
  FramePacer pacer_;
  CaptureState state_ = CaptureState::Waiting;
  std::uint64_t sequence_ = 0;
  Exposure exposure_ = kAutomatic;
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
