#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>

#include "proto/wire/session_clock.h"
#include "server/origin/origin.h"
#include "server/pipeline/capture_thread.h"

namespace telepalp::origin {

/// The frames of `source`, encoded on a separate thread as `encode` says. `source_name` appears in messages.
[[nodiscard]] std::unique_ptr<Origin> of_camera(boost::asio::io_context& network,
                                                std::unique_ptr<capture::CaptureSource> source, std::string source_name,
                                                pipeline::EncodeOptions encode, const wire::SessionClock& clock);

}  // namespace telepalp::origin
