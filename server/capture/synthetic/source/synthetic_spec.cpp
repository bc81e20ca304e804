#include "server/capture/synthetic/source/synthetic_spec.h"

#include <optional>
#include <string_view>

#include "proto/words/number_word.h"

namespace telepalp::capture {
namespace {

constexpr double kMm = 0.001;

bool set_switch(std::string_view text, bool& target) {
  if (text != "on" && text != "off") return false;
  target = text == "on";
  return true;
}

/// Sets `target` when `text` is a number of `unit` within the bounds, given in `unit`.
bool set_number(std::string_view text, double least, double most, double unit, double& target) {
  const std::optional<double> value = number_of(text);
  if (!value || !(*value >= least && *value <= most)) return false;
  target = *value * unit;
  return true;
}

bool set_noise(std::string_view text, SyntheticSettings& settings) {
  if (text == "none" || text == "kinect") {
    settings.noise = text == "none" ? DepthNoise::None : DepthNoise::Kinect;
    return true;
  }
  settings.noise = DepthNoise::Gaussian;
  return set_number(text, 0.0, 100.0, kMm, settings.gaussian_sigma_m);
}

bool set_seed(std::string_view text, std::uint64_t& seed) {
  const std::optional<std::uint64_t> value = number_of<std::uint64_t>(text);
  if (value) seed = *value;
  return value.has_value();
}

bool set_motion(std::string_view text, SyntheticSettings& settings) {
  const std::optional<Motion> motion = motion_named(text);
  if (motion) settings.motion = *motion;
  return motion.has_value();
}

/// Sets a Kinect's camera with this many columns, the same field of view, and the aspect ratio 4:3.
bool set_width(std::string_view text, SyntheticSettings& settings) {
  constexpr double kMostWidth = 640.0;
  const std::optional<double> width = number_of(text);
  if (!width || (*width != 160.0 && *width != 320.0 && *width != kMostWidth)) return false;
  const Intrinsics whole = SyntheticSettings{}.camera;
  const double share = *width / kMostWidth;
  const auto centre = [share](double at_px) { return (at_px + 0.5) * share - 0.5; };
  settings.camera = {.width = static_cast<int>(*width),
                     .height = static_cast<int>(share * whole.height),
                     .fx = share * whole.fx,
                     .fy = share * whole.fy,
                     .cx = centre(whole.cx),
                     .cy = centre(whole.cy)};
  return true;
}

struct Key {
  std::string_view name;
  std::string_view values;
  bool (*set)(std::string_view value, SyntheticSettings& settings);
};

constexpr Key kKeys[] = {
    {"motion", "regular, irregular, cough, hold, speech, shift, drift or sit-up", set_motion},
    {"amplitude_mm", "0 to 50, in mm",
     [](std::string_view v, SyntheticSettings& s) { return set_number(v, 0.0, 50.0, kMm, s.amplitude_m); }},
    {"rate_hz", "0 to 2, in breaths per second",
     [](std::string_view v, SyntheticSettings& s) { return set_number(v, 0.0, 2.0, 1.0, s.rate_hz); }},
    {"seed", "a whole number", [](std::string_view v, SyntheticSettings& s) { return set_seed(v, s.seed); }},
    {"noise", "none, kinect, or a standard deviation of 0 to 100, in mm", set_noise},
    {"steps", "on or off", [](std::string_view v, SyntheticSettings& s) { return set_switch(v, s.disparity_steps); }},
    {"holes", "on or off", [](std::string_view v, SyntheticSettings& s) { return set_switch(v, s.holes); }},
    {"unit_mm", "0.05 to 10, the mm for a depth pixel's value of 1",
     [](std::string_view v, SyntheticSettings& s) { return set_number(v, 0.05, 10.0, kMm, s.depth_unit_m); }},
    {"hand", "on or off: every 24 s, a colleague's hand comes over the belly for 10 s",
     [](std::string_view v, SyntheticSettings& s) { return set_switch(v, s.colleague); }},
    {"width", "160, 320 or 640 pixels", set_width},
};

std::string all_keys() {
  std::string text;
  for (const Key& key : kKeys)
    text += (text.empty() ? "" : "; ") + std::string(key.name) + " (" + std::string(key.values) + ")";
  return text;
}

Result<void> apply(std::string_view pair, SyntheticSettings& settings) {
  const std::string where = "--source synthetic: " + std::string(pair);
  const std::size_t equals = pair.find('=');
  const std::string_view name = pair.substr(0, equals);
  for (const Key& key : kKeys) {
    if (key.name != name) continue;
    if (equals != std::string_view::npos && key.set(pair.substr(equals + 1), settings)) return {};
    return Error{.what = "the value of " + std::string(key.name) + " is not allowed",
                 .where = where,
                 .fix = "give " + std::string(key.name) + "=VALUE; VALUE is " + std::string(key.values)};
  }
  return Error{.what = "'" + std::string(name) + "' is not a setting of the synthetic patient",
               .where = where,
               .fix = "give one of these: " + all_keys()};
}

}  // namespace

Result<SyntheticSpec> parse_synthetic_spec(const std::string& text) {
  SyntheticSpec spec;
  std::string_view rest = text;
  for (bool first = true; !rest.empty(); first = false) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
    if (first && word.find('=') == std::string_view::npos) {
      if (!word.empty()) spec.model = word;
    } else if (const Result<void> applied = apply(word, spec.settings); !applied) {
      return applied.error();
    }
  }
  return spec;
}

}  // namespace telepalp::capture
