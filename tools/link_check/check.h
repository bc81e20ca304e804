#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "proto/keys/key_file.h"
#include "support/program/address.h"
#include "tools/link_check/findings.h"

namespace telepalp::link_check {

struct CheckOptions {
  program::Address server;                     ///< or the meeting point, with its site
  std::uint16_t web_port = 0;                  ///< of the server's web page
  std::shared_ptr<const keys::KeyFile> key{};  ///< null: the server is on this machine
  std::string consent{};  ///< the patient's consent to being watched; empty: no images are asked for
  std::chrono::duration<double> listens_s{3.0};  ///< for images
};

/// Tries the network to a server: its name, its ports, a session, datagrams and images. Takes at most about 10 s and
/// `listens_s`. Blocks; Ctrl-C ends the process.
[[nodiscard]] Findings check(const CheckOptions& options);

/// The command `telepalp-link check`; returns the exit code: 0 if a session begins and images come.
[[nodiscard]] int check_command(int argc, const char* const* argv);

}  // namespace telepalp::link_check
