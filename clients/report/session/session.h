#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "foxglove/CameraCalibration.pb.h"
#include "messages/camera.pb.h"
#include "messages/playback.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/writer.h"
#include "proto/wire/message.h"
#include "proto/words/rgbd_frame.h"
#include "support/speech/speech_survey.h"

namespace telepalp::report {

/// The x, y and z components of a vector at each tick, in the haptic base's frame H.
using Axes = std::array<std::vector<float>, 3>;

/// The recorded ticks of the 2 kHz loop, as columns of equal length.
struct Ticks {
  std::vector<std::int64_t> at_ns;  ///< session time of the tick's deadline
  std::vector<float> work_us;       ///< computing time of the tick
  std::vector<float> late_us;       ///< delay of the wake-up after the deadline
  std::vector<msg::Phase> phase;
  Axes hand, device, proxy;          ///< [m]
  Axes force;                        ///< [N]
  std::vector<float> indentation_m;  ///< norm of the indentation; 0 outside the body
  std::vector<float> distance_m;     ///< of the device point from the surface; negative inside the body
  std::uint32_t period_ns = 500'000;
  std::uint64_t first_number = 0, last_number = 0;  ///< of the first and the last tick, since the station's start

  [[nodiscard]] std::size_t size() const noexcept { return at_ns.size(); }
};

/// How much another program's counter grew during the recording. The counter starts at 0 with its program; when it
/// falls, that program has restarted.
class Growth {
 public:
  /// `began_here`: the counter started during the recording, so its first value counts as growth.
  void add(std::uint64_t value, bool began_here) noexcept;
  [[nodiscard]] std::uint64_t in_recording() const noexcept { return grown_; }
  /// False if the recording has no value, or a single value of a counter that started earlier: growth is unknown then.
  [[nodiscard]] bool is_known() const noexcept { return known_; }

 private:
  std::uint64_t grown_ = 0;
  bool known_ = false;
  std::optional<std::uint64_t> last_;
};

/// The messages of one sender on the topics of a station (/station/…).
struct SenderRecord {
  std::uint32_t sender = 0;  ///< number that the server gave the sender; 0: unknown
  std::uint64_t sent_messages = 0;
  Ticks ticks;
  std::vector<msg::StationState> states;
  std::vector<msg::SurfaceReport> surfaces;
  std::vector<msg::StationCompensation> compensations;
  std::vector<msg::StationEvent> events;
  std::optional<msg::StationStats> station_stats;  ///< the last such message
  bool began_here = false;                         ///< the sender started during the recording
  std::int64_t counted_ns = 0;                     ///< session time of station_stats
  Growth frames_received, frames_dropped, deadlines_missed, telemetry_dropped;
};

/// From `since_ns` (session time) on, the images of a connection went by UDP datagrams, or by TCP.
struct Carrier {
  std::int64_t since_ns = 0;
  bool by_datagram = false;
};

/// When something else used a connection's line, by /server/stats, which come once a second.
struct SharedLine {
  std::uint64_t seconds = 0;   ///< number of messages that said so
  double least_B_per_s = 0.0;  ///< least rate that was left
  void add(double left_B_per_s) noexcept {
    least_B_per_s = seconds++ == 0 ? left_B_per_s : std::min(least_B_per_s, left_B_per_s);
  }
  void add(const SharedLine& other) noexcept {
    if (other.seconds == 0) return;
    add(other.least_B_per_s);
    seconds += other.seconds - 1;
  }
};

/// One connection to the server, from /server/stats.
struct Subscription {
  std::uint32_t sender = 0;
  std::string name, address;
  bool was_there_first = false;  ///< true: the connection existed when the recording began
  Growth depth_sent, depth_dropped;
  std::uint64_t depth_sent_before = 0, depth_dropped_before = 0;  ///< counts in the first /server/stats that lists it
  std::int64_t counted_ns = 0;      ///< session time of the last /server/stats that lists it
  std::vector<Carrier> carriers{};  ///< in the order of time; one more at each change
  SharedLine shared_line{};
};

/// The content of a session file, without images: the images of a long session do not fit into memory. After settle(),
/// the inherited SenderRecord is that of the sender with the most ticks; the report is about this sender.
struct Session : SenderRecord {
  std::string name;         ///< file name without folders
  wire::SessionInfo info;   ///< what the recorder stated
  std::string origin;       ///< the recorded server or file, from the metadata; empty: not stated
  msg::SessionNotes notes;  ///< notes of people who watched the session, from SESSION.mcap.notes.json, or
                            ///< the session's own marks
  speech::Speech spoken;    ///< where people speak, if what they said was recorded
  std::map<std::uint32_t, SenderRecord> others;                               ///< of the other senders, by their number
  std::map<std::pair<std::string, std::string>, Subscription> subscriptions;  ///< by name and address
  bool heard_server_stats = false;
  std::string server_software;                ///< name, version and commit of the server's program; empty: not stated
  std::optional<msg::CaptureStatus> capture;  ///< the last such message
  std::map<std::string, foxglove::CameraCalibration> calibrations;  ///< the last one of each frame of reference
  std::vector<std::int64_t> depth_captured_ns;
  std::vector<std::int64_t> depth_key_ns;  ///< for each depth frame: log time of the newest key frame
  std::vector<std::int64_t> color_captured_ns;
  wire::DepthFidelity depth;             ///< the loosest bound among the depth images
  std::optional<std::int64_t> first_ns;  ///< log time of the first message
  std::optional<std::int64_t> last_ns;
  std::uint64_t messages = 0;
  std::uint64_t damaged = 0;  ///< messages that could not be parsed as their topic's type
};

/// Adds one message to the session; an unreadable message is counted as damaged.
void add(Session& session, const wire::Message& message);

/// Makes the sender with the most ticks the session's own record. Call it after the last message.
void settle(Session& session);

/// The source of the camera images: as the server stated it, else as the recorder's metadata state it.
[[nodiscard]] std::string source_of(const Session& session);

/// Duration of the session [s]; 0 when empty.
[[nodiscard]] double seconds(const Session& session) noexcept;

}  // namespace telepalp::report
