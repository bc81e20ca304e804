#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "haptic_station/device/random.h"
#include "haptic_station/mechanism/four_bar_pose.h"
#include "tests/bench/distribution.h"
#include "tests/bench/needle/section.h"
#include "tests/haptic_station/mechanism/dual.h"
#include "tests/haptic_station/periods.h"
#include "tools/study/designer/live/live_tool.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using mechanism::Dual;
using mechanism::FeltLinkage;
using mechanism::FourBar;
using mechanism::FourBarPose;
using mechanism::HeldLinkage;
using mechanism::InPlane;
using mechanism::LinkPart;

/// Both ends of each moving part, in the linkage's frame.
template <class Number>
struct Ends {
  InPlane<Number> from;
  InPlane<Number> to;
};
template <class Number>
Ends<Number> ends_of(LinkPart part, const FourBar& bar, const FourBarPose<Number>& at) {
  const InPlane<Number> o{Number(bar.l4_m), Number(0.0)};
  switch (part) {
    case LinkPart::Link1:
      return {{}, at.p};
    case LinkPart::Link2:
      return {at.b, at.p};
    case LinkPart::Link3:
      return {o, at.b};
    case LinkPart::Handle:
      return {at.d, at.c};
    default:
      return {at.p, at.tip};
  }
}
template <class Number>
InPlane<Number> between(const Ends<Number>& ends, double share) {
  return ends.from + Number(share) * (ends.to - ends.from);
}

/// Random places on the moving parts of S4's first linkage, in random poses: the work of the force on the hand and that
/// of the force on the tip, in the motion that automatic differentiation gives.
void add_work_at_any_part(std::vector<Row>& rows) {
  device::Random random(12);
  const FourBar bar{.needle_rad = -0.31};
  double compared = 0.0;
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double link3_rad = random.uniform(1.0, 2.4);
    const auto part = static_cast<LinkPart>(i % 5);
    const double share = random.uniform(0.1, 1.0);
    const auto dual = mechanism::four_bar_pose(bar, Dual(link3_rad, 1.0), 1.0);
    const InPlane<Dual> grasp = between(ends_of(part, bar, dual), share);
    const double tip_moves = std::hypot(dual.tip.x.slope, dual.tip.y.slope);
    if (tip_moves > 4.9 * std::hypot(grasp.x.slope, grasp.y.slope)) continue;  // there the force has its bound
    Result<FeltLinkage> felt = FeltLinkage::make(HeldLinkage(bar, {}, link3_rad, mechanism::Branch::Open));
    if (!felt) continue;
    felt->hold(part, {{grasp.x.value, grasp.y.value, 0.0}});
    const Vector3d tip_N(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(-1.0, 1.0));
    const Vector3d hand_N = felt->hand_force({tip_N}).N;
    const double at_tip = tip_N.x() * dual.tip.x.slope + tip_N.y() * dual.tip.y.slope;
    const double at_hand = hand_N.x() * grasp.x.slope + hand_N.y() * grasp.y.slope;
    worst = std::max(worst, std::abs(at_tip - at_hand) / (tip_N.head<2>().norm() * tip_moves));
    ++compared;
  }
  rows.push_back(at_least("felt links: places on all parts compared with virtual work", compared, "", 10'000.0));
  rows.push_back(
      at_most("felt links: force on the hand at any part against virtual work: greatest error over the force "
              "of the needle",
              worst, "N/N", 1e-9));
}

/// A hand at 2 kHz that touches a part from the side, grasps it, pushes the needle in, lets go and leaves.
class Visit {
 public:
  Visit(study::LiveTool& tool, Distribution& took_us)
      : tool_(tool), took_us_(took_us), hand_m_(tool.linkage().proxy().m) {
    tool_.forget_hand();
  }
  /// Moves the hand there at `m_per_s`.
  void go(const Vector3d& to, bool pressed, double m_per_s = 0.1) {
    const int ticks = std::max(1, static_cast<int>((to - hand_m_).norm() / (m_per_s * kTick_s)));
    const Vector3d each = (to - hand_m_) / ticks;
    for (int i = 0; i < ticks; ++i) tick(hand_m_ + each, pressed);
  }
  void rest(double seconds, bool pressed) {
    for (int i = 0; i < static_cast<int>(seconds / kTick_s); ++i) tick(hand_m_, pressed);
  }
  [[nodiscard]] const Vector3d& hand_m() const { return hand_m_; }
  [[nodiscard]] double most_step_N() const { return most_step_N_; }
  [[nodiscard]] double most_N() const { return most_N_; }

 private:
  void tick(const Vector3d& hand_m, bool pressed) {
    const FeltLinkage& linkage = tool_.linkage();
    const Vector3d before_N = linkage.contact_force().N;
    const double own_N = study::Plant{}.grip_N_per_m * (hand_m - hand_m_).norm();
    hand_m_ = hand_m;
    const auto begun = std::chrono::steady_clock::now();
    (void)tool_.feel(hand_m_, pressed);
    took_us_.add(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begun).count());
    most_N_ = std::max(most_N_, linkage.contact_force().N.norm());
    most_step_N_ = std::max(most_step_N_, (linkage.contact_force().N - before_N).norm() - own_N);
  }

  study::LiveTool& tool_;
  Distribution& took_us_;
  Vector3d hand_m_;
  double most_step_N_ = 0.0;
  double most_N_ = 0.0;
};

struct Visits {
  Distribution took_us;
  double most_step_N = 0.0;
  double least_touch_N = 1e9;
  int punctures = 0;
};

/// One visit for each moving part. The path of a part's middle while the handle turns is where the hand goes.
Visits visit_all(const study::LiveTool& fresh) {
  Visits out;
  for (const LinkPart part : {LinkPart::Link1, LinkPart::Link2, LinkPart::Link3, LinkPart::Handle}) {
    study::LiveTool tool = fresh;
    const FourBar bar = tool.linkage().bar();
    const mechanism::LinkagePlane plane = tool.linkage().plane();
    const auto place = [&](double link3_rad) -> Vector3d {
      const InPlane<double> at = between(ends_of(part, bar, mechanism::four_bar_pose(bar, link3_rad, 1.0)), 0.8);
      return plane.pivot_a.m + at.x * plane.x.v + at.y * plane.y.v;
    };
    const double from_rad = tool.linkage().link3_rad();
    const Vector3d above(0.0, 0.0, 0.008);  // 1 mm into the rod, whose surface is 9 mm from its axis
    Visit visit(tool, out.took_us);
    visit.go(place(from_rad) + Vector3d(0.0, 0.0, 0.03), false, 0.4);
    visit.go(place(from_rad) + above, false);
    out.least_touch_N = std::min(out.least_touch_N, visit.most_N());
    visit.rest(0.2, true);
    for (double rad = from_rad; rad < from_rad + 0.45; rad += 0.01) visit.go(place(rad) + above, true, 0.05);
    visit.rest(0.2, false);
    visit.go(visit.hand_m() + Vector3d(0.0, 0.0, 0.03), false);
    out.most_step_N = std::max(out.most_step_N, visit.most_step_N());
    out.punctures += static_cast<int>(tool.frame().punctured);
  }
  return out;
}

}  // namespace

std::vector<Row> run_needle_felt_section() {
  std::vector<Row> rows;
  add_work_at_any_part(rows);
  const auto tissue = tissue::make_tissue(study::tissue_of(study::Plant{}));
  const auto tool =
      study::LiveTool::make(study::amniocentesis_design().configurations.front(), study::Plant{}, *tissue);
  const Visits all = visit_all(*tool);
  const std::string of = "felt links: touch, grasp, push through, let go, by four parts: ";
  rows.push_back(at_least(of + "layers punctured", all.punctures, "", 8.0));
  rows.push_back(at_least(of + "least force of a touch", all.least_touch_N, "N", 0.4));
  rows.push_back(at_most(of + "greatest step of the force of touch and grasp beyond the spring's own", all.most_step_N,
                         "N", 0.05));
  rows.push_back(at_most(of + "tick: time, p50", all.took_us.p50(), "us", 20.0));
  rows.push_back(at_most(of + "tick: time, p99.9", all.took_us.p999(), "us", 100.0));
  return rows;
}

}  // namespace telepalp::bench
