#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "messages/playback.pb.h"
#include "proto/words/result.h"

namespace telepalp::playback {

/// Compares the played session with another one of a folder. A separate thread reads both files; the mutex guards the
/// result, which the network thread copies. Owner: the network thread.
class SessionComparison {
 public:
  static constexpr std::size_t kMostSessions = 200;  ///< largest number of the folder's sessions that state() lists

  using Say = std::function<void(const std::string& line)>;

  /// `folder`: its files *.mcap may be compared with `played`. `say` is called on the thread that reads, once for each
  /// session of which a part is left out: the part, and why. Error: it is not a folder.
  [[nodiscard]] static Result<std::unique_ptr<SessionComparison>> open(
      std::filesystem::path played, std::filesystem::path folder, Say say = [](const std::string&) {});
  ~SessionComparison() { stop(); }
  SessionComparison(const SessionComparison&) = delete;
  SessionComparison& operator=(const SessionComparison&) = delete;

  /// Carries out the JSON of a msg::ComparisonCommand. Error: the command is wrong, or names a file that is not in the
  /// folder.
  [[nodiscard]] Result<void> apply(const std::string& json);
  [[nodiscard]] msg::ComparisonState state() const;

 private:
  SessionComparison(std::filesystem::path played, std::filesystem::path folder, Say say)
      : played_(std::move(played)), folder_(std::move(folder)), say_(std::move(say)) {}
  [[nodiscard]] std::vector<std::string> sessions() const;
  void begin(const std::string& with);
  void stop();
  void compare(const std::filesystem::path& other);

  std::filesystem::path played_;
  std::filesystem::path folder_;
  Say say_;
  mutable std::mutex mutex_;
  msg::ComparisonState state_;  // without `sessions`, which each state() lists again
  std::atomic<bool> stopping_{false};
  std::thread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::playback
