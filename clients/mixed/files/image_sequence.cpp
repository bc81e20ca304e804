#include "clients/mixed/files/image_sequence.h"

#include <string>

#include "clients/mixed/files/tables.h"
#include "proto/words/numbers/number_row.h"
#include "support/images/image_file.h"
#include "support/models/point_model.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

constexpr double kLatest_s = 1e9;  // 64 bits of nanoseconds overflow at 9.2e9 s

/// The text before the first comma. Text and comma are removed from `row`.
std::string take_name(std::string_view& row) {
  const std::size_t end = std::min(row.find(','), row.size());
  const std::string name(row.substr(0, end));
  row.remove_prefix(std::min(end + 1, row.size()));
  return name;
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Result<void> read_images(const fs::path& folder, ImageSequence& sequence) {
  return each_row(folder / "background.csv", kBackgroundHeader, [&](std::string_view row) {
    const fs::path file = folder / take_name(row);
    const auto n = number_row<6>(row);
    if (n) sequence.background.push_back({file, {pose_at(*n, 0)}});
    return n.has_value();
  });
}

Result<void> read_live(const fs::path& folder, ImageSequence& sequence) {
  return each_row(folder / "frames.csv", kFramesHeader, [&](std::string_view row) {
    LiveImage live;
    live.image.file = folder / take_name(row);
    const auto n = number_row<16>(row);
    if (!n) return false;
    live.time_s = (*n)[0];
    if (!(std::abs(live.time_s) < kLatest_s && std::abs((*n)[1]) < kLatest_s)) return false;
    live.trust = {.fault = (*n)[3] != 0.0, .markers_seen = (*n)[2] != 0.0, .image_age_s = (*n)[1]};
    live.image.world_from_eye.iso = pose_at(*n, 4);
    live.joints_rad.assign(n->begin() + 10, n->begin() + 16);
    sequence.frames.push_back(std::move(live));
    return true;
  });
}

Result<void> read_coupling(const fs::path& folder, ImageSequence& sequence) {
  return each_row(folder / "coupling.csv", kCouplingHeader, [&](std::string_view row) {
    const auto n = number_row<7>(row);
    if (!n || !(std::abs((*n)[0]) < kLatest_s)) return false;
    const CouplingEnds ends{SessionTime(from_seconds((*n)[0])), {vector_at(*n, 1)}, {vector_at(*n, 4)}};
    if (!sequence.coupling.empty() && ends.at <= sequence.coupling.back().at) return false;
    sequence.coupling.push_back(ends);
    return true;
  });
}

Result<void> read_camera(const fs::path& file, Intrinsics& lens) {
  const Result<void> read = each_row(file, kCameraHeader, [&](std::string_view row) {
    const auto n = number_row<6>(row);
    if (!n || !((*n)[0] >= 1 && (*n)[0] <= kMaxImageSide && (*n)[1] >= 1 && (*n)[1] <= kMaxImageSide)) return false;
    lens = {static_cast<int>((*n)[0]), static_cast<int>((*n)[1]), (*n)[2], (*n)[3], (*n)[4], (*n)[5]};
    return is_well_formed(lens);
  });
  if (read && lens.width == 0)
    return Error{
        .what = "it has no row", .where = file.string(), .fix = "calibrate the camera, and write its intrinsics"};
  return read;
}

}  // namespace

Result<ImageSequence> read_sequence(const fs::path& folder) {
  ImageSequence sequence;
  if (const auto read = read_camera(folder / "camera.csv", sequence.lens); !read) return read.error();
  if (const auto read = read_images(folder, sequence); !read) return read.error();
  if (sequence.background.size() < kLeastImages)
    return Error{.what = "the background has " + std::to_string(sequence.background.size()) +
                         " images, which show it from one side only",
                 .where = (folder / "background.csv").string(),
                 .fix = "take images of the desk without the device, from all places where the head will be"};
  const Result<void> device = each_row(folder / "device.csv", kDeviceHeader, [&](std::string_view row) {
    const auto n = number_row<8>(row);
    if (n) sequence.device = {{pose_at(*n, 0)}, (*n)[6], (*n)[7]};
    return n.has_value();
  });
  if (!device) return device.error();
  if (const auto read = read_live(folder, sequence); !read) return read.error();
  if (const auto read = read_coupling(folder, sequence); !read) return read.error();
  Result<models::PointModel> mesh = models::read_point_model(folder / "proxy.obj");
  if (!mesh) return mesh.error();
  for (const Eigen::Vector3f& vertex : mesh->points) sequence.proxy.vertices.emplace_back(vertex.cast<double>());
  sequence.proxy.triangles = std::move(mesh->triangles);
  return sequence;
}

Result<ColorImage> read_frame(const fs::path& file, const Intrinsics& lens) {
  Result<ColorImage> image = images::read_color_image(file);
  if (image && (image->width != lens.width || image->height != lens.height))
    return Error{.what = "the image is " + std::to_string(image->width) + " x " + std::to_string(image->height) +
                         " pixels, but the camera was calibrated at " + std::to_string(lens.width) + " x " +
                         std::to_string(lens.height),
                 .where = file.string(),
                 .fix = "calibrate at the size of the images, or record at the size of the calibration"};
  return image;
}

Result<std::vector<Click>> read_clicks(const fs::path& file) {
  std::vector<Click> clicks;
  const Result<void> read = each_row(file, kClicksHeader, [&](std::string_view row) {
    const auto n = number_row<10>(row);
    if (!n || !(std::abs((*n)[0]) < 1e6)) return false;
    clicks.push_back({static_cast<int>((*n)[0]), {vector_at(*n, 1)}, {n->begin() + 4, n->end()}});
    return true;
  });
  if (!read) return read.error();
  return clicks;
}

std::string camera_table(const Intrinsics& lens) {
  return std::string(kCameraHeader) + "\n" +
         cells({1.0 * lens.width, 1.0 * lens.height, lens.fx, lens.fy, lens.cx, lens.cy}) + "\n";
}

std::string background_table(const std::vector<PosedImage>& images) {
  std::string text = std::string(kBackgroundHeader) + "\n";
  for (const PosedImage& image : images)
    text += image.file.string() + "," + cells(pose_numbers(image.world_from_eye.iso)) + "\n";
  return text;
}

std::string device_table(const DevicePlace& device) {
  std::vector<double> row = pose_numbers(device.world_from_haptic.iso);
  append(row, {device.deviation_m, device.turn_rad});
  return std::string(kDeviceHeader) + "\n" + cells(row) + "\n";
}

std::string frames_table(const std::vector<LiveImage>& frames) {
  std::string text = std::string(kFramesHeader) + "\n";
  for (const LiveImage& live : frames) {
    std::vector<double> row{live.time_s, live.trust.image_age_s, live.trust.markers_seen ? 1.0 : 0.0,
                            live.trust.fault ? 1.0 : 0.0};
    append(row, pose_numbers(live.image.world_from_eye.iso));
    append(row, live.joints_rad);
    text += live.image.file.string() + "," + cells(row) + "\n";
  }
  return text;
}

std::string coupling_table(const std::vector<CouplingEnds>& states) {
  std::string text = std::string(kCouplingHeader) + "\n";
  for (const CouplingEnds& ends : states)
    text += cells({to_seconds(ends.at.time_since_epoch()), ends.device.m.x(), ends.device.m.y(), ends.device.m.z(),
                   ends.tool.m.x(), ends.tool.m.y(), ends.tool.m.z()}) +
            "\n";
  return text;
}

std::string clicks_table(const std::vector<Click>& clicks) {
  std::string text = std::string(kClicksHeader) + "\n";
  for (const Click& click : clicks) {
    std::vector<double> row{1.0 * click.place, click.ring.m.x(), click.ring.m.y(), click.ring.m.z()};
    append(row, click.readings_rad);
    text += cells(row) + "\n";
  }
  return text;
}

std::string proxy_obj(const Proxy& proxy) {
  std::string text;
  char line[96];
  for (const Vector3d& vertex : proxy.vertices) {
    std::snprintf(line, sizeof line, "v %.6g %.6g %.6g\n", vertex.x(), vertex.y(), vertex.z());
    text += line;
  }
  for (const auto& [a, b, c] : proxy.triangles) {
    std::snprintf(line, sizeof line, "f %u %u %u\n", a + 1, b + 1, c + 1);
    text += line;
  }
  return text;
}

}  // namespace telepalp::mixed
