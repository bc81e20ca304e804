#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "haptic_station/surface/build/surface_builder.h"
#include "tests/haptic_station/surface/analytic_surface.h"
#include "tests/haptic_station/surface/touch_scenario.h"

namespace telepalp::bench {

/// One way to make a surface, as a line of the table.
struct SurfaceVariant {
  std::string family;  ///< lattice, paper or cloud
  std::string name;    ///< name of a setting, or of the parameter that is changed
  std::string index;   ///< the neighbour index
  std::string support;
  std::string normals;
  surface::SurfaceSettings settings;
  bool named = false;        ///< true: a setting that users can select by this name
  int normal_neighbors = 0;  ///< for Cloud: replaces the builder's sixteen neighbours
};

/// Every named setting, and variants of each with one changed parameter.
[[nodiscard]] std::vector<SurfaceVariant> surface_variants();
/// One named setting for each method; the tables over noise, density and motion compare these.
[[nodiscard]] std::vector<SurfaceVariant> few_variants();

/// Turns a stream of frames into snapshots by one variant.
class VariantStream {
 public:
  explicit VariantStream(const SurfaceVariant& variant) : variant_(variant), builder_(variant.settings) {}
  [[nodiscard]] std::shared_ptr<const surface::SurfaceSnapshot> add(const DepthImage& depth, const Intrinsics& camera,
                                                                    double at_s, const surface::Reach& reach);

 private:
  SurfaceVariant variant_;
  surface::SurfaceBuilder builder_;
};

/// Error of a touched surface.
struct TouchError {
  double position_m = 0.0;  ///< RMS of the foot from the true surface
  double normal_deg = 0.0;  ///< RMS
  int places = 0;
  int touched = 0;        ///< number of points in contact at the end of the press
  double build_ms = 0.0;  ///< processor time of one snapshot, median
};

/// `text`, and the number of places without contact, if any: a cell of a table.
[[nodiscard]] std::string touched(const TouchError& error, const std::string& text);
/// A cell "position / normal": the position in metres times `scale`, the normal in degrees.
[[nodiscard]] std::string both(const TouchError& error, double scale);

/// Errors and costs of a variant.
struct SurfaceFigures {
  TouchError shapes;     ///< worst values over the shapes, without noise
  TouchError torso;      ///< 1 mm noise, still patient, after one second of frames
  double jump_um = 0.0;  ///< greatest change of f over 1 µm of travel
  double build_p50_ms = std::numeric_limits<double>::infinity();
  double build_p99_ms = std::numeric_limits<double>::infinity();
  double step_p50_us = std::numeric_limits<double>::infinity();
  double step_p99_us = std::numeric_limits<double>::infinity();

  /// Share of one core that live touch needs: 30 snapshots and 2000 steps a second.
  [[nodiscard]] double load() const noexcept { return 0.03 * build_p50_ms + 0.002 * step_p50_us; }
  /// True if the errors meet their requirements and every point was in contact.
  [[nodiscard]] bool right_enough() const noexcept;
};

inline constexpr double kShapeReach_um = 10.0;
inline constexpr double kShapeReach_deg = 0.2;
inline constexpr double kTorsoReach_mm = 0.25;
inline constexpr double kTorsoReach_deg = 1.5;
inline constexpr double kJumpReach_um = 2.0;
inline constexpr double kStepReach_us = 3.0;

/// A shape known by formula, rendered once for all variants.
struct RenderedShape {
  std::unique_ptr<testing::AnalyticSurface> truth;
  Intrinsics camera;
  DepthImage clean;
};
[[nodiscard]] std::vector<RenderedShape> rendered_shapes(double spacing_m);
/// The sphere of 80 mm among them.
[[nodiscard]] RenderedShape rendered_sphere(double spacing_m);

/// A torso and its frames at 30 Hz, rendered once for all variants.
struct FilmedTorso {
  capture::SyntheticPatient patient;
  testing::Spot spot;
  std::vector<RgbdFrame> frames;
};
/// One second of a still patient.
[[nodiscard]] Result<FilmedTorso> filmed_torso(double sigma_m);
/// One second of a still patient through a Kinect-like sensor at `above_m`: noise that grows with depth, disparity
/// steps, holes.
[[nodiscard]] Result<FilmedTorso> kinect_torso(double above_m,
                                               const Intrinsics& camera = capture::SyntheticSettings{}.camera);

[[nodiscard]] TouchError shape_touch_error(const RenderedShape& shape, const SurfaceVariant& variant);
/// As above, only at places whose normal is within 2 degrees of `slope_deg` off the camera's ray, all around the shape.
[[nodiscard]] TouchError slope_touch_error(const RenderedShape& sphere, const SurfaceVariant& variant,
                                           double slope_deg);
[[nodiscard]] TouchError torso_touch_error(const FilmedTorso& torso, const SurfaceVariant& variant);
[[nodiscard]] SurfaceFigures measure_surface(const SurfaceVariant& variant, const std::vector<RenderedShape>& shapes,
                                             const FilmedTorso& torso);

/// Measures the cost a second time, later, so that other programs during the first measurement do not decide about the
/// knee.
void measure_cost_again(const SurfaceVariant& variant, const FilmedTorso& torso, SurfaceFigures& figures);

}  // namespace telepalp::bench
