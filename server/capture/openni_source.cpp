#include <array>
#include <fstream>
#include <string_view>
#include <thread>

#include "server/capture/openni_device.h"
#include "server/capture/reconnecting_source.h"
#include "server/capture/sources.h"

namespace telepalp::server {
namespace {

constexpr std::string_view kOniMagic = "NI10";

Result<std::unique_ptr<CaptureSource>> open_device(OpenNiAddress address, const SourceOptions& options) {
  std::unique_ptr<CameraDevice> device = make_openni_device(std::move(address), options.clock);
  if (const Result<void> opened = device->open(); !opened) return opened.error();
  const wire::SessionClock clock = options.clock;
  return std::unique_ptr<CaptureSource>{std::make_unique<ReconnectingSource>(
      std::move(device), SourceTime{.now = [clock] { return clock.now(); },
                                    .sleep = [](Nanoseconds span) { std::this_thread::sleep_for(span); }})};
}

}  // namespace

Result<std::unique_ptr<CaptureSource>> open_camera(const std::string& uri, const SourceOptions& options) {
  return open_device({.uri = uri, .recording = false, .loop = true}, options);
}

Result<std::unique_ptr<CaptureSource>> open_oni(const std::string& file, const SourceOptions& options) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return Error{.what = "cannot be read", .where = file, .fix = "check the path and its permissions"};
  std::array<char, kOniMagic.size()> magic{};
  if (!stream.read(magic.data(), magic.size()) || std::string_view{magic.data(), magic.size()} != kOniMagic)
    return Error{.what = "is not an .oni recording",
                 .where = file,
                 .fix = "give a recording made by OpenNI's recorder (NiViewer writes them)"};
  return open_device({.uri = file, .recording = true, .loop = options.loop, .paced = options.paced}, options);
}

}  // namespace telepalp::server
