#include "haptic_station/station/parts/inside_view.h"

#include <utility>

#include "haptic_station/station/rigs/inner_layers.h"

namespace telepalp::station {

void InsideView::start(boost::asio::io_context& network, const scenes::Scene& scene, Handlers handlers) {
  surfaces_.emplace(inner_layers(scene));
  if (scene.layers().empty() && !scene.probe) return;
  thread_.emplace(network, handlers.now);
  surfaces_driver_.emplace(
      *surfaces_, *thread_,
      [this, now = handlers.now, on_structures = std::move(handlers.on_structures)](
          core::InnerSurfacesStage::Result result) { on_structures(surfaces_->hand_over(std::move(result), now())); });
  surfaces_driver_->begin(handlers.now());
  if (!scene.probe) return;
  ultrasound_.emplace(inner_layers(scene), *image_settings(scene));
  ultrasound_driver_.emplace(
      *ultrasound_, *thread_,
      [now = handlers.now, on_image = std::move(handlers.on_image)](core::UltrasoundStage::Result result) {
        if (const auto image = core::UltrasoundStage::hand_over(std::move(result), now())) on_image(*image);
      });
}

void InsideView::end() {
  thread_.reset();
  ultrasound_driver_.reset();
  surfaces_driver_.reset();
}

std::optional<msg::InnerStructures> InsideView::structures(
    SessionTime now, const Transform<HapticBase, DepthCamera>& haptic_from_camera) const {
  return surfaces_ ? surfaces_->placed(now, haptic_from_camera) : std::nullopt;
}

void InsideView::look(SessionTime now, const loop::TickSample& tick,
                      const Transform<HapticBase, DepthCamera>& haptic_from_camera) {
  if (ultrasound_driver_)
    ultrasound_driver_->begin(now, core::UltrasoundStage::View{tick, haptic_from_camera, objects_});
}

}  // namespace telepalp::station
