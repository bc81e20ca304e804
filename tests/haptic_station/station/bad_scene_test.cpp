#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <locale>
#include <string>

#include "haptic_station/station/commands/scene_command.h"
#include "tests/support/child_process.h"

namespace telepalp::station {
namespace {

/// Line 1; the layer that is tested begins on line 2.
const std::string kBegin =
    "haptic_from_camera { translation_m { y: 0.8 } rotation_vector_rad { x: 1.5708 } } effects { skin {} }\n";

class BadScene : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  /// A file of 1 GB that takes no room on the disk.
  void write_gigabyte(const std::string& name) const {
    write(name, "");
    std::filesystem::resize_file(path(name), 1'000'000'000);
  }

  /// What `telepalp-station scene check` says about the file; empty: it accepts the scene.
  [[nodiscard]] std::string checked(const std::string& name) const {
    const std::string file = path(name).string();
    const char* const words[] = {"scene", "check", file.c_str()};
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = scene_command(3, words);
    const std::string out = testing::internal::GetCapturedStdout();
    std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(code == 0, said.empty()) << said;
    EXPECT_EQ(code == 0, !out.empty()) << "nothing of a refused scene is shown";
    return said;
  }
  [[nodiscard]] std::string said_about(const std::string& more) const {
    write("bad.textproto", kBegin + more);
    return checked("bad.textproto");
  }
  [[nodiscard]] std::string said_about_layer(const std::string& more) const {
    return said_about("effects { solid { name: \"ribs\" " + more + " } }");
  }

  /// `said` names line and column (":2:31: " for example), the words `what`, and a fix.
  void expect_place(const std::string& said, const std::string& place, const std::string& what) const {
    EXPECT_NE(said.find("textproto" + place), std::string::npos) << place << " in: " << said;
    EXPECT_NE(said.find(what), std::string::npos) << what << " in: " << said;
    EXPECT_NE(said.find("fix: "), std::string::npos) << said;
    EXPECT_LT(said.size(), 700U) << "one line that can be read";
  }

  support::TemporaryFolder folder_;
};

TEST_F(BadScene, AnUnknownWordIsRefused) {
  expect_place(said_about_layer("polish: \"orb 1\""), ":2:41: ", "ribs: expected a solid, found 'orb'");
  expect_place(said_about_layer("polis: \"sphere 1\""), ":2:37: ", "no field named \"polis\"");
  expect_place(said_about("\neffects { skin { tissue: \"wood\" } }"), ":3:11: ", "skin.tissue \"wood\" is not known");
  expect_place(said_about("\neffects {}"), ":3:1: ", "the effect has no kind");
}

TEST_F(BadScene, AWrongTissueIsRefusedAtItsPlace) {
  const auto said = [&](const std::string& layers) {
    return said_about("effects { layered_tissue {\n" + layers + "\n} }");
  };
  expect_place(said("layer { name: \"skin\" surface { punctures_at_N: 0 } }"),
               ":3:32: ", "surface.punctures_at_N is 0 N, outside 0.01 to");
  expect_place(said("layer { name: \"skin\" surface { friction_N: nan } }"), ":3:", "surface.friction_N is nan N");
  expect_place(said("layer { name: \"skin\" top_m: 0.01 surface {} }\nlayer { name: \"sac\" top_m: 0.005 surface {} }"),
               ":4:1: ", "layer \"sac\": the layer begins above the end of the layer \"skin\"");
  expect_place(said("layer { name: \"muscle\" bulk {} }"),
               ":3:1: ", "layer \"muscle\": the layer has a bulk and no thickness");
  expect_place(said("layer { name: \"air\" }"), ":3:1: ", "layer \"air\": the layer has neither");
  expect_place(said("layer { surface {} relaxation { share: 0.5 time_s: 0 } }"), ":3:20: ", "relaxation.time_s is 0 s");
  expect_place(said("layer { surface {} }\nnet_radius_m: 0.1 net_edge_m: 0.001"),
               ":2:11: ", "net_radius_m is not 3 to 40 times net_edge_m");
  expect_place(said(""), ":2:11: ", "the tissue has no layer");
}

TEST_F(BadScene, AMissingOperandIsRefusedInBothNotations) {
  expect_place(said_about_layer("polish: \"+ sphere 1\""),
               ":2:51: ", "ribs: expected the solid that is operand 2 of +");
  const std::string sphere = "of { sphere { radius_m: 1 } }";
  expect_place(said_about_layer("\nsolid {\n difference { " + sphere + " } }"),
               ":4:2: ", "ribs: difference: has 1 operand instead of 2");
  expect_place(said_about_layer("\nsolid {\n blend { width_m: 1 " + sphere + sphere + sphere + " } }"),
               ":4:2: ", "ribs: blend: has 3 operands instead of 2");
  expect_place(said_about_layer("\nsolid { sphere {} }"), ":3:9: ", "ribs: sphere: radius_m is missing");
  expect_place(said_about_layer("\nsolid { translate { x_m: 0 y_m: 0 z_m: 0\n of {} } }"),
               ":4:2: ", "ribs: translate.of[0]: the solid has no kind");
  expect_place(said_about_layer(""), ":2:11: ", "ribs: the layer has no solid");
}

TEST_F(BadScene, ANegativeRadiusIsNamedWhereItStands) {
  expect_place(said_about_layer("polish: \"sphere -1\""), ":2:48: ", "ribs: radius_m of sphere is -1");
  expect_place(said_about_layer("\nsolid { sphere {\n radius_m: -1 } }"),
               ":4:2: ", "ribs: sphere: radius_m of sphere is -1");
  // 0.5 m is a radius of a layer, and too much for the cylinder of the next effect.
  expect_place(said_about_layer("solid { sphere { radius_m: 0.5 } } } }\neffects { cylinder { radius_m: 0.5 "),
               ":3:22: ", "cylinder.radius_m is 0.5 m, outside 0.001 to 0.3 m");
}

TEST_F(BadScene, NotANumberIsRefused) {
  expect_place(said_about_layer("polish: \"sphere nan\""), ":2:48: ", "ribs: radius_m of sphere is nan");
  expect_place(said_about_layer("\nsolid { sphere { radius_m: nan } }"), ":3:18: ", "radius_m of sphere is nan");
  expect_place(said_about_layer("polish: \"sphere 1\"\nstiffness_N_per_m: nan"),
               ":3:1: ", "solid.stiffness_N_per_m is nan N/m");
  expect_place(said_about("\neffects { sphere { center_m {\n y: inf } } }"), ":4:2: ", "sphere.center_m.y is inf m");
}

TEST_F(BadScene, AMissingMeshNamesTheLayerAndTheLine) {
  expect_place(said_about_layer("\npolish: \"+ sphere 1 mesh none.ply 1 0.004\""),
               ":3:21: ", "none.ply: cannot be read");
  expect_place(said_about_layer("\nsolid { mesh { file: \"none.ply\" unit_m: 1 cell_m: 0.004 } }"),
               ":3:9: ", "none.ply: cannot be read");
  write("rib.solid", "sphere 1 +");
  const std::string in_file = said_about_layer("\npolish_file: \"rib.solid\"");
  EXPECT_NE(in_file.find("rib.solid:1:10: layer ribs: found '+' after the end of the solid"), std::string::npos)
      << in_file;
  EXPECT_NE(in_file.find("bad.textproto:3:15 names this file"), std::string::npos) << in_file;
  for (const char* solid : {"polish: \"mesh none.ply 1 0.004\"", "polish_file: \"none.solid\""})
    EXPECT_NE(said_about_layer(solid).find(": layer ribs: "), std::string::npos) << solid;
  expect_place(said_about("\neffects { organ { file: \"none.ply\" } }"), ":3:11: ", "organ: ");
  expect_place(said_about("\npatient_surface { static_model { file: \"none.ply\" } }"),
               ":3:19: ", "none.ply: cannot be read");
  expect_place(said_about("\nhand { trace { file: \"none.csv\" } }"), ":3:8: ", "none.csv: cannot be read");
}

TEST_F(BadScene, TwoLayersOfTheSameNameAreRefused) {
  const std::string ball = "polish: \"sphere 1\"";
  expect_place(said_about_layer(ball + "} }\neffects { solid { name: \"ribs\" " + ball),
               ":3:11: ", "an earlier layer has the name ribs");
  EXPECT_EQ(said_about_layer(ball + "} }\neffects { solid { name: \"liver\" polish: \"sphere 0.9\""), "");
}

TEST_F(BadScene, ATransformThatShearsOrMirrorsIsRefused) {
  for (const char* matrix : {"1 0.5 0 0  0 1 0 0  0 0 1 0", "-1 0 0 0  0 1 0 0  0 0 1 0", "2 0 0 0  0 1 0 0  0 0 1 0"})
    expect_place(said_about_layer("polish: \"tm " + std::string(matrix) + " sphere 1\""),
                 ":2:41: ", "ribs: the matrix of tm shears, mirrors, or scales its axes differently");
  expect_place(said_about_layer("\nsolid { scale { factor: -1 of { sphere { radius_m: 1 } } } }"),
               ":3:17: ", "factor of sc is -1");
}

TEST_F(BadScene, ACycleIsRefused) {
  expect_place(said_about_layer("polish_file: \"bad.textproto\""), ":1:1: ", "ribs: expected a solid");
  std::filesystem::create_symlink("b.solid", path("a.solid"));
  std::filesystem::create_symlink("a.solid", path("b.solid"));
  const std::string said = said_about_layer("polish_file: \"a.solid\"");
  EXPECT_NE(said.find("ribs: cannot be read: "), std::string::npos) << said;
}

TEST_F(BadScene, NestingOfAHundredThousandLevelsIsRefused) {
  const auto repeated = [](const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
  };
  constexpr int kDepth = 100'000;
  expect_place(said_about_layer("polish: \"" + repeated("sc 1 ", kDepth) + "sphere 1\""),
               ":2:546: ", "ribs: operators nest deeper than 100");
  expect_place(said_about_layer("solid {" + repeated("scale{of{", kDepth)), ":2:", "too deep");
  const std::string deep = repeated("\nscale { factor: 1 of {", 110) + "sphere { radius_m: 1 }" + repeated("}}", 110);
  expect_place(said_about_layer("solid {" + deep + "}"), ":103:19: ", "operators nest deeper than 100");
  write("deep.solid", repeated("sc 1\n", kDepth) + "sphere 1");
  EXPECT_NE(said_about_layer("polish_file: \"deep.solid\"").find("deep.solid:102:1: layer ribs: operators nest deeper"),
            std::string::npos);
}

TEST_F(BadScene, AFileOfAGigabyteIsRefusedBeforeItIsRead) {
  for (const char* name : {"big.textproto", "big.solid", "big.ply", "big.obj"}) write_gigabyte(name);
  EXPECT_NE(checked("big.textproto").find("larger than 1 MiB"), std::string::npos);
  EXPECT_NE(said_about_layer("polish_file: \"big.solid\"").find("larger than 4 MiB"), std::string::npos);
  for (const std::string mesh : {"big.ply", "big.obj"}) {
    expect_place(said_about_layer("polish: \"mesh " + mesh + " 1 0.004\""),
                 ":2:41: ", mesh + ": is larger than 64 MiB");
    expect_place(said_about("\neffects { organ { file: \"" + mesh + "\" } }"),
                 ":3:11: ", mesh + ": is larger than 64 MiB");
  }
}

/// The punctuation of a locale that writes 0,5.
struct DecimalComma : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
};

TEST_F(BadScene, ADecimalCommaIsRefusedAndADecimalPointReadInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  (void)std::setlocale(LC_ALL, "de_DE.UTF-8");  // fails on a computer without it; the C++ locale remains
  const std::string point = said_about_layer("polish: \"sphere 0.5\" stiffness_N_per_m: 12.5");
  const std::string range = said_about_layer("polish: \"sphere 0.5\"\nstiffness_N_per_m: -0.5");
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  EXPECT_EQ(point, "");
  expect_place(range, ":3:1: ", "solid.stiffness_N_per_m is -0.5 N/m");
  expect_place(said_about_layer("polish: \"sphere 0,5\""), ":2:48: ", "write a decimal point");
  expect_place(said_about_layer("stiffness_N_per_m: 0,5"), ":2:", "write a decimal point, as in 0.5, not a comma");
}

TEST_F(BadScene, TextInAnotherEncodingIsRefused) {
  EXPECT_EQ(said_about("purpose: \"Rippen f\xc3\xbchlen\""), "") << "UTF-8";
  expect_place(said_about("purpose: \"Rippen f\xfchlen\""), ":2:19: ", "not UTF-8");
  expect_place(said_about("p\xfcrpose: \"ribs\""), ":2:2: ", "UTF-8");
  write("wide.textproto", std::string("\xff\xfe"
                                      "n\0a\0m\0e\0",
                                      10));
  expect_place(checked("wide.textproto"), ":1:1: ", "UTF-8");
}

}  // namespace
}  // namespace telepalp::station
