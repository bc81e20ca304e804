#include "support/images/lettering.h"

#include <gtest/gtest.h>

#include <string>

namespace telepalp::images {
namespace {

ColorImage white(int width, int height) {
  ColorImage image{.width = width, .height = height, .rgb = {}};
  image.rgb.assign(3 * static_cast<std::size_t>(width * height), 255);
  return image;
}

/// Mean darkness of a rectangle: 0 white, 1 black.
double darkness(const ColorImage& image, int left, int top, int width, int height) {
  double sum = 0.0;
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) sum += 255 - image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
  return sum / (255.0 * width * height);
}

TEST(Lettering, WritesLettersThatCanBeRead) {
  ColorImage image = white(12, kFullLine_px);
  draw_text(image, 0, 0, "L", {0, 0, 0});
  EXPECT_GT(darkness(image, 2, 6, 2, 14), 0.9) << "the stem";
  EXPECT_GT(darkness(image, 3, 19, 7, 2), 0.5) << "the foot";
  EXPECT_EQ(darkness(image, 5, 5, 7, 12), 0.0) << "nothing at the upper right";
}

TEST(Lettering, ALowerLineShowsTheSameLettersSmaller) {
  ColorImage large = white(120, kFullLine_px);
  draw_text(large, 0, 0, "Ribs 8", {0, 0, 0});
  for (const int line_px : {22, 15, 9}) {
    const double scale = static_cast<double>(line_px) / kFullLine_px;
    ColorImage small = white(120, line_px);
    draw_text(small, 0, 0, "Ribs 8", {0, 0, 0}, line_px);
    EXPECT_NEAR(darkness(small, 0, 0, 120, line_px), scale * darkness(large, 0, 0, 120, kFullLine_px), 0.01) << line_px;
    EXPECT_NEAR(text_width_px("Ribs 8", line_px), scale * text_width_px("Ribs 8"), 3.0) << line_px;
  }
}

TEST(Lettering, IsAsWideAsItsLettersAndSurvivesWhatIsNoUtf8) {
  EXPECT_EQ(text_width_px("ab"), text_width_px("a") + text_width_px("b"));
  EXPECT_EQ(text_width_px("\xff"), text_width_px("?"));
  EXPECT_EQ(text_width_px("\xe2\x80"), text_width_px("??"));
  EXPECT_EQ(text_width_px("\xc3W"), text_width_px("?W")) << "a letter behind a torn sequence stays";
  EXPECT_EQ(text_width_px("\xe2\x80WW"), text_width_px("??WW"));
  EXPECT_EQ(text_width_px("\xf8WWW"), text_width_px("?WWW"));
  EXPECT_GT(text_width_px("µ"), 0);
  ColorImage image{8, 8, std::vector<std::uint8_t>(8 * 8 * 3, 0)};
  draw_text(image, -5, -5, "clipped on every side", {});
  EXPECT_EQ(image.rgb.size(), 8U * 8U * 3U);
}

TEST(Lettering, ShowsAnotherLetterAsOneQuestionMark) {
  ColorImage asked = white(16, kFullLine_px);
  ColorImage umlaut = white(16, kFullLine_px);
  draw_text(asked, 0, 0, "?", {0, 0, 0});
  draw_text(umlaut, 0, 0, "\xc3\xbc", {0, 0, 0});  // two bytes, one letter
  EXPECT_EQ(umlaut.rgb, asked.rgb);
}

TEST(Lettering, BreaksLinesBetweenWordsAndWideWordsAnywhere) {
  using Lines = std::vector<std::string>;
  const int skin_of_px = text_width_px("skin of");
  EXPECT_EQ(lines_of("skin of belly", skin_of_px), (Lines{"skin of", "belly"}));
  EXPECT_EQ(lines_of("skin", text_width_px("skin")), (Lines{"skin"}));
  EXPECT_EQ(lines_of("", 60), (Lines{""}));
  EXPECT_EQ(lines_of("a nnnnnnn", text_width_px("nnn")), (Lines{"a", "nnn", "nnn", "n"}));
  EXPECT_EQ(lines_of("\xc3\xbc\xc3\xbc\xc3\xbc", text_width_px("??")), (Lines{"\xc3\xbc\xc3\xbc", "\xc3\xbc"}))
      << "no letter is cut in two";
  EXPECT_EQ(lines_of("ab", 1), (Lines{"a", "b"})) << "a line has a letter, however narrow it is";
  EXPECT_EQ(lines_of("skin of belly", skin_of_px, 13), (Lines{"skin of belly"})) << "lower lines hold more letters";
}

}  // namespace
}  // namespace telepalp::images
