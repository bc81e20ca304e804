#include "haptic_station/station/picture/scene_picture.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "haptic_station/effects/presets/tissue_presets.h"
#include "haptic_station/station/picture/drawn_needle.h"
#include "haptic_station/station/picture/ground.h"
#include "haptic_station/station/picture/picture_view.h"
#include "haptic_station/station/picture/pixels.h"

namespace telepalp::station {
namespace {

using images::Rgb;

constexpr int kSide_px = 512;
constexpr int kSamples = 2;  // per pixel and axis, against jagged edges
constexpr int kMargin_px = 16;
constexpr int kCanvas_px = kSide_px + 2 * kMargin_px;  // width
constexpr int kLine_px = 22;
constexpr int kSmallLine_px = 15;
constexpr images::Ink kLetters{kInk[0], kInk[1], kInk[2]};
constexpr double kSkinOverObject = 0.2;  // share of the skin's colour in that of an object below it

/// Colours that colour-blind people can tell apart (Okabe and Ito 2008).
constexpr std::array<Rgb, 7> kColors{
    {{230, 159, 0}, {86, 180, 233}, {0, 158, 115}, {240, 228, 66}, {204, 121, 167}, {0, 114, 178}, {213, 94, 0}}};

Rgb color_of(std::size_t object) { return kColors[object % kColors.size()]; }

/// The objects through the skin, each pixel the mean of its samples.
ColorImage through_skin(const ColorImage& objects, const ColorImage& ground) {
  const int side = ground.width / kSamples;
  ColorImage out = blank(side, side, kWhite);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      std::array<int, 3> sum{};
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const int u = kSamples * x + i % kSamples;
        const int v = kSamples * y + i / kSamples;
        const Rgb object = pixel(objects, u, v);
        const Rgb skin = pixel(ground, u, v);
        const Rgb sample = object == kWhite ? skin : mixed(object, skin, kSkinOverObject);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += sample[c];
      }
      Rgb mean{};
      for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>(sum[c] / (kSamples * kSamples));
      set_pixel(out, x, y, mean);
    }
  return out;
}

std::string length_text(double length_m) {
  char text[32];
  std::snprintf(text, sizeof text, length_m < 1.0 ? "%.0f mm" : "%.0f m", length_m < 1.0 ? 1e3 * length_m : length_m);
  return text;
}

void draw_scale(ColorImage& picture, const solids::PictureView& view) {
  const double step_m = grid_step_m(view.width_m);
  const int length_px = static_cast<int>(std::lround(step_m / view.width_m * picture.width));
  const int y = picture.height - kMargin_px;
  images::fill(picture, {kMargin_px, y, length_px, 3}, kInk);
  for (const int x : {kMargin_px, kMargin_px + length_px - 3}) images::fill(picture, {x, y - 6, 3, 9}, kInk);
  images::draw_text(picture, kMargin_px, y - 28, length_text(step_m), kLetters, kLine_px);
}

void draw_directions(ColorImage& picture, const Directions& directions) {
  const std::string right = std::string(directions.at_right) + " >";
  const int top_px = images::text_width_px(directions.at_top, kLine_px);
  const int right_px = images::text_width_px(right, kLine_px);
  images::draw_text(picture, (picture.width - top_px) / 2, 4, directions.at_top, kLetters, kLine_px);
  images::draw_text(picture, picture.width - right_px - 6, picture.height - kMargin_px - 14, right, kLetters, kLine_px);
}

struct LegendLine {
  Rgb rgb;
  std::string text;
};

std::vector<LegendLine> legend_of(const scenes::Scene& scene, const std::vector<scenes::SceneObject>& objects,
                                  bool is_model) {
  std::vector<LegendLine> lines;
  for (std::size_t i = 0; i < objects.size(); ++i) lines.push_back({color_of(i), objects[i].name});
  bool friction = false;
  std::string tissue;
  for (const effects::Recipe& recipe : scene.effects) {
    friction = friction || std::holds_alternative<effects::FrictionSettings>(recipe);
    if (const auto* skin = std::get_if<effects::SkinSettings>(&recipe); skin != nullptr && skin->tissue != nullptr)
      tissue = " of " + std::string(skin->tissue->name);
  }
  lines.push_back({kSkin, "skin" + tissue + (friction ? " with friction" : "") +
                              (is_model ? "" : " (drawn flat; its shape comes from the camera)")});
  if (scenes::needle_of(scene)) lines.push_back({kInk, "needle, at the innermost net"});
  return lines;
}

constexpr int kSwatch_px = 14;
constexpr int kLegendLeft_px = kMargin_px + kSwatch_px + 8;

/// The legend's text, broken into lines as wide as the canvas.
std::vector<std::vector<std::string>> broken(const std::vector<LegendLine>& legend) {
  std::vector<std::vector<std::string>> texts;
  for (const LegendLine& line : legend)
    texts.push_back(images::lines_of(line.text, kCanvas_px - kLegendLeft_px - kMargin_px, kLine_px));
  return texts;
}

void draw_legend(ColorImage& canvas, const std::vector<LegendLine>& legend, int y) {
  const auto texts = broken(legend);
  for (std::size_t i = 0; i < legend.size(); ++i) {
    images::fill(canvas, {kMargin_px, y, kSwatch_px, kSwatch_px}, kInk);
    images::fill(canvas, {kMargin_px + 1, y + 1, kSwatch_px - 2, kSwatch_px - 2}, legend[i].rgb);
    for (const std::string& text : texts[i]) {
      images::draw_text(canvas, kLegendLeft_px, y - 4, text, kLetters, kLine_px);
      y += kLine_px;
    }
  }
}

int height_of_legend(const std::vector<LegendLine>& legend) {
  std::size_t lines = 0;
  for (const auto& texts : broken(legend)) lines += texts.size();
  return kLine_px * static_cast<int>(lines);
}

/// The scene's name and purpose above the picture, in as many lines as they need.
struct Title {
  std::vector<std::string> name;
  std::vector<std::string> purpose;

  [[nodiscard]] int height_px() const {
    return 8 + kLine_px * static_cast<int>(name.size()) + kSmallLine_px * static_cast<int>(purpose.size()) + 6;
  }
};

Title title_of(const scenes::Scene& scene, const Directions& directions) {
  const int width_px = kCanvas_px - 2 * kMargin_px;
  return {images::lines_of(scene.name + ", " + directions.name, width_px, kLine_px),
          images::lines_of(scene.purpose, width_px, kSmallLine_px)};
}

void draw_title(ColorImage& canvas, const Title& title) {
  int y = 8;
  for (const std::string& line : title.name) {
    images::draw_text(canvas, kMargin_px, y, line, kLetters, kLine_px);
    y += kLine_px;
  }
  for (const std::string& line : title.purpose) {
    images::draw_text(canvas, kMargin_px, y, line, kLetters, kSmallLine_px);
    y += kSmallLine_px;
  }
}

void place(ColorImage& canvas, const ColorImage& picture, int left, int top) {
  images::fill(canvas, {left - 1, top - 1, picture.width + 2, picture.height + 2}, kInk);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) set_pixel(canvas, left + x, top + y, pixel(picture, x, y));
}

}  // namespace

ColorImage picture_of_scene(const scenes::Scene& scene, std::span<const SkinPoint> skin, PictureSide side,
                            std::optional<double> width_m) {
  const std::vector<scenes::SceneObject> objects = scenes::objects_of(scene);
  const Directions directions = directions_of(side);
  const solids::PictureView view = view_of(objects, skin, directions, width_m, kSide_px * kSamples);
  std::vector<solids::PaintedSolid> painted;
  for (std::size_t i = 0; i < objects.size(); ++i) painted.push_back({objects[i].tree.get(), color_of(i)});
  ColorImage picture = through_skin(solids::picture_of(painted, view), ground_of(view, skin, kSamples));
  if (const auto needle = scenes::needle_of(scene)) draw_needle(picture, view, *needle);
  draw_scale(picture, view);
  draw_directions(picture, directions);
  const std::vector<LegendLine> legend = legend_of(scene, objects, !skin.empty());
  const Title title = title_of(scene, directions);
  const int below_px = title.height_px() + kSide_px;
  ColorImage canvas = blank(kCanvas_px, below_px + kMargin_px + height_of_legend(legend), kWhite);
  draw_title(canvas, title);
  place(canvas, picture, kMargin_px, title.height_px());
  draw_legend(canvas, legend, below_px + kMargin_px / 2);
  return canvas;
}

}  // namespace telepalp::station
