#include <string>

#include "server/capture/capture_source.h"
#include "server/capture/sources.h"

namespace telepalp::server {
namespace {

using Opener = Result<std::unique_ptr<CaptureSource>> (*)(const std::string& rest, const SourceOptions& options);

struct Kind {
  std::string_view name;
  Opener open;
  bool needs_rest;  ///< a file or directory must follow the colon
};

constexpr Kind kKinds[] = {
    {"openni2", open_camera, false}, {"oni", open_oni, true},         {"images", open_images, true},
    {"pcd", open_pcd, true},         {"session", open_session, true}, {"synthetic", open_synthetic, false},
};

constexpr std::string_view kForms =
    "give openni2[:URI], oni:FILE, images:DIR, pcd:FILE, synthetic[:MODEL] or session:FILE.mcap";

}  // namespace

Result<std::unique_ptr<CaptureSource>> open_source(std::string_view spec, const SourceOptions& options) {
  const std::size_t colon = spec.find(':');
  const std::string_view name = spec.substr(0, colon);
  const std::string rest{colon == std::string_view::npos ? std::string_view{} : spec.substr(colon + 1)};
  const std::string where = "--source " + std::string(spec);
  for (const Kind& kind : kKinds) {
    if (kind.name != name) continue;
    if (kind.needs_rest && rest.empty())
      return Error{.what = "nothing stands behind the colon", .where = where, .fix = std::string(kForms)};
    return kind.open(rest, options);
  }
  return Error{
      .what = "'" + std::string(name) + "' is not a kind of source", .where = where, .fix = std::string(kForms)};
}

}  // namespace telepalp::server
