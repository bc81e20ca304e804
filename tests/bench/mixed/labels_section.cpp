#include "clients/mixed/compose/mixed_view.h"
#include "support/program/parallel.h"
#include "tests/bench/mixed/section.h"
#include "tests/clients/mixed/desk_truth.h"

namespace telepalp::bench {
namespace {

using namespace mixed;

void add_device_rows(std::vector<Row>& rows, const std::string& what, bool arm_alone) {
  constexpr int kImages = 60;
  const std::string start = "mask of the " + what + " under 1.35 mm and 0.5 degrees: ";
  const MaskFigures ours = mask_figures(kImages, kLens, expected_margin(), arm_alone);
  rows.push_back(at_least(start + "recall", 100 * ours.recall, "%", 99.5));
  rows.push_back(measured(start + "least recall of an image", 100 * ours.least_recall, "%"));
  rows.push_back(at_most(start + "distance of its outline, mean", ours.mean_m * 1e3, "mm", 5.0));
  rows.push_back(measured(start + "distance of its outline, p95", ours.furthest_m * 1e3, "mm"));
  rows.push_back(measured(start + "too much", 100 * ours.too_much, "%"));
  const MaskFigures paper = mask_figures(kImages, kLens, paper_margin(), arm_alone);
  rows.push_back(measured(start + "recall with the paper's 5 %", 100 * paper.recall, "%"));
  rows.push_back(measured(start + "too much with the paper's 5 %", 100 * paper.too_much, "%"));
}

void add_hand_rows(std::vector<Row>& rows) {
  const Intrinsics lens{640, 480, 594, 594, 319.5, 239.5};
  const int threads = program::processors();
  const Background desk = desk_background(lens, 80, ProxyKind::Depth, {0.2e-3, 0.0005236}, false, threads);
  const StandingDevice device = standing_device();
  double glove = 0.0, bare = 0.0, colour = 0.0, least = 1.0;
  constexpr int kViews = 6;
  for (const View& view : head_views(lens, kViews, 0.25, 0.3, 77)) {
    const auto masks = [&](const std::array<std::uint8_t, 3>& rgb, double& by_colour, double& by_background) {
      const RenderedDesk live =
          render({.device = device, .hands = {holding_hand(device, Eigen::Vector3d::Zero(), rgb)}}, view, threads);
      const Mask truth = live.mask(Label::Hand);
      MixedSettings settings;
      const MaskMargin margin = calibrated_margin(0.3e-3, 0.001, {});
      const MixedImage behind = mix(live.color, view, desk, device, margin, {}, settings);
      settings.glove = fit_hand_colour(colors_of(live.color, truth));
      const MixedImage coloured = mix(live.color, view, desk, device, margin, {}, settings);
      const Mask expected = both(truth, behind.searched);
      by_background = overlap_of(both(behind.hand, behind.searched), expected).iou;
      by_colour = overlap_of(both(coloured.hand, behind.searched), expected).iou;
    };
    double skin_colour = 0.0, skin_behind = 0.0, glove_colour = 0.0, glove_behind = 0.0;
    masks({205, 150, 120}, skin_colour, skin_behind);
    masks({30, 150, 60}, glove_colour, glove_behind);
    glove += glove_colour / kViews;
    bare += skin_behind / kViews;
    colour += skin_colour / kViews;
    least = std::min(least, skin_behind);
  }
  rows.push_back(at_least("hand mask, green glove by its colour: IoU", glove, "", 0.95));
  rows.push_back(at_least("hand mask, bare hand before the completed background: IoU", bare, "", 0.9));
  rows.push_back(measured("hand mask, bare hand before the background: least IoU of an image", least, ""));
  rows.push_back(measured("hand mask, bare hand by colour alone on the rendered desk: IoU", colour, ""));
}

}  // namespace

std::vector<Row> run_labels_section() {
  std::vector<Row> rows;
  add_device_rows(rows, "device", false);
  add_device_rows(rows, "arm alone", true);
  add_hand_rows(rows);
  return rows;
}

}  // namespace telepalp::bench
