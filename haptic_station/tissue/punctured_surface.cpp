#include "haptic_station/tissue/punctured_surface.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/tissue/tissue_model.h"

namespace telepalp::tissue {

using Eigen::Vector3d;

namespace {

constexpr double kHole_m = 0.0025;       ///< a tip at most this far from a hole enters it
constexpr double kJustInside_m = 0.005;  ///< a tip at most this far below the surface counts as come from outside

}  // namespace

void PuncturedSurface::begin(const TissueModel& model, const Vector3d& tip_m) noexcept {
  const MeshPoint nearest = model.tree.nearest(tip_m);
  const double above_m = (tip_m - nearest.at_m).dot(model.mesh.normal(nearest.triangle));
  leave();
  dissipated_J_ = 0.0;
  side_ = above_m >= -kJustInside_m ? 1.0 : -1.0;
  const bool over = (tip_m - nearest.at_m).norm() < 2.0 * std::abs(above_m);  // not beside the mesh
  if (above_m >= 0.0 || side_ < 0.0 || !over) return;
  if (const std::size_t hole = hole_near(nearest.at_m); hole < kMostHoles) {
    touch(model, nearest, 1.0);
    state_ = LayerState::Inserted;
    hole_ = hole;
    whole_ = 0.0;
  } else {
    touch(model, nearest, 1.0);
  }
}

std::size_t PuncturedSurface::hole_near(const Vector3d& at_m) const noexcept {
  for (std::size_t i = 0; i < holes(); ++i)
    if ((hole_at_m_[i] - at_m).norm() <= kHole_m) return i;
  return kMostHoles;
}

void PuncturedSurface::touch(const TissueModel& model, const MeshPoint& at, double side) noexcept {
  state_ = LayerState::Touching;
  side_ = side;
  contact_ = at;
  plane_m_ = at.at_m;
  out_ = side * model.mesh.normal(at.triangle);
  stiffness_ = model.stiffness.felt_at(at.triangle, at.shares);
  whole_ = 1.0;
  spring_ = {};
  drag_ = {};
}

void PuncturedSurface::leave() noexcept {
  state_ = LayerState::Removed;
  spring_ = {};
  drag_ = {};
  whole_ = 0.0;
}

/// A motion that begins on the surface and goes back to the side from which the last contact came does not touch it.
void PuncturedSurface::meet(const TissueModel& model, const LayerSettings& layer, const Vector3d& from_m,
                            const Vector3d& to_m) noexcept {
  constexpr double kOn_m = 1e-12;
  const auto hit = model.tree.first_hit(from_m, to_m);
  if (!hit) return;
  const double side = (to_m - from_m).dot(model.mesh.normal(hit->triangle)) < 0.0 ? 1.0 : -1.0;
  if ((hit->at_m - from_m).norm() < kOn_m && side != side_) return;
  const std::size_t hole = hole_near(hit->at_m);
  touch(model, *hit, side);
  spring_.move(to_m - hit->at_m);
  if (hole == kMostHoles) return;
  state_ = LayerState::Inserted;
  hole_ = hole;
  whole_ = 0.0;
  pass(layer, Vector3d::Zero(), (plane_m_ - to_m).dot(out_), 0.0);
}

void PuncturedSurface::step(const TissueModel& model, const LayerSettings& layer, const Vector3d& from_m,
                            const Vector3d& to_m, bool may_puncture, double dt_s) noexcept {
  fresh_hole_ = false;
  if (state_ == LayerState::Removed) {
    meet(model, layer, from_m, to_m);
  } else {
    spring_.relax(layer.relaxation, dt_s);
    stretch(layer, to_m - from_m);
  }
  if (state_ == LayerState::Removed) return;
  const double depth_m = (plane_m_ - to_m).dot(out_);
  if (depth_m <= 0.0) return leave();
  if (state_ == LayerState::Inserted) return pass(layer, to_m - from_m, depth_m, dt_s);
  slide(model, layer);
  if (may_puncture && net_N(layer).norm() > layer.surface->punctures_at_N) puncture(to_m);
}

/// Once the net no longer pushes, it lets the tip go: its anchor follows the tip outwards. Otherwise a net that has
/// relaxed or yielded would be stretched outwards, and store energy that the hand cannot get back.
void PuncturedSurface::stretch(const LayerSettings& layer, const Vector3d& by_m) noexcept {
  const double before_N = std::max(0.0, pulled_by_net_N(layer).dot(out_));
  spring_.move(by_m);
  const double after_N = pulled_by_net_N(layer).dot(out_);
  const double outwards_m = by_m.dot(out_);
  if (after_N < 0.0 && outwards_m > 0.0) spring_.move(-after_N / (after_N - before_N) * outwards_m * out_);
}

/// The place of contact only follows the tip, and the stiffness only falls: both take energy out.
void PuncturedSurface::slide(const TissueModel& model, const LayerSettings& layer) noexcept {
  const Vector3d pulled_N = pulled_by_net_N(layer);
  const double sideways_N = (pulled_N - pulled_N.dot(out_) * out_).norm();
  const double most_N = layer.surface->side_grip * std::max(0.0, pulled_N.dot(out_));
  if (sideways_N <= most_N) return;
  const double kept = most_N / sideways_N;
  const Vector3d bent_m = spring_.whole_m();
  const Vector3d to_m = contact_.at_m + (1.0 - kept) * (bent_m - bent_m.dot(out_) * out_);
  spring_.shorten_across(out_, kept);
  contact_ = model.tree.nearest(to_m);
  stiffness_ = std::min(stiffness_, model.stiffness.felt_at(contact_.triangle, contact_.shares));
}

void PuncturedSurface::puncture(const Vector3d& tip_m) noexcept {
  state_ = LayerState::Inserted;
  hole_ = holes_ % kMostHoles;
  hole_at_m_[hole_] = contact_.at_m;
  ++holes_;
  if (holes_ >= 2 * kMostHoles) holes_ -= kMostHoles;
  fresh_hole_ = true;
  plane_m_ += (tip_m - plane_m_) - (tip_m - plane_m_).dot(out_) * out_;
}

/// Over the first 2 mm below the surface, the friction rises to its full value.
void PuncturedSurface::pass(const LayerSettings& layer, const Vector3d& by_m, double depth_m, double dt_s) noexcept {
  constexpr double kFull_m = 0.002;
  const double left = std::max(0.0, whole_ - dt_s / layer.surface->falls_in_s);
  dissipated_J_ += (whole_ - left) * net_J(layer);
  whole_ = left;
  // A tip that goes on faster than the net falls would stretch it beyond its puncture; the net slips over it instead.
  if (const double pushes_N = whole_ * net_N(layer).norm(); pushes_N > layer.surface->punctures_at_N) {
    const double before_J = net_J(layer);
    spring_.shorten(layer.surface->punctures_at_N / pushes_N);
    dissipated_J_ += whole_ * (before_J - net_J(layer));
  }
  const double most_N = (1.0 - whole_) * layer.surface->friction_N * std::min(1.0, depth_m / kFull_m);
  drag_.step(by_m, layer.surface->bristle_N_per_m, most_N, layer.relaxation, dt_s);
}

Vector3d PuncturedSurface::pulled_by_net_N(const LayerSettings& layer) const noexcept {
  const Vector3d& bent_m = spring_.whole_m();
  return -stiffness_ * (layer.surface->stiffness_N_per_m * spring_.extension_m(layer.relaxation) +
                        layer.surface->stiffening_N_per_m2 * bent_m.norm() * bent_m);
}

/// The net only pushes: it does not pull a tip that leaves faster than the tissue recovers.
Vector3d PuncturedSurface::net_N(const LayerSettings& layer) const noexcept {
  const Vector3d force_N = pulled_by_net_N(layer);
  return force_N.dot(out_) > 0.0 ? force_N : Vector3d::Zero();
}

double PuncturedSurface::net_J(const LayerSettings& layer) const noexcept {
  return stiffness_ * (layer.surface->stiffness_N_per_m * spring_.stored_m2(layer.relaxation) +
                       layer.surface->stiffening_N_per_m2 * std::pow(spring_.whole_m().norm(), 3) / 3.0);
}

Vector3d PuncturedSurface::force_N(const LayerSettings& layer) const noexcept {
  if (state_ == LayerState::Removed) return Vector3d::Zero();
  const Vector3d drag_N = -layer.surface->bristle_N_per_m * drag_.bent_m(layer.relaxation);
  return whole_ > 0.0 ? Vector3d(whole_ * net_N(layer) + drag_N) : drag_N;
}

double PuncturedSurface::stored_J(const LayerSettings& layer) const noexcept {
  if (state_ == LayerState::Removed) return 0.0;
  return whole_ * net_J(layer) + layer.surface->bristle_N_per_m * drag_.stored_m2(layer.relaxation);
}

double PuncturedSurface::stiffness_N_per_m(const LayerSettings& layer) const noexcept {
  if (state_ == LayerState::Removed) return 0.0;
  const SurfaceSettings& surface = *layer.surface;
  const double net =
      stiffness_ * (surface.stiffness_N_per_m + 2.0 * surface.stiffening_N_per_m2 * spring_.whole_m().norm());
  return whole_ * net + (state_ == LayerState::Inserted ? surface.bristle_N_per_m : 0.0);
}

void PuncturedSurface::yield(double share) noexcept {
  spring_.shorten(share);
  drag_.shorten(share);
}

}  // namespace telepalp::tissue
