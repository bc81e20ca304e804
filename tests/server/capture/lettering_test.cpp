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

/// The dark pixels as text, a row a line.
std::string drawn(const ColorImage& image) {
  std::string text;
  for (int y = 0; y < image.height; ++y, text += '\n')
    for (int x = 0; x < image.width; ++x)
      text += image.rgb[3 * static_cast<std::size_t>(y * image.width + x)] == 0 ? '#' : '.';
  return text;
}

TEST(Lettering, WritesLettersThatCanBeRead) {
  ColorImage image = white(18, 8);
  write_text(image, 0, 0, "Lp!", {0, 0, 0}, 1);
  EXPECT_EQ(drawn(image),
            "#.............#...\n"
            "#.............#...\n"
            "#.....####....#...\n"
            "#.....#...#...#...\n"
            "#.....#...#...#...\n"
            "#.....####........\n"
            "#####.#.......#...\n"
            "......#...........\n");
}

TEST(Lettering, LeavesOutDotsBeyondTheImageAndShowsOtherLettersAsOneQuestionMark) {
  ColorImage image = white(4, 4);
  write_text(image, -3, -3, "\xc3\xbc WWWWWW", {0, 0, 0}, 2);  // an umlaut: two bytes, one letter
  EXPECT_EQ(image.rgb.size(), 48U);
  EXPECT_EQ(width_of("\xc3\xbc", 2), 12);
  ColorImage asked = white(6, 8);
  ColorImage umlaut = white(6, 8);
  write_text(asked, 0, 0, "?", {0, 0, 0}, 1);
  write_text(umlaut, 0, 0, "\xc3\xbc", {0, 0, 0}, 1);
  EXPECT_EQ(drawn(umlaut), drawn(asked));
}

TEST(Lettering, BreaksLinesBetweenWordsAndWideWordsAnywhere) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines_of("skin of belly", 6 * 7, 1), (Lines{"skin of", "belly"}));
  EXPECT_EQ(lines_of("skin", 6 * 4, 1), (Lines{"skin"}));
  EXPECT_EQ(lines_of("", 60, 1), (Lines{""}));
  EXPECT_EQ(lines_of("a sternocleid", 6 * 5, 1), (Lines{"a", "stern", "oclei", "d"}));
  EXPECT_EQ(lines_of("\xc3\xbc\xc3\xbc\xc3\xbc", 6 * 2, 1), (Lines{"\xc3\xbc\xc3\xbc", "\xc3\xbc"}))
      << "no letter is cut in two";
  EXPECT_EQ(lines_of("ab", 1, 1), (Lines{"a", "b"})) << "a line has a letter, however narrow it is";
}

}  // namespace
}  // namespace telepalp::images
