#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "codec/color_reader.h"
#include "codec/video.h"

namespace telepalp::codec {
namespace {

/// A bright disc that moves to the right over a slope of colour.
ColorImage scene(int frame, int width = 64, int height = 48) {
  ColorImage color{.width = width, .height = height, .rgb = {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const int dx = column - 10 - 2 * frame;
      const int dy = row - height / 2;
      const bool in_disc = dx * dx + dy * dy < 64;
      color.rgb.push_back(static_cast<std::uint8_t>(in_disc ? 230 : 40 + 2 * row % 100));
      color.rgb.push_back(static_cast<std::uint8_t>(in_disc ? 60 : 60 + column % 120));
      color.rgb.push_back(static_cast<std::uint8_t>(in_disc ? 50 : 120));
    }
  return color;
}

SessionTime at(int frame) { return session_time(1'000'000'000 + std::int64_t{frame} * 33'333'333); }

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

double mean_difference(const ColorImage& a, const ColorImage& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  return sum / static_cast<double>(a.rgb.size());
}

std::vector<EncodedVideo> encoded_scene(int frames, ColorVideoSettings settings = {}) {
  ColorVideoEncoder encoder(settings);
  std::vector<EncodedVideo> video;
  for (int frame = 0; frame < frames; ++frame) video.push_back(encoder.encode(scene(frame), at(frame)));
  return video;
}

TEST(ColorVideo, EachFrameLooksLikeTheImageThatWasEncoded) {
  ColorVideoDecoder decoder;
  const std::vector<EncodedVideo> video = encoded_scene(20);
  for (int frame = 0; frame < 20; ++frame) {
    const Result<ColorImage> back = decoder.decode(bytes_of(video[static_cast<std::size_t>(frame)].bytes));
    ASSERT_TRUE(back.ok()) << to_string(back.error());
    EXPECT_LT(mean_difference(*back, scene(frame)), 4.0) << frame;
    EXPECT_GT(mean_difference(*back, scene(frame + 4)), 4.0) << "another frame would not pass";
  }
}

TEST(ColorVideo, GreyStaysGreyFromBlackToWhite) {
  for (const int value : {0, 1, 16, 128, 235, 254, 255}) {
    const ColorImage grey{
        .width = 32, .height = 32, .rgb = std::vector<std::uint8_t>(32 * 32 * 3, static_cast<std::uint8_t>(value))};
    ColorVideoEncoder encoder({});
    ColorVideoDecoder decoder;
    const Result<ColorImage> back = decoder.decode(bytes_of(encoder.encode(grey, at(0)).bytes));
    ASSERT_TRUE(back.ok());
    for (const std::uint8_t channel : back->rgb) ASSERT_NEAR(channel, value, 3);
  }
}

TEST(ColorVideo, AnySizeIsCodedAlsoAnOddOne) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(2, 1), std::pair(17, 33), std::pair(641, 3)}) {
    ColorVideoEncoder encoder({});
    ColorVideoDecoder decoder;
    const Result<ColorImage> back = decoder.decode(bytes_of(encoder.encode(scene(0, width, height), at(0)).bytes));
    ASSERT_TRUE(back.ok()) << width << " x " << height << ": " << to_string(back.error());
    EXPECT_EQ(back->width, width);
    EXPECT_EQ(back->height, height);
  }
}

TEST(ColorVideo, KeyFramesComeAtTheirDistanceAndOnDemand) {
  ColorVideoEncoder encoder({.kbit_per_s = 800, .key_every = 5});
  std::string keys;
  for (int frame = 0; frame < 13; ++frame) {
    if (frame == 7) encoder.request_key_frame();
    keys += encoder.encode(scene(frame), at(frame)).key_frame ? 'K' : '.';
  }
  EXPECT_EQ(keys, "K....K.K....K");
}

TEST(ColorVideo, ANewSizeBeginsWithAKeyFrame) {
  ColorVideoEncoder encoder({});
  ColorVideoDecoder decoder;
  ASSERT_TRUE(decoder.decode(bytes_of(encoder.encode(scene(0), at(0)).bytes)).ok());
  const EncodedVideo larger = encoder.encode(scene(1, 80, 60), at(1));
  EXPECT_TRUE(larger.key_frame);
  const Result<ColorImage> back = decoder.decode(bytes_of(larger.bytes));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->width, 80);
}

TEST(ColorVideo, NothingIsShownBetweenALostFrameAndTheNextKeyFrame) {
  ColorVideoEncoder encoder({.kbit_per_s = 800, .key_every = 6});
  ColorReader reader;
  std::string shown;
  for (int frame = 0; frame < 9; ++frame) {
    const EncodedVideo video = encoder.encode(scene(frame), at(frame));
    if (frame == 2) continue;  // lost on the way: its number is missing
    shown += reader.read(kVideoFormat, bytes_of(video.bytes), static_cast<std::uint64_t>(frame) + 1) ? 'y' : '-';
  }
  EXPECT_EQ(shown, "yy---yyy");
}

TEST(ColorVideo, ASkippedFrameIsStillAReference) {
  const std::vector<EncodedVideo> video = encoded_scene(8);
  ColorReader reader;
  for (std::size_t frame = 0; frame < 7; ++frame) reader.skip(kVideoFormat, bytes_of(video[frame].bytes), frame + 1);
  const Result<ColorImage> last = reader.read(kVideoFormat, bytes_of(video[7].bytes), 8);
  ASSERT_TRUE(last.ok());
  EXPECT_LT(mean_difference(*last, scene(7)), 4.0);
}

TEST(ColorVideo, ANumberOfAFileHasThirtyTwoBits) {
  const std::vector<EncodedVideo> video = encoded_scene(2);
  ColorReader reader;
  ASSERT_TRUE(reader.read(kVideoFormat, bytes_of(video[0].bytes), 0xffff'ffff).ok());
  EXPECT_TRUE(reader.read(kVideoFormat, bytes_of(video[1].bytes), 0x1'0000'0000).ok());
}

TEST(ColorVideo, APacketThatIsCutShortIsRefusedOrWhole) {
  const std::vector<EncodedVideo> video = encoded_scene(2);
  for (const bool key : {true, false}) {
    const std::string& whole = video[key ? 0 : 1].bytes;
    ColorVideoDecoder intact;
    ASSERT_TRUE(intact.decode(bytes_of(video[0].bytes)).ok());
    const ColorImage expected = key ? *ColorVideoDecoder().decode(bytes_of(whole)) : *intact.decode(bytes_of(whole));
    std::size_t refused = 0;
    for (std::size_t size = 0; size < whole.size(); ++size) {
      ColorVideoDecoder decoder;
      const bool ready = key || decoder.decode(bytes_of(video[0].bytes)).ok();
      ASSERT_TRUE(ready);
      const Result<ColorImage> back = decoder.decode(bytes_of(whole).first(size));
      refused += back ? 0 : 1;
      EXPECT_TRUE(!back || back->rgb == expected.rgb) << "the last " << whole.size() - size << " B say nothing";
    }
    EXPECT_GE(refused + 8, whole.size()) << (key ? "key frame" : "predicted frame");
  }
}

TEST(ColorVideo, AfterADamagedPacketTheNextPredictedFrameIsRefused) {
  const std::vector<EncodedVideo> video = encoded_scene(4);
  ColorVideoDecoder decoder;
  ASSERT_TRUE(decoder.decode(bytes_of(video[0].bytes)).ok());
  ASSERT_FALSE(decoder.decode(bytes_of(video[1].bytes).first(5)).ok());
  EXPECT_FALSE(decoder.decode(bytes_of(video[2].bytes)).ok());
  EXPECT_TRUE(decoder.decode(bytes_of(video[0].bytes)).ok()) << "a key frame begins again";
}

/// The start of a key frame that declares these sides.
std::string declared(int width, int height) {
  std::string packet = encoded_scene(1).front().bytes;
  const auto put = [&](std::size_t place, int value) {
    packet[place] = static_cast<char>(value & 0xff);
    packet[place + 1] = static_cast<char>(value >> 8);
  };
  put(6, width);
  put(8, height);
  return packet;
}

TEST(ColorVideo, ABombIsRefusedBeforeAnythingIsAllocatedForIt) {
  for (const auto& [width, height] :
       {std::pair(0x3fff, 0x3fff), std::pair(4096, 4096), std::pair(4097, 1), std::pair(0, 48), std::pair(64, 0)}) {
    const Result<ColorImage> back = ColorVideoDecoder().decode(bytes_of(declared(width, height)));
    ASSERT_FALSE(back.ok()) << width << " x " << height;
    EXPECT_NE(back.error().what.find("pixels"), std::string::npos) << back.error().what;
  }
}

TEST(ColorVideo, AFrameOfAnotherSizeThanDeclaredIsNotShownAsWhole) {
  const Result<ColorImage> back = ColorVideoDecoder().decode(bytes_of(declared(640, 480)));
  EXPECT_FALSE(back.ok()) << "the packet has the content of 64 x 48 pixels";
}

TEST(ColorVideo, AnythingElseIsRefused) {
  for (const std::string& packet : {std::string(), std::string("x"), std::string(10, '\0'), std::string(4096, '\xff')})
    EXPECT_FALSE(ColorVideoDecoder().decode(bytes_of(packet)).ok()) << packet.size();
  EXPECT_FALSE(ColorReader().read("h264", bytes_of(encoded_scene(1).front().bytes), 1).ok());
}

TEST(ColorVideo, TheRateIsKeptOnAPictureThatMoves) {
  for (const int kbit_per_s : {200, 800}) {
    ColorVideoEncoder encoder({.kbit_per_s = kbit_per_s});
    double bytes = 0.0;
    constexpr int kFrames = 120;
    for (int frame = 0; frame < kFrames; ++frame) {
      ColorImage color = scene(frame % 20, 320, 240);
      for (std::size_t i = 0; i < color.rgb.size(); ++i)  // noise that no prediction foresees
        color.rgb[i] =
            static_cast<std::uint8_t>(color.rgb[i] + (i * 2654435761U + static_cast<unsigned>(frame) * 97U) % 23U);
      bytes += static_cast<double>(encoder.encode(color, at(frame)).bytes.size());
    }
    const double measured = 8e-3 * bytes / (kFrames / 30.0);
    EXPECT_LT(measured, 1.25 * kbit_per_s);
  }
}

}  // namespace
}  // namespace telepalp::codec
