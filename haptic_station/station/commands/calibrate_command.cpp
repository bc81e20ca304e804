#include "haptic_station/station/commands/calibrate_command.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "haptic_station/calibration/calibration_file.h"
#include "haptic_station/station/commands/calibrate_methods.h"
#include "haptic_station/station/rigs/rig_choice.h"
#include "proto/words/counted.h"
#include "support/program/patience.h"

namespace telepalp::station {
namespace {

program::Usage calibrate_usage() {
  return {
      .program = "telepalp-station calibrate",
      .purpose = "measures the transforms between tracker, camera and haptic device",
      .positional = "",
      .options =
          {{"out", "FILE", "calibration file to write; other transforms in the file are kept",
            "site.calibration.textproto"},
           {"pairs", "FILE",
            "for 'points', and for 'offset' without a device: CSV of places that both instruments measured; columns: "
            "place (its number), to_x_m, to_y_m, to_z_m (by the device), from_x_m, from_y_m, from_z_m (by the "
            "tracker or camera), in metres"},
           {"from", "tracker|camera", "for 'points': the instrument that measured from_x_m, from_y_m, from_z_m",
            "tracker"},
           {"device", "haply[:URL]|udp:HOST:PORT", "for 'offset': the haptic device", "haply"},
           {"tracker", "leap[:URL]", "for 'offset': the hand tracker", "leap"},
           {"seconds", "S", "for 'offset': how long the hand rests, in seconds", "3"},
           program::patience_option(
               "for 'offset': how many seconds the device, and then the tracker, may take to answer; 0: for ever", "3"),
           {"poses", "FILE",
            "for 'probe': CSV; a row is the hand's pose in the tracker's frame, then the probe's in the device's; "
            "columns: hand_x_m, hand_y_m, hand_z_m, hand_rx_rad, hand_ry_rad, hand_rz_rad (rotation vector), then "
            "probe_x_m and so on"},
           {"hand-at", "X,Y,Z,RX,RY,RZ",
            "for 'probe': pose of the hand in the probe's frame: metres, and a rotation vector in radians",
            "0,0,0,0,0,0"}},
      .example = "telepalp-station calibrate points --pairs pairs.csv --from camera --out site.calibration.textproto",
      .commands = {{"points", "", "find the pose of tracker or camera, from pairs of points (--pairs)"},
                   {"offset", "", "find the tracker's position by a hand that rests on the end-effector"},
                   {"probe", "", "find the tracker's pose, from poses of a hand on the device's probe (--poses)"}},
      .needs_command = true};
}

struct Method {
  std::string_view name;
  Result<void> (*check_options)(const program::Arguments&);
  Result<Measured> (*measure)(const program::Arguments&);
};
constexpr std::array kMethods{Method{"points", check_points, from_points}, Method{"offset", check_offset, from_offset},
                              Method{"probe", check_probe, from_probe}};

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

int calibrate(const program::Arguments& arguments) {
  const bool one = arguments.positional().size() == 1;
  const std::string how = one ? arguments.positional().front() : "";
  const auto method = std::ranges::find(kMethods, how, &Method::name);
  if (method == kMethods.end())
    return program::fail({.what = one ? "'" + how + "' is not points, offset or probe"
                                      : "none, or more than one, of points, offset and probe is given",
                          .where = "telepalp-station calibrate",
                          .fix = "give exactly one of them; see telepalp-station calibrate --help"},
                         program::kAskedWrongly);
  if (const Result<void> options = method->check_options(arguments); !options)
    return program::fail(options.error(), program::kAskedWrongly);
  const Result<Measured> measured = method->measure(arguments);
  if (!measured) return program::fail(measured.error());
  if (const Result<void> kept = keep(*measured, arguments.text("out")); !kept) return program::fail(kept.error());
  const msg::MeasuredTransform& m = measured->transform;
  std::printf(
      "transform haptic_from_%s from %s: residual mean %.2f mm, standard deviation %.2f mm, largest %.2f mm; "
      "written to %s\n",
      measured->of_camera ? "camera" : "tracker", counted(m.measurements(), "measurement", "measurements").c_str(),
      m.residual_mean_m() * 1e3, m.residual_deviation_m() * 1e3, m.residual_largest_m() * 1e3,
      arguments.text("out").c_str());
  return program::kDone;
}

}  // namespace

int calibrate_command(int argc, const char* const* argv) {
  return program::run_program(calibrate_usage(), argc, argv, calibrate);
}

}  // namespace telepalp::station
