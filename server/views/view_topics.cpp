#include "server/views/view_topics.h"

#include "foxglove/CompressedImage.pb.h"
#include "foxglove/FrameTransforms.pb.h"
#include "foxglove/KeyValuePair.pb.h"
#include "foxglove/PointCloud.pb.h"
#include "foxglove/PoseInFrame.pb.h"
#include "foxglove/RawImage.pb.h"
#include "foxglove/SceneUpdate.pb.h"
#include "proto/words/demand.h"

namespace telepalp::views {

const google::protobuf::Descriptor* descriptor_of_view(const wire::Topic& topic) {
  for (const google::protobuf::Descriptor* type :
       {foxglove::RawImage::descriptor(), foxglove::PointCloud::descriptor(), foxglove::FrameTransforms::descriptor(),
        foxglove::SceneUpdate::descriptor(), foxglove::PoseInFrame::descriptor(),
        foxglove::CompressedImage::descriptor(), foxglove::KeyValuePair::descriptor()})
    if (type->full_name() == topic.schema) return type;
  demand(false, "the message type of each view for Foxglove is listed in this file");
  return nullptr;
}

}  // namespace telepalp::views
