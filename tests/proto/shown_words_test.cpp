#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "proto/words/drawn_sizes.h"
#include "proto/words/phase_names.h"
#include "where.h"

namespace telepalp {
namespace {

std::string text_of(const char* file) {
  std::ifstream in(std::string(TELEPALP_SOURCE_DIR "/") + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PhaseNames, AreTheSameWordsInTheViewerInTheOrderOfTheirNumbers) {
  const std::string viewer = text_of("clients/viewer/src/words/phases.ts");
  std::size_t after = 0;
  for (const PhaseName& name : kPhaseNames) {
    const std::size_t found = viewer.find("{name: '" + std::string(name.words) + "'", after);
    ASSERT_NE(found, std::string::npos) << "phases.ts lacks " << name.words << ", or has it in another place";
    after = found;
  }
}

TEST(PhaseNames, StandBesideThoseOfThePaperInTheGlossary) {
  const std::string glossary = text_of("docs/glossary.md");
  for (std::size_t i = 1; i < kPhaseNames.size(); ++i)
    EXPECT_TRUE(contains(glossary,
                         "| " + std::string(kPhaseNames[i].words) + " | " + std::string(kPhaseNames[i].in_S1) + " | "))
        << kPhaseNames[i].words;
}

TEST(PhaseNames, ShowNoWordThatOnlyThePaperExplains) {
  for (const PhaseName& name : kPhaseNames)
    for (const char* const word : {"ylinder", "lane", "Out body", "In body"})
      EXPECT_FALSE(contains(std::string(name.words), word)) << name.words;
  EXPECT_EQ(phase_name(99).words, "Unknown state");
}

TEST(DrawnSizes, AreThoseOfTheViewerAndOfThePagesThatStateThem) {
  const std::string viewer = text_of("clients/viewer/src/scene/drawn_sizes.ts");
  EXPECT_TRUE(contains(viewer, "ARROW_M_PER_N = 0.02;")) << viewer;
  EXPECT_TRUE(contains(viewer, "BALL_RADIUS_M = 0.03;")) << viewer;
  EXPECT_EQ(kArrow_m_per_N, 0.02);
  EXPECT_EQ(kBallRadius_m, 0.03);
  EXPECT_TRUE(contains(text_of("clients/viewer/src/index.html"), "20 mm of arrow for each newton"));
  EXPECT_TRUE(contains(text_of("clients/viewer/src/index.html"), "ball, 6 cm across"));
  EXPECT_TRUE(contains(text_of("docs/cli.md"), "(a ball of 6 cm), proxy, and the force as an arrow of 20 mm"));
}

}  // namespace
}  // namespace telepalp
