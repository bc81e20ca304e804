#pragma once

#include <google/protobuf/message.h>

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "proto/wire/topics.h"
#include "proto/words/result.h"

namespace telepalp::origin {

/// The topic of a resource's state, which only the gateway publishes, and only for viewers. The path of the resource is
/// the topic's name.
struct StateTopic {
  wire::Topic topic;
  std::chrono::milliseconds every;  ///< least time between two states that no command of a visitor changed
};

constexpr StateTopic state_topic(std::string_view path, std::string_view schema, std::chrono::milliseconds every) {
  return {.topic = {.name = path,
                    .schema = schema,
                    .publisher = wire::Publisher::Gateway,
                    .validity = wire::Validity::UntilChanged,
                    .backlog = wire::Backlog::Newest},
          .every = every};
}

using std::chrono_literals::operator""ms;

/// Of a reading.
inline constexpr StateTopic kReading = state_topic("/reading", "telepalp.msg.ReadingState", 100ms);

// Of a played session. The last member of each comment is the command that changes the state.
inline constexpr StateTopic kPlayback =
    state_topic("/playback", "telepalp.msg.PlaybackState", 100ms);  ///< PlaybackCommand
inline constexpr StateTopic kEvents = state_topic("/playback/events", "telepalp.msg.SessionEvents", 1000ms);  ///< none
inline constexpr StateTopic kNetwork =
    state_topic("/playback/network", "telepalp.msg.NetworkState", 250ms);  ///< NetworkCommand
inline constexpr StateTopic kNotes =
    state_topic("/playback/notes", "telepalp.msg.SessionNotes", 100ms);  ///< NoteCommand
inline constexpr StateTopic kComparison =
    state_topic("/playback/comparison", "telepalp.msg.ComparisonState", 250ms);  ///< ComparisonCommand
// Of the server, whatever its origin.
inline constexpr StateTopic kRecording =
    state_topic("/recording", "telepalp.msg.RecordingState", 250ms);  ///< RecordingCommand
inline constexpr StateTopic kSessions = state_topic("/sessions", "telepalp.msg.SessionList", 1000ms);  ///< SessionPart

inline constexpr StateTopic kSource = state_topic("/source", "telepalp.msg.SourceState", 250ms);  ///< SourceCommand
inline constexpr StateTopic kRoomVoice =
    state_topic("/room_voice", "telepalp.msg.RoomVoiceState", 250ms);                             ///< RoomVoiceCommand
inline constexpr StateTopic kPeople = state_topic("/people", "telepalp.msg.PeopleState", 250ms);  ///< PeopleCommand
// Of a camera, and of a played session, which only shows them.
inline constexpr StateTopic kMarks = state_topic("/marks", "telepalp.msg.MarksState", 100ms);  ///< MarkCommand
inline constexpr StateTopic kExposure =
    state_topic("/exposure", "telepalp.msg.ExposureState", 100ms);  ///< ExposureCommand

inline constexpr std::array kStateTopics{kPlayback, kEvents, kNetwork,  kNotes,  kComparison, kRecording, kSessions,
                                         kReading,  kSource, kExposure, kPeople, kMarks,      kRoomVoice};

/// The Protobuf type of one of kStateTopics.
[[nodiscard]] const google::protobuf::Descriptor* descriptor_of_state(const wire::Topic& topic);

using StateMessage = std::unique_ptr<const google::protobuf::Message>;

/// A state that visitors read, and change by commands.
struct Resource {
  std::function<StateMessage()> state{};  ///< of the type that the topic of its path names
  using Done = std::function<void(Result<void>)>;
  /// Carries out `command`, a Protobuf message as JSON, for the person `who`. Calls `done` once, on the network thread,
  /// at once or later. Unset: the state is only read.
  std::function<void(const std::string& command, const std::string& who, Done done)> change{};
};
using Resources = std::map<std::string_view, Resource>;  ///< by path, such as "/playback"

/// A change that is carried out at once.
template <class Change>
[[nodiscard]] auto at_once(Change change) {
  return [change](const std::string& command, const std::string& who, const Resource::Done& done) {
    done(change(command, who));
  };
}

template <class Proto>
[[nodiscard]] StateMessage state_message(Proto state) {
  return std::make_unique<const Proto>(std::move(state));
}

}  // namespace telepalp::origin
