#include "haptic_station/loop/body_frame.h"

#include <algorithm>

#include "haptic_station/loop/packed.h"

namespace telepalp::loop {

using Eigen::Vector3d;

static_assert(effects::kMostEffects == surface::kMostMarks);

namespace {

/// True unless the contact begins above the skin that was last seen over a hidden object, where the object cannot be.
/// Such a contact is one with the thing that hides the object from the camera.
bool may_be_reached(const surface::SkinMark& mark, const surface::TouchSample& touch) noexcept {
  return mark.seen || mark.normal.isZero() || mark.normal.dot(touch.foot.m - mark.at) < 0.0;
}

}  // namespace

surface::MarkLines mark_lines(const effects::EffectBank& effects,
                              const Transform<DepthCamera, HapticBase>& camera_from_haptic) noexcept {
  surface::MarkLines lines;
  const Vector<DepthCamera> up = camera_from_haptic * Vector<HapticBase>{Vector3d::UnitY()};
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (const auto object = effects.object_at(i))
      lines[i] = surface::MarkLine{.point = (camera_from_haptic * *object).m, .up = up.v};
  return lines;
}

void BodyFrame::adopt(const surface::SurfaceSnapshot& snapshot,
                      const Transform<HapticBase, DepthCamera>& haptic_from_camera) noexcept {
  snapshot_ = &snapshot;
  haptic_from_camera_ = haptic_from_camera;
  marks_ = snapshot.marks;
  note_unseen();
}

/// The skin's motion at the mark since the capture, as the snapshot's motion model predicts it for the skin. Zero where
/// the snapshot has no surface.
BodyFrame::Carried BodyFrame::carried(const surface::SkinMark& mark, double age_s) const noexcept {
  const surface::MotionBasis basis = surface::motion_basis(snapshot_->motion, age_s);
  const surface::FieldSample then = snapshot_->evaluate(mark.at, mark.normal, {});
  const surface::FieldSample now = snapshot_->evaluate(mark.at, mark.normal, basis);
  if (!then.valid || !now.valid) return {};
  return {.m = then.f_m - now.f_m, .m_per_s = now.velocity_m_per_s};
}

/// Without a snapshot no mark is seen, and the objects stay where they are.
void BodyFrame::release() noexcept {
  snapshot_ = nullptr;
  for (surface::SkinMark& mark : marks_) mark.seen = mark.slide_seen = false;
  note_unseen();
}

void BodyFrame::note_unseen() noexcept {
  watched_ = unseen_ = slide_unseen_ = false;
  for (const surface::SkinMark& mark : marks_) {
    watched_ = watched_ || mark.watched;
    unseen_ = unseen_ || (mark.watched && !mark.seen);
    slide_unseen_ = slide_unseen_ || (mark.watched && !mark.slide_seen);
  }
}

/// Updates the motion of one object a tick; a motion changes little in eight ticks.
void BodyFrame::look_at_one(double age_s) noexcept {
  const std::size_t i = next_look_;
  next_look_ = (next_look_ + 1) % marks_.size();
  if (marks_[i].watched && marks_[i].seen)
    carried_[i] = carried(marks_[i], age_s);
  else
    carried_[i] = {};
}

/// The displacement and velocity of the object in the body below the newest surface, predicted to now.
effects::Placement BodyFrame::target(std::size_t object) const noexcept {
  const surface::SkinMark& mark = marks_[object];
  const Carried& carried = carried_[object];
  return {.moved = haptic_from_camera_ * Vector<DepthCamera>{mark.moved_m + carried.m * mark.normal},
          .velocity = haptic_from_camera_ * Vector<DepthCamera>{carried.m_per_s * mark.normal}};
}

/// Places each object, when a contact begins, as deep below the displayed skin as it is below the measured skin. This
/// includes an object whose mark is hidden or not found yet: a hand that sank in while the station gave no force may be
/// inside this object, and would get the energy of a spring that the hand never compressed.
void BodyFrame::lower_with_skin(const surface::TouchSample& touch) noexcept {
  const Vector<HapticBase> lowered = haptic_from_camera_ * Vector<DepthCamera>{touch.newest_above_m * touch.normal};
  const Vector<HapticBase> rising =
      haptic_from_camera_ * Vector<DepthCamera>{touch.surface_velocity_m_per_s * touch.normal};
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (marks_[i].watched && may_be_reached(marks_[i], touch))
      shown_[i] = {.moved = {target(i).moved.v - lowered.v}, .velocity = rising};
}

const effects::Placements& BodyFrame::step(const surface::TouchSample& touch, double dt_s) noexcept {
  const bool begins = touch.valid && touch.in_body && !in_body_;
  in_body_ = touch.valid && touch.in_body;
  if (!watched_) return shown_;
  const double dt = dt_s > 0.0 ? std::min(dt_s, 0.1) : 0.0;
  if (snapshot_ != nullptr) look_at_one(touch.age_s);
  if (begins) lower_with_skin(touch);
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (!marks_[i].watched) continue;
    effects::Placement& shown = shown_[i];
    const effects::Placement wanted = target(i);
    shown.velocity.v = surface::next_rate(shown.velocity.v, wanted.moved.v - shown.moved.v, wanted.velocity.v, limits_,
                                          share_.of(limits_.bandwidth_rad_per_s, dt), dt);
    shown.moved.v += dt * shown.velocity.v;
  }
  return shown_;
}

ObjectPlacements BodyFrame::objects() const noexcept {
  ObjectPlacements objects;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const surface::SkinMark& mark = marks_[i];
    objects[i] = {.watched = mark.watched,
                  .unseen = mark.watched && !mark.seen,
                  .slide_unseen = mark.watched && !mark.slide_seen,
                  .moved = packed(shown_[i].moved.v),
                  .sigma_normal_m = static_cast<float>(mark.sigma_normal_m),
                  .sigma_slide_m = static_cast<float>(mark.sigma_slide_m)};
  }
  return objects;
}

}  // namespace telepalp::loop
