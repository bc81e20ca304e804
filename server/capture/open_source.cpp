#include "server/capture/capture_source.h"
#include "server/capture/source_kind.h"
#include "server/capture/sources.h"

namespace telepalp::capture {

Result<std::unique_ptr<CaptureSource>> open_source(std::string_view spec, const SourceOptions& options) {
  static constexpr SourceKind kKinds[] = {
      {"openni2", open_camera, false}, {"oni", open_oni, true},         {"images", open_images, true},
      {"pcd", open_pcd, true},         {"session", open_session, true}, {"synthetic", open_synthetic, false},
  };
  return open_by_kind(spec, kKinds,
                      "give openni2[:URI], oni:FILE, images:DIR, pcd:FILE, synthetic[:MODEL] or session:FILE.mcap",
                      options);
}

}  // namespace telepalp::capture
