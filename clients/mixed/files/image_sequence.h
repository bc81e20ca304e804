#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "clients/mixed/background/background.h"
#include "clients/mixed/calibration/device_fit.h"
#include "clients/mixed/compose/camouflage.h"
#include "clients/mixed/compose/misalignment.h"
#include "clients/mixed/device/device_mask.h"

namespace telepalp::mixed {

/// Headers of the tables of a folder of images. A pose is a translation and a rotation vector, in the world: of the
/// camera, and in device.csv of the device.
inline constexpr std::string_view kCameraHeader = "width,height,fx,fy,cx,cy";
inline constexpr std::string_view kBackgroundHeader = "image,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad";
inline constexpr std::string_view kDeviceHeader = "x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,deviation_m,turn_rad";
inline constexpr std::string_view kFramesHeader =
    "image,time_s,age_s,markers,fault,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad";
inline constexpr std::string_view kCouplingHeader =
    "time_s,device_x_m,device_y_m,device_z_m,tool_x_m,tool_y_m,tool_z_m";
inline constexpr std::string_view kClicksHeader =
    "place,ring_x_m,ring_y_m,ring_z_m,q1_rad,q2_rad,q3_rad,q4_rad,q5_rad,q6_rad";

/// One image with its camera's pose.
struct PosedImage {
  std::filesystem::path file;
  Transform<World, Eye> world_from_eye;
};

/// One image of the doctor's camera while the device is there.
struct LiveImage {
  PosedImage image;
  double time_s = 0.0;
  PictureTrust trust = {};
  std::vector<double> joints_rad;
};

/// Where the device stands, and how well that is known.
struct DevicePlace {
  Transform<World, HapticBase> world_from_haptic;
  double deviation_m = 0.0;  ///< standard deviation of the device's place on each axis
  double turn_rad = 0.0;     ///< standard deviation of its rotation about each axis
};

/// What a folder holds: camera.csv, background.csv, proxy.obj, device.csv, frames.csv, coupling.csv and the images
/// they name.
struct ImageSequence {
  Intrinsics lens;
  std::vector<PosedImage> background;
  Proxy proxy;
  DevicePlace device;
  std::vector<LiveImage> frames;
  std::vector<CouplingEnds> coupling;  ///< the station's states, by increasing time
};

/// Reads the folder's tables, not its images. Error, with file and line: a table is missing or has another header, a
/// row lacks a finite number, or the times of the states do not increase. Error: fewer than kLeastImages background
/// images.
[[nodiscard]] Result<ImageSequence> read_sequence(const std::filesystem::path& folder);

inline constexpr std::size_t kLeastImages = 2;

/// Reads an image. Error: it cannot be read, or its size is not that of the camera's intrinsics.
[[nodiscard]] Result<ColorImage> read_frame(const std::filesystem::path& file, const Intrinsics& lens);

/// Reads clicks.csv: one click a row.
[[nodiscard]] Result<std::vector<Click>> read_clicks(const std::filesystem::path& file);

/// The text of each table, header first. proxy_obj(): the text of a Wavefront OBJ file.
[[nodiscard]] std::string camera_table(const Intrinsics& lens);
[[nodiscard]] std::string background_table(const std::vector<PosedImage>& images);
[[nodiscard]] std::string device_table(const DevicePlace& device);
[[nodiscard]] std::string frames_table(const std::vector<LiveImage>& frames);
[[nodiscard]] std::string coupling_table(const std::vector<CouplingEnds>& states);
[[nodiscard]] std::string clicks_table(const std::vector<Click>& clicks);
[[nodiscard]] std::string proxy_obj(const Proxy& proxy);

}  // namespace telepalp::mixed
