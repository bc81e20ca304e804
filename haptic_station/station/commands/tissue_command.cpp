#include "haptic_station/station/commands/tissue_command.h"

#include <cstdio>

#include "haptic_station/calibration/tissue_fit.h"
#include "haptic_station/effects/presets/tissue_presets.h"
#include "support/program/options.h"

namespace telepalp::station {
namespace {

program::Usage tissue_usage() {
  return {.program = "telepalp-station tissue",
          .purpose =
              "fits the skin's stiffness to a compression test of a tissue or phantom, and prints the fit's error; "
              "without a test, lists the tissue presets and their errors",
          .positional = "",
          .options = {{"test", "FILE", "CSV: a header row, then rows compression_mm,load_N"},
                      {"diameter-mm", "MM", "diameter of the specimen, in millimetres", "50"},
                      {"height-mm", "MM", "height of the tested specimen before the test, in millimetres", "30"},
                      {"contact-mm", "MM", "diameter of the fingers' contact with the skin, in millimetres", "30"},
                      {"thickness-mm", "MM", "thickness of the tissue under the hand, in millimetres", "60"},
                      {"to-strain", "SHARE",
                       "largest strain of the test that the fit uses: compression / height of the specimen", "0.5"}},
          .example = "telepalp-station tissue --test tests/data/tissue/EF10_50T.csv"};
}

void print_law(const effects::SkinLaw& law) {
  std::printf("effects { skin { measured { constant_N_per_m: %.4g slope_N_per_m2: %.4g curve_N_per_m3: %.4g } } }\n",
              law.constant_N_per_m, law.slope_N_per_m2, law.curve_N_per_m3);
}

int list_presets() {
  std::printf(
      "force of the skin at an indentation of 10, 20 and 30 mm, for each tissue that a scene can name by "
      "skin { tissue: \"NAME\" }\n%-14s %-12s %10s %10s %10s   %s\n",
      "tissue", "material", "N at 10 mm", "N at 20 mm", "N at 30 mm", "RMS fit error, % of the largest load");
  for (const effects::TissuePreset& preset : effects::kTissuePresets) {
    const auto force_N = [&](double d) { return preset.law.stiffness_N_per_m(d) * d; };
    std::printf("%-14s %-12s %10.2f %10.2f %10.2f   %.1f %%\n", preset.name.data(), preset.material.data(),
                force_N(0.01), force_N(0.02), force_N(0.03), 100.0 * preset.rms_error_share);
  }
  return program::kDone;
}

/// The options; lengths are in millimetres.
struct Asked {
  calibration::Specimen specimen;
  calibration::TissueUnderHand tissue;
  double to_strain = 0.5;
};

Result<Asked> asked_of(const program::Arguments& arguments) {
  Asked asked;
  const auto read_m = [&](const char* option, double& into_m) -> Result<void> {
    const Result<double> mm = arguments.number(option, 0.1, 1000.0);
    if (!mm) return mm.error();
    into_m = 1e-3 * *mm;
    return {};
  };
  const std::pair<const char*, double*> lengths[] = {{"diameter-mm", &asked.specimen.diameter_m},
                                                     {"height-mm", &asked.specimen.height_m},
                                                     {"contact-mm", &asked.tissue.contact_diameter_m},
                                                     {"thickness-mm", &asked.tissue.thickness_m}};
  for (const auto& [option, into_m] : lengths)
    if (const Result<void> read = read_m(option, *into_m); !read) return read.error();
  const Result<double> strain = arguments.number("to-strain", 0.01, 1.0);
  if (!strain) return strain.error();
  asked.to_strain = *strain;
  return asked;
}

Result<calibration::TissueFit> fit(const std::filesystem::path& file, const Asked& asked) {
  auto test = calibration::read_compression_test(file);
  if (!test) return test.error();
  std::erase_if(*test, [&](const calibration::CompressionSample& sample) {
    return sample.compression_m > asked.to_strain * asked.specimen.height_m;
  });
  return calibration::fit_tissue(calibration::under_hand(*test, asked.specimen, asked.tissue));
}

int print_fit(const program::Arguments& arguments) {
  if (!arguments.has("test")) return list_presets();
  const Result<Asked> asked = asked_of(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  const Result<calibration::TissueFit> found = fit(arguments.text("test"), *asked);
  if (!found) return program::fail(found.error());
  std::printf("# %zu rows; RMS error %.3f N, %.1f %% of the largest load; valid to a depth of %.0f mm\n",
              found->samples, found->rms_error_N, 100.0 * found->rms_error_share,
              1e3 * asked->to_strain * asked->tissue.thickness_m);
  print_law(found->law);
  return program::kDone;
}

}  // namespace

int tissue_command(int argc, const char* const* argv) {
  return program::run_program(tissue_usage(), argc, argv, print_fit);
}

}  // namespace telepalp::station
