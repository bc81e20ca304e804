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

}  // namespace
}  // namespace telepalp::images
