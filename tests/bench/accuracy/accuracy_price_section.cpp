#include <chrono>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/commands/scene_bill.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "where.h"

namespace telepalp::bench {
namespace {

/// An effect of a shipped scene, and its name in the table.
struct Priced {
  const char* scene;
  const char* effect;
  const char* name;
};
constexpr Priced kPriced[] = {
    {"skin", "skin", "`skin`"},
    {"palpation", "cylinder", "`cylinder`, of `palpation`"},
    {"sphere", "sphere", "`sphere`"},
    {"friction", "friction", "`friction`"},
    {"regions", "regions", "`regions`"},
    {"organ", "organ", "`organ`"},
    {"appendix-rebound", "caecum", "`solid`, one ellipsoid"},
    {"liver-enlarged", "spleen", "`solid`, a blend of two shapes"},
    {"liver-enlarged", "aorta", "`solid`, a capsule that pulses"},
    {"long-reach", "aorta", "`solid`, a capsule that pulses, and a fingertip of 6 mm"},
    {"ribs-ultrasound", "ribs", "`solid`, 24 ribs and a fingertip of 6 mm"},
    {"liver-enlarged", "liver", "`solid`, a mesh"},
};

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Result<Section> price_section() {
  Section section;
  PageTable table{
      .head = {"effect", "cost a tick, µs", "memory of the tree, kB", "reading its scene, ms", "error of the depth"},
      .rows = {}};
  for (const Priced& priced : kPriced) {
    const auto start = std::chrono::steady_clock::now();
    const auto scene = scenes::read_scene(std::string(TELEPALP_SOURCE_DIR "/haptic_station/scenes/") + priced.scene +
                                          ".scene.textproto");
    if (!scene) return scene.error();
    const double read_ms = ms_since(start);
    for (const station::EffectPrice& price : station::price_of(*scene)) {
      if (price.name != priced.effect) continue;
      section.rows.push_back(measured(std::string("time in a tick: ") + priced.name, price.mean_us, "us"));
      table.rows.push_back({priced.name, cell(price.mean_us), cell(1e-3 * static_cast<double>(price.bytes)),
                            cell(read_ms), price.depth_error});
    }
  }
  section.parts = {{"price", to_markdown(table)}};
  return section;
}

}  // namespace telepalp::bench
