#include "server/capture/capture_source.h"
#include "server/capture/source_kind.h"
#include "server/capture/sources.h"

namespace telepalp::capture {
namespace {

constexpr SourceKind kKinds[] = {
    {"openni2", open_camera, false}, {"oni", open_oni, true},         {"images", open_images, true},
    {"pcd", open_pcd, true},         {"session", open_session, true}, {"synthetic", open_synthetic, false},
};
constexpr std::string_view kForms =
    "give openni2[:URI], oni:FILE, images:DIR, pcd:FILE, synthetic[:MODEL] or session:FILE.mcap";
constexpr std::string_view kSynthetic = "synthetic:";

}  // namespace

Result<void> check_source(std::string_view spec) {
  if (const Result<const SourceKind*> kind = kind_of(spec, kKinds, kForms); !kind) return kind.error();
  if (!spec.starts_with(kSynthetic)) return {};
  return check_synthetic(std::string(spec.substr(kSynthetic.size())));
}

Result<std::unique_ptr<CaptureSource>> open_source(std::string_view spec, const SourceOptions& options) {
  return open_by_kind(spec, kKinds, kForms, options);
}

}  // namespace telepalp::capture
