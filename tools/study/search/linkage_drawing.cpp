#include "tools/study/search/linkage_drawing.h"

#include "haptic_station/mechanism/held_linkage.h"
#include "support/plot/palette.h"
#include "support/plot/svg.h"
#include "tools/study/task/plant.h"

namespace telepalp::study {
namespace {

constexpr double kWidth_px = 210.0;
constexpr double kHeight_px = 250.0;
constexpr double kScale_px_per_m = 480.0;
constexpr double kTip_px = 205.0;  // height of the tip, which is at the sac

/// Middle of each range.
Plant middle_plant() {
  Plant plant;
  for (const Drawn<Plant>& range : plant_ranges()) plant.*range.value = 0.5 * (range.least + range.most);
  return plant;
}

}  // namespace

std::string linkage_drawing(const Configuration& mechanism, const std::string& title) {
  const Plant plant = middle_plant();
  mechanism::FourBar bar = mechanism.bar;
  if (!mechanism.l4_given) bar.l4_m = plant.l4_of_l2 * bar.l2_m;
  if (!mechanism.needle_given) bar.needle_m = plant.needle_m;
  if (!mechanism::checked_at(bar, plant.link3_rad)) return "";
  const mechanism::FourBarPose<double> pose = mechanism::four_bar_pose<double>(bar, plant.link3_rad, 1.0);
  // The linkage's x axis points out of the patient, and so upwards in the drawing.
  const auto at = [&](const mechanism::InPlane<double>& point) {
    return plot::Pixel{0.65 * kWidth_px - kScale_px_per_m * (point.y - pose.tip.y),
                       kTip_px - kScale_px_per_m * (point.x - pose.tip.x)};
  };
  plot::Svg svg(kWidth_px, kHeight_px, title);
  const double skin_px = kTip_px - kScale_px_per_m * plant.sac_depth_m;
  svg.rect({0.0, skin_px}, {kWidth_px, kTip_px}, plot::kOrange, 0.25);
  svg.rect({0.0, kTip_px}, {kWidth_px, kHeight_px}, plot::kSky, 0.35);
  const plot::Pixel a = at({0.0, 0.0});
  const plot::Pixel o = at({bar.l4_m, 0.0});
  svg.line(a, o, plot::kGrey, 4.0);
  svg.line(a, at(pose.p), plot::kBlue, 3.0);
  svg.line(at(pose.p), at(pose.b), plot::kGreen, 3.0);
  svg.line(o, at(pose.b), plot::kPurple, 3.0);
  svg.line(at(pose.d), at(pose.c), plot::kVermilion, 3.0);
  svg.line(at(pose.p), at(pose.tip), plot::kBlack, 1.5);
  for (const plot::Pixel joint : {a, o, at(pose.p), at(pose.b)}) svg.disc(joint, 3.0, plot::kBlack);
  svg.disc(at(pose.c), 5.0, plot::kVermilion);
  svg.text({4.0, 14.0}, title, plot::Anchor::Start, 12.0, plot::kBlack);
  return std::move(svg).finish();
}

}  // namespace telepalp::study
