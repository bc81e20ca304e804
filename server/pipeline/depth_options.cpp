#include "server/pipeline/depth_options.h"

#include <optional>

#include "proto/words/number_word.h"

namespace telepalp::pipeline {
namespace {

constexpr double kMostLeast_mm = 100.0;
constexpr double kMostPerM2_mm = 20.0;

std::string option_name(std::string_view option) { return "--" + std::string(option); }

/// Parses a number from 0 to `most`; nullopt for any other text.
std::optional<double> read_mm(std::string_view text, double most) {
  const std::optional<double> value = number_of(text);
  return value && *value >= 0.0 && *value <= most ? value : std::nullopt;
}

}  // namespace

Result<DepthErrorBound> read_depth_bound(const std::string& text, std::string_view option) {
  const std::size_t comma = text.find(',');
  const auto refused = [&](const std::string& what) {
    return Error{.what = "'" + text + "' " + what,
                 .where = option_name(option),
                 .fix = "give LEAST,PER_M2: an error of max(LEAST, PER_M2 z²) mm is allowed at a depth of z m, as in " +
                        option_name(option) + " 1,2.85"};
  };
  if (comma == std::string::npos) return refused("is not two numbers with a comma between them");
  const std::optional<double> least_mm = read_mm(std::string_view(text).substr(0, comma), kMostLeast_mm);
  const std::optional<double> per_m2_mm = read_mm(std::string_view(text).substr(comma + 1), kMostPerM2_mm);
  if (!least_mm) return refused("does not begin with a number from 0 to 100");
  if (!per_m2_mm) return refused("does not end with a number from 0 to 20");
  return DepthErrorBound{.least_m = *least_mm / 1000.0, .per_m = *per_m2_mm / 1000.0};
}

Result<codec::DepthStreamSettings> read_depth_settings(const program::Arguments& arguments,
                                                       const DepthOptionNames& names) {
  const std::string text = arguments.text(names.mode);
  const std::optional<codec::DepthMode> mode = codec::depth_mode(text);
  if (!mode)
    return Error{.what = "'" + text + "' is not a depth mode",
                 .where = option_name(names.mode),
                 .fix = "give fast, intra, temporal or bounded"};
  const Result<std::int64_t> key_every = arguments.whole("key-every", 1, 65535);
  if (!key_every) return key_every.error();
  codec::DepthStreamSettings settings{.mode = *mode, .key_every = static_cast<int>(*key_every)};
  if (!arguments.has(names.bound)) return settings;
  if (*mode != codec::DepthMode::Bounded)
    return Error{.what = "the mode " + text + " is lossless and takes no bound",
                 .where = option_name(names.bound),
                 .fix = "leave " + option_name(names.bound) + " out, or give " + option_name(names.mode) + " bounded"};
  const Result<DepthErrorBound> bound = read_depth_bound(arguments.text(names.bound), names.bound);
  if (!bound) return bound.error();
  settings.bound = *bound;
  return settings;
}

}  // namespace telepalp::pipeline
