#include "server/capture/openni/openni_device.h"

#include <OpenNI.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <string_view>
#include <thread>
#include <utility>

#include "server/capture/capture_source.h"
#include "server/capture/openni/color_depth_pairing.h"
#include "server/capture/openni/openni_frames.h"

namespace telepalp::capture {
namespace {

constexpr std::chrono::milliseconds kTwoPeriods{70};

/// OpenNI's text about its last error, on one line.
std::string last_words() {
  std::string words = openni::OpenNI::getExtendedError();
  for (char& letter : words)
    if (letter == '\n' || letter == '\t') letter = ' ';
  while (!words.empty() && words.back() == ' ') words.pop_back();
  words.erase(0, words.find_first_not_of(' '));
  return words.empty() ? "OpenNI2 gives no reason" : words;
}

/// Initialises OpenNI. OpenNI counts initialisations, so each device object has its own session.
class Session {
 public:
  Session() : status_(openni::OpenNI::initialize()) {}
  ~Session() {
    if (status_ == openni::STATUS_OK) openni::OpenNI::shutdown();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  [[nodiscard]] bool ok() const noexcept { return status_ == openni::STATUS_OK; }

 private:
  openni::Status status_;
};

/// Listens for an unplugged device; OpenNI calls it on its own thread.
class Unplugged final : public openni::OpenNI::DeviceDisconnectedListener {
 public:
  Unplugged() { openni::OpenNI::addDeviceDisconnectedListener(this); }
  ~Unplugged() override { openni::OpenNI::removeDeviceDisconnectedListener(this); }
  Unplugged(const Unplugged&) = delete;
  Unplugged& operator=(const Unplugged&) = delete;

  void onDeviceDisconnected(const openni::DeviceInfo* info) override {
    if (watched_ == hash_of(info->getUri())) gone_ = true;
  }
  void watch(const char* uri) {
    gone_ = false;
    watched_ = hash_of(uri);
  }
  [[nodiscard]] bool gone() const noexcept { return gone_; }

 private:
  static std::size_t hash_of(std::string_view uri) { return std::hash<std::string_view>{}(uri); }

  std::atomic<std::size_t> watched_{0};  // hash of the URI, because two threads cannot share a string without a lock
  std::atomic<bool> gone_{false};        // set by: OpenNI's thread
};

class OpenNiDevice final : public CameraDevice {
 public:
  OpenNiDevice(std::string uri, wire::SessionClock clock) : uri_(std::move(uri)), clock_(clock) {}
  ~OpenNiDevice() override { close(); }
  OpenNiDevice(const OpenNiDevice&) = delete;
  OpenNiDevice& operator=(const OpenNiDevice&) = delete;

  Result<void> open() override;
  Read read(Nanoseconds patience) override;
  void close() override;
  std::string describe() const override { return description_; }
  std::optional<ExposureLimits> exposure_limits() override;
  Exposure exposure() override;
  bool set_exposure(const Exposure& exposure) override;

 private:
  [[nodiscard]] Error failed(const std::string& what) const;
  Result<void> start_streams();
  void prepare_camera();
  Read take_ready(openni::VideoStream& stream);
  [[nodiscard]] Read paired();

  std::string uri_;
  wire::SessionClock clock_;
  // Members are destroyed from last to first: streams, then the device, then OpenNI. Any other order crashes.
  Session session_;
  Unplugged unplugged_;
  openni::Device device_;
  openni::VideoStream depth_;
  openni::VideoStream color_;
  ColorDepthPairing pairing_;
  CameraModel camera_;
  std::chrono::steady_clock::time_point started_;
  std::string description_ = "OpenNI2 camera";
};

Error OpenNiDevice::failed(const std::string& what) const {
  return {
      .what = what + ": " + last_words(),
      .where = uri_.empty() ? "openni2" : uri_,
      .fix =
          "plug in a depth camera, check that `lsusb` lists it and that its OpenNI2 driver is installed, or start with "
          "--source synthetic"};
}

Result<void> OpenNiDevice::open() {
  if (!session_.ok()) return failed("OpenNI2 does not start");
  close();
  if (device_.open(uri_.empty() ? openni::ANY_DEVICE : uri_.c_str()) != openni::STATUS_OK)
    return failed("no camera can be opened");
  unplugged_.watch(device_.getDeviceInfo().getUri());
  Result<void> started = start_streams();
  if (!started) close();
  return started;
}

Result<void> OpenNiDevice::start_streams() {
  if (device_.getSensorInfo(openni::SENSOR_DEPTH) == nullptr ||
      depth_.create(device_, openni::SENSOR_DEPTH) != openni::STATUS_OK)
    return failed("the camera has no depth stream");
  if (device_.getSensorInfo(openni::SENSOR_COLOR) != nullptr) (void)color_.create(device_, openni::SENSOR_COLOR);
  prepare_camera();
  if (depth_.start() != openni::STATUS_OK) return failed("the camera's depth stream does not start");
  if (color_.isValid() && color_.start() != openni::STATUS_OK) color_.destroy();
  started_ = std::chrono::steady_clock::now();
  camera_ = camera_of(device_, depth_, color_);
  if (!is_well_formed(camera_.depth)) return failed("the camera states no usable image size or focal length");
  const std::string name = device_.getDeviceInfo().getName();
  description_ = (name.empty() ? "camera " + std::string(device_.getDeviceInfo().getUri()) : name) + " " +
                 std::to_string(camera_.depth.width) + "x" + std::to_string(camera_.depth.height) +
                 (color_.isValid() ? " depth and colour" : " depth") +
                 (camera_.color_registered || !color_.isValid() ? "" : ", colour not aligned with depth");
  return {};
}

void OpenNiDevice::prepare_camera() {
  choose_mode(depth_, openni::PIXEL_FORMAT_DEPTH_1_MM);
  if (color_.isValid()) choose_mode(color_, openni::PIXEL_FORMAT_RGB888);
  // A mirrored image would put the doctor's left hand on the patient's right side.
  (void)depth_.setMirroringEnabled(false);
  if (!color_.isValid()) return;
  (void)color_.setMirroringEnabled(false);
  if (device_.isImageRegistrationModeSupported(openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR))
    (void)device_.setImageRegistrationMode(openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR);
  (void)device_.setDepthColorSyncEnabled(true);
}

CameraDevice::Read OpenNiDevice::read(Nanoseconds patience) {
  const SessionTime until = clock_.now() + patience;
  for (;;) {
    if (unplugged_.gone()) return Gone{"the camera was unplugged"};
    if (Read pair = paired(); !std::holds_alternative<Nothing>(pair)) return pair;
    const Nanoseconds left = until - clock_.now();
    if (left <= Nanoseconds{0}) return Nothing{};
    const Nanoseconds wait = pairing_.waiting() ? std::min(left, ColorDepthPairing::kWaitForColor) : left;
    openni::VideoStream* streams[] = {&depth_, &color_};
    int ready = -1;
    const openni::Status status = openni::OpenNI::waitForAnyStream(streams, color_.isValid() ? 2 : 1, &ready,
                                                                   static_cast<int>(std::ceil(to_milliseconds(wait))));
    if (status == openni::STATUS_TIME_OUT) continue;
    if (status != openni::STATUS_OK) return Gone{last_words()};
    if (Read gone = take_ready(*streams[ready]); std::holds_alternative<Gone>(gone)) return gone;
  }
}

CameraDevice::Read OpenNiDevice::take_ready(openni::VideoStream& stream) {
  openni::VideoFrameRef frame;
  if (stream.readFrame(&frame) != openni::STATUS_OK) return Gone{last_words()};
  const std::chrono::microseconds driver_time{static_cast<std::int64_t>(frame.getTimestamp())};
  if (&stream == &depth_) {
    if (std::optional<DepthImage> depth = depth_image(frame))
      pairing_.add_depth(driver_time, clock_.now(), std::move(*depth));
  } else if (std::optional<ColorImage> color = color_image(frame)) {
    pairing_.add_color(driver_time, std::move(*color));
  }
  return Nothing{};
}

CameraDevice::Read OpenNiDevice::paired() {
  std::optional<ColorDepthPairing::Pair> pair = pairing_.take(clock_.now());
  if (!pair) return Nothing{};
  Frame frame;
  frame.driver_time = pair->driver_time;
  frame.arrival = pair->arrival;
  frame.frame.camera = camera_;
  frame.frame.depth = std::move(pair->depth);
  frame.frame.color = std::move(pair->color);
  return frame;
}

void OpenNiDevice::close() {
  if (depth_.isValid()) {
    // Waits for the driver's thread. It may start after start() returned, and after stop() it may finish its frame in
    // memory that destroy() freed or in a library that shutdown() unloaded. OpenNI2's Dummy driver does both.
    std::this_thread::sleep_until(started_ + kTwoPeriods);
    depth_.stop();
    color_.stop();
    std::this_thread::sleep_for(kTwoPeriods);
  }
  color_.destroy();
  depth_.destroy();
  device_.close();
  pairing_ = {};
}

/// OpenNI2 names neither the unit of the exposure nor its limits.
std::optional<ExposureLimits> OpenNiDevice::exposure_limits() {
  constexpr double kMost = 65535.0;
  const openni::CameraSettings* const settings = color_.isValid() ? color_.getCameraSettings() : nullptr;
  if (settings == nullptr || !settings->isValid()) return std::nullopt;
  int known = 0;
  if (color_.getProperty(openni::STREAM_PROPERTY_EXPOSURE, &known) != openni::STATUS_OK) return std::nullopt;
  return ExposureLimits{
      .unit = "the driver's unit", .least = 0.0, .most = kMost, .least_gain = 0.0, .most_gain = kMost};
}

Exposure OpenNiDevice::exposure() {
  openni::CameraSettings* const settings = color_.getCameraSettings();
  return {.automatic = settings->getAutoExposureEnabled(),
          .exposure = static_cast<double>(settings->getExposure()),
          .gain = static_cast<double>(settings->getGain())};
}

bool OpenNiDevice::set_exposure(const Exposure& exposure) {
  openni::CameraSettings* const settings = color_.isValid() ? color_.getCameraSettings() : nullptr;
  if (settings == nullptr) return false;
  if (settings->setAutoExposureEnabled(exposure.automatic) != openni::STATUS_OK) return false;
  if (exposure.automatic) return true;
  return settings->setExposure(static_cast<int>(std::lround(exposure.exposure))) == openni::STATUS_OK &&
         settings->setGain(static_cast<int>(std::lround(exposure.gain))) == openni::STATUS_OK;
}

}  // namespace

std::vector<FoundCamera> find_cameras() {
  const Session session;
  std::vector<FoundCamera> found;
  if (!session.ok()) return found;
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  for (int at = 0; at < devices.getSize(); ++at)
    found.push_back({.spec = "openni2:" + std::string(devices[at].getUri()),
                     .name = std::string(devices[at].getVendor()) + " " + devices[at].getName()});
  return found;
}

std::unique_ptr<CameraDevice> make_openni_device(std::string uri, wire::SessionClock clock) {
  return std::make_unique<OpenNiDevice>(std::move(uri), clock);
}

}  // namespace telepalp::capture
