#include "tools/study/task/insertion.h"

#include <algorithm>

#include "tools/study/task/plant.h"

namespace telepalp::study {

using Eigen::Vector3d;

Insertion::Insertion(HeldTool& tool, const std::shared_ptr<const tissue::TissueModel>& tissue) noexcept
    : tool_(tool), tissue_(tissue) {
  tissue_.begin({.tip_m = tool_.tip_m(), .axis = tool_.axis()});
}

bool Insertion::stands_still() noexcept {
  const std::size_t at = tips_ % kWindow;
  const bool still = tips_ >= kWindow && (tool_.tip_m() - tips_m_[at]).norm() < kStoppedMove_m;
  tips_m_[at] = tool_.tip_m();
  ++tips_;
  return still;
}

double Insertion::way_past_contact_m() const noexcept { return (tool_.tip_m() - contact_m_).dot(along_); }

/// Keeps the place of the first contact with the sac, and what the puncture changes. `before_N`: force of the sac on
/// the hand at the tick before.
void Insertion::note_sac(double before_N) noexcept {
  const tissue::LayerState sac = tissue_.layer(kSac).state;
  if (!touched_ && sac != tissue::LayerState::Removed) {
    touched_ = true;
    contact_m_ = tool_.tip_m();
    along_ = tool_.axis();
  }
  if (!out_.through && sac == tissue::LayerState::Inserted) {
    out_.through = true;
    out_.depth_at_puncture_m = depth_m();
    out_.hand_drop_N = before_N;
  }
}

void Insertion::step(const Vector3d& hand_m) noexcept {
  if (over()) return;
  out_.seconds = ticks_ * kTick_s;
  tool_.step(hand_m, kTick_s);
  needle_N_ = tool_.hand_force_N(tissue_.step({.tip_m = tool_.tip_m(), .axis = tool_.axis()}, kTick_s).force_N);
  out_.most_hand_N = std::max(out_.most_hand_N, needle_N_.norm());
  note_sac(before_N_);
  if (!out_.through) before_N_ = tool_.hand_force_N(tissue_.layer(kSac).force_N).norm();
  if (touched_) out_.deepest_m = std::max(out_.deepest_m, way_past_contact_m());
  if (stands_still() && out_.through) out_.stopped = true;
  ++ticks_;
}

Outcome Insertion::outcome() const noexcept {
  Outcome out = out_;
  if (touched_) out.overshoot_m = way_past_contact_m();
  return out;
}

}  // namespace telepalp::study
