#include "clients/mixed/files/image_sequence.h"

#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "proto/words/numbers/number_row.h"
#include "proto/words/rotation_vector.h"
#include "support/images/image_file.h"
#include "support/models/point_model.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

Result<std::string> read_table(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return Error{.what = "the file cannot be read",
                 .where = file.string(),
                 .fix = "name a folder that telepalp-mixed render wrote, or one with the same tables"};
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

/// Calls `row` with each line after the header. Error: the file cannot be read, its first line is not `header`, or
/// `row` returns false.
Result<void> each_row(const fs::path& file, std::string_view header, const std::function<bool(std::string_view)>& row) {
  const Result<std::string> text = read_table(file);
  if (!text) return text.error();
  std::string_view rest = *text;
  if (take_line(rest) != header)
    return Error{.what = "the first line is not this table's header",
                 .where = file.string() + ":1",
                 .fix = "write this line first: " + std::string(header)};
  for (int line = 2; !rest.empty(); ++line) {
    const std::string_view here = take_line(rest);
    if (!here.empty() && !row(here))
      return Error{.what = "the row does not fit the header, or a number in it is not finite",
                   .where = file.string() + ":" + std::to_string(line),
                   .fix = "correct the row; if it is the last one, the file was cut short"};
  }
  return {};
}

/// The text before the first comma. Text and comma are removed from `row`.
std::string take_name(std::string_view& row) {
  const std::size_t end = std::min(row.find(','), row.size());
  const std::string name(row.substr(0, end));
  row.remove_prefix(std::min(end + 1, row.size()));
  return name;
}

template <std::size_t N>
Vector3d three(const std::array<double, N>& n, std::size_t first) {
  return {n[first], n[first + 1], n[first + 2]};
}

template <std::size_t N>
Eigen::Isometry3d pose(const std::array<double, N>& n, std::size_t first) {
  return isometry_of(three(n, first + 3), three(n, first));
}

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    char one[40];
    std::snprintf(one, sizeof one, "%s%.9g", text.empty() ? "" : ",", value);
    text += one;
  }
  return text;
}

std::vector<double> pose_numbers(const Eigen::Isometry3d& pose) {
  const Eigen::AngleAxisd turn(pose.linear());
  const Vector3d at = pose.translation(), vector = turn.angle() * turn.axis();
  return {at.x(), at.y(), at.z(), vector.x(), vector.y(), vector.z()};
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Result<void> read_images(const fs::path& folder, ImageSequence& sequence) {
  return each_row(folder / "background.csv", kBackgroundHeader, [&](std::string_view row) {
    const fs::path file = folder / take_name(row);
    const auto n = number_row<6>(row);
    if (n) sequence.background.push_back({file, {pose(*n, 0)}});
    return n.has_value();
  });
}

Result<void> read_live(const fs::path& folder, ImageSequence& sequence) {
  return each_row(folder / "frames.csv", kFramesHeader, [&](std::string_view row) {
    LiveImage live;
    live.image.file = folder / take_name(row);
    const auto n = number_row<19>(row);
    if (!n) return false;
    live.time_s = (*n)[0];
    live.trust = {.fault = (*n)[3] != 0.0, .markers_seen = (*n)[2] != 0.0, .image_age_s = (*n)[1]};
    live.image.world_from_eye.iso = pose(*n, 4);
    live.joints_rad.assign(n->begin() + 10, n->begin() + 16);
    live.tool_minus_device.v = three(*n, 16);
    sequence.frames.push_back(std::move(live));
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
    if (n) sequence.device = {{pose(*n, 0)}, (*n)[6], (*n)[7]};
    return n.has_value();
  });
  if (!device) return device.error();
  if (const auto read = read_live(folder, sequence); !read) return read.error();
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
    clicks.push_back({static_cast<int>((*n)[0]), {three(*n, 1)}, {n->begin() + 4, n->end()}});
    return true;
  });
  if (!read) return read.error();
  return clicks;
}

std::string camera_table(const Intrinsics& lens) {
  return std::string(kCameraHeader) + "\n" +
         numbers({1.0 * lens.width, 1.0 * lens.height, lens.fx, lens.fy, lens.cx, lens.cy}) + "\n";
}

std::string background_table(const std::vector<PosedImage>& images) {
  std::string text = std::string(kBackgroundHeader) + "\n";
  for (const PosedImage& image : images)
    text += image.file.string() + "," + numbers(pose_numbers(image.world_from_eye.iso)) + "\n";
  return text;
}

std::string device_table(const DevicePlace& device) {
  std::vector<double> row = pose_numbers(device.world_from_haptic.iso);
  append(row, {device.deviation_m, device.turn_rad});
  return std::string(kDeviceHeader) + "\n" + numbers(row) + "\n";
}

std::string frames_table(const std::vector<LiveImage>& frames) {
  std::string text = std::string(kFramesHeader) + "\n";
  for (const LiveImage& live : frames) {
    std::vector<double> row{live.time_s, live.trust.image_age_s, live.trust.markers_seen ? 1.0 : 0.0,
                            live.trust.fault ? 1.0 : 0.0};
    append(row, pose_numbers(live.image.world_from_eye.iso));
    append(row, live.joints_rad);
    append(row, {live.tool_minus_device.v.x(), live.tool_minus_device.v.y(), live.tool_minus_device.v.z()});
    text += live.image.file.string() + "," + numbers(row) + "\n";
  }
  return text;
}

std::string clicks_table(const std::vector<Click>& clicks) {
  std::string text = std::string(kClicksHeader) + "\n";
  for (const Click& click : clicks) {
    std::vector<double> row{1.0 * click.place, click.ring.m.x(), click.ring.m.y(), click.ring.m.z()};
    append(row, click.readings_rad);
    text += numbers(row) + "\n";
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
