#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "support/nats/streams.h"

namespace telepalp::nats {

/// An item of a work queue, taken by this program. Until it is answered or destroyed, a thread reports to the cluster
/// that the work goes on. After WorkQueue::kSilence without a report, the cluster delivers the item again, to any
/// consumer.
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

  // The answers: one per item. False: there is no connection, so the cluster will deliver the item again.
  bool finished();                                  ///< removes the item
  bool give_back(std::chrono::milliseconds after);  ///< delivers it again after this time, to any consumer
  bool remove_as_bad();                             ///< removes it unfinished

 private:
  std::unique_ptr<Parts> parts_;
  std::uint64_t deliveries_ = 0;
};

/// Takes items of a work queue. Programs that open the same `consumer` share its items: each item goes to one of them.
/// Owner: one thread.
class WorkQueue {
 public:
  static constexpr std::chrono::seconds kSilence{
      10};  ///< without a report, after which an item goes to another program

  /// `filter`: subjects of the consumer's items. Error: there is no such stream, or no JetStream.
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
