#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "proto/words/result.h"

namespace telepalp::station {

/// By which an operator at the station's own machine speaks to it: a Unix socket that only the same user can open. One
/// line is asked and one line answered. Owner: network thread.
class ControlSocket {
 public:
  using Reply = std::function<void(const std::string& line)>;
  /// Answers `command` by calling `reply` once, now or later.
  using Handler = std::function<void(const std::string& command, Reply reply)>;

  ControlSocket(boost::asio::io_context& io, Handler handler)
      : acceptor_(io), handler_(std::make_shared<Handler>(std::move(handler))) {}
  ~ControlSocket() { stop(); }
  ControlSocket(const ControlSocket&) = delete;
  ControlSocket& operator=(const ControlSocket&) = delete;

  [[nodiscard]] Result<void> listen(const std::filesystem::path& path);
  void stop();
  /// Empty when it does not listen.
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  void accept();

  boost::asio::local::stream_protocol::acceptor acceptor_;
  std::shared_ptr<Handler> handler_;  // shared: who has asked and not been answered looks whether we still are
  std::filesystem::path path_;
};

/// Asks the station that listens at `path`; its answer.
[[nodiscard]] Result<std::string> ask_station(const std::filesystem::path& path, const std::string& command);

/// The folder of this user's control sockets, and the name of this process's own.
[[nodiscard]] std::filesystem::path control_folder();
[[nodiscard]] std::filesystem::path own_control_path();

/// The one socket that a station listens at; or why there is no such one.
[[nodiscard]] Result<std::filesystem::path> find_control_socket();

}  // namespace telepalp::station
