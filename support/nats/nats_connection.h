#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "proto/words/result.h"
#include "support/nats/nats_address.h"

namespace telepalp::nats {

/// A connection to a cluster of NATS servers. When it is lost, it connects again by itself, after at most half a
/// second, to another server of the cluster if there is one. Any thread.
class NatsConnection {
 public:
  struct Options {
    Address address;
    std::string name;                                    ///< which the NATS server's monitoring shows
    std::function<void(bool is_connected)> on_change{};  ///< after a loss or a new connection; on a library's thread
    /// True: publish() writes the whole payload to the socket. False: a thread of the library writes its last bytes,
    /// a millisecond later or more, together with what was published meanwhile.
    bool writes_at_once = false;
  };
  struct Note {
    std::string_view subject;
    std::string_view payload;
    std::string_view reply_to;  ///< subject for an answer; empty: the sender wants no answer
  };
  using OnNote = std::function<void(const Note&)>;

  /// Connects. Error: no server of the cluster can be reached, or it refuses the credentials.
  [[nodiscard]] static Result<std::unique_ptr<NatsConnection>> open(Options options);
  /// No handler runs any more when the destructor returns.
  ~NatsConnection();
  NatsConnection(const NatsConnection&) = delete;
  NatsConnection& operator=(const NatsConnection&) = delete;

  /// `on_note` is called on a thread of the library, for one note at a time. At most 64 MiB of notes wait for it; more
  /// are dropped.
  /// Error: the server does not permit this subject.
  [[nodiscard]] Result<void> subscribe(const std::string& subject, OnNote on_note);
  /// Blocks while the socket takes no bytes, up to the write deadline. False: there is no connection, and the payload
  /// is dropped.
  bool publish(const std::string& subject, std::string_view payload);
  /// Asks, and waits for the answer for at most `time`. Error: no answer came.
  [[nodiscard]] Result<std::string> ask(const std::string& subject, std::string_view payload,
                                        std::chrono::milliseconds time);
  [[nodiscard]] bool is_connected() const;
  /// Largest payload that the server takes [B].
  [[nodiscard]] std::size_t most_payload_B() const;

 private:
  friend class Streams;
  struct Parts;
  [[nodiscard]] void* library_connection()
      const noexcept;  ///< a natsConnection*; void keeps libnats out of this header
  explicit NatsConnection(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace telepalp::nats
