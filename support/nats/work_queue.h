#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "support/nats/streams.h"

namespace telepalp::nats {

/// An item of a work queue that this program works on. A thread tells the cluster so, until this object is answered or
/// destroyed; the cluster delivers an item again, to anyone, when it has not heard of it for WorkQueue::kSilence.
class WorkItem {
 public:
  struct Parts;
  explicit WorkItem(std::unique_ptr<Parts> parts);
  ~WorkItem();
  WorkItem(WorkItem&&) noexcept;
  WorkItem& operator=(WorkItem&&) noexcept;

  [[nodiscard]] std::string_view subject() const noexcept;
  [[nodiscard]] std::string_view payload() const noexcept;
  /// How many times the cluster has delivered the item, this time included.
  [[nodiscard]] std::uint64_t deliveries() const noexcept { return deliveries_; }

  // The answers. The first one counts. False: there is no connection, so the item will be delivered again.
  bool finished();                                  ///< removes the item
  bool give_back(std::chrono::milliseconds after);  ///< delivers it again, to anyone, after this time
  bool remove_as_bad();                             ///< removes it unfinished, so that nobody gets it again

 private:
  std::unique_ptr<Parts> parts_;
  std::uint64_t deliveries_ = 0;
};

/// The end of a work queue that takes items. All programs that open the same `consumer` share its items. Owner: one
/// thread.
class WorkQueue {
 public:
  static constexpr std::chrono::seconds kSilence{10};

  /// `filter`: subjects of the items that this consumer takes. Error: there is no such stream, or no JetStream.
  [[nodiscard]] static Result<std::unique_ptr<WorkQueue>> open(const Streams& streams, const std::string& stream,
                                                               const std::string& consumer, const std::string& filter);
  ~WorkQueue();
  WorkQueue(const WorkQueue&) = delete;
  WorkQueue& operator=(const WorkQueue&) = delete;

  /// The next item; nullopt: none came within `patience`. Error: the queue cannot be read, for instance because the
  /// connection is lost.
  [[nodiscard]] Result<std::optional<WorkItem>> take(std::chrono::milliseconds patience);

 private:
  struct Parts;
  explicit WorkQueue(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace telepalp::nats
