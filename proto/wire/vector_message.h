#pragma once

#include <Eigen/Core>

namespace telepalp::wire {

// Conversions between Eigen and messages with coordinates x, y and z: msg::Vec3, foxglove::Vector3.

template <class Message>
[[nodiscard]] Eigen::Vector3d vector_of(const Message& message) {
  return {message.x(), message.y(), message.z()};
}

/// `v` has three elements: an Eigen vector or an array.
template <class Message, class Vector>
void set_vector(Message& message, const Vector& v) {
  message.set_x(v[0]);
  message.set_y(v[1]);
  message.set_z(v[2]);
}

}  // namespace telepalp::wire
