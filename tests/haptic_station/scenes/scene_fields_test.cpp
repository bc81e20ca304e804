// The fields of a scene file: which exist, which were removed, and that each has an effect.

#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/tissue/tissue_settings.h"
#include "messages/scene.pb.h"
#include "support/program/text/text_format.h"
#include "where.h"

namespace telepalp::scenes {
namespace {

namespace fs = std::filesystem;
using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr const char* kLeast = "haptic_from_camera { translation_m { y: 0.8 } }\n";
const fs::path kScenes = TELEPALP_SOURCE_DIR "/haptic_station/scenes";

Result<Scene> scene_with(const std::string& more) {
  return parse_scene(std::string(kLeast) + more, kScenes / "fields.scene.textproto");
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The scene's own messages; the grammar of solids has documents and tests of its own.
bool is_of_the_scene(const Descriptor& message) { return message.file()->name() == "messages/scene.proto"; }

void collect_fields(const Descriptor& message, std::set<std::string>& fields) {
  for (int i = 0; i < message.field_count(); ++i) {
    const FieldDescriptor& field = *message.field(i);
    if (!fields.insert(field.full_name()).second) continue;
    if (const Descriptor* nested = field.message_type(); nested != nullptr && is_of_the_scene(*nested))
      collect_fields(*nested, fields);
  }
}

void collect_set_fields(const Message& message, std::set<std::string>& fields) {
  std::vector<const FieldDescriptor*> set;
  message.GetReflection()->ListFields(message, &set);
  for (const FieldDescriptor* field : set) {
    fields.insert(field->full_name());
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    if (!field->is_repeated()) collect_set_fields(message.GetReflection()->GetMessage(message, field), fields);
    for (int i = 0; field->is_repeated() && i < message.GetReflection()->FieldSize(message, field); ++i)
      collect_set_fields(message.GetReflection()->GetRepeatedMessage(message, field, i), fields);
  }
}

std::set<std::string> fields_of_shipped_scenes() {
  std::set<std::string> set;
  for (const auto& entry : fs::directory_iterator(kScenes)) {
    if (!entry.path().string().ends_with(".scene.textproto")) continue;
    msg::Scene message;
    EXPECT_TRUE(program::read_text_format(entry.path(), message).ok()) << entry.path();
    collect_set_fields(message, set);
  }
  return set;
}

TEST(SceneFields, EachIsSetByAShippedSceneOrDescribedInTheDocument) {
  std::set<std::string> all;
  collect_fields(*msg::Scene::descriptor(), all);
  const std::set<std::string> set = fields_of_shipped_scenes();
  const std::string document = text_of(TELEPALP_SOURCE_DIR "/docs/scenes.md");
  int unset = 0;
  std::string names;
  for (const std::string& field : all) {
    if (set.contains(field)) continue;
    ++unset;
    names += field + "\n";
    EXPECT_NE(document.find('`' + field.substr(field.rfind('.') + 1) + '`'), std::string::npos)
        << field << " is set by no shipped scene. fix: describe it in docs/scenes.md, or make it a constant";
  }
  EXPECT_LE(unset, 22) << names;
}

struct Removed {
  const char* text;
  const char* instead;
};
const Removed kRemoved[] = {
    {"effects { cylinder { around_m: 0.02 } }", "10 mm around"},
    {"effects { sphere { around_m: 0.02 } }", "10 mm around"},
    {"effects { organ { around_m: 0.02 } }", "10 mm around"},
    {"effects { solid { around_m: 0.02 } }", "10 mm around"},
    {"plane { speed_m_per_s: 0.2 }", "0.1 m/s"},
    {"transitions { from_body_within_m: 0.5 }", "d_thr"},
    {"transitions { offset_fade_s: 1 }", "0.15 s"},
    {"transitions { hand_rose_m: 0.1 }", "20 mm"},
    {"transitions { force_fade_N_per_s: 10 }", "40 N/s"},
    {"age_limits { tracker_in_contact_s: 1 }", "3 s"},
    {"limits { slew_N_per_s: 100 }", "2000 N/s"},
    {"hand { arm_stiffness_N_per_m: 100 }", "300 N/m"},
    {"hand { arm_damping_N_s_per_m: 10 }", "20 N s/m"},
    {"hand { hand_mass_kg: 1 }", "0.5 kg"},
    {"workspace { recall_N_per_m: 10 }", "150 N/m"},
    {"workspace { recall_most_N: 1 }", "3 N"},
    {"workspace { shift_m_per_s_per_N: 0.1 }", "0.05 m/s"},
    {"position_control { most_N: 1 }", "peak_N"},
    {"simulated_device { mass_kg: 1 }", "0.3 kg"},
};

TEST(SceneFields, EachThatWasRemovedIsRefusedWithWhatToWriteInstead) {
  for (const auto& [text, instead] : kRemoved) {
    const Result<Scene> scene = scene_with(text);
    ASSERT_FALSE(scene.ok()) << text;
    const std::string told = to_string(scene.error());
    EXPECT_NE(told.find("any more"), std::string::npos) << told;
    EXPECT_NE(told.find(instead), std::string::npos) << told;
    EXPECT_NE(told.find("fields.scene.textproto:2:"), std::string::npos) << told;
  }
}

/// The constants are those that the refusals name.
TEST(SceneFields, TheConstantsAreAsTheRefusalsSay) {
  const control::ControlSettings control;
  EXPECT_EQ(effects::kAround_m, 0.01);
  EXPECT_EQ(control.plane.speed_m_per_s, 0.1);
  EXPECT_EQ(control.transitions.offset_fade_s, 0.15);
  EXPECT_EQ(control.transitions.hand_rose_m, 0.02);
  EXPECT_EQ(control.transitions.force_fade_N_per_s, 40.0);
  EXPECT_EQ(control.ages.tracker_in_contact_s, 3.0);
  EXPECT_EQ(control.limits.slew_N_per_s, 2000.0);
  EXPECT_EQ(control.indexing.recall_N_per_m, 150.0);
  EXPECT_EQ(control.indexing.recall_most_N, 3.0);
  EXPECT_EQ(control.indexing.shift_m_per_s_per_N, 0.05);
}

TEST(SceneFields, AModelHasAUnitAndNormals) {
  const Result<Scene> scene = scene_with(
      "effects { skin {} } patient_surface { static_model { file: "
      "\"../../deploy/demo_data/torso/visible_human_torso.ply\" "
      "unit_m: 0.001 flip_normals: true } }");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  ASSERT_TRUE(scene->model);
  EXPECT_EQ(scene->model->unit_m, 0.001);
  EXPECT_TRUE(scene->model->flip_normals);
  EXPECT_FALSE(scene->model->samples);
}

TEST(SceneFields, ASkinMayHaveOneStiffnessAtEveryDepth) {
  const Result<Scene> scene = scene_with("effects { skin { linear_stiffness_N_per_m: 250 } }");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  EXPECT_EQ(scene->skin()->law.constant_N_per_m, 250.0);
}

constexpr const char* kLiver = "file: \"../../deploy/demo_data/organs/visible_human_liver.ply\" ";

TEST(SceneFields, AnOrganHasAUnitAndASpacing) {
  const auto spacing_of = [](const std::string& more, MeshDetail detail) {
    const Result<Scene> scene = parse_scene(kLeast + ("effects { organ { " + (kLiver + more) + " } }"),
                                            kScenes / "fields.scene.textproto", detail);
    EXPECT_TRUE(scene.ok()) << to_string(scene.error());
    return std::get<effects::OrganSettings>(scene->effects[0]).shape;
  };
  const auto plain = spacing_of("", MeshDetail::AsGiven);
  EXPECT_EQ(plain->spacing_m, 0.004);
  EXPECT_EQ(spacing_of("cell_m: 0.01", MeshDetail::AsGiven)->spacing_m, 0.01);
  EXPECT_EQ(spacing_of("cell_m: 0.01", MeshDetail::Finer)->spacing_m, 0.005);
  EXPECT_LT(spacing_of("unit_m: 0.5", MeshDetail::AsGiven)->size[0], plain->size[0]) << "half as wide";
}

TEST(SceneFields, ALayersShapeMayBeInAFileOfItsOwn) {
  const fs::path folder = fs::path(::testing::TempDir()) / "scene_fields";
  fs::create_directories(folder);
  std::ofstream(folder / "ball.polish") << "tr 0 -0.03 0 sphere 0.01\n";
  const Result<Scene> scene =
      parse_scene(std::string(kLeast) + "effects { solid { name: \"ball\" polish_file: \"ball.polish\" } }",
                  folder / "s.scene.textproto");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  EXPECT_NEAR(scene->layers().front().solid->tree->box().low.y(), -0.04, 1e-9);
}

TEST(SceneFields, AMembraneIsMetByAPointBesideTheDevice) {
  const Result<Scene> scene = scene_with("effects { membrane { tip_m { z: -0.12 } } }");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  EXPECT_EQ(std::get<effects::MembraneSettings>(scene->effects[0]).tip_m, Eigen::Vector3d(0.0, 0.0, -0.12));
}

TEST(SceneFields, LayersOfTissueAreReadIntoTheirSettings) {
  const Result<Scene> scene = scene_with(
      "effects { layered_tissue { at_m { y: -0.01 } net_radius_m: 0.04 net_edge_m: 0.01 spread_m: 0.02 subdivisions: 0 "
      "side_N_per_m: 70 tears_at_N_per_m: 9 bevel_rad: 0.2 skin_left: 0.3 tip_m { z: -0.12 } "
      "layer { name: \"skin\" thickness_m: 0.02 surface { stiffness_N_per_m: 99 stiffening_N_per_m2: 7 "
      "punctures_at_N: 1.5 friction_N: 0.4 bristle_N_per_m: 88 side_grip: 0.7 falls_in_s: 0.03 } "
      "bulk { law: LAW_PAPER stick_N_per_m: 77 slips_at_N: 0.6 slips_at_N_per_m: 5 cuts_at_N: 0.8 "
      "damping_N_s_per_m: 3 resolution_m: 1e-4 equal_readings: 9 } relaxation { share: 0.25 time_s: 2 } } "
      "layer { name: \"sac\" top_m: 0.02 surface {} } } }");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  const auto& recipe = std::get<effects::LayeredTissueSettings>(scene->effects[0]);
  EXPECT_EQ(recipe.skin_left, 0.3);
  EXPECT_EQ(recipe.tip_m, Eigen::Vector3d(0.0, 0.0, -0.12));
  const tissue::TissueSettings& tissue = tissue::settings_of(*recipe.model);
  EXPECT_EQ(tissue.at_m.y(), -0.01);
  EXPECT_EQ(
      std::vector<double>({tissue.net_radius_m, tissue.net_edge_m, tissue.net.spread_m, 1.0 * tissue.net.subdivisions}),
      std::vector<double>({0.04, 0.01, 0.02, 0.0}));
  EXPECT_EQ(std::vector<double>({tissue.shaft.side_N_per_m, tissue.shaft.tears_at_N_per_m, tissue.shaft.bevel_rad}),
            std::vector<double>({70.0, 9.0, 0.2}));
  ASSERT_EQ(tissue.layers.size(), 2U);
  EXPECT_EQ(tissue.layers[1].top_m, 0.02);
  EXPECT_FALSE(tissue.layers[1].bulk);
  const tissue::LayerSettings& layer = tissue.layers[0];
  EXPECT_EQ(layer.name, "skin");
  const tissue::SurfaceSettings& surface = *layer.surface;
  EXPECT_EQ(std::vector<double>({layer.thickness_m, surface.stiffness_N_per_m, surface.stiffening_N_per_m2,
                                 surface.punctures_at_N, surface.friction_N, surface.bristle_N_per_m, surface.side_grip,
                                 surface.falls_in_s}),
            std::vector<double>({0.02, 99.0, 7.0, 1.5, 0.4, 88.0, 0.7, 0.03}));
  const tissue::BulkSettings& bulk = *layer.bulk;
  EXPECT_EQ(bulk.law, tissue::BulkLaw::Paper);
  EXPECT_EQ(std::vector<double>({bulk.stick_N_per_m, bulk.slips_at_N, bulk.slips_at_N_per_m, bulk.cuts_at_N,
                                 bulk.damping_N_s_per_m, bulk.resolution_m, 1.0 * bulk.equal_readings}),
            std::vector<double>({77.0, 0.6, 5.0, 0.8, 3.0, 1e-4, 9.0}));
  EXPECT_EQ(layer.relaxation.branches, 1);
  EXPECT_EQ(layer.relaxation.share[0], 0.25);
  EXPECT_EQ(layer.relaxation.time_s[0], 2.0);
}

TEST(SceneFields, AreReadIntoTheValuesThatTheStationUses) {
  const Result<Scene> scene = scene_with(
      "effects { skin {} } limits { thermal_time_s: 5 } workspace { center_x_m: 0.1 center_z_m: -0.2 most_shift_x_m: "
      "0.15 "
      "most_shift_z_m: 0.4 } probe { width_m: 0.04 depth_m: 0.2 } purpose: \"why\" surface { name: \"paper\" }");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  EXPECT_EQ(scene->control.limits.thermal_time_s, 5.0);
  EXPECT_EQ(scene->control.indexing.center_x_m, 0.1);
  EXPECT_EQ(scene->control.indexing.center_z_m, -0.2);
  EXPECT_EQ(scene->control.indexing.most_shift_x_m, 0.15);
  EXPECT_EQ(scene->control.indexing.most_shift_z_m, 0.4);
  EXPECT_EQ(scene->probe->width_m, 0.04);
  EXPECT_EQ(scene->probe->depth_m, 0.2);
  EXPECT_EQ(scene->purpose, "why");
  EXPECT_EQ(scene->surface, "paper");
}

TEST(SceneFields, ARecordedHandHasADepth) {
  const fs::path folder = fs::path(::testing::TempDir()) / "scene_fields";
  fs::create_directories(folder);
  std::ofstream(folder / "hand.csv") << "time_s,x_m,y_m,z_m\n";
  const Result<Scene> scene =
      parse_scene(std::string(kLeast) + "effects { skin {} } hand { trace { file: \"hand.csv\" deepest_m: 0.02 } }",
                  folder / "s.scene.textproto");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  EXPECT_EQ(scene->hand_trace, folder / "hand.csv");
  EXPECT_EQ(scene->trace_deepest_m, 0.02);
}

TEST(SceneFields, ASceneKeepsItsTextSoThatAJournalCanReadItAgain) {
  const Result<Scene> scene = read_scene(kScenes / "ribs-ultrasound.scene.textproto");
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(scene->text, text_of(kScenes / "ribs-ultrasound.scene.textproto"));
  const Result<Scene> again = parse_scene(scene->text, kScenes / "ribs-ultrasound.scene.textproto");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->effects.size(), scene->effects.size());
}

}  // namespace
}  // namespace telepalp::scenes
