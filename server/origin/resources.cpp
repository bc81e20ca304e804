#include "server/origin/resources.h"

#include "messages/people.pb.h"
#include "messages/playback.pb.h"
#include "messages/recording.pb.h"
#include "messages/voice.pb.h"
#include "proto/words/demand.h"

namespace telepalp::origin {

const google::protobuf::Descriptor* descriptor_of_state(const wire::Topic& topic) {
  for (const google::protobuf::Descriptor* type :
       {msg::PlaybackState::descriptor(), msg::SessionEvents::descriptor(), msg::NetworkState::descriptor(),
        msg::SessionNotes::descriptor(), msg::ComparisonState::descriptor(), msg::RecordingState::descriptor(),
        msg::SessionList::descriptor(), msg::ReadingState::descriptor(), msg::SourceState::descriptor(),
        msg::ExposureState::descriptor(), msg::PeopleState::descriptor(), msg::MarksState::descriptor(),
        msg::RoomVoiceState::descriptor()})
    if (type->full_name() == topic.schema) return type;
  demand(false, "the message type of each resource's state is listed in this file");
  return nullptr;
}

}  // namespace telepalp::origin
