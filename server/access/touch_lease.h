#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace telepalp::access {

/// Decides which doctor's station may publish on the station's topics (it "holds the touch"): one at a time. The holder
/// keeps the touch while it publishes, and frees it with a Goodbye message or after kLease without a message; then any
/// station may take it. When the holder's connection breaks, the same doctor may take the touch again within kLease;
/// the same run of the holder's program also while the server does not know yet that the older connection is dead. The
/// holder may offer the touch to another doctor, who gets it by accepting. An offer ends after kOffer, with the
/// holder's lease, or when the touch changes hands. An offer survives a broken connection of the holder: within kLease,
/// the touch goes to the holder or to the doctor of the offer, whoever asks first. A holder that leaves with a Goodbye
/// after an offer leaves the touch to the other doctor for kLease. A run of a station that had to wait for the touch,
/// or from which the technician took it away, gets it only when its doctor accepts: no device begins to move by itself
/// in an empty room. Pure; owner: the server's network thread.
class TouchLease {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kLease{10};
  static constexpr std::chrono::seconds kOffer{60};

  /// A station that asks for the touch.
  struct Station {
    std::uint64_t peer = 0;
    std::uint64_t run = 0;  ///< random number of this run of the program (msg::Hello.run); 0: unknown
    std::string serial{};   ///< serial number of its doctor's key
    std::string name{};     ///< its doctor's name
    bool accepts = false;   ///< its doctor accepts that it goes live
  };
  /// Returns true if `station` now holds the touch.
  [[nodiscard]] bool take(const Station& station, TimePoint now);
  /// The peer by which the same run of `station`'s program holds the touch: its older connection, which is dead,
  /// because a program has one connection at a time. nullopt: none.
  [[nodiscard]] std::optional<std::uint64_t> older_connection(const Station& station) const;
  /// True if the touch is free, but `run` had to wait for it, and so gets it only when its doctor accepts.
  [[nodiscard]] bool must_accept(std::uint64_t run, TimePoint now) const;

  /// The technician takes the touch away. The holder notices when it renews. Returns the holder's name; nullopt: the
  /// touch is free.
  std::optional<std::string> take_away(TimePoint now);

  /// What must survive a restart of the server, as text: the holder and the runs that wait.
  [[nodiscard]] std::string kept() const;
  /// Restores kept(): within kLease from `now`, only the kept holder may take the touch. Other texts are ignored.
  void restore(const std::string& kept, TimePoint now);

  /// Extends the lease of `peer`, which has published. Returns false if `peer` does not hold the touch.
  [[nodiscard]] bool renew(std::uint64_t peer, TimePoint now);
  /// `peer` has left. `on_purpose`: with a Goodbye, which frees the touch at once; else its doctor has kLease to
  /// return.
  void leave(std::uint64_t peer, bool on_purpose, TimePoint now);

  /// `peer` offers the touch to the doctor named `to`, instead of an earlier offer. An empty name withdraws the offer.
  /// Returns false if `peer` does not hold the touch.
  [[nodiscard]] bool offer(std::uint64_t peer, const std::string& to, TimePoint now);
  /// `station` accepts an offer to its doctor. Returns the peer that held the touch until now, 0 if its connection has
  /// ended; nullopt: nothing is offered to this doctor.
  [[nodiscard]] std::optional<std::uint64_t> accept(const Station& station, TimePoint now);

  /// The name of the doctor who holds the touch; nullopt: the touch is free.
  [[nodiscard]] std::optional<std::string> holder(TimePoint now) const;
  /// The name of the doctor to whom the touch is offered; nullopt: no offer stands.
  [[nodiscard]] std::optional<std::string> offered_to(TimePoint now) const;

 private:
  struct Offer {
    std::string to;
    TimePoint until;
  };
  struct Held {
    std::uint64_t peer = 0;  // 0: its connection has ended
    std::uint64_t run = 0;
    std::string serial;  // empty: the holder left on purpose, and the touch waits for the doctor of the offer
    std::string name;
    TimePoint until;
    std::optional<Offer> offer;
  };
  void hold(const Station& station, std::optional<Offer> offer, TimePoint now);
  [[nodiscard]] bool waits(std::uint64_t run) const;
  void wait(std::uint64_t run);

  std::optional<Held> held_;
  std::deque<std::uint64_t> waiting_;  // runs that had to wait; at most kMostWaiting, the oldest is forgotten
};

}  // namespace telepalp::access
