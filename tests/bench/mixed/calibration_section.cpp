#include "tests/bench/mixed/section.h"
#include "tests/clients/mixed/clicked_device.h"

namespace telepalp::bench {

std::vector<Row> run_calibration_section() {
  using namespace mixed;
  constexpr int kSeeds = 60;
  constexpr double kShare = 0.05;
  std::vector<Row> rows;
  const auto add = [&](const std::string& what, double m, double reach_mm) {
    const std::string name = "calibration at unclicked places, rms: " + what;
    rows.push_back(reach_mm > 0.0 ? at_most(name, m * 1e3, "mm", reach_mm) : measured(name, m * 1e3, "mm"));
  };
  const ElsewhereError eighty = elsewhere_error(16, 5, kShare, GimbalShape::WholeSine, GimbalFit::Fitted, kSeeds);
  add("80 clicks at 16 places, device (wrist point)", eighty.wrist_m, 0.3);
  add("80 clicks, tip", eighty.tip_m, 0.3);
  const ElsewhereError few = elsewhere_error(12, 3, kShare, GimbalShape::WholeSine, GimbalFit::Fitted, kSeeds);
  add("36 clicks at 12 places, device (wrist point)", few.wrist_m, 0.4);
  add("36 clicks, tip", few.tip_m, 0.4);
  const ElsewhereError cubic = elsewhere_error(16, 5, kShare, GimbalShape::Cubic, GimbalFit::Fitted, kSeeds);
  add("80 clicks, gimbal errs by a cubic, device", cubic.wrist_m, 0.0);
  add("80 clicks, gimbal errs by a cubic, tip", cubic.tip_m, 0.0);
  const ElsewhereError shifted = elsewhere_error(16, 5, kShare, GimbalShape::ShiftedSine, GimbalFit::Fitted, kSeeds);
  add("80 clicks, gimbal errs by a shifted sine, device", shifted.wrist_m, 0.0);
  add("80 clicks, gimbal errs by a shifted sine, tip", shifted.tip_m, 0.0);
  const ElsewhereError paper = elsewhere_error(16, 5, kShare, GimbalShape::WholeSine, GimbalFit::Ignored, kSeeds);
  add("80 clicks, gimbal believed, device", paper.wrist_m, 0.0);
  add("80 clicks, gimbal believed, tip", paper.tip_m, 0.0);
  return rows;
}

}  // namespace telepalp::bench
