#include "tests/bench/hand/contact_work.h"

namespace telepalp::bench::hand {

void ContactWork::add(const Tick& tick, const Eigen::Vector3d& newest_N) {
  // While the device moved, it held the force of the previous tick.
  now_.excess_mJ += 1e3 * (force_N_ - law_N_).dot(tick.moved_m);
  const double unseen_mJ = 1e3 * (newest_N_ - law_N_).dot(tick.moved_m);
  (newest_N_.norm() > law_N_.norm() ? now_.sunk_mJ : now_.risen_mJ) += unseen_mJ;
  force_N_ = tick.force_N;
  law_N_ = tick.law_N() * tick.normal;
  newest_N_ = newest_N;
  const bool touched = tick.displayed || tick.law_N() > 0.0;
  if (touched) last_touched_s_ = tick.time_s;
  if (touched) now_.seen_mJ = 1e3 * tick.control.hand_excess_J;
  const bool in_contact = tick.time_s - last_touched_s_ < 0.02;
  if (in_contact && !in_contact_) now_ = {};
  if (!in_contact && in_contact_) contacts_.push_back(now_);
  in_contact_ = in_contact;
}

}  // namespace telepalp::bench::hand
