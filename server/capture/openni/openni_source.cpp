#include <filesystem>
#include <thread>

#include "server/capture/openni/openni_device.h"
#include "server/capture/openni/reconnecting_source.h"
#include "server/capture/sources.h"

namespace telepalp::capture {

Result<std::unique_ptr<CaptureSource>> open_camera(const std::string& uri, const SourceOptions& options) {
  // A file is not passed to OpenNI2, because a damaged file crashes OpenNI2's player.
  std::error_code code;
  if (std::filesystem::exists(uri, code) && !std::filesystem::is_character_file(uri, code))
    return std::filesystem::is_directory(uri, code)
               ? Error{.what = "is a folder, not a camera", .where = uri, .fix = "give --source images:" + uri}
               : Error{.what = "is a file, not a camera", .where = uri, .fix = "give --source oni:" + uri};
  std::unique_ptr<CameraDevice> device = make_openni_device(uri, options.clock);
  if (const Result<void> opened = device->open(); !opened) return opened.error();
  const wire::SessionClock clock = options.clock;
  return std::unique_ptr<CaptureSource>{std::make_unique<ReconnectingSource>(
      std::move(device), SourceTime{.now = [clock] { return clock.now(); },
                                    .sleep = [](Nanoseconds span) { std::this_thread::sleep_for(span); }})};
}

}  // namespace telepalp::capture
