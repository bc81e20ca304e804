#pragma once

#include <vector>

#include "tests/bench/hand/run.h"

namespace telepalp::bench::hand {

/// The energy that a contact gave to the hand beyond the true skin's work on the same path. It has three parts: two
/// that a display of the newest image, without error and without delay of its own, would give on this path, and the
/// rest, which is the station's part.
struct Contact {
  double excess_mJ = 0.0;
  double seen_mJ = 0.0;   ///< the station's own ledger when the contact ends, relative to the measured skin
  double sunk_mJ = 0.0;   ///< part of the excess: the skin sank since the newest image, so the hand gets energy back
                          ///< that it stored in the higher skin
  double risen_mJ = 0.0;  ///< part of the excess: the skin rose since the newest image and would have taken this work

  [[nodiscard]] double own_mJ() const noexcept { return excess_mJ - sunk_mJ - risen_mJ; }
};

/// Sums the work of each contact. A contact begins with the first touch of the true or the displayed skin and ends 20
/// ms after the last touch of either.
class ContactWork {
 public:
  /// `newest_N`: the force of the law on the skin as it was at the capture of the newest image [N], in H.
  void add(const Tick& tick, const Eigen::Vector3d& newest_N);
  [[nodiscard]] const std::vector<Contact>& contacts() const noexcept { return contacts_; }

 private:
  Contact now_;
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d law_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d newest_N_ = Eigen::Vector3d::Zero();
  double last_touched_s_ = -1.0;
  bool in_contact_ = false;
  std::vector<Contact> contacts_;
};

}  // namespace telepalp::bench::hand
