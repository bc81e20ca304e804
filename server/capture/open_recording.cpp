#include "server/capture/open_recording.h"

#include <string>

#include "server/capture/source_kind.h"
#include "server/capture/sources.h"

namespace telepalp::capture {

Result<std::unique_ptr<CaptureSource>> open_by_kind(std::string_view spec, std::span<const SourceKind> kinds,
                                                    std::string_view forms, const SourceOptions& options) {
  const std::size_t colon = spec.find(':');
  const std::string_view name = spec.substr(0, colon);
  const std::string rest{colon == std::string_view::npos ? std::string_view{} : spec.substr(colon + 1)};
  const std::string where = "source " + std::string(spec);
  for (const SourceKind& kind : kinds) {
    if (kind.name != name) continue;
    if (kind.needs_rest && rest.empty())
      return Error{.what = "a file or folder must follow '" + std::string(name) + ":'",
                   .where = where,
                   .fix = std::string(forms)};
    return kind.open(rest, options);
  }
  return Error{
      .what = "'" + std::string(name) + "' is not a kind of source", .where = where, .fix = std::string(forms)};
}

Result<std::unique_ptr<CaptureSource>> open_recording(std::string_view spec, const SourceOptions& options) {
  static constexpr SourceKind kKinds[] = {
      {"oni", open_oni, true}, {"images", open_images, true}, {"pcd", open_pcd, true}, {"session", open_session, true}};
  // Only users of telepalp-replay name the kind themselves; it opens the kind `synthetic` without this function.
  return open_by_kind(spec, kKinds, "give oni:FILE, images:DIR, pcd:FILE, synthetic[:MODEL] or session:FILE.mcap",
                      options);
}

}  // namespace telepalp::capture
