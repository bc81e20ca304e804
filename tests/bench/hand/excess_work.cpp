#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/distribution.h"
#include "tests/bench/hand/contact_work.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A hand presses and lets go while the patient breathes irregularly and shifts by 10 mm. Measures the work on the hand
// in each contact beyond the work that the true skin would have done on the same path.

namespace telepalp::bench::hand {
namespace {

constexpr double kRunLasts_s = 14.0;
constexpr double kStarts_s = 2.0;

struct Bad {
  double least_rtt_s;
  double most_rtt_s;
  bool outage;  ///< true: half a second without frames around a shift
};

/// The patient's height: at random times it changes by 10 mm up, or back.
struct Shifts {
  explicit Shifts(device::Random& random) {
    for (double& at_s : at_s_) at_s = random.uniform(3.0, kRunLasts_s - 1.5);
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

/// One run: a patient, a hand and a link, as drawn from a seed.
struct DrawnRun {
  DrawnRun(const Bad& kind, int number)
      : bad(kind),
        seed(static_cast<std::uint64_t>(number) + 1),
        random(7000 + seed),
        begins_s(random.uniform(0.0, 900.0)),
        shifts(random),
        one_way_s(0.5 * random.uniform(bad.least_rtt_s, bad.most_rtt_s)),
        depth_m(random.uniform(0.01, 0.03)),
        period_s(random.uniform(1.5, 4.0)),
        spot(spots()[random.bits() % spots().size()]),
        anchor(number % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding) {}

  [[nodiscard]] capture::PatientPose pose(double time_s, double rise_m) const {
    capture::PatientPose pose = patient->pose(at_time(begins_s + time_s));
    pose.rise_m = rise_m;
    return pose;
  }
  [[nodiscard]] std::unique_ptr<Person> person() const {
    const Eigen::Vector3d normal = normal_at(*patient, spot).v;  // the law has no tangential force
    return std::make_unique<ArmHand>(300.0, [normal, depth = depth_m, period = period_s](double t) {
      const double since_s = std::max(0.0, t - kStarts_s);
      const double pressed = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * since_s / period);
      return device::Intention{{(0.03 - (0.03 + depth) * pressed) * normal}, {}};
    });
  }

  Bad bad;
  std::uint64_t seed;
  device::Random random;
  std::shared_ptr<const capture::SyntheticPatient> patient = torso(Sensor::Kinect, capture::Motion::Irregular);
  double begins_s;  ///< start in the patient's breathing: each run has another interval of it [s]
  Shifts shifts;
  double one_way_s;
  double depth_m;
  double period_s;
  Spot spot;
  effects::SkinAnchor anchor;
};

/// An image that became touchable.
struct Arrival {
  double at_s;
  double captured_s;
};

/// The contacts at the station. Adds each image to `arrivals`.
std::vector<Contact> play_excess_work(const DrawnRun& drawn, std::vector<Arrival>& arrivals) {
  Feed feed({.patient = drawn.patient,
             .pose = [&](double t) { return drawn.pose(t, drawn.shifts.rise_m(t)); },
             .damage = [&](double t, DepthImage&) { return !drawn.bad.outage || !drawn.shifts.near(t); },
             .link = {.one_way_s = drawn.one_way_s, .seed = drawn.seed},
             .builder = {}});
  const auto placed = haptic_from_camera(*drawn.patient, drawn.spot);
  BenchStation station(with_skin(drawn.anchor), placed, drawn.person());
  ContactWork work;
  for (std::int64_t i = 0; i < std::llround(kRunLasts_s / kTick_s); ++i) {
    const double t = static_cast<double>(i) * kTick_s;
    const auto snapshot = feed.step(t, station.device_camera());
    if (snapshot) arrivals.push_back({t, to_seconds(snapshot->captured - at_time(0.0))});
    station.receive(snapshot, t);
    const Tick tick = station.step(t, feed.truth(t));
    Tick newest = tick;  // of the skin as the newest image shows it
    if (!arrivals.empty()) {
      const double captured_s = arrivals.back().captured_s;
      touch(feed.truth(captured_s), placed, newest);
    }
    work.add(tick, newest.law_N() * newest.normal);
  }
  return work.contacts();
}

/// What a display without error knows of the patient at this instant.
enum class Knows {
  AllButShifts,  ///< the true shape and breath; a shift as the newest received image shows it
  NewestImage,   ///< the true shape at the capture of the newest received image, nothing newer
};

/// The contacts at a display that applies the force law to what it knows, without delay.
std::vector<Contact> play_limit(const DrawnRun& drawn, const std::vector<Arrival>& arrivals, Knows knows) {
  const auto placed = haptic_from_camera(*drawn.patient, drawn.spot);
  const auto touch_at = [&](double breath_s, double shift_s, Tick& tick) {
    touch(drawn.patient->surface_of(drawn.pose(breath_s, drawn.shifts.rise_m(shift_s))), placed, tick);
  };
  const std::unique_ptr<Person> person = drawn.person();
  auto next = arrivals.begin();
  double captured_s = 0.0;
  Eigen::Vector3d before_m = person->device().m;
  ContactWork work;
  for (std::int64_t i = 0; i < std::llround(kRunLasts_s / kTick_s); ++i) {
    Tick tick{.time_s = static_cast<double>(i) * kTick_s, .device_m = person->device().m};
    for (; next != arrivals.end() && next->at_s <= tick.time_s; ++next) captured_s = next->captured_s;
    const double breath_s = knows == Knows::AllButShifts ? tick.time_s : captured_s;
    tick.moved_m = tick.device_m - before_m;
    before_m = tick.device_m;
    Tick displayed = tick;
    touch_at(breath_s, captured_s, displayed);
    touch_at(tick.time_s, tick.time_s, tick);
    tick.force_N = displayed.law_N() * displayed.normal;
    tick.displayed = displayed.law_N() > 0.0;
    work.add(tick, tick.force_N);
    person->apply({.force = {tick.force_N}, .torque = {}, .contact = {}, .control = {}, .sample = {}}, tick.time_s,
                  kTick_s);
  }
  return work.contacts();
}

std::vector<Row> measure_excess_work(const std::string& name, const Bad& bad, double worst_mJ, const Options& options) {
  const auto count = static_cast<std::size_t>(options.seeds);
  std::vector<std::vector<Contact>> all(count);
  std::vector<std::vector<Contact>> all_but_shifts(count);
  std::vector<std::vector<Contact>> newest_image(count);
  for_each_parallel(options.seeds, options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const DrawnRun drawn(bad, i);
    std::vector<Arrival> arrivals;
    all[at] = play_excess_work(drawn, arrivals);
    all_but_shifts[at] = play_limit(drawn, arrivals, Knows::AllButShifts);
    newest_image[at] = play_limit(drawn, arrivals, Knows::NewestImage);
  });
  Distribution contacts_mJ;
  Distribution own_mJ;
  Contact worst{.excess_mJ = -INFINITY};
  for (const auto& one : all)
    for (const Contact& contact : one) {
      contacts_mJ.add(contact.excess_mJ);
      own_mJ.add(contact.own_mJ());
      if (contact.excess_mJ > worst.excess_mJ) worst = contact;
    }
  const bool touched = contacts_mJ.count() >= all.size();  // at least one contact a seed, or the study is invalid
  const std::string own = name + ": the station's own part of the excess work in a contact, ";
  std::vector<Row> rows{
      at_most(name + ": excess work in a contact, worst", touched ? contacts_mJ.max() : NAN, "mJ", worst_mJ),
      measured(name + ": worst contact, part that the station's ledger sees", worst.seen_mJ, "mJ"),
      measured(name + ": worst contact, part because the skin sank since the newest image", worst.sunk_mJ, "mJ"),
      measured(name + ": worst contact, part because the skin rose since the newest image", worst.risen_mJ, "mJ"),
      measured(name + ": worst contact, the station's own part", worst.own_mJ(), "mJ"),
      measured(name + ": excess work in a contact, 95th percentile", contacts_mJ.quantile(0.95), "mJ"),
      measured(name + ": number of contacts", static_cast<double>(contacts_mJ.count()), ""),
      at_most(own + "worst", touched ? own_mJ.max() : NAN, "mJ", worst_mJ),
      measured(own + "95th percentile", own_mJ.quantile(0.95), "mJ"),
      measured(own + "median", own_mJ.p50(), "mJ")};
  for (const auto& [knows, runs] : {std::pair{"all but the patient's shifts since the newest image", &all_but_shifts},
                                    std::pair{"only the newest image", &newest_image}}) {
    Distribution limit_mJ;
    for (const auto& one : *runs)
      for (const Contact& contact : one) limit_mJ.add(contact.excess_mJ);
    const std::string as_known = name + ": excess work in a contact, ideal display that knows " + knows + ", ";
    rows.push_back(measured(as_known + "worst", limit_mJ.max(), "mJ"));
    rows.push_back(measured(as_known + "95th percentile", limit_mJ.quantile(0.95), "mJ"));
  }
  if (worst_mJ < 10.0)
    rows.push_back(at_most(name + ": excess work in a contact, median", contacts_mJ.p50(), "mJ", 0.5));
  return rows;
}

}  // namespace

std::vector<Study> excess_work() {
  std::vector<Study> studies;
  const auto add = [&](const std::string& name, const Bad& bad, double worst_mJ) {
    studies.push_back({name, [name, bad, worst_mJ](const Options& options) {
                         return measure_excess_work(name, bad, worst_mJ, options);
                       }});
  };
  add("work/RTT 0-300 ms", {0.0, 0.3, false}, 3.0);
  add("work/RTT 1 s", {1.0, 1.0, false}, 15.0);
  add("work/outage of 0.5 s", {0.0, 0.3, true}, 15.0);
  return studies;
}

}  // namespace telepalp::bench::hand
