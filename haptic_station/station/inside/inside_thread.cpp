#include "haptic_station/station/inside/inside_thread.h"

#include <boost/asio/post.hpp>
#include <chrono>
#include <utility>

namespace telepalp::station {
namespace {

std::optional<ultrasound::BModeSettings> settings_of(const scenes::Scene& scene) {
  if (!scene.probe) return std::nullopt;
  return ultrasound::BModeSettings{.width_m = scene.probe->width_m, .depth_m = scene.probe->depth_m};
}

Eigen::Vector3d moved_m(const loop::ObjectPlacements& objects, std::uint32_t effect) {
  const std::array<float, 3>& moved = objects.at(effect).moved;
  return {moved[0], moved[1], moved[2]};
}

}  // namespace

InsideThread::InsideThread(const scenes::Scene& scene, Handlers handlers)
    : layers_(scene.layers),
      settings_(settings_of(scene)),
      handlers_(std::move(handlers)),
      stay_(boost::asio::make_work_guard(io_)),
      thread_([this] {
        handlers_.on_structures(inner_structures(layers_));
        io_.run();
      }) {}

InsideThread::~InsideThread() {
  io_.stop();
  thread_.join();
}

void InsideThread::offer(const View& view) {
  if (!has_probe() || busy_.exchange(true)) return;
  boost::asio::post(io_, [this, view] {
    msg::UltrasoundImage image = image_of(view);
    busy_ = false;
    handlers_.on_image(std::move(image));
  });
}

msg::UltrasoundImage InsideThread::image_of(const View& view) const {
  const auto began = std::chrono::steady_clock::now();
  const HeldProbe probe = held_probe(view.tick, view.haptic_from_camera);
  msg::UltrasoundImage message = probe_message(probe, *settings_, view.haptic_from_camera);
  message.set_stamp_ns(static_cast<std::uint64_t>(view.tick.stamp_ns));
  message.set_surface_captured_ns(static_cast<std::uint64_t>(view.tick.surface_captured_ns));
  if (probe.on_skin) {
    std::vector<ultrasound::PlacedLayer> placed;
    for (const auto& [solid, effect] : layers_) placed.push_back({solid.get(), moved_m(view.objects, effect)});
    set_image(message, ultrasound::b_mode(placed, probe.pose, *settings_));
    message.set_compute_ms(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count());
  }
  return message;
}

}  // namespace telepalp::station
