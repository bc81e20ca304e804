#include "clients/mixed/hand/hand_mask.h"

#include <cmath>
#include <cstdlib>
#include <vector>

namespace telepalp::mixed {
namespace {

constexpr std::size_t kLeastSamples = 50;  // with fewer pixels of the hand outside the device, no colour is fitted
constexpr std::size_t kSampleStep = 5;     // every fifth pixel is a sample; more samples change no figure

Mask differing(const ColorImage& live, const ColorImage& background, const Mask& known,
               const DifferenceSettings& settings) {
  Mask differs(live.width, live.height), sure(live.width, live.height);
  for (std::size_t i = 0; i < known.on.size(); ++i) {
    if (known.on[i] == 0) continue;
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += std::abs(int{live.rgb[3 * i + c]} - int{background.rgb[3 * i + c]});
    differs.on[i] = sum > 3 * settings.least_levels ? 1 : 0;
    sure.on[i] = sum > 3 * settings.sure_levels ? 1 : 0;
  }
  return reconstructed(sure, differs);
}

/// True if the colour is the hand's. Only pixels within the device's mask are tested, so that filling a table of all
/// colours would cost more. The intensity is tested first: it rules out most pixels cheaply.
bool is_hand(const HandColour& hand, const std::uint8_t* rgb) {
  const double intensity = (rgb[0] + rgb[1] + rgb[2]) / 765.0;
  if (std::abs(intensity - hand.key.intensity) > hand.threshold * hand.intensity_deviation) return false;
  return mahalanobis(hand, hsi_of({rgb[0], rgb[1], rgb[2]})) <= hand.threshold;
}

}  // namespace

std::vector<Rgb> colors_of(const ColorImage& image, const Mask& where) {
  std::vector<Rgb> samples;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < where.on.size(); ++i)
    if (where.on[i] != 0 && seen++ % kSampleStep == 0)
      samples.push_back({image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]});
  return samples;
}

Mask hand_by_colour(const ColorImage& live, const HandColourTable& hand, const CleanUp& how) {
  Mask mask(live.width, live.height);
  for (std::size_t i = 0; i < mask.on.size(); ++i) mask.on[i] = hand.contains(live.rgb.data() + 3 * i) ? 1 : 0;
  return cleaned(mask, how);
}

Mask hand_before_background(const ColorImage& live, const ColorImage& background, const Mask& known, const Mask& device,
                            const DifferenceSettings& settings) {
  Mask hand = differing(live, background, known, settings);
  Mask outside = hand;
  for (std::size_t i = 0; i < device.on.size(); ++i)
    if (device.on[i] != 0) outside.on[i] = 0;
  // Erosion removes the hand's rim, where colours mix with the background's, and specks, which are noise.
  const std::vector<Rgb> samples = colors_of(live, eroded(outside, settings.clean_up.opening_px));
  if (samples.size() * kSampleStep < kLeastSamples) return cleaned(outside, settings.clean_up);
  HandColour colour = fit_hand_colour(samples);
  colour.threshold = settings.hand_threshold;
  for (std::size_t i = 0; i < device.on.size(); ++i)
    if (device.on[i] != 0 && hand.on[i] != 0 && !is_hand(colour, live.rgb.data() + 3 * i)) hand.on[i] = 0;
  return cleaned(hand, settings.clean_up);
}

}  // namespace telepalp::mixed
