#include <cmath>
#include <numbers>

#include "support/program/parallel.h"
#include "tests/bench/mixed/section.h"
#include "tests/clients/mixed/desk_truth.h"

namespace telepalp::bench {
namespace {

using namespace mixed;

const PoseNoise kBoardNoise{0.2e-3 / std::numbers::sqrt3, 0.03 * std::numbers::pi / 180.0 / std::numbers::sqrt3};
constexpr int kRing_px = 12;

struct Figures {
  double psnr_db = 0.0, ssim = 0.0, step = 0.0, hard_step = 0.0;
};

/// Means over views of the doctor. The pose of each view errs with the noise that the background's images have.
Figures figures_of(const Background& desk, bool printed, int cameras) {
  Figures out;
  double squares = 0.0;
  constexpr int kViews = 5;
  std::uint64_t seed = 1000;
  for (const View& view : head_views(kLens, kViews, 0.25, 0.3, 55)) {
    const StandingDevice device = standing_device();
    const RenderedDesk live =
        render({.printed_pages = printed, .device = device, .hands = {holding_hand(device, Eigen::Vector3d::Zero())}},
               view, program::processors());
    const ColorImage truth = render({.printed_pages = printed}, view, program::processors()).color;
    View believed = view;
    believed.world_from_eye = disturbed(view.world_from_eye, kBoardNoise, seed++);
    Mask region = device_mask(device, view, expected_margin());
    add(region, live.mask(Label::Hand));
    const CompletionSettings settings{.cameras_a_vertex = cameras, .ring_px = kRing_px};
    const Synthesis synthesis = synthesise(desk, believed, with_ring(region, kRing_px), settings);
    squares += std::pow(10.0, -psnr_db(synthesis.color, truth, region) / 10.0) / kViews;
    ColorImage soft = truth, hard = truth;
    paint_background(soft, synthesis, region, kRing_px);
    paint_background(hard, synthesis, region, 0);
    out.ssim += ssim(hard, truth, region) / kViews;
    out.step += border_step(soft, truth, region) / kViews;
    out.hard_step += border_step(hard, truth, region) / kViews;
  }
  out.psnr_db = -10.0 * std::log10(squares);
  return out;
}

Background desk(ProxyKind kind, bool printed) {
  return desk_background(kLens, 121, kind, kBoardNoise, printed, program::processors());
}

}  // namespace

std::vector<Row> run_background_section() {
  std::vector<Row> rows;
  const auto add_rows = [&](const char* name, const Figures& figures, double least_db) {
    const std::string start = std::string("background, ") + name + ": ";
    const bool judged = least_db > 0.0;
    rows.push_back(judged ? at_least(start + "PSNR", figures.psnr_db, "dB", least_db)
                          : measured(start + "PSNR", figures.psnr_db, "dB"));
    rows.push_back(judged ? at_least(start + "SSIM", figures.ssim, "", 0.92)
                          : measured(start + "SSIM", figures.ssim, ""));
    rows.push_back(judged ? at_most(start + "step across the ring", figures.step, "levels", 3.0)
                          : measured(start + "step across the ring", figures.step, "levels"));
    rows.push_back(measured(start + "step without a ring", figures.hard_step, "levels"));
  };
  {
    const Background planes = desk(ProxyKind::Planes, false);
    add_rows("planes", figures_of(planes, false, 1), 30.0);
    add_rows("planes, three cameras a vertex", figures_of(planes, false, 3), 0.0);
  }
  {
    const Background depths = desk(ProxyKind::Depth, false);
    add_rows("depth", figures_of(depths, false, 1), 33.0);
    add_rows("depth, three cameras a vertex", figures_of(depths, false, 3), 0.0);
  }
  add_rows("depth, printed pages", figures_of(desk(ProxyKind::Depth, true), true, 1), 0.0);
  return rows;
}

}  // namespace telepalp::bench
