#include "tools/replay/commands/settings.h"

#include <array>
#include <cstdio>

#include "proto/wire/depth_loss.h"
#include "support/program/version.h"
#include "tools/replay/source/content_digest.h"
#include "tools/replay/words/words.h"

namespace telepalp::replay {
namespace {

std::string exact_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.12g", value);
  return text.data();
}

std::string milliseconds(Nanoseconds span) { return exact_number(to_milliseconds(span)); }

std::string direction(const impaired::Impairment& path) {
  std::string text = "delay " + milliseconds(path.delay) + " ms, jitter " + milliseconds(path.jitter) + " ms, loss " +
                     exact_number(100.0 * path.loss) + " % in bursts of " + exact_number(path.burst_packets) +
                     ", reordered " + exact_number(100.0 * path.reorder) + " % by " + milliseconds(path.reorder_by) +
                     " ms, twice " + exact_number(100.0 * path.duplicate) + " %, damaged " +
                     exact_number(100.0 * path.corrupt) + " %";
  if (path.rate_B_per_s > 0.0)
    text += ", at most " + exact_number(path.rate_B_per_s / 125.0) + " kbit/s with a queue of " +
            std::to_string(path.queue_B) + " B";
  if (path.outage_every > Nanoseconds{0})
    text += ", every " + milliseconds(path.outage_every) + " ms an outage of " + milliseconds(path.outage_for) + " ms";
  return text;
}

/// "1000ms+200ms:20,…": as on the command line; "none" without windows.
template <class Fault, class Words>
std::string faults(const std::vector<Fault>& all, Words words) {
  std::string text;
  for (const Fault& fault : all) text += (text.empty() ? "" : ",") + words(fault);
  return text.empty() ? "none" : text;
}

std::string depth_coding(const TapeSettings& tape) {
  const codec::DepthStreamSettings& depth = tape.depth;
  std::string text(codec::name(depth.mode));
  if (depth.mode == codec::DepthMode::Bounded)
    text += ", depth within max(" + exact_number(1e3 * depth.bound.least_m) + " mm, " +
            exact_number(1e3 * depth.bound.per_m) + " mm × (z / 1 m)²)";
  if (depth.mode == codec::DepthMode::Bounded || depth.mode == codec::DepthMode::Temporal)
    text += ", a key frame every " + std::to_string(depth.key_every) + " frames";
  return text;
}

}  // namespace

std::map<std::string, std::string> settings_of(const Request& request, const Scenario& scenario) {
  const Faults& all = scenario.faults;
  return {{"surface_setting", request.surface.name},
          {"depth_coding", depth_coding(request.tape)},
          {"color", request.tape.color ? "JPEG of quality " + std::to_string(request.tape.jpeg_quality) : "none"},
          {"recording_repeats", request.tape.repeat ? "yes" : "no"},
          {"encode_ms", milliseconds(scenario.stages.encode)},
          {"decode_ms", milliseconds(scenario.stages.decode)},
          {"build_ms", milliseconds(scenario.stages.build)},
          {"collision_ms", milliseconds(scenario.stages.collision)},
          {"slow_effects_ms", milliseconds(scenario.stages.effects)},
          {"deadline_ms", milliseconds(scenario.deadline)},
          {"network_down", direction(scenario.down)},
          {"network_up", direction(scenario.up)},
          {"outage", faults(all.outages, window_in_words)},
          {"restart", faults(all.restarts, window_in_words)},
          {"tracker_lost", faults(all.tracker_lost, window_in_words)},
          {"glitch", faults(all.glitches,
                            [](const EncoderGlitch& one) {
                              return window_in_words(one.when) + ":" + exact_number(1e3 * one.off_m);
                            })},
          {"clock_step", faults(all.clock_steps, [](const ClockStep& one) {
             return window_in_words(one.when) + ":" + span_in_words(one.by);
           })}};
}

namespace {

std::string in_words(const Intrinsics& camera) {
  return std::to_string(camera.width) + "x" + std::to_string(camera.height) + " pixels, focal lengths in x and y " +
         exact_number(camera.fx) + " and " + exact_number(camera.fy) + " px, principal point at " +
         exact_number(camera.cx) + ", " + exact_number(camera.cy) + " px";
}

}  // namespace

void add_settings(program::Json& json, const Request& request, const Scenario& scenario, const RunOptions& options,
                  const ImageFacts& images) {
  json.begin_object("settings");
  for (const auto& [name, text] : settings_of(request, scenario)) json.add(name, text);
  json.add("depth_camera", in_words(images.camera));
  json.end_object();
  json.begin_object("again");
  json.add("source", request.source);
  json.add("source_digest", request.source_digest);
  json.add("scene_text", request.scene_text);
  json.begin_object("options");
  for (const auto& [name, text] : options) json.add(name, text);
  json.end_object();
  json.end_object();
}

std::string identity_of(const Request& request, const Scenario& scenario) {
  ContentDigest digest;
  for (const std::string& part :
       {std::string(program::version()), std::string(program::commit()), request.source, request.source_digest,
        request.scene_text, exact_number(request.seconds),
        std::string(request.recorded.empty() ? name(scenario.hand) : "recorded"), std::to_string(scenario.seed)})
    digest.add(std::to_string(part.size()) + ":" + part);
  for (const auto& [name, text] : settings_of(request, scenario)) digest.add(name + "=" + text + ";");
  return digest.hex();
}

}  // namespace telepalp::replay
