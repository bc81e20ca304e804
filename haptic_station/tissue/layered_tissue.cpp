#include "haptic_station/tissue/layered_tissue.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/tissue/tissue_model.h"

namespace telepalp::tissue {

using Eigen::Vector3d;

const TissueSettings& settings_of(const TissueModel& model) noexcept { return model.settings; }

std::size_t LayeredTissue::size() const noexcept { return model_->settings.layers.size(); }

Vector3d LayeredTissue::local_m(const Vector3d& tip_m, const LayerSettings& layer) const noexcept {
  return tip_m - model_->settings.at_m + layer.top_m * Vector3d::UnitY();
}

void LayeredTissue::begin(const NeedleMotion& needle) noexcept {
  const auto& layers = model_->settings.layers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    bulks_[i].clear();
    if (layers[i].surface) surfaces_[i].begin(*model_, local_m(needle.tip_m, layers[i]));
  }
  shaft_.leave();
  tip_m_ = needle.tip_m;
}

TissueWrench LayeredTissue::step(const NeedleMotion& needle, double dt_s) noexcept {
  step_surfaces(needle, dt_s);
  step_bulks(needle, dt_s);
  step_shaft(needle);
  tip_m_ = needle.tip_m;
  return wrench();
}

bool LayeredTissue::open_down_to(std::size_t index) const noexcept {
  for (std::size_t i = 0; i < index; ++i)
    if (model_->settings.layers[i].surface && surfaces_[i].state() != LayerState::Inserted) return false;
  return true;
}

/// A surface that the needle meets from inside may be punctured even if a layer outside it is not.
void LayeredTissue::step_surfaces(const NeedleMotion& needle, double dt_s) noexcept {
  const auto& layers = model_->settings.layers;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i].surface)
      surfaces_[i].step(*model_, layers[i], local_m(tip_m_, layers[i]), local_m(needle.tip_m, layers[i]),
                        surfaces_[i].from_inside() || open_down_to(i), dt_s);
}

/// Keeps the greatest depth of the tip below each hole of the outermost surface, because tissue is cut only once.
void LayeredTissue::step_bulks(const NeedleMotion& needle, double dt_s) noexcept {
  constexpr double kRise_m = 0.001;
  const auto& layers = model_->settings.layers;
  const auto outermost =
      std::ranges::find_if(layers, [](const LayerSettings& layer) { return layer.surface.has_value(); });
  std::size_t way = 0;
  bool in_the_way = true;
  if (outermost != layers.end()) {
    const PuncturedSurface& surface = surfaces_[static_cast<std::size_t>(outermost - layers.begin())];
    way = surface.hole();
    in_the_way = surface.state() == LayerState::Inserted;
    if (surface.fresh_hole()) deepest_m_[way] = 0.0;
  }
  const double slope = std::max(0.2, std::abs(needle.axis.y()));
  const double depth_m = model_->settings.at_m.y() - needle.tip_m.y();
  const double bevel = model_->settings.shaft.bevel_rad;
  const double uncut = std::clamp(1.0 - (deepest_m_[way] - depth_m) / kRise_m, 0.0, 1.0);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!layers[i].bulk) continue;
    if (!open_down_to(i + 1)) {
      bulks_[i].clear();
      continue;
    }
    const double under_m = depth_m - layers[i].top_m;
    const double past_m = under_m - layers[i].thickness_m;
    const double here = std::clamp(std::min(under_m, -past_m + kRise_m) / kRise_m, 0.0, 1.0);
    bulks_[i].step(*layers[i].bulk, layers[i].relaxation,
                   {.to_m = needle.tip_m,
                    .by_m = needle.tip_m - tip_m_,
                    .cuts = std::cos(bevel) * needle.axis + std::sin(bevel) * needle.bevel,
                    .inside_m = std::clamp(under_m, 0.0, layers[i].thickness_m) / slope,
                    .uncut = here * uncut},
                   dt_s);
  }
  if (in_the_way) deepest_m_[way] = std::max(deepest_m_[way], depth_m);
}

void LayeredTissue::step_shaft(const NeedleMotion& needle) noexcept {
  const auto& layers = model_->settings.layers;
  std::size_t i = 0;
  while (i < layers.size() && !layers[i].surface) ++i;
  if (i == layers.size() || surfaces_[i].state() != LayerState::Inserted || surfaces_[i].from_inside())
    return shaft_.leave();
  if (!shaft_.inside())
    shaft_.enter(surfaces_[i].hole_m() + model_->settings.at_m - layers[i].top_m * Vector3d::UnitY());
  shaft_.step(model_->settings.shaft, needle.tip_m, needle.axis);
}

LayerReading LayeredTissue::layer(std::size_t index) const noexcept {
  const LayerSettings& layer = model_->settings.layers[index];
  LayerReading reading;
  reading.depth_m = model_->settings.at_m.y() - layer.top_m - tip_m_.y();
  if (layer.surface) {
    reading.state = surfaces_[index].state();
    reading.force_N = surfaces_[index].force_N(layer);
  } else if (reading.depth_m > 0.0 && open_down_to(index)) {
    reading.state = LayerState::Inserted;
  }
  if (layer.bulk) reading.force_N += bulks_[index].force_N(*layer.bulk, layer.relaxation);
  return reading;
}

/// The sum of the layers' forces (S4 eq. 1) and the wrench of the shaft.
TissueWrench LayeredTissue::wrench() const noexcept {
  const ShaftSettings& shaft = model_->settings.shaft;
  TissueWrench sum{shaft_.force_N(shaft), shaft_.torque_N_m(shaft)};
  for (std::size_t i = 0; i < size(); ++i) sum.force_N += layer(i).force_N;
  return sum;
}

double LayeredTissue::opened() const noexcept {
  for (std::size_t i = 0; i < size(); ++i)
    if (model_->settings.layers[i].surface) return surfaces_[i].opened();
  return 0.0;
}

double LayeredTissue::stored_J() const noexcept {
  double sum_J = shaft_.stored_J(model_->settings.shaft);
  for (std::size_t i = 0; i < size(); ++i) {
    const LayerSettings& layer = model_->settings.layers[i];
    if (layer.surface) sum_J += surfaces_[i].stored_J(layer);
    if (layer.bulk) sum_J += bulks_[i].stored_J(*layer.bulk, layer.relaxation);
  }
  return sum_J;
}

double LayeredTissue::punctures_dissipated_J() const noexcept {
  double sum_J = 0.0;
  for (std::size_t i = 0; i < size(); ++i) sum_J += surfaces_[i].puncture_dissipated_J();
  return sum_J;
}

void LayeredTissue::yield(double share) noexcept {
  shaft_.yield(share);
  for (std::size_t i = 0; i < size(); ++i) {
    surfaces_[i].yield(share);
    bulks_[i].yield(share);
  }
}

bool LayeredTissue::falls() const noexcept {
  return std::ranges::any_of(surfaces_, [](const PuncturedSurface& surface) { return surface.falls(); }) ||
         std::ranges::any_of(bulks_, [](const Bulk& bulk) { return bulk.slips(); });
}

double LayeredTissue::stiffness_N_per_m() const noexcept {
  double sum = model_->settings.shaft.side_N_per_m;
  for (std::size_t i = 0; i < size(); ++i) {
    const LayerSettings& layer = model_->settings.layers[i];
    if (layer.surface) sum += surfaces_[i].stiffness_N_per_m(layer);
    if (layer.bulk) sum += 2.0 * layer.bulk->stick_N_per_m;
  }
  return sum;
}

double LayeredTissue::most_N() const noexcept { return model_->most_N; }

/// The tip cuts in at most two layers at once, where one ends and the next begins.
double LayeredTissue::stiffest_N_per_m() const noexcept {
  const TissueSettings& settings = model_->settings;
  double sum = settings.shaft.side_N_per_m;
  double cuts = 0.0;
  double cuts_less = 0.0;
  for (const LayerSettings& layer : settings.layers) {
    if (layer.surface) {
      const double a2 = layer.surface->stiffening_N_per_m2;
      const double deepest_m = a2 > 0.0 ? std::sqrt(layer.surface->punctures_at_N / a2) : 0.0;
      sum += layer.surface->stiffness_N_per_m + 2.0 * a2 * deepest_m + layer.surface->bristle_N_per_m;
    }
    if (!layer.bulk) continue;
    sum += layer.bulk->stick_N_per_m;
    if (layer.bulk->cuts_at_N <= 0.0) continue;
    cuts_less = std::max(cuts_less, std::min(cuts, layer.bulk->stick_N_per_m));
    cuts = std::max(cuts, layer.bulk->stick_N_per_m);
  }
  return sum + cuts + cuts_less;
}

}  // namespace telepalp::tissue
