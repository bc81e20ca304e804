// Offline touch of valid and of damaged files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "haptic_station/probe/palpation_path.h"
#include "haptic_station/probe/probed_surface.h"
#include "haptic_station/probe/touch_run.h"
#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "support/images/image_file.h"
#include "support/models/point_model.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::probe {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

const fs::path kData = TELEPALP_SOURCE_DIR "/tests/data";

std::string pcd(const std::vector<Vector3d>& points, int width = 0) {
  const auto count = static_cast<int>(points.size());
  std::ostringstream text;
  text << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << (width > 0 ? width : count)
       << "\nHEIGHT " << (width > 0 ? count / width : 1) << "\nPOINTS " << count << "\nDATA ascii\n";
  for (const Vector3d& at : points) {
    for (const double value : at) text << (std::isnan(value) ? "nan" : std::to_string(value)) << ' ';
    text << '\n';
  }
  return text.str();
}

/// 61 × 61 points 2 mm apart at 0.8 m.
std::vector<Vector3d> flat(double scale = 1.0) {
  std::vector<Vector3d> points;
  for (int j = -30; j <= 30; ++j)
    for (int i = -30; i <= 30; ++i) points.emplace_back(scale * 0.002 * i, scale * 0.002 * j, scale * 0.8);
  return points;
}

/// A cube of 0.2 m around (0, 0, 0.9), faces outwards.
struct Cube {
  bool inverted = false;
  bool without_lid = false;  ///< the side towards the origin
  int normals = 0;           ///< 1: outwards at the corners, −1: inwards
};

std::string obj(const Cube& cube) {
  std::ostringstream text;
  for (int corner = 0; corner < 8; ++corner)
    text << "v " << ((corner & 1) != 0 ? 0.1 : -0.1) << ' ' << ((corner & 2) != 0 ? 0.1 : -0.1) << ' '
         << ((corner & 4) != 0 ? 1.0 : 0.8) << '\n';
  for (int corner = 0; corner < 8 && cube.normals != 0; ++corner)
    text << "vn " << cube.normals * ((corner & 1) != 0 ? 1 : -1) << ' ' << cube.normals * ((corner & 2) != 0 ? 1 : -1)
         << ' ' << cube.normals * ((corner & 4) != 0 ? 1 : -1) << '\n';
  const int sides[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  for (int side = cube.without_lid ? 1 : 0; side < 6; ++side) {
    text << 'f';
    for (int k = 0; k < 4; ++k) {
      const int corner = sides[side][cube.inverted ? 3 - k : k];
      text << ' ' << corner;
      if (cube.normals != 0) text << "//" << corner;
    }
    text << '\n';
  }
  return text.str();
}

/// A path from the camera to a surface at 0.8 m, and 10 mm into it.
std::vector<Waypoint> straight_in() {
  std::vector<Waypoint> path;
  for (int i = 0; i <= 600; ++i) path.push_back({0.001 * i, {0.0005, 0.0003, 0.75 + 0.0001 * i}});
  return path;
}

void expect_finite(const std::vector<Felt>& felt) {
  for (const Felt& one : felt) {
    ASSERT_TRUE(one.force_N.allFinite() && one.proxy_m.allFinite() && one.normal.allFinite()) << one.t_s;
    ASSERT_LT(one.force_N.norm(), 60.0) << one.t_s;
  }
}

class Probe : public ::testing::Test {
 protected:
  fs::path file(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
    return folder_.path() / name;
  }
  support::TemporaryFolder folder_;
};

struct BadCloud {
  const char* name;
  std::string file;
  std::string text;
  const char* says;  ///< in the error
};

std::vector<BadCloud> bad_clouds() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vector3d> line;
  for (int i = 0; i < 100; ++i) line.emplace_back(0.001 * i, 0.002 * i, 0.8);
  const Vector3d nowhere(nan, nan, nan);
  return {{"empty file", "a.pcd", "", "DATA line"},
          {"no points", "a.pcd", pcd({}), "has no surface"},
          {"all NaN", "a.pcd", pcd(std::vector<Vector3d>(500, nowhere)), "has no surface"},
          {"all NaN, organised", "a.pcd", pcd(std::vector<Vector3d>(500, nowhere), 25), "has no surface"},
          {"one point", "a.pcd", pcd({{0, 0, 0.8}}), "has no surface"},
          {"one point, many times", "a.pcd", pcd(std::vector<Vector3d>(500, {0.1, 0, 0.8})), "has no surface"},
          {"on a line", "a.pcd", pcd(line), "has no surface"},
          {"millimetres", "a.pcd", pcd(flat(1000.0)), "unit_m=0.001,"},
          {"millimetres, organised", "a.pcd", pcd(flat(1000.0), 61), "unit_m=0.001,"},
          {"mesh of no area", "a.obj", "v 0 0 1\nv 0 0 1\nv 0 0 1\nf 1 2 3\n", "has no surface"},
          {"mesh without vertices", "a.obj", "g body\n", "has no vertices"},
          {"mesh that names what is not there", "a.obj", "v 0 0 1\nf 1 2 3\n", "line 2"},
          {"face that names a normal that is not there", "a.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1//1 2//1 3//1\n",
           "line 4"},
          {"unknown kind", "a.stl", "solid\n", "is not a supported kind of file"},
          {"PLY that promises too much", "a.ply",
           "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n",
           "too large for the file's size"}};
}

TEST_F(Probe, ACloudWithoutASurfaceIsAnErrorThatSaysWhy) {
  for (const BadCloud& bad : bad_clouds())
    for (const auto& settings : surface::all_surface_settings()) {
      const auto opened = open_cloud(file(bad.file, bad.text), {}, settings);
      ASSERT_FALSE(opened.ok()) << bad.name << " by " << settings.name;
      EXPECT_NE(to_string(opened.error()).find(bad.says), std::string::npos)
          << bad.name << " by " << settings.name << ": " << to_string(opened.error());
      EXPECT_NE(opened.error().where.find(bad.file), std::string::npos) << "the file is named";
    }
}

TEST_F(Probe, AFlatCloudIsTouchedByEverySettingOrganisedOrNot) {
  for (const int width : {0, 61})
    for (const auto& settings : surface::all_surface_settings()) {
      const auto opened = open_cloud(file("flat.pcd", pcd(flat(), width)), {}, settings);
      ASSERT_TRUE(opened.ok()) << settings.name << ": " << to_string(opened.error());
      const auto felt = touch_along(*opened->snapshot, straight_in(), 500.0);
      expect_finite(felt);
      EXPECT_TRUE(felt.back().in_body) << settings.name << " width " << width;
      EXPECT_NEAR(felt.back().distance_m, -0.01, 2e-4) << settings.name;
      EXPECT_NEAR(felt.back().force_N.z(), -5.0, 0.1) << settings.name;
      EXPECT_NEAR(felt.back().normal.z(), -1.0, 0.01) << settings.name;
      EXPECT_FALSE(felt.front().in_body);
      EXPECT_EQ(felt.front().force_N.norm(), 0.0);
    }
}

TEST_F(Probe, AGivenUnitIsUsed) {
  const auto opened =
      open_cloud(file("mm.pcd", pcd(flat(1000.0))), {.unit_m = 0.001}, *surface::surface_settings("fast"));
  ASSERT_TRUE(opened.ok());
  EXPECT_NEAR(touch_along(*opened->snapshot, straight_in(), 500.0).back().force_N.z(), -5.0, 0.1);
}

TEST_F(Probe, PointsThatAreNaNAreLeftOut) {
  std::vector<Vector3d> points = flat();
  for (std::size_t i = 0; i < points.size(); i += 17) points[i].setConstant(std::numeric_limits<double>::quiet_NaN());
  const auto opened = open_cloud(file("holes.pcd", pcd(points)), {}, *surface::surface_settings("fast"));
  ASSERT_TRUE(opened.ok());
  EXPECT_NEAR(touch_along(*opened->snapshot, straight_in(), 500.0).back().force_N.z(), -5.0, 0.1);
}

struct CubeCase {
  const char* name;
  Cube cube;
  const char* remark;
};

TEST_F(Probe, AMeshIsTouchedFromOutsideHoweverItsFacesTurn) {
  const CubeCase cases[] = {{"without normals", {}, "has no normals"},
                            {"inverted", {.inverted = true}, "inside out"},
                            {"with normals", {.normals = 1}, ""},
                            {"normals inwards", {.normals = -1}, "inside out"},
                            {"faces inwards, normals right", {.inverted = true, .normals = 1}, ""},
                            {"all inwards", {.inverted = true, .normals = -1}, "inside out"}};
  for (const CubeCase& mesh : cases) {
    const auto opened = open_cloud(file("cube.obj", obj(mesh.cube)), {}, *surface::surface_settings("fast"));
    ASSERT_TRUE(opened.ok()) << mesh.name;
    EXPECT_NE(opened->remarks.find(mesh.remark), std::string::npos) << mesh.name << ": " << opened->remarks;
    const auto felt = touch_along(*opened->snapshot, straight_in(), 500.0);
    expect_finite(felt);
    EXPECT_TRUE(felt.back().in_body) << mesh.name;
    EXPECT_LT(felt.back().force_N.z(), -4.5) << mesh.name;
  }
}

TEST_F(Probe, AnOpenMeshSaysSoAndCanBeTurnedOver) {
  const fs::path box = file("box.obj", obj({.inverted = true, .without_lid = true}));
  const auto& fast = *surface::surface_settings("fast");
  const auto opened = open_cloud(box, {}, fast);
  ASSERT_TRUE(opened.ok());
  EXPECT_NE(opened->remarks.find("open (4 edges"), std::string::npos) << opened->remarks;
  std::vector<Waypoint> from_behind = straight_in();
  for (Waypoint& waypoint : from_behind) waypoint.at_m.z() = 1.8 - waypoint.at_m.z();
  expect_finite(touch_along(*opened->snapshot, from_behind, 500.0));
  const auto turned = open_cloud(box, {.flip_normals = true}, fast);
  ASSERT_TRUE(turned.ok());
  EXPECT_GT(touch_along(*turned->snapshot, from_behind, 500.0).back().force_N.z(), 4.5);
}

TEST_F(Probe, AMeshWithVerticesThatAreNoNumbersIsTouchedWhereItIs) {
  std::string text = obj({});
  text += "v nan nan nan\nf 1 2 9\n";
  const auto opened = open_cloud(file("cube.obj", text), {}, *surface::surface_settings("fast"));
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  EXPECT_NE(opened->remarks.find("not a finite number"), std::string::npos) << opened->remarks;
  const auto felt = touch_along(*opened->snapshot, straight_in(), 500.0);
  expect_finite(felt);
  EXPECT_TRUE(felt.back().in_body);
}

TEST_F(Probe, OnlyTheGroupBodyOfAnObjIsRead) {
  std::string moved = "g helper\nv 0 0 90\nv 1 0 90\nv 0 1 90\nf 1 2 3\ng body\n";
  bool in_faces = false;  // face corners counted back from the newest vertex
  for (const char letter : obj({})) {
    in_faces = in_faces || letter == 'f';
    moved += in_faces && letter >= '1' && letter <= '8' ? "-" + std::to_string('9' - letter) : std::string(1, letter);
  }
  const auto opened = open_cloud(file("figure.obj", moved), {}, *surface::surface_settings("fast"));
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  for (const Vector3d& at : opened->on_surface) ASSERT_LT(at.z(), 1.01);
  EXPECT_TRUE(touch_along(*opened->snapshot, straight_in(), 500.0).back().in_body);
}

TEST_F(Probe, AMeshIsResampledToAsManyPointsAsAskedAndItsNormalsAreKept) {
  for (const std::size_t samples : {1000U, 16000U}) {
    const auto opened = open_cloud(file("cube.obj", obj({})), {.samples = samples}, *surface::surface_settings("fast"));
    ASSERT_TRUE(opened.ok());
    EXPECT_EQ(opened->snapshot->points, samples);
  }
}

TEST(Trajectory, TimeThatGoesBackIsAnErrorWithItsLine) {
  const auto read = parse_trajectory("t_s,x,y,z\n0,0,0,1\n0.2,0,0,1\n0.1,0,0,1\n", "q.csv");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().where, "q.csv:4");
  EXPECT_NE(read.error().what.find("decreases from"), std::string::npos);
}

TEST(Trajectory, AnInvalidTrajectoryIsAnErrorWithItsLine) {
  EXPECT_FALSE(parse_trajectory("", "q.csv").ok());
  EXPECT_FALSE(parse_trajectory("t_s,x,y,z\n", "q.csv").ok());
  EXPECT_EQ(parse_trajectory("0,0,0,1\n1,2,3\n", "q.csv").error().where, "q.csv:2");
  EXPECT_EQ(parse_trajectory("0,0,0,1\n1,2,3,4,5\n", "q.csv").error().where, "q.csv:2");
  EXPECT_EQ(parse_trajectory("nan,0,0,1\n", "q.csv").error().where, "q.csv:1");
  EXPECT_EQ(parse_trajectory("inf,0,0,1\n", "q.csv").error().where, "q.csv:1");
}

TEST_F(Probe, WaypointsThatAreNaNGetNoForceAndTouchContinues) {
  for (const char* setting : {"fast", "paper", "cloud"}) {
    const auto opened = open_cloud(file("flat.pcd", pcd(flat(), 61)), {}, *surface::surface_settings(setting));
    std::vector<Waypoint> path = straight_in();
    path.front().at_m.setConstant(std::numeric_limits<double>::quiet_NaN());
    path[550].at_m.x() = std::numeric_limits<double>::quiet_NaN();
    path[560].at_m.y() = std::numeric_limits<double>::infinity();
    const auto felt = touch_along(*opened->snapshot, path, 500.0);
    expect_finite(felt);
    EXPECT_EQ(felt[550].force_N.norm(), 0.0) << setting;
    EXPECT_TRUE(std::isnan(felt[550].distance_m));
    EXPECT_FALSE(felt[550].in_body);
    EXPECT_NEAR(felt[551].force_N.z(), -500.0 * 0.0051, 0.05) << setting << ": contact goes on";
    EXPECT_NEAR(felt.back().force_N.z(), -5.0, 0.1) << setting;
  }
}

TEST_F(Probe, TeleportsAreFiniteAndEndAtTheSurface) {
  for (const char* setting : {"fast", "cloud"}) {
    const auto opened = open_cloud(file("flat.pcd", pcd(flat(), 61)), {}, *surface::surface_settings(setting));
    std::vector<Waypoint> path{{0.0, {0, 0, 0.75}},    {0.0005, {0.01, 0.01, 0.81}}, {0.001, {1e9, -1e9, 1e9}},
                               {0.001, {0, 0, -1e30}}, {0.002, {0, 0, 0}},           {0.0025, {0, 0, 0.75}},
                               {0.003, {0, 0, 0.805}}};
    const auto felt = touch_along(*opened->snapshot, path, 500.0);
    expect_finite(felt);
    EXPECT_TRUE(felt[1].in_body) << setting << ": swept, so it stops at the surface";
    EXPECT_NEAR(felt[1].proxy_m.z(), 0.8, 2e-4) << setting;
    EXPECT_EQ(felt[2].force_N.norm(), 0.0) << setting;
    EXPECT_NEAR(felt.back().force_N.z(), -2.5, 0.1) << setting;
  }
}

TEST_F(Probe, APathPalpatesWhateverCanBeTouched) {
  const fs::path clouds[] = {kData / "pcd/person.pcd", kData / "pcd/milk_color.pcd", file("cube.obj", obj({}))};
  for (const fs::path& cloud : clouds) {
    const auto opened = open_cloud(cloud, {}, *surface::surface_settings("fast"));
    ASSERT_TRUE(opened.ok()) << cloud << to_string(opened.error());
    const auto path = palpation_path(*opened->snapshot, opened->on_surface, {});
    ASSERT_TRUE(path.ok()) << cloud << to_string(path.error());
    const auto felt = touch_along(*opened->snapshot, *path, 500.0);
    expect_finite(felt);
    double deepest_m = 0.0;
    int touched = 0;
    for (const Felt& one : felt) {
      touched += one.in_body ? 1 : 0;
      if (one.in_body) deepest_m = std::min(deepest_m, one.distance_m);
    }
    EXPECT_GT(touched, static_cast<int>(felt.size() / 5)) << cloud;
    EXPECT_LT(deepest_m, -0.008) << cloud;
    EXPECT_GT(deepest_m, -0.013) << cloud;
    EXPECT_FALSE(felt.front().in_body || felt.back().in_body) << cloud;
  }
}

TEST_F(Probe, ADepthImageIsTouchedInItsOwnUnit) {
  const auto opened = open_depth(kData / "images_depth_only/30.png", kData / "images_depth_only/camera.textproto",
                                 *surface::surface_settings("fast"));
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  const auto path = palpation_path(*opened->snapshot, opened->on_surface, {.spots = 2});
  ASSERT_TRUE(path.ok()) << to_string(path.error());
  const auto felt = touch_along(*opened->snapshot, *path, 500.0);
  expect_finite(felt);
  EXPECT_TRUE(std::any_of(felt.begin(), felt.end(), [](const Felt& one) { return one.in_body; }));
}

/// A real carton as a PCD file with normals of random sign, and points that scatter by `noise_m`.
std::string carton_of_random_normals(float noise_m) {
  models::PointModel cloud = *models::read_point_model(kData / "pcd/milk_color.pcd");
  std::mt19937 random(8);
  std::normal_distribution<float> noise(0.0F, noise_m);
  std::ostringstream text;
  text << "VERSION 0.7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\n"
       << "COUNT 1 1 1 1 1 1\nWIDTH " << cloud.points.size() << "\nHEIGHT 1\nPOINTS " << cloud.points.size()
       << "\nDATA ascii\n";
  for (const surface::CloudPoint& point : surface::with_normals(cloud.points, 30, Eigen::Vector3f::Zero())) {
    const Eigen::Vector3f normal = random() % 2 == 0 ? point.normal : Eigen::Vector3f(-point.normal);
    for (const float at : point.at_m) text << at + noise(random) << ' ';
    text << normal.x() << ' ' << normal.y() << ' ' << normal.z() << '\n';
  }
  return text.str();
}

struct RefusedCloud {
  const char* name;
  float noise_m;
  const char* says;
};

TEST_F(Probe, AHandThatGoesInByAFlankThatTheCameraDidNotSeeIsSaidToFeelNothing) {
  images::GrayImage16 box{.width = 160, .height = 120, .samples = {}};
  for (int v = 0; v < box.height; ++v)
    for (int u = 0; u < box.width; ++u) box.samples.push_back(u >= 60 && u < 100 && v >= 40 && v < 80 ? 900 : 1000);
  const fs::path camera =
      file("box.textproto", "depth { width: 160 height: 120 fx: 130 fy: 130 cx: 79.5 cy: 59.5 } depth_unit_m: 0.001");
  const auto opened = open_depth(file("box.png", images::encode_png(box)), camera, *surface::surface_settings("fast"));
  ASSERT_TRUE(opened.ok()) << to_string(opened.error());
  std::vector<Waypoint> sideways;
  for (int i = 0; i <= 200; ++i) sideways.push_back({0.001 * i, {-0.25 + 0.00125 * i, 0.0, 0.95}});
  const std::vector<Felt> felt = touch_along(*opened->snapshot, sideways, 500.0);
  const auto without =
      std::count_if(felt.begin(), felt.end(), [](const Felt& one) { return std::isnan(one.distance_m); });
  EXPECT_GT(without, 50) << "inside the box, behind its front";
  EXPECT_NE(in_words(felt).find("nothing is felt at " + std::to_string(without) + " waypoints"), std::string::npos)
      << in_words(felt);
  EXPECT_EQ(in_words(touch_along(*opened->snapshot, {{0.0, {0.25, 0.0, 0.98}}}, 500.0)).find("nothing is felt"),
            std::string::npos);
}

TEST_F(Probe, TheProgramsRefuseACloudThatCannotBeTouchedAndTouchItAnyway) {
  const fs::path out = folder_.path() / "path.csv";
  for (const RefusedCloud& refused : {RefusedCloud{"signs.pcd", 0.0F, "% of the normals contradict their neighbours"},
                                      RefusedCloud{"noise.pcd", 0.012F, "is too noisy to be touched"}}) {
    const fs::path cloud = file(refused.name, carton_of_random_normals(refused.noise_m));
    const std::vector<std::string> probe = {"telepalp-probe", "path", "--cloud", cloud, "--out", out};
    const std::vector<std::string> station = {"telepalp-station", "--check", "--surface", "model:" + cloud.string()};
    for (std::vector<std::string> words : {probe, station}) {
      const fs::path program = fs::path(TELEPALP_BINARY_DIR "/bin") / words.front();
      words.erase(words.begin());
      const auto run = [&] {
        return support::ChildProcess(program, words, folder_.path() / "log").wait(std::chrono::seconds(60));
      };
      EXPECT_EQ(run(), 1) << program;
      std::ifstream log(folder_.path() / "log");
      const std::string said{std::istreambuf_iterator<char>(log), {}};
      EXPECT_NE(said.find(refused.says), std::string::npos) << said;
      EXPECT_NE(said.find("--anyway"), std::string::npos) << said;
      words.emplace_back("--anyway");
      EXPECT_EQ(run(), 0) << program << ' ' << refused.name;
    }
  }
}

TEST_F(Probe, TheProgramWritesTheColumnsThatItPromises) {
  const fs::path cloud = file("flat.pcd", pcd(flat(), 61));
  const fs::path out = folder_.path() / "o.csv";
  const fs::path path = folder_.path() / "q.csv";
  const fs::path svg = folder_.path() / "o.svg";
  const fs::path program = TELEPALP_BINARY_DIR "/bin/telepalp-probe";
  const auto run = [&](const std::vector<std::string>& arguments) {
    return support::ChildProcess(program, arguments, folder_.path() / "log")
        .wait(std::chrono::seconds(60))
        .value_or(-1);
  };
  ASSERT_EQ(run({"path", "--cloud", cloud, "--out", path, "--spots", "2"}), 0);
  ASSERT_EQ(run({"--cloud", cloud, "--trajectory", path, "--out", out, "--setting", "paper", "--plot", svg}), 0);
  std::ifstream felt(out);
  std::string line;
  std::getline(felt, line);
  EXPECT_EQ(line, "t_s,px,py,pz,distance_m,in_body,nx,ny,nz,fx,fy,fz,step_us");
  std::size_t rows = 0;
  while (std::getline(felt, line)) {
    ASSERT_EQ(std::count(line.begin(), line.end(), ','), 12) << line;
    ++rows;
  }
  EXPECT_EQ(rows, read_trajectory(path)->size());
  EXPECT_GT(fs::file_size(svg), 1000U);
  EXPECT_EQ(run({"--cloud", cloud, "--out", out}), 2);
  EXPECT_EQ(run({"--cloud", cloud, "--trajectory", path, "--out", out, "--setting", "none"}), 2);
  EXPECT_EQ(run({"--cloud", folder_.path() / "none.pcd", "--trajectory", path, "--out", out}), 1);
  EXPECT_EQ(run({"--cloud", cloud, "--trajectory", path, "--out", "/nowhere/o.csv"}), 1);
}

TEST_F(Probe, TheProgramRefusesOptionsWithoutEffectAndFilesThatItWouldOverwrite) {
  const fs::path cloud = file("flat.pcd", pcd(flat(), 61));
  const fs::path path = file("q.csv", "0,0,0,0\n");
  const fs::path out = folder_.path() / "o.csv";
  const auto refuses = [&](const std::vector<std::string>& arguments, const std::string& what) {
    const fs::path log = folder_.path() / "log";
    support::ChildProcess program(TELEPALP_BINARY_DIR "/bin/telepalp-probe", arguments, log);
    EXPECT_EQ(program.wait(std::chrono::seconds(60)), 2) << what;
    std::ifstream stream(log);
    const std::string said{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_NE(said.find(what), std::string::npos) << said;
    EXPECT_NE(said.find("fix: "), std::string::npos) << said;
  };
  const std::vector<std::vector<std::string>> without_effect = {
      {"--samples", "1000"}, {"--spacing-mm", "3"}, {"--anyway"}, {"--flip-normals"}};
  for (const std::vector<std::string>& option : without_effect) {
    std::vector<std::string> words = {"--depth", "d.png", "--camera", "c", "--trajectory", path, "--out", out};
    words.insert(words.end(), option.begin(), option.end());
    refuses(words, option.front() + ": this option has no effect on a depth image");
  }
  refuses({"--cloud", cloud, "--trajectory", path, "--out", folder_.path() / "." / "q.csv"},
          "is also the file of --trajectory");
  refuses({"--cloud", cloud, "--trajectory", path, "--out", out, "--plot", out}, "is also the file of --out");
  refuses({"path", "--cloud", cloud, "--out", cloud}, "is also the file of --cloud");
  EXPECT_EQ(read_trajectory(path)->size(), 1U) << "nothing was overwritten";
}

}  // namespace
}  // namespace telepalp::probe
