#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/accuracy_surface.h"

namespace telepalp::bench {
namespace {

/// The slope of the skin against the camera's ray, on a sphere of 80 mm, for the few settings and narrower windows.
PageTable slopes_table(std::vector<Row>& rows) {
  const RenderedShape sphere = rendered_sphere(0.0015);
  std::vector<SurfaceVariant> variants = few_variants();
  for (const SurfaceVariant& variant : surface_variants())
    if (variant.name == "fast, fit 3" || variant.name == "fast, support 1.5") variants.push_back(variant);
  PageTable table{.head = {"setting"}, .rows = {}};
  for (const SurfaceVariant& variant : variants)
    table.rows.push_back({variant.named ? "`" + variant.name + "`" : variant.name});
  for (const double slope_deg : {10.0, 30.0, 45.0, 55.0, 65.0, 72.0, 78.0}) {
    table.head.push_back(cell(slope_deg) + "°, µm / °");
    for (std::size_t k = 0; k < variants.size(); ++k) {
      const TouchError error = slope_touch_error(sphere, variants[k], slope_deg);
      table.rows[k].push_back(both(error, 1e6));
      rows.push_back(
          measured(variants[k].name + ": RMS position error, sphere of 80 mm, slope of " + cell(slope_deg) + " degrees",
                   1e6 * error.position_m, "um"));
    }
  }
  return table;
}

}  // namespace

Result<Section> slopes_section() {
  Section section;
  section.parts = {{"slopes", to_markdown(slopes_table(section.rows))}};
  return section;
}

}  // namespace telepalp::bench
