#include "tools/study/experiments/push_task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace telepalp::study {
namespace {

using Eigen::Vector2d;

constexpr double kStep_s = 0.01;
constexpr double kStick_m = 0.005;  // radius of the stick's end
constexpr double kRolls_s = 0.15;   // a ball that is no longer pushed comes to rest within about this time
constexpr double kSteady_s = 0.2;   // correlation time of the hand's unsteadiness
constexpr double kWall_m = 0.05;    // S3's transparent wall keeps the ball this close to the pockets' rectangle
constexpr std::size_t kSeen = 100;  // positions of the ball that are kept: those of the last second
constexpr double kPractice = 1.2;   // after so many moves the slowness of the first one has fallen to 1/e

/// The ball's intended path: straight to the pocket, or around a circle about the device.
class Way {
 public:
  Way(const PushDesk& desk, double clear_m, bool to_blue) noexcept
      : middle_(0.5 * desk.pockets_m, desk.beside_m), clear_m_(clear_m), goal_(to_blue ? desk.pockets_m : 0.0, 0.0) {}

  /// Unit direction in which a ball at `from` should move. While the straight line to the goal crosses the circle, the
  /// ball moves along the circle's tangent, on the device's near side.
  [[nodiscard]] Vector2d direction(const Vector2d& from) const noexcept {
    const Vector2d to_goal = goal_ - from;
    if (to_goal.norm() < 1e-9) return Vector2d::UnitX();
    const Vector2d along = to_goal.normalized();
    const Vector2d to_middle = middle_ - from;
    const double ahead_m = to_middle.dot(along);
    const double off_m = std::abs(along.x() * to_middle.y() - along.y() * to_middle.x());
    const double away_m = to_middle.norm();
    if (ahead_m <= 0.0 || ahead_m > to_goal.norm() || off_m >= clear_m_ || away_m < 1e-9) return along;
    const double angle = away_m > clear_m_ ? std::asin(clear_m_ / away_m) : 0.5 * std::numbers::pi;
    // The device stands at positive y, so the near side is reached by turning towards negative y.
    const double turn = to_goal.x() > 0.0 ? -angle : angle;
    const Vector2d straight = to_middle / away_m;
    return {std::cos(turn) * straight.x() - std::sin(turn) * straight.y(),
            std::sin(turn) * straight.x() + std::cos(turn) * straight.y()};
  }
  [[nodiscard]] const Vector2d& goal() const noexcept { return goal_; }

 private:
  Vector2d middle_;
  double clear_m_;
  Vector2d goal_;
};

/// Where the stick goes next to push a ball at `ball` along `along`: against the ball from behind, or around the ball
/// to get behind it.
Vector2d stick_goal(const Vector2d& stick, const Vector2d& ball, const Vector2d& along, double touch_m) noexcept {
  const Vector2d from_ball = stick - ball;
  const double behind_m = -from_ball.dot(along);
  const Vector2d across(-along.y(), along.x());
  const double side_m = from_ball.dot(across);
  if (behind_m > 0.5 * touch_m && std::abs(side_m) < 0.6 * touch_m) return ball - along * (touch_m - 0.004);
  const double room_m = touch_m + 0.012;
  if (behind_m > 0.0) return ball - along * room_m;
  return ball - along * room_m + across * std::copysign(room_m, side_m);
}

/// Radius of the circle about the device that the person keeps the ball out of [m]; 0: the device is not in sight.
double clear_of(const Pusher& person, const PushDesk& desk, bool sees_device) noexcept {
  if (!sees_device) return 0.0;
  return person.heeds * (desk.body_m + person.clearance_m);
}

}  // namespace

Push push_ball(const Pusher& person, const PushDesk& desk, bool to_blue, int move, bool sees_device, Pushed& at,
               device::Random& random) noexcept {
  const Way way(desk, clear_of(person, desk, sees_device), to_blue);
  const double touch_m = desk.ball_m + kStick_m;
  const double speed = person.hand_m_per_s * (1.0 - person.slow_at_first * std::exp(-move / kPractice));
  const auto late = std::min<std::size_t>(kSeen - 1, static_cast<std::size_t>(person.reaction_s / kStep_s));
  std::array<Vector2d, kSeen> seen;  // the ball as seen from the stick
  seen.fill(at.ball_m - at.stick_m);
  Vector2d rolls = Vector2d::Zero(), unsteady = Vector2d::Zero();
  Push out;
  for (std::size_t step = 0; out.seconds < kLongestPush_s; ++step) {
    out.seconds += kStep_s;
    seen[step % kSeen] = at.ball_m - at.stick_m;
    // The person feels where the hand is, but sees the ball relative to it only after the reaction time.
    const Vector2d ball = at.stick_m + seen[(step + kSeen - late) % kSeen];
    const Vector2d wanted = stick_goal(at.stick_m, ball, way.direction(ball), touch_m) - at.stick_m;
    const Vector2d kick(random.normal(), random.normal());
    unsteady += kStep_s / kSteady_s * -unsteady + person.unsteady * speed * std::sqrt(2.0 * kStep_s / kSteady_s) * kick;
    const Vector2d velocity = wanted.normalized() * std::min(speed, wanted.norm() / 0.05) + unsteady;
    at.stick_m += kStep_s * velocity;
    out.path_m += kStep_s * velocity.norm();
    rolls *= 1.0 - kStep_s / kRolls_s;
    at.ball_m += kStep_s * rolls;
    const Vector2d apart = at.ball_m - at.stick_m;
    if (apart.norm() < touch_m) {
      const Vector2d out_of = apart.norm() > 1e-9 ? Vector2d(apart.normalized()) : Vector2d(Vector2d::UnitX());
      at.ball_m = at.stick_m + touch_m * out_of;
      rolls = std::max(0.0, velocity.dot(out_of)) * out_of;
    }
    const Vector2d most(desk.pockets_m + kWall_m, 2.0 * kWall_m);
    at.ball_m = at.ball_m.cwiseMax(Vector2d(-kWall_m, -2.0 * kWall_m)).cwiseMin(most);
    if ((at.ball_m - way.goal()).norm() < desk.pocket_m) {
      at.ball_m = way.goal();
      out.done = true;
      break;
    }
  }
  return out;
}

}  // namespace telepalp::study
