#include "server/capture/open_recording.h"

#include <string>

#include "server/capture/source_kind.h"
#include "server/capture/sources.h"

namespace telepalp::capture {

namespace {

struct Parts {
  std::string_view name;
  std::string rest;
};

Parts parts_of(std::string_view spec) {
  const std::size_t colon = spec.find(':');
  return {spec.substr(0, colon), std::string(colon == std::string_view::npos ? "" : spec.substr(colon + 1))};
}

}  // namespace

Result<const SourceKind*> kind_of(std::string_view spec, std::span<const SourceKind> kinds, std::string_view forms) {
  const Parts parts = parts_of(spec);
  const std::string where = "source " + std::string(spec);
  for (const SourceKind& kind : kinds) {
    if (kind.name != parts.name) continue;
    if (kind.needs_rest && parts.rest.empty())
      return Error{.what = "a file or folder must follow '" + std::string(parts.name) + ":'",
                   .where = where,
                   .fix = std::string(forms)};
    return &kind;
  }
  return Error{
      .what = "'" + std::string(parts.name) + "' is not a kind of source", .where = where, .fix = std::string(forms)};
}

Result<std::unique_ptr<CaptureSource>> open_by_kind(std::string_view spec, std::span<const SourceKind> kinds,
                                                    std::string_view forms, const SourceOptions& options) {
  const Result<const SourceKind*> kind = kind_of(spec, kinds, forms);
  if (!kind) return kind.error();
  return (*kind)->open(parts_of(spec).rest, options);
}

Result<std::unique_ptr<CaptureSource>> open_recording(std::string_view spec, const SourceOptions& options) {
  static constexpr SourceKind kKinds[] = {
      {"oni", open_oni, true}, {"images", open_images, true}, {"pcd", open_pcd, true}, {"session", open_session, true}};
  // Only users of telepalp-replay name the kind themselves; it opens the kind `synthetic` without this function.
  return open_by_kind(spec, kKinds, "give oni:FILE, images:DIR, pcd:FILE, synthetic[:MODEL] or session:FILE.mcap",
                      options);
}

}  // namespace telepalp::capture
