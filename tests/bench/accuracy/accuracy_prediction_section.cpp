#include <algorithm>
#include <cmath>

#include "tests/bench/accuracy/accuracy_prediction.h"
#include "tests/bench/accuracy/accuracy_sections.h"

namespace telepalp::bench {
namespace {

PageTable hand_table(const std::vector<HandPredictionError>& errors) {
  PageTable table{.head = {"recorded hand", "ahead ms"}, .rows = {}};
  for (const char* model : kHandModels) table.head.push_back(std::string(model) + ", mm / height");
  for (const HandPredictionError& error : errors) {
    table.rows.push_back({error.trace, cell(error.ahead_ms)});
    const auto best = std::min_element(error.all_m.begin(), error.all_m.end()) - error.all_m.begin();
    for (std::size_t model = 0; model < kHandModels.size(); ++model) {
      const std::string text = cell(1e3 * error.all_m[model]);
      table.rows.back().push_back((static_cast<std::ptrdiff_t>(model) == best ? "**" + text + "**" : text) + " / " +
                                  cell(1e3 * error.height_m[model]));
    }
  }
  return table;
}

/// Geometric mean over the recorded hands and horizons, by model, relative to the default's.
std::string hand_text(const std::vector<HandPredictionError>& errors) {
  std::array<double, kHandModels.size()> mean{};
  for (std::size_t model = 0; model < mean.size(); ++model) {
    double sum = 0.0;
    for (const HandPredictionError& error : errors)
      sum += std::log(error.all_m[model] / error.all_m[kDefaultHandModel]);
    mean[model] = std::exp(sum / static_cast<double>(errors.size()));
  }
  const auto best = static_cast<std::size_t>(std::min_element(mean.begin(), mean.end()) - mean.begin());
  std::string text =
      "RMS error over all axes, divided by that of the default (adaptive); geometric mean over all rows: ";
  for (std::size_t model = 0; model < mean.size(); ++model)
    text += (model > 0 ? "; " : "") + std::string(kHandModels[model]) + " " + cell(mean[model]);
  text += best == kDefaultHandModel ? ". The default is the best of them.\n"
                                    : std::string(". Best is ") + kHandModels[best] + ", which is not the default.\n";
  return text;
}

std::string hand_time_text(const std::array<double, kHandModels.size()>& us) {
  std::string text = "\nA sample and a prediction take, in µs of processor time: ";
  for (std::size_t model = 2; model < us.size(); ++model)
    text += (model > 2 ? "; " : "") + std::string(kHandModels[model]) + " " + cell(us[model]);
  return text + ".\n";
}

PageTable time_table(const std::vector<SurfacePredictionError>& errors) {
  PageTable table{.head = {"carried by", "", "still, 1 s, mm", "still, 3 s, mm", "frames to follow 3 mm", "build ms"},
                  .rows = {}};
  for (const double age_s : kSurfaceAges_s) {
    const std::string age = cell(1e3 * age_s) + " ms old";
    table.head.push_back("breathing, " + age + ", mm");
  }
  for (const SurfacePredictionError& error : errors) {
    table.rows.push_back({error.model, error.what, cell(1e3 * error.still_1s_m), cell(1e3 * error.still_3s_m),
                          cell(error.step_frames), cell(error.build_ms)});
    for (const double breathing_m : error.breathing_m) table.rows.back().push_back(cell(1e3 * breathing_m));
  }
  return table;
}

/// The text about the knee: the memory with the least still error × breathing error, among the variants with the
/// breathing model.
std::string time_text(const std::vector<SurfacePredictionError>& errors) {
  constexpr std::size_t kDelayed = 2;  // 100 ms old
  const auto product = [](const SurfacePredictionError& error) {
    return error.still_1s_m * error.breathing_m[kDelayed];
  };
  const SurfacePredictionError* usual = nullptr;
  const SurfacePredictionError* best = nullptr;
  for (const SurfacePredictionError& error : errors) {
    if (error.model.find("breathing") == std::string::npos) continue;
    if (error.model.find("default") != std::string::npos) usual = &error;
    if (best == nullptr || product(error) < product(*best)) best = &error;
  }
  constexpr double kAsGood = 1.02;
  if (usual == nullptr || product(*usual) <= kAsGood * product(*best))
    return "The default has the least product of still error and breathing error at 100 ms, or is within 2 % of it.\n";
  return "*" + best->model + "* has the least product of still error and breathing error at 100 ms: still " +
         cell(best->still_1s_m / usual->still_1s_m) + " times, breathing " +
         cell(best->breathing_m[kDelayed] / usual->breathing_m[kDelayed]) + " times the default's.\n";
}

}  // namespace

Result<Section> prediction_section() {
  const auto hands = hand_predictions();
  if (!hands) return hands.error();
  const auto hand_us = hand_model_us();
  if (!hand_us) return hand_us.error();
  const auto surfaces = surface_predictions();
  if (!surfaces) return surfaces.error();
  Section section;
  for (const HandPredictionError& error : *hands)
    for (std::size_t model = 0; model < kHandModels.size(); ++model) {
      const std::string name = "hand prediction, recording " + error.trace + ", " + cell(error.ahead_ms) +
                               " ms ahead: " + std::string(kHandModels[model]);
      section.rows.push_back(measured(name + ", RMS error", 1e3 * error.all_m[model], "mm"));
      section.rows.push_back(measured(name + ", RMS error of the height", 1e3 * error.height_m[model], "mm"));
    }
  for (const SurfacePredictionError& error : *surfaces) {
    section.rows.push_back(measured("surface, prediction " + error.model + ": RMS error, patient still, after 1 s",
                                    1e3 * error.still_1s_m, "mm"));
    section.rows.push_back(measured("surface, prediction " + error.model + ": RMS error, patient still, after 3 s",
                                    1e3 * error.still_3s_m, "mm"));
    section.rows.push_back(measured("surface, prediction " + error.model + ": frames to follow a step of 3 mm",
                                    error.step_frames, "frames"));
    for (std::size_t age = 0; age < kSurfaceAges_s.size(); ++age)
      section.rows.push_back(measured("surface, prediction " + error.model + ": RMS error, breathing, " +
                                          cell(1e3 * kSurfaceAges_s[age]) + " ms old",
                                      1e3 * error.breathing_m[age], "mm"));
  }
  section.parts = {{"hand", to_markdown(hand_table(*hands)) + "\n" + hand_text(*hands) + hand_time_text(*hand_us)},
                   {"time", to_markdown(time_table(*surfaces)) + "\n" + time_text(*surfaces)}};
  return section;
}

}  // namespace telepalp::bench
