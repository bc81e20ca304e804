#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "server/gateway/gateway.h"
#include "server/gateway/monitoring/health_port.h"
#include "server/meet/site/meet_dialer.h"
#include "server/pipeline/capture_thread.h"
#include "server/recording/session_recorder.h"
#include "server/relay/relay_options.h"
#include "server/server.h"
#include "server/voice/room_voice.h"
#include "support/program/options.h"

namespace telepalp::server {

inline constexpr const char* kProgram = "telepalp-server";
inline constexpr std::string_view kSession = "session:";  ///< begins the source that plays a session

/// What the command line asks for.
struct Asked {
  std::string source;
  bool loop = true;
  std::chrono::duration<double> seconds{0.0};
  std::filesystem::path ready_file;
  std::optional<access::Access::Options> keys;  // nullopt: no TLS, and peers of this machine only
  Server::Options server;
  pipeline::EncodeOptions encode;
  relay::RelayOptions relay;
  std::optional<gateway::GatewayOptions> gateway;               // nullopt: browsers are not served
  std::filesystem::path sign_in;                                // empty: people sign in with tokens alone
  std::optional<gateway::HealthPort::Options> health;           // nullopt: no port for monitoring
  std::optional<meet::MeetDialer::Options> meet;                // nullopt: no meeting point
  std::optional<recording::SessionRecorder::Options> recorder;  // nullopt: the web viewer records nothing
  std::optional<voice::RoomDevice> room_voice;                  // nullopt: the server does not hear the room
  std::filesystem::path compare_folder;                         // empty: the played session is compared with no other
};

[[nodiscard]] program::Usage usage();

/// Error: an option has a wrong value, or has no effect without another one.
[[nodiscard]] Result<Asked> read_asked(const program::Arguments& arguments);

/// Writes `text` to the log of telepalp-server.
void log_line(const std::string& text);

}  // namespace telepalp::server
