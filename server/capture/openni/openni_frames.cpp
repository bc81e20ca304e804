#include "server/capture/openni/openni_frames.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace telepalp::capture {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kFramesPerSecond = 30;

/// True when the frame has `bytes_per_pixel` for each pixel of each row.
bool rows_are_there(const openni::VideoFrameRef& frame, int bytes_per_pixel) {
  const int width = frame.getWidth();
  const int height = frame.getHeight();
  return width > 0 && height > 0 && width <= kMaxImageSide && height <= kMaxImageSide && frame.getData() != nullptr &&
         frame.getStrideInBytes() >= width * bytes_per_pixel &&
         frame.getDataSize() >= frame.getStrideInBytes() * (height - 1) + width * bytes_per_pixel;
}

void copy_rows(const openni::VideoFrameRef& frame, std::size_t bytes_per_row, void* to) {
  for (int row = 0; row < frame.getHeight(); ++row)
    std::memcpy(static_cast<char*>(to) + static_cast<std::size_t>(row) * bytes_per_row,
                static_cast<const char*>(frame.getData()) + row * frame.getStrideInBytes(), bytes_per_row);
}

/// Focal length: half the pixels / tangent of half the angle. Without an angle from the driver, a Kinect's is assumed.
double focal_px(int pixels, float angle_rad, int width) {
  if (angle_rad > 0.1F && angle_rad < 3.0F) return 0.5 * pixels / std::tan(0.5 * static_cast<double>(angle_rad));
  return 525.0 * width / kWidth;
}

Intrinsics pinhole_of(const openni::VideoStream& stream) {
  const openni::VideoMode mode = stream.getVideoMode();
  Intrinsics pinhole;
  pinhole.width = mode.getResolutionX();
  pinhole.height = mode.getResolutionY();
  pinhole.fx = focal_px(pinhole.width, stream.getHorizontalFieldOfView(), pinhole.width);
  pinhole.fy = focal_px(pinhole.height, stream.getVerticalFieldOfView(), pinhole.width);
  pinhole.cx = 0.5 * (pinhole.width - 1);
  pinhole.cy = 0.5 * (pinhole.height - 1);
  return pinhole;
}

int distance_from_wanted(const openni::VideoMode& mode) {
  return std::abs(mode.getResolutionX() - kWidth) + std::abs(mode.getResolutionY() - kHeight) +
         10 * std::abs(mode.getFps() - kFramesPerSecond);
}

}  // namespace

std::optional<DepthImage> depth_image(const openni::VideoFrameRef& frame) {
  const openni::PixelFormat format = frame.getVideoMode().getPixelFormat();
  const bool fine = format == openni::PIXEL_FORMAT_DEPTH_100_UM;
  if ((!fine && format != openni::PIXEL_FORMAT_DEPTH_1_MM) || !rows_are_there(frame, 2)) return std::nullopt;
  const auto width = static_cast<std::size_t>(frame.getWidth());
  DepthImage image{frame.getWidth(), frame.getHeight(), fine ? 0.0001 : 0.001,
                   std::vector<std::uint16_t>(width * static_cast<std::size_t>(frame.getHeight()))};
  copy_rows(frame, 2 * width, image.samples.data());
  return image;
}

std::optional<ColorImage> color_image(const openni::VideoFrameRef& frame) {
  if (frame.getVideoMode().getPixelFormat() != openni::PIXEL_FORMAT_RGB888 || !rows_are_there(frame, 3))
    return std::nullopt;
  const auto width = static_cast<std::size_t>(frame.getWidth());
  ColorImage image{frame.getWidth(), frame.getHeight(),
                   std::vector<std::uint8_t>(3 * width * static_cast<std::size_t>(frame.getHeight()))};
  copy_rows(frame, 3 * width, image.rgb.data());
  return image;
}

CameraModel camera_of(openni::Device& device, const openni::VideoStream& depth, const openni::VideoStream& color) {
  CameraModel camera;
  camera.depth = pinhole_of(depth);
  camera.color = camera.depth;
  if (!color.isValid()) return camera;
  camera.color_registered = device.getImageRegistrationMode() == openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR;
  if (!camera.color_registered) camera.color = pinhole_of(color);
  return camera;
}

void choose_mode(openni::VideoStream& stream, openni::PixelFormat format) {
  const openni::Array<openni::VideoMode>& modes = stream.getSensorInfo().getSupportedVideoModes();
  const openni::VideoMode* best = nullptr;
  for (int i = 0; i < modes.getSize(); ++i)
    if (modes[i].getPixelFormat() == format &&
        (best == nullptr || distance_from_wanted(modes[i]) < distance_from_wanted(*best)))
      best = &modes[i];
  if (best != nullptr) (void)stream.setVideoMode(*best);
}

}  // namespace telepalp::capture
