#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/distribution.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A hand presses and lets go while the patient breathes irregularly and shifts by 10 mm. Measures the work on the hand
// in each contact beyond the work that the true skin would have done on the same path.

namespace telepalp::bench::hand {
namespace {

constexpr double kLasts_s = 14.0;
constexpr double kStarts_s = 2.0;

/// The energy that a contact gave to the hand beyond the true skin's work.
struct Contact {
  double excess_mJ = 0.0;
  double seen_mJ = 0.0;  ///< of it, in the station's own ledger when the contact ends: against the measured skin
};

/// Sums the work of each contact. A contact begins with the first touch of the true or the displayed skin and ends 20
/// ms after the last touch of either.
class ContactWork {
 public:
  void add(const Tick& tick) {
    // While the device moved, it held the force of the previous tick.
    excess_J_ += (force_N_ - law_N_).dot(tick.moved_m);
    force_N_ = tick.force_N;
    law_N_ = tick.law_N() * tick.normal;
    const bool touched = tick.displayed || tick.law_N() > 0.0;
    if (touched) last_touched_s_ = tick.time_s;
    if (touched) seen_J_ = tick.control.hand_excess_J;
    const bool in_contact = tick.time_s - last_touched_s_ < 0.02;
    if (in_contact && !in_contact_) excess_J_ = 0.0;
    if (!in_contact && in_contact_) contacts_.push_back({1e3 * excess_J_, 1e3 * seen_J_});
    in_contact_ = in_contact;
  }
  [[nodiscard]] const std::vector<Contact>& contacts() const noexcept { return contacts_; }

 private:
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d law_N_ = Eigen::Vector3d::Zero();
  double excess_J_ = 0.0;
  double seen_J_ = 0.0;
  double last_touched_s_ = -1.0;
  bool in_contact_ = false;
  std::vector<Contact> contacts_;
};

struct Bad {
  double least_rtt_s;
  double most_rtt_s;
  bool outage;  ///< true: half a second without frames around a shift
};

/// The patient's height: at random times it changes by 10 mm up, or back.
struct Shifts {
  explicit Shifts(device::Random& random) {
    for (double& at_s : at_s_) at_s = random.uniform(3.0, kLasts_s - 1.5);
    std::sort(at_s_.begin(), at_s_.end());
  }
  [[nodiscard]] double rise_m(double time_s) const noexcept {
    double rise_m = 0.0;
    for (std::size_t i = 0; i < at_s_.size(); ++i)
      rise_m += (i % 2 == 0 ? 0.01 : -0.01) * eased((time_s - at_s_[i]) / 0.2);
    return rise_m;
  }
  [[nodiscard]] bool near(double time_s) const noexcept {
    return std::any_of(at_s_.begin(), at_s_.end(),
                       [&](double at_s) { return time_s > at_s - 0.15 && time_s < at_s + 0.35; });
  }
  std::array<double, 3> at_s_{};
};

std::vector<Contact> play(const Bad& bad, int number) {
  const auto seed = static_cast<std::uint64_t>(number) + 1;
  device::Random random(7000 + seed);
  const auto patient = torso(Sensor::Kinect, capture::Motion::Irregular);
  const double begins_s = random.uniform(0.0, 900.0);  // another interval of the same patient's breathing
  const Shifts shifts(random);
  Feed feed({.patient = patient,
             .pose =
                 [&](double t) {
                   capture::PatientPose pose = patient->pose(at_time(begins_s + t));
                   pose.rise_m = shifts.rise_m(t);
                   return pose;
                 },
             .damage = [&](double t, DepthImage&) { return !bad.outage || !shifts.near(t); },
             .link = {.one_way_s = 0.5 * random.uniform(bad.least_rtt_s, bad.most_rtt_s), .seed = seed},
             .builder = {}});
  const double depth_m = random.uniform(0.01, 0.03);
  const double period_s = random.uniform(1.5, 4.0);
  const Spot spot = spots()[random.bits() % spots().size()];
  const Eigen::Vector3d normal = normal_at(*patient, spot).v;  // the law has no tangential force
  const auto anchor = number % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding;
  BenchStation station(with_skin(anchor), haptic_from_camera(*patient, spot),
                       std::make_unique<ArmHand>(300.0, [&](double t) {
                         const double since_s = std::max(0.0, t - kStarts_s);
                         const double pressed = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * since_s / period_s);
                         return device::Intention{{(0.03 - (0.03 + depth_m) * pressed) * normal}, {}};
                       }));
  ContactWork work;
  run(feed, station, kLasts_s, [&](const Tick& tick) { work.add(tick); });
  return work.contacts();
}

std::vector<Row> measure(const std::string& name, const Bad& bad, double worst_mJ, const Options& options) {
  std::vector<std::vector<Contact>> all(static_cast<std::size_t>(options.seeds));
  for_each_parallel(options.seeds, options, [&](int i) { all[static_cast<std::size_t>(i)] = play(bad, i); });
  Distribution contacts_mJ;
  Contact worst{-INFINITY, 0.0};
  for (const auto& one : all)
    for (const Contact& contact : one) {
      contacts_mJ.add(contact.excess_mJ);
      if (contact.excess_mJ > worst.excess_mJ) worst = contact;
    }
  const bool touched = contacts_mJ.count() >= all.size();  // at least one contact a seed, or the study is invalid
  std::vector<Row> rows{at_most(name + ": a contact, worst", touched ? contacts_mJ.max() : NAN, "mJ", worst_mJ),
                        measured(name + ": of the worst, seen by the station's own ledger", worst.seen_mJ, "mJ"),
                        measured(name + ": contacts", static_cast<double>(contacts_mJ.count()), "")};
  if (worst_mJ < 10.0) rows.push_back(at_most(name + ": a contact, median", contacts_mJ.p50(), "mJ", 0.5));
  return rows;
}

}  // namespace

std::vector<Study> excess_work() {
  std::vector<Study> studies;
  const auto add = [&](const std::string& name, const Bad& bad, double worst_mJ) {
    studies.push_back(
        {name, [name, bad, worst_mJ](const Options& options) { return measure(name, bad, worst_mJ, options); }});
  };
  add("work/RTT 0-300 ms", {0.0, 0.3, false}, 3.0);
  add("work/RTT 1 s", {1.0, 1.0, false}, 15.0);
  add("work/outage of 0.5 s", {0.0, 0.3, true}, 15.0);
  return studies;
}

}  // namespace telepalp::bench::hand
