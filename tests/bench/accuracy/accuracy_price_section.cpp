#include <algorithm>
#include <chrono>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/bill/scene_bill.h"
#include "haptic_station/surface/build/hidden_skin.h"
#include "server/capture/synthetic/source/patient_model.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/ms_since.h"
#include "tests/bench/effects/thread_time.h"
#include "where.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kSeconds = 8.0;

/// An effect of a shipped scene, and its name in the table.
struct PricedEffect {
  const char* scene;
  const char* effect;
  const char* name;
};
constexpr PricedEffect kPriced[] = {
    {"skin", "skin", "`skin`"},
    {"palpation", "cylinder", "`cylinder`, of `palpation`"},
    {"sphere", "sphere", "`sphere`"},
    {"friction", "friction", "`friction`"},
    {"regions", "regions", "`regions`"},
    {"organ", "organ", "`organ`, a mesh"},
    {"appendix-rebound", "caecum", "`solid`, one ellipsoid"},
    {"liver-enlarged", "spleen", "`solid`, a blend of two shapes"},
    {"liver-enlarged", "aorta", "`solid`, a capsule that pulses"},
    {"long-reach", "aorta", "`solid`, a capsule that pulses, and a fingertip of 6 mm"},
    {"ribs-ultrasound", "ribs", "`solid`, 24 ribs and a fingertip of 6 mm"},
    {"liver-enlarged", "liver", "`solid`, a mesh"},
    {"amniocentesis", "layered_tissue", "`layered_tissue`, three layers"},
    {"prisms_to_compare", "fem_prism", "`fem_prism`"},
    {"ribs-ultrasound", "ultrasound probe", "`probe`, its image of 256 x 256 pixels at 25 Hz"},
};

std::string quantiles(const station::StationCost& cost, station::Part part, double unit_ns) {
  const core::DurationHistogram& steps = cost.steps[static_cast<std::size_t>(part)];
  if (steps.total() == 0) return "–";
  return cell(steps.quantile_ns(0.5) / unit_ns) + " / " + cell(steps.quantile_ns(0.999) / unit_ns);
}

/// "p50 / p99" of the force error [mN] and of the depth error [µm].
std::string errors_of(const station::Price& price, bool as_depth) {
  if (!price.error || !price.error->compared) return "–";
  if (price.error->ticks == 0) return "not touched";
  const double per = as_depth ? 1e6 / price.error->stiffness_N_per_m : 1e3;
  return cell(per * price.error->p50_N) + " / " + cell(per * price.error->p99_N);
}

void add_scene(const std::string& name, const station::SceneBill& bill, PageTable& scenes, std::vector<Row>& rows) {
  const double share = bill.share();
  const station::Price& all = bill.prices.back();
  rows.push_back(measured("scene " + name + ": the station", share, "% of a core"));
  rows.push_back(measured("scene " + name + ": what its effects add", all.total_share, "% of a core"));
  scenes.rows.push_back({"`" + name + "`", cell(share), cell(all.total_share),
                         quantiles(bill.live, station::Part::Loop, 1e3),
                         quantiles(bill.live, station::Part::Surface, 1e6),
                         quantiles(bill.live, station::Part::Inside, 1e6), cell(bill.start_ms)});
}

void add_effects(const std::string& scene, const station::SceneBill& bill, double read_ms, PageTable& prices,
                 std::vector<Row>& rows) {
  for (const PricedEffect& priced : kPriced) {
    const auto price = std::ranges::find(bill.prices, priced.effect, &station::Price::name);
    if (scene != priced.scene || price == bill.prices.end()) continue;
    rows.push_back(measured(std::string("time in a tick: ") + priced.name, price->tick_us, "us"));
    rows.push_back(measured(std::string("whole station: ") + priced.name, price->total_share, "% of a core"));
    prices.rows.push_back({priced.name, cell(price->total_share),
                           cell(price->share[static_cast<std::size_t>(station::Part::Surface)]), cell(price->tick_us),
                           cell(1e-3 * static_cast<double>(price->bytes)), cell(read_ms), errors_of(*price, false),
                           errors_of(*price, true)});
  }
}

/// Processor time with which the station tells the patient's skin from objects over it (HiddenSkin), at 30 images of
/// 640x480 pixels per second [% of a core]. A colleague's hand comes, stays and leaves in the measured time.
Result<double> skin_from_objects_share() {
  constexpr double kImages_hz = 30.0;
  constexpr int kImages = 150;
  const auto mesh = capture::shipped_torso();
  if (!mesh) return mesh.error();
  const auto patient = capture::SyntheticPatient::make(*mesh, {});
  if (!patient) return patient.error();
  const auto at = [](double t) { return session_time(0) + from_seconds(t); };
  const Intrinsics& camera = patient->settings().camera;
  const capture::ColleagueVisit visit{.place = patient->surface_of({}).at_pixel(camera.cx, camera.cy).at,
                                      .over_m = 0.06,
                                      .begins_s = 0.5,
                                      .stays_s = 1.0};
  surface::HiddenSkin skin;
  double spent_us = 0.0;
  for (int i = 0; i < kImages; ++i) {
    const double t = i / kImages_hz;
    capture::PatientPose pose = patient->pose(at(t));
    pose.colleague = visit.at(t, patient->surface_of({}), patient->surface_of(pose));
    const surface::DepthField field = surface::to_depth_field(patient->depth_of(pose, at(t)));
    const double start_us = thread_us();
    (void)skin.add(field, camera, 1.0 / kImages_hz, visit.place);
    spent_us += thread_us() - start_us;
  }
  return 1e-4 * kImages_hz * spent_us / kImages;
}

Result<void> add_skin_from_objects(PageTable& prices, std::vector<Row>& rows) {
  const Result<double> share = skin_from_objects_share();
  if (!share) return share.error();
  rows.push_back(measured("whole station: telling skin from objects over it", *share, "% of a core"));
  prices.rows.push_back({"telling skin from objects over it", cell(*share), cell(*share), "–", "–", "–", "–", "–"});
  return {};
}

}  // namespace

Result<Section> price_section() {
  Section section;
  PageTable scenes{
      .head = {"scene", "station, % of a core", "of it its effects", "a tick, µs, p50 / p99.9",
               "an image, ms, p50 / p99.9", "an ultrasound image, ms, p50 / p99.9", "surfaces for viewers, once, ms"},
      .rows = {}};
  PageTable prices{
      .head = {"effect", "station, % of a core", "of it at the surface", "in a tick, µs", "memory of the tree, kB",
               "reading its scene, ms", "force error mN, p50 / p99", "as depth µm, p50 / p99"},
      .rows = {}};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(TELEPALP_SOURCE_DIR "/haptic_station/scenes"))
    if (entry.path().extension() == ".textproto") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    const auto start = std::chrono::steady_clock::now();
    const auto scene = scenes::read_scene(file);
    if (!scene) return scene.error();
    const double read_ms = ms_since(start);
    const bool each = std::ranges::any_of(kPriced, [&](const PricedEffect& one) { return scene->name == one.scene; });
    const Result<station::SceneBill> bill =
        station::bill_of(*scene, file, kSeconds, each ? station::Detail::EachEffect : station::Detail::Together);
    if (!bill) return bill.error();
    add_scene(scene->name, *bill, scenes, section.rows);
    add_effects(scene->name, *bill, read_ms, prices, section.rows);
  }
  if (const Result<void> added = add_skin_from_objects(prices, section.rows); !added) return added.error();
  section.parts = {{"scenes", to_markdown(scenes)}, {"price", to_markdown(prices)}};
  return section;
}

}  // namespace telepalp::bench
