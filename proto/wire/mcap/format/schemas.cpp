#include "proto/wire/mcap/format/schemas.h"

#include <google/protobuf/descriptor.pb.h>

#include <set>

#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "foxglove/CompressedVideo.pb.h"
#include "messages/camera.pb.h"
#include "messages/clock.pb.h"
#include "messages/inside.pb.h"
#include "messages/playback.pb.h"
#include "messages/station.pb.h"
#include "messages/viewer.pb.h"
#include "messages/voice.pb.h"
#include "proto/words/demand.h"

namespace telepalp::wire {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptor;

/// The linker keeps a type of a static library only if the program refers to it, so this function refers to one type of
/// each .proto file.
const DescriptorPool& pool_with_our_types() {
  static const Descriptor* const linked[] = {foxglove::CameraCalibration::descriptor(),
                                             foxglove::CompressedImage::descriptor(),
                                             foxglove::CompressedVideo::descriptor(),
                                             msg::DepthImage::descriptor(),
                                             msg::Clock::descriptor(),
                                             msg::StationState::descriptor(),
                                             msg::UltrasoundImage::descriptor(),
                                             msg::LiveNote::descriptor(),
                                             msg::ViewerHand::descriptor(),
                                             msg::VoiceFrame::descriptor()};
  return *linked[0]->file()->pool();
}

void add_imports_first(const FileDescriptor& file, std::set<const FileDescriptor*>& added,
                       google::protobuf::FileDescriptorSet& set) {
  if (!added.insert(&file).second) return;
  for (int number = 0; number < file.dependency_count(); ++number)
    add_imports_first(*file.dependency(number), added, set);
  file.CopyTo(set.add_file());
}

}  // namespace

const Descriptor* descriptor_of(const Topic& topic) {
  const Descriptor* const type = pool_with_our_types().FindMessageTypeByName(std::string(topic.schema));
  demand(type != nullptr, "the topic's message type is linked: name its file in proto/wire/mcap/format/schemas.cpp");
  return type;
}

std::string file_descriptor_set(const Descriptor& type) {
  google::protobuf::FileDescriptorSet set;
  std::set<const FileDescriptor*> added;
  add_imports_first(*type.file(), added, set);
  return set.SerializeAsString();
}

mcap::Schema mcap::schema_of(const Topic& topic) {
  return {.id = 0,
          .name = std::string(topic.schema),
          .encoding = "protobuf",
          .data = file_descriptor_set(*descriptor_of(topic))};
}

}  // namespace telepalp::wire
