#include "haptic_station/station/commands/calibrate_methods.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numbers>
#include <thread>

#include "haptic_station/calibration/calibration_file.h"
#include "haptic_station/calibration/offset_procedure.h"
#include "haptic_station/calibration/pair_file.h"
#include "haptic_station/calibration/pose_file.h"
#include "haptic_station/station/rigs/rig_choice.h"
#include "support/program/patience.h"

namespace telepalp::station {
namespace {

/// Records one touch for each hand sample of the tracker while the device answers.
std::vector<calibration::Touch> take_touches(ports::Device& device, tracking::LeapTracker& tracker, double seconds) {
  constexpr double kSilent_s = 0.05;
  std::vector<calibration::Touch> touches;
  const auto until = std::chrono::steady_clock::now() + from_seconds(seconds);
  while (std::chrono::steady_clock::now() < until) {
    device.apply({}, {}, 0.001);  // zero force; a device that only answers commands then continues to send its position
    const ports::DeviceReading reading = device.read();
    if (const auto palm = tracker.palm(); palm && reading.age_s < kSilent_s) touches.push_back({*palm, reading.at});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return touches;
}

/// The touches of a file of point pairs: `from` is the hand in the tracker's frame, `to` the end-effector in H.
Result<std::vector<calibration::Touch>> read_touches(const std::string& file) {
  const auto pairs = calibration::read_point_pairs(file);
  if (!pairs) return pairs.error();
  std::vector<calibration::Touch> touches;
  for (const calibration::PointPair& pair : *pairs) touches.push_back({{pair.from}, {pair.to}});
  return touches;
}

Result<double> seconds_of(const program::Arguments& arguments) { return arguments.number("seconds", 0.2, 60.0); }

Result<RigChoice> rig_of(const program::Arguments& arguments) {
  Result<RigChoice> choice = read_rig_choice(arguments.text("device"), arguments.text("tracker"));
  if (choice && (std::holds_alternative<Simulated>(choice->device) || !std::holds_alternative<Leap>(choice->tracker)))
    return Error{.what = "only a real device with a Leap tracker can be calibrated",
                 .where = "calibrate offset",
                 .fix = "give --device haply or --device udp:HOST:PORT, and --tracker leap"};
  return choice;
}

Result<Eigen::Isometry3d> hand_of(const program::Arguments& arguments) {
  const auto probe_from_hand = calibration::parse_pose(arguments.text("hand-at"));
  if (probe_from_hand) return *probe_from_hand;
  return Error{.what = "'" + arguments.text("hand-at") + "' is not a pose",
               .where = "--hand-at",
               .fix = "give x,y,z,rx,ry,rz: metres, and a rotation vector in radians"};
}

/// Touches measured now, with the rig that the arguments name.
Result<std::vector<calibration::Touch>> measure_touches(const program::Arguments& arguments) {
  const RigChoice choice = *rig_of(arguments);
  const program::Patience patience = *program::patience_of(arguments);
  const auto within = std::chrono::duration_cast<std::chrono::milliseconds>(patience.value_or(program::kForEver));
  Result<std::unique_ptr<ports::Device>> device = connect_device(choice.device, within);
  if (!device) return device.error();
  Result<std::unique_ptr<tracking::LeapTracker>> tracker = connect_leap(std::get<Leap>(choice.tracker), {}, within);
  if (!tracker) return tracker.error();
  std::fprintf(
      stderr,
      "rest the hand on the end-effector now, at the height at which the patient's skin will be, until the result "
      "is printed\n");
  return take_touches(**device, **tracker, *seconds_of(arguments));
}

}  // namespace

Result<void> check_points(const program::Arguments& arguments) {
  const std::string from = arguments.text("from");
  if (from != "tracker" && from != "camera")
    return Error{.what = "'" + from + "' is neither tracker nor camera", .where = "--from", .fix = "give one of them"};
  if (!arguments.has("pairs"))
    return Error{
        .what = "no file of point pairs is named", .where = "calibrate points", .fix = "give --pairs FILE.csv"};
  return {};
}

Result<void> check_offset(const program::Arguments& arguments) {
  if (arguments.has("pairs")) return {};
  if (const auto seconds = seconds_of(arguments); !seconds) return seconds.error();
  if (const auto rig = rig_of(arguments); !rig) return rig.error();
  if (const auto patience = program::patience_of(arguments); !patience) return patience.error();
  return {};
}

Result<void> check_probe(const program::Arguments& arguments) {
  if (!arguments.has("poses"))
    return Error{.what = "no file of poses is named", .where = "calibrate probe", .fix = "give --poses FILE.csv"};
  if (const auto hand = hand_of(arguments); !hand) return hand.error();
  return {};
}

Result<Measured> from_points(const program::Arguments& arguments) {
  const auto pairs = calibration::read_point_pairs(arguments.text("pairs"));
  if (!pairs) return pairs.error();
  const Result<calibration::Registration> fit = calibration::register_points(*pairs);
  if (!fit) return fit.error();
  std::printf("the point pair with the largest residual is pair %zu of the file\n", fit->residuals.worst() + 1);
  return Measured{
      calibration::measured(fit->to_from_from, fit->residuals, "points", std::chrono::system_clock::now(), fit->rank),
      arguments.text("from") == "camera"};
}

Result<Measured> from_offset(const program::Arguments& arguments) {
  const auto touches = arguments.has("pairs") ? read_touches(arguments.text("pairs")) : measure_touches(arguments);
  if (!touches) return touches.error();
  const Result<calibration::OffsetCalibration> fit = calibration::calibrate_offset(*touches);
  if (!fit) return fit.error();
  return Measured{
      calibration::measured(fit->haptic_from_tracker.iso, fit->residuals, "offset", std::chrono::system_clock::now()),
      false};
}

Result<Measured> from_probe(const program::Arguments& arguments) {
  const auto poses = calibration::read_hand_on_probe(arguments.text("poses"));
  if (!poses) return poses.error();
  const auto fit = calibration::calibrate_hand_on_probe(*poses, *hand_of(arguments));
  if (!fit) return fit.error();
  const double widest_rad = *std::max_element(fit->angles_rad.begin(), fit->angles_rad.end());
  std::printf("the tracker's rotation, computed from each pose alone, differs from the mean by at most %.2f degrees\n",
              widest_rad * 180.0 / std::numbers::pi);
  return Measured{calibration::measured(fit->haptic_from_tracker, fit->residuals, "hand on probe",
                                        std::chrono::system_clock::now()),
                  false};
}

}  // namespace telepalp::station
