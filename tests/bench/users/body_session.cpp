#include "tests/bench/users/body_session.h"

#include "foxglove/CameraCalibration.pb.h"
#include "haptic_station/station/bill/body_stream.h"
#include "proto/wire/mcap/writer.h"

namespace telepalp::bench {
namespace {

foxglove::CameraCalibration calibration_of(const Intrinsics& camera) {
  foxglove::CameraCalibration message;
  message.set_width(static_cast<std::uint32_t>(camera.width));
  message.set_height(static_cast<std::uint32_t>(camera.height));
  for (const double value : {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0}) message.add_k(value);
  return message;
}

}  // namespace

Result<void> write_body_session(const std::filesystem::path& file, double seconds) {
  const station::SeenBody body;
  const station::BodyStream stream(body, seconds);
  Result<wire::McapWriter> writer = wire::McapWriter::open(
      file, {.program = "telepalp-bench", .version = {}, .commit = {}, .source = "the body of a bill", .scene = {}});
  if (!writer) return writer.error();
  Result<void> written = writer->write(
      wire::make_message(wire::kCameraInfo, stream.images.front().published, calibration_of(stream.camera)));
  for (const wire::Message& image : stream.images)
    if (written) written = writer->write(image);
  return writer->finish(written);
}

}  // namespace telepalp::bench
