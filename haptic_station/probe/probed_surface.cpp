#include "haptic_station/probe/probed_surface.h"

#include <png.h>

#include <cmath>
#include <cstdio>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/cloud/static_model.h"
#include "haptic_station/surface/grid/grid_snapshot.h"
#include "haptic_station/surface/paper/paper_surface.h"
#include "messages/camera.pb.h"
#include "support/models/png_bounds.h"
#include "support/program/text/text_format.h"

namespace telepalp::probe {
namespace {

using models::PointModel;
using surface::DepthField;
using surface::Method;
using surface::SurfaceSettings;

constexpr std::size_t kPaperSamples = 16'000;

/// Slope and offset of pixel against x/z along one axis by least squares, and the RMS residual [px].
struct AxisFit {
  double focal_px = 0.0;
  double centre_px = 0.0;
  double residual_px = 1e9;
};

AxisFit fit_axis(const PointModel& cloud, bool rows) {
  double n = 0.0, sx = 0.0, sp = 0.0, sxx = 0.0, sxp = 0.0, spp = 0.0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3d at = cloud.points[i].cast<double>();
    if (!at.allFinite() || !(at.z() > 0.0)) continue;
    const auto width = static_cast<std::size_t>(cloud.width);
    const auto pixel = static_cast<double>(rows ? i / width : i % width);
    const double x = (rows ? at.y() : at.x()) / at.z();
    n += 1.0;
    sx += x;
    sp += pixel;
    sxx += x * x;
    sxp += x * pixel;
    spp += pixel * pixel;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 100.0 || !(spread > 0.0)) return {};
  AxisFit fit;
  fit.focal_px = (n * sxp - sx * sp) / spread;
  fit.centre_px = (sp - fit.focal_px * sx) / n;
  const double square = spp - fit.centre_px * sp - fit.focal_px * sxp;
  fit.residual_px = std::sqrt(std::max(0.0, square / n));
  return fit;
}

/// The pinhole camera of an organised cloud; nullopt when no pinhole camera fits it.
std::optional<Intrinsics> camera_of(const PointModel& cloud) {
  if (cloud.width <= 1) return std::nullopt;
  const AxisFit across = fit_axis(cloud, false);
  const AxisFit down = fit_axis(cloud, true);
  constexpr double kMostResidual_px = 0.5;
  const auto height = static_cast<int>(cloud.points.size() / static_cast<std::size_t>(cloud.width));
  const Intrinsics camera{.width = cloud.width,
                          .height = height,
                          .fx = across.focal_px,
                          .fy = down.focal_px,
                          .cx = across.centre_px,
                          .cy = down.centre_px};
  if (across.residual_px > kMostResidual_px || down.residual_px > kMostResidual_px || !is_well_formed(camera))
    return std::nullopt;
  return camera;
}

DepthField depth_of(const PointModel& cloud, const Intrinsics& camera) {
  DepthField depth{.width = camera.width, .height = camera.height, .z_m = {}, .weight = {}};
  for (const Eigen::Vector3f& at : cloud.points) depth.z_m.push_back(at.allFinite() && at.z() > 0.0F ? at.z() : 0.0F);
  return depth;
}

/// A snapshot that never becomes stale, because no newer frame follows a file.
std::shared_ptr<const surface::SurfaceSnapshot> still(const DepthField& depth, const Intrinsics& camera,
                                                      const SurfaceSettings& settings) {
  auto snapshot = std::make_shared<surface::GridSnapshot>(depth, camera, std::nullopt, settings);
  snapshot->motion.ages = false;
  return snapshot;
}

/// Finite points, evenly picked: fewer than 40 000.
std::vector<Eigen::Vector3d> some_of(const std::vector<Eigen::Vector3f>& points) {
  constexpr std::size_t kSome = 20'000;
  std::vector<Eigen::Vector3d> some;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kSome);
  for (std::size_t i = stride / 2; i < points.size(); i += stride)
    if (points[i].allFinite()) some.push_back(points[i].cast<double>());
  return some;
}

std::vector<Eigen::Vector3f> positions(const std::vector<surface::CloudPoint>& cloud,
                                       const Eigen::Vector3d& origin_m = Eigen::Vector3d::Zero()) {
  std::vector<Eigen::Vector3f> at;
  at.reserve(cloud.size());
  for (const surface::CloudPoint& point : cloud) at.push_back((origin_m + point.at_m.cast<double>()).cast<float>());
  return at;
}

std::vector<Eigen::Vector3f> positions(const surface::CloudSnapshot& model) {
  return positions(model.cloud(), model.shape().origin_m);
}

Error with_place(Error error, const std::filesystem::path& file) {
  error.where = file.string();
  return error;
}

struct PngReader {
  std::FILE* file = nullptr;
  png_structp png = nullptr;
  png_infop info = nullptr;
  models::PngBounds bounds;

  explicit PngReader(const std::filesystem::path& path) : file(std::fopen(path.c_str(), "rb")) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() {
    png_destroy_read_struct(&png, &info, nullptr);
    if (file != nullptr) std::fclose(file);
  }
};

void take_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
  models::check_png_bytes(png, reader->info, reader->bounds, count);
  if (std::fread(to, 1, count, reader->file) != count) png_error(png, "the file ends too early, or cannot be read");
}

/// libpng calls longjmp when a file is damaged. Each function that may be left this way therefore has no C++ objects.
bool read_header(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_read_fn(reader.png, &reader, take_bytes);
  models::bound_png(reader.png, kMaxImageSide);
  png_read_info(reader.png, reader.info);
  png_set_swap(reader.png);
  return png_get_bit_depth(reader.png, reader.info) == 16 &&
         png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_GRAY;
}

bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  return true;
}

/// Reads 16-bit grey samples unchanged. libpng's simplified interface would apply a gamma correction.
Result<DepthImage> read_depth_png(const std::filesystem::path& path, double unit_m) {
  const auto fail = [&](const std::string& what) {
    return Error{
        .what = what, .where = path.string(), .fix = "give a whole 16-bit grey PNG of at most 4096 pixels a side"};
  };
  PngReader reader(path);
  if (reader.file == nullptr || reader.info == nullptr)
    return Error{.what = "cannot be opened", .where = path.string(), .fix = "check the path and your permissions"};
  if (!read_header(reader)) return fail("is not a 16-bit grey PNG, is damaged, or has a side of more than 4096 pixels");
  DepthImage image{.width = static_cast<int>(png_get_image_width(reader.png, reader.info)),
                   .height = static_cast<int>(png_get_image_height(reader.png, reader.info)),
                   .unit_m = unit_m,
                   .samples = {}};
  image.samples.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(image.height));
  for (int row = 0; row < image.height; ++row)
    rows.push_back(reinterpret_cast<png_bytep>(&image.samples[static_cast<std::size_t>(row * image.width)]));
  if (!read_rows(reader.png, rows.data())) return fail("is damaged or incomplete");
  return image;
}

}  // namespace

Result<ProbedSurface> open_cloud(const std::filesystem::path& file, const CloudOptions& options,
                                 const SurfaceSettings& settings) {
  Result<PointModel> read = models::read_point_model(file);
  if (!read) return read.error();
  PointModel& model = *read;
  for (Eigen::Vector3f& at : model.points) at = (options.unit_m * at.cast<double>()).cast<float>();
  if (const std::optional<Error> unit = models::unit_error(model, options.unit_m)) return with_place(*unit, file);
  if (!surface::spans_a_surface(model)) return with_place(surface::no_surface(), file);
  const std::optional<Intrinsics> camera = camera_of(model);
  if (camera && settings.method == Method::Grid)
    return ProbedSurface{still(depth_of(model, *camera), *camera, settings), "", some_of(model.points)};
  if (settings.method == Method::Paper) {
    if (!model.triangles.empty())
      model.points =
          positions(surface::poisson_disk_samples(model, options.samples > 0 ? options.samples : kPaperSamples, 1));
    auto paper = std::make_shared<surface::PaperSurface>(surface::IndexedPoints{model.points, model.width}, settings);
    paper->motion.ages = false;
    return ProbedSurface{std::move(paper),
                         "all normals are turned towards the origin of the file's frame, where the surface setting "
                         "'paper' assumes the camera",
                         some_of(model.points)};
  }
  surface::StaticModelSettings how{
      .samples = options.samples,
      .spacing_m = options.spacing_m,
      .anyway = options.anyway,
      .flip_normals = options.flip_normals,
      .on_progress = [](const std::string& step) { std::fprintf(stderr, "%s\n", step.c_str()); }};
  if (settings.method == Method::Cloud) how.support_m = settings.radius_m;
  const Result<surface::StaticModel> made = surface::make_static_model(model, how);
  if (!made) return with_place(made.error(), file);
  const std::string between = made->remarks.empty() || made->sampling.empty() ? "" : "; ";
  return ProbedSurface{made->snapshot, made->remarks + between + made->sampling, some_of(positions(*made->snapshot))};
}

Result<ProbedSurface> open_depth(const std::filesystem::path& png, const std::filesystem::path& camera_file,
                                 const SurfaceSettings& settings) {
  msg::CameraFile camera;
  if (const auto read = program::read_text_format(camera_file, camera); !read) return read.error();
  const msg::CameraFile::Pinhole& pinhole = camera.depth();
  const Intrinsics intrinsics{.width = static_cast<int>(pinhole.width()),
                              .height = static_cast<int>(pinhole.height()),
                              .fx = pinhole.fx(),
                              .fy = pinhole.fy(),
                              .cx = pinhole.cx(),
                              .cy = pinhole.cy()};
  const double unit_m = camera.depth_unit_m() > 0.0 ? camera.depth_unit_m() : 0.001;
  Result<DepthImage> image = read_depth_png(png, unit_m);
  if (!image) return image.error();
  if (!is_well_formed(intrinsics) || intrinsics.width != image->width || intrinsics.height != image->height)
    return Error{.what = "does not describe the camera of " + png.string() + ", which has " +
                         std::to_string(image->width) + " x " + std::to_string(image->height) + " pixels",
                 .where = camera_file.string(),
                 .fix = "give depth { width: … height: … fx: … fy: … cx: … cy: … } of the camera that took the PNG"};
  if (camera.ignore_above() > 0)
    for (std::uint16_t& sample : image->samples)
      if (sample > camera.ignore_above()) sample = 0;
  const DepthField depth = surface::to_depth_field(*image);
  const std::vector<Eigen::Vector3f> points = surface::to_points(depth, intrinsics).at_m;
  if (settings.method == Method::Grid) return ProbedSurface{still(depth, intrinsics, settings), "", some_of(points)};
  return ProbedSurface{surface::build_snapshot(*image, intrinsics, SessionTime{}, std::nullopt, settings), "",
                       some_of(points)};
}

}  // namespace telepalp::probe
