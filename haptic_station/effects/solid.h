#pragma once

#include <memory>
#include <string>
#include <utility>

#include "haptic_station/effects/effect.h"
#include "haptic_station/effects/laws/spring.h"
#include "haptic_station/solids/solid_proxy.h"

namespace telepalp::effects {

/// How a layer answers to ultrasound. The defaults are those of soft tissue.
struct Echo {
  double impedance_MRayl = 1.65;
  double attenuation_dB_per_cm = 1.75;  ///< one way, at 3.5 MHz
  double scatter = 0.6;                 ///< brightness of the speckle, 0 to 1
};

/// A layer of the body: a solid with a name, under which its computation cost is reported. Shared by the copies of the
/// effect.
struct SolidLayer {
  std::string name;                               ///< as the scene calls it: ribs, liver, mass
  std::shared_ptr<const solids::SolidTree> tree;  // shared: a scene may hold one tree in two layers
  Echo echo;
};

struct SolidSettings {
  std::shared_ptr<const SolidLayer> layer;  ///< in the haptic base's frame H; nullptr: no force
  double stiffness_N_per_m = 800.0;
  double pulse_m = 0.0;  ///< the surface moves out by this much at each pulse; 0: it is still
  double pulses_per_s = 1.2;
  /// 0: the device is a point. Above 0: the device is a point on a ball of this radius, a fingertip. The ball's centre
  /// lies outwards of the device, along the skin's normal at the first contact.
  double tip_radius_m = 0.0;
};

/// An implicit solid inside the body, like the ribs of paper S2 (docs/sources.md): a spring of one stiffness from the
/// device to the solid's proxy. Each layer of a scene has its own proxy, and the forces of all layers and of the skin
/// are summed (S2 III.A). The force is minus the gradient of 1/2 k depth^2, where depth is the distance from the device
/// to the proxy. The surface of an artery moves out by up to `pulse_m` and back at each pulse. EffectBank counts the
/// hand's work relative to this moving wall. A fingertip of radius R is a ball: its centre touches a solid that is
/// larger by R on all sides. While the ball slides across a rib of radius r at a depth d, the turning direction of the
/// force acts like a lateral stiffness of k d / (r + R - d). For a point, this stiffness is k d / (r - d), which grows
/// without bound towards the middle of the rib.
class Solid {
 public:
  static constexpr const char* kName = "solid";
  using Settings = SolidSettings;

  explicit Solid(Settings settings = {}) noexcept : settings_(std::move(settings)) {}
  void begin(const EffectInput& in) noexcept;
  /// Finds the proxy with `settings` from the next contact on.
  void find_proxy_with(const solids::ProxySettings& settings) noexcept { proxy_ = solids::SolidProxy(settings); }
  [[nodiscard]] Force<HapticBase> step(const EffectInput& in, double dt_s) noexcept;
  [[nodiscard]] Pull pull(double relaxed_m) const noexcept { return spring_.pull(relaxed_m); }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept { return spring_.force(relaxed_m); }
  [[nodiscard]] double energy_J(double relaxed_m = 0.0) const noexcept { return spring_.energy_J(relaxed_m); }
  /// The middle of the solid's box; the origin of H for a solid without bounds.
  [[nodiscard]] Point<HapticBase> place() const noexcept;
  /// Velocity of the wall under the proxy during the coming tick, relative to the solid's place.
  [[nodiscard]] Vector<HapticBase> wall_velocity(double dt_s) const noexcept;
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return settings_.stiffness_N_per_m; }
  [[nodiscard]] ObjectTouch touch() const noexcept { return touch_; }
  [[nodiscard]] const std::shared_ptr<const SolidLayer>& layer() const noexcept { return settings_.layer; }
  /// The layer's name, for the report of costs. Valid as long as a copy of the effect lives.
  [[nodiscard]] const char* label() const noexcept { return settings_.layer ? settings_.layer->name.c_str() : kName; }

 private:
  [[nodiscard]] double swell_m(double phase) const noexcept;

  Settings settings_;
  Eigen::Vector3d tip_center_m_ = Eigen::Vector3d::Zero();  ///< from the device to the centre of the fingertip
  solids::SolidProxy proxy_;
  solids::ProxyAt felt_;
  double phase_ = 0.0;   ///< of the pulse, 0 to 1
  LinearSpring spring_;  ///< at the last step
  ObjectTouch touch_ = ObjectTouch::None;
};

}  // namespace telepalp::effects
