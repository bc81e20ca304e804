#include "haptic_station/station/calibrate_command.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "haptic_station/calibration/calibration_file.h"
#include "haptic_station/calibration/offset_procedure.h"
#include "haptic_station/calibration/pair_file.h"
#include "haptic_station/station/rig_choice.h"
#include "proto/program/options.h"

namespace telepalp::station {
namespace {

program::Usage usage() {
  return {
      .program = "telepalp-station calibrate",
      .purpose =
          "measures where tracker, camera and haptic device stand to one another: 'points' from pairs of "
          "points in a file, 'offset' from the hand resting on the end-effector",
      .positional = "points|offset",
      .options = {{"out", "FILE", "the calibration; what else is in it stays", "site.calibration.textproto"},
                  {"pairs", "FILE", "points: CSV, header place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m"},
                  {"from", "tracker|camera", "points: the frame of the from columns; to is the haptic device's",
                   "tracker"},
                  {"device", kDeviceWords, "offset: the haptic device", "haply"},
                  {"tracker", "leap[:URL]", "offset: the hand tracker", "leap"},
                  {"seconds", "S", "offset: how long the hand rests", "3"}},
      .example = "telepalp-station calibrate points --pairs pairs.csv --from camera --out site.calibration.textproto"};
}

/// One transform, measured, and where in the file it belongs.
struct Measured {
  msg::MeasuredTransform transform;
  bool of_camera = false;
};

Result<Measured> from_points(const program::Arguments& arguments) {
  const std::string from = arguments.text("from");
  if (from != "tracker" && from != "camera")
    return Error{.what = "'" + from + "' is neither tracker nor camera", .where = "--from", .fix = "give one of them"};
  if (!arguments.has("pairs"))
    return Error{.what = "no pairs", .where = "calibrate points", .fix = "name a CSV file by --pairs"};
  const auto pairs = calibration::read_point_pairs(arguments.text("pairs"));
  if (!pairs) return pairs.error();
  const Result<calibration::Registration> fit = calibration::register_points(*pairs);
  if (!fit) return fit.error();
  std::printf("worst is pair %zu\n", fit->residuals.worst() + 1);
  return Measured{
      calibration::measured(fit->to_from_from, fit->residuals, "points", std::chrono::system_clock::now(), fit->rank),
      from == "camera"};
}

/// A touch at each hand that the tracker sees while the device answers.
std::vector<calibration::Touch> take_touches(device::Device& device, tracking::LeapTracker& tracker, double seconds) {
  constexpr double kSilent_s = 0.05;
  std::vector<calibration::Touch> touches;
  const auto until = std::chrono::steady_clock::now() + from_seconds(seconds);
  while (std::chrono::steady_clock::now() < until) {
    device.apply({}, {}, 0.001);  // no force; devices that answer each command go on telling where they are
    const DeviceReading reading = device.read();
    if (const auto palm = tracker.palm(); palm && reading.age_s < kSilent_s) touches.push_back({*palm, reading.at});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return touches;
}

Result<Measured> from_offset(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 0.2, 60.0);
  if (!seconds) return seconds.error();
  const Result<RigChoice> choice = read_rig_choice(arguments.text("device"), arguments.text("tracker"));
  if (!choice) return choice.error();
  const auto* leap = std::get_if<Leap>(&choice->tracker);
  if (std::holds_alternative<Simulated>(choice->device) || leap == nullptr)
    return Error{.what = "only a real device under a real tracker can be calibrated",
                 .where = "calibrate offset",
                 .fix = "give --device haply or udp:HOST:PORT, and --tracker leap"};
  Result<std::unique_ptr<device::Device>> device = connect_device(choice->device, {});
  if (!device) return device.error();
  Result<std::unique_ptr<tracking::LeapTracker>> tracker = connect_leap(*leap, {});
  if (!tracker) return tracker.error();
  std::fprintf(stderr, "rest the hand on the end-effector, where the skin is to be met\n");
  const Result<calibration::OffsetCalibration> fit =
      calibration::calibrate_offset(take_touches(**device, **tracker, *seconds));
  if (!fit) return fit.error();
  return Measured{
      calibration::measured(fit->haptic_from_tracker.iso, fit->residuals, "offset", std::chrono::system_clock::now()),
      false};
}

Result<void> keep(const Measured& measured, const std::filesystem::path& file) {
  msg::Calibration calibration;
  if (std::filesystem::exists(file)) {
    Result<msg::Calibration> before = calibration::read_calibration(file);
    if (!before) return before.error();
    calibration = std::move(before).value();
  }
  *(measured.of_camera ? calibration.mutable_haptic_from_camera() : calibration.mutable_haptic_from_tracker()) =
      measured.transform;
  return calibration::write_calibration(file, calibration);
}

}  // namespace

int calibrate_command(int argc, const char* const* argv) {
  const auto read = program::read_arguments(usage(), argc, argv);
  if (!read) return program::fail(read.error(), program::kAskedWrongly);
  if (!*read) return program::kDone;
  const program::Arguments& arguments = **read;
  const std::string how = arguments.positional().size() == 1 ? arguments.positional().front() : "";
  if (how != "points" && how != "offset")
    return program::fail({.what = "'" + how + "' is neither points nor offset",
                          .where = "telepalp-station calibrate",
                          .fix = "telepalp-station calibrate --help"},
                         program::kAskedWrongly);
  const Result<Measured> measured = how == "points" ? from_points(arguments) : from_offset(arguments);
  if (!measured) return program::fail(measured.error());
  if (const Result<void> kept = keep(*measured, arguments.text("out")); !kept) return program::fail(kept.error());
  const msg::MeasuredTransform& m = measured->transform;
  std::printf("haptic_from_%s from %u measurements: residual %.2f +- %.2f mm, at most %.2f mm; kept in %s\n",
              measured->of_camera ? "camera" : "tracker", m.measurements(), m.residual_mean_m() * 1e3,
              m.residual_deviation_m() * 1e3, m.residual_largest_m() * 1e3, arguments.text("out").c_str());
  return program::kDone;
}

}  // namespace telepalp::station
