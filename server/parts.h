#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <optional>

#include "server/command_line.h"
#include "server/gateway/gateway.h"
#include "server/gateway/monitoring/health_port.h"
#include "server/meet/site/meet_dialer.h"
#include "server/oidc/hospital_sign_in.h"
#include "server/origin/opening_pool.h"
#include "server/origin/origin.h"
#include "server/origin/session_shelf.h"
#include "server/origin/source_choice.h"
#include "server/recording/session_recorder.h"
#include "server/relay/publisher.h"
#include "server/server.h"
#include "server/voice/room_voice.h"

namespace telepalp::server {

/// All parts of a running server. The later ones use the earlier ones.
struct Parts {
  boost::asio::io_context io;
  std::unique_ptr<Server> server;
  origin::OpeningPool opening{io};
  std::optional<origin::SessionShelf> shelf;
  std::optional<origin::SourceChoice> sources;           // nullopt: no browsers
  std::unique_ptr<origin::Origin> origin;                // handed to the server at the start
  std::unique_ptr<recording::SessionRecorder> recorder;  // null: visitors may not record
  std::unique_ptr<voice::RoomVoice> voice;               // null: the server does not hear the patient's room
  std::unique_ptr<oidc::HospitalSignIn> hospital;        // null: people sign in with tokens alone
  std::unique_ptr<gateway::Gateway> gateway;             // null: no browsers
  std::unique_ptr<gateway::HealthPort> health;           // null: no port for monitoring
  std::unique_ptr<meet::MeetDialer> meet;                // null: no meeting point
  std::unique_ptr<relay::Publisher> publisher;           // null: for no edges
};

/// Opens the parts that `asked` names, which must live as long as `parts`: the parts keep references to it. Completes
/// the options in `asked` by what is known only then, such as ports. Error: a part cannot be opened.
[[nodiscard]] Result<void> open_parts(Parts& parts, Asked& asked);

}  // namespace telepalp::server
