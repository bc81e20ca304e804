#include "tools/study/designer/live/live_tool.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/mechanism/crank_range.h"
#include "tools/study/task/insertion.h"

namespace telepalp::study {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kTraceEach = 10;       // ticks
constexpr int kAfterPuncture = 200;  // ticks in which the force falls to its least
constexpr double kInserts_m_per_s = 0.04;
constexpr double kSettles_s = 0.2;
constexpr double kDeadPointSine = 0.03;  // about 2 degrees between links 1 and 2
constexpr double kAtRest_N = 1e-5;       // change of force over one step

}  // namespace

Result<LiveTool> LiveTool::make(const Configuration& configuration, const Plant& plant, Model tissue) {
  const Result<mechanism::HeldLinkage> outside = placed_linkage(configuration, plant);
  if (!outside) return outside.error();
  Result<mechanism::FeltLinkage> felt =
      mechanism::FeltLinkage::make(*outside, {.stiffness_N_per_m = plant.grip_N_per_m});
  if (!felt) return felt.error();
  return LiveTool(*outside, std::move(*felt), std::move(tissue));
}

LiveTool::LiveTool(const mechanism::HeldLinkage& outside, mechanism::FeltLinkage linkage, Model tissue)
    : outside_(outside), model_(std::move(tissue)), fresh_(linkage), linkage_(std::move(linkage)), tissue_(model_) {
  take_the_end();
  at_rest_ = true;
  tissue_.begin({.tip_m = linkage_.tip().m, .axis = linkage_.needle_axis().v});
}

void LiveTool::renew() { *this = LiveTool(outside_, fresh_, model_); }

void LiveTool::take(mechanism::LinkPart part, const Vector2d& at_m) noexcept {
  linkage_.hold(part, {{at_m.x(), at_m.y(), 0.0}});
  hand_m_ = aim_m_ = linkage_.proxy().m;
  at_the_end_ = at_rest_ = false;
}

void LiveTool::take_the_end() noexcept {
  take(mechanism::LinkPart::Handle, places_of(linkage_).c_m);
  at_the_end_ = true;
}

void LiveTool::aim(const Vector2d& hand_m) noexcept {
  if (!hand_m.allFinite()) return;
  aim_m_ = {hand_m.x(), hand_m.y(), 0.0};
  at_rest_ = false;
}

void LiveTool::turn(double by_rad) noexcept {
  if (!at_the_end_) take_the_end();
  const mechanism::LinkagePlane& plane = linkage_.plane();
  const mechanism::FourBar& bar = linkage_.bar();
  const mechanism::Lever lever = mechanism::lever_of(bar);
  const double link3_rad = mechanism::crank_range(bar, linkage_.link3_rad()).nearest(linkage_.link3_rad() + by_rad);
  const double angle = link3_rad + lever.from_link3_rad;
  const Vector3d to_m = plane.pivot_a.m + (bar.l4_m + lever.length_m * std::cos(angle)) * plane.x.v +
                        lever.length_m * std::sin(angle) * plane.y.v;
  aim(to_m.head<2>());
}

double LiveTool::hand_N() const noexcept { return linkage_.hand_force({tissue_.wrench().force_N}).N.norm(); }

void LiveTool::note_punctures(double before_N) noexcept {
  for (std::size_t layer = 0; layer < tissue_.size() && punctured_ < punctures_.size(); ++layer) {
    const auto end = punctures_.begin() + static_cast<std::ptrdiff_t>(punctured_);
    const bool known =
        std::any_of(punctures_.begin(), end, [&](const Puncture& puncture) { return puncture.layer == layer; });
    if (known || !tissue_.punctured(layer)) continue;
    punctures_[punctured_++] = {.layer = layer, .depth_m = depth_m(), .before_N = before_N, .after_N = before_N};
    since_puncture_ = 0;
  }
  if (punctured_ == 0 || since_puncture_++ >= kAfterPuncture) return;
  double& after_N = punctures_[punctured_ - 1].after_N;
  after_N = std::min(after_N, hand_N());
}

void LiveTool::tick(const Vector3d& hand_m, bool pressed) noexcept {
  const double before_N = hand_N();
  linkage_.step({hand_m}, pressed, kTick_s);
  (void)tissue_.step({.tip_m = linkage_.tip().m, .axis = linkage_.needle_axis().v}, kTick_s);
  note_punctures(before_N);
  ++ticks_;
}

Force<HapticBase> LiveTool::feel(const Vector3d& hand_m, bool pressed) noexcept {
  tick(hand_m, pressed);
  return {linkage_.contact_force().N + linkage_.hand_force({tissue_.wrench().force_N}).N};
}

TracePoint LiveTool::trace_point() const noexcept {
  return {.depth_m = depth_m(), .needle_N = tissue_.wrench().force_N.norm(), .hand_N = hand_N()};
}

std::vector<TracePoint> LiveTool::step(double seconds) {
  const int count = std::max(1, static_cast<int>(std::lround(seconds / kTick_s)));
  const double most_m = kFastest_m_per_s * count * kTick_s;
  const Vector3d way_m = aim_m_ - hand_m_;
  const Vector3d each_m = way_m * std::min(1.0, most_m / std::max(way_m.norm(), 1e-12)) / count;
  const Vector3d before_N = tissue_.wrench().force_N;
  std::vector<TracePoint> trace;
  for (int i = 0; i < count; ++i) {
    hand_m_ += each_m;
    tick(hand_m_, true);
    if (ticks_ % kTraceEach == 0) trace.push_back(trace_point());
  }
  at_rest_ = way_m.norm() < 1e-9 && (tissue_.wrench().force_N - before_N).norm() < kAtRest_N;
  return trace;
}

std::vector<TracePoint> LiveTool::insert(double depth_m) {
  std::vector<TracePoint> trace;
  const auto add = [&trace](const std::vector<TracePoint>& more) {
    trace.insert(trace.end(), more.begin(), more.end());
  };
  constexpr double kPiece_s = 0.02;
  constexpr int kMostPieces = 500;  // 10 s; the tip of a long handle's needle is slow
  const double piece_rad = kInserts_m_per_s * kPiece_s / mechanism::lever_of(linkage_.bar()).length_m;
  for (int piece = 0; piece < kMostPieces && this->depth_m() < depth_m; ++piece) {
    const double before_rad = linkage_.link3_rad();
    turn(piece_rad);
    add(step(kPiece_s));
    if (std::abs(linkage_.link3_rad() - before_rad) < 1e-9) break;  // a dead point
  }
  add(step(kSettles_s));
  return trace;
}

LiveFrame LiveTool::frame() const noexcept {
  LiveFrame frame{.at = places_of(linkage_),
                  .link3_rad = linkage_.link3_rad(),
                  .open = linkage_.sine_of_links() > 0.0,
                  .at_dead_point = std::abs(linkage_.sine_of_links()) < kDeadPointSine,
                  .held = linkage_.held(),
                  .touched = linkage_.touched(),
                  .grasp_m = linkage_.proxy().m.head<2>(),
                  .needle_N = tissue_.wrench().force_N.head<2>(),
                  .hand_N = linkage_.hand_force({tissue_.wrench().force_N}).N.head<2>(),
                  .contact_N = linkage_.contact_force().N.head<2>(),
                  .punctures = punctures_,
                  .punctured = punctured_};
  for (std::size_t layer = 0; layer < frame.layers.size(); ++layer) frame.layers[layer] = tissue_.layer(layer).state;
  return frame;
}

}  // namespace telepalp::study
