#include "codec/unmarked/unmarked_depth.h"

#include <span>

#include "codec/depth.h"
#include "messages/camera.pb.h"

namespace telepalp::codec {

bool is_unmarked_key_frame(std::string_view depth_image) {
  msg::DepthImage image;
  return image.ParseFromArray(depth_image.data(), static_cast<int>(depth_image.size())) &&
         is_key_frame(std::as_bytes(std::span(image.data())));
}

}  // namespace telepalp::codec
