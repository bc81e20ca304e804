#include "tools/replay/workers/cell_answer.h"

#include <messages/sweep.pb.h>

#include "proto/keys/audit_chain.h"

namespace telepalp::replay {
namespace {

constexpr std::size_t kLongestName = 256;
constexpr std::size_t kLongestReason = 2048;

Error answer_refused(const std::string& what) {
  return {.what = what,
          .where = "answer of a worker",
          .fix = "let only telepalp-worker publish on the subjects telepalp-sweep.answer.>"};
}

}  // namespace

std::string encode(const CellAnswer& answer) {
  msg::SweepAnswer message;
  message.set_build(answer.build);
  message.set_cell(answer.cell);
  message.set_report(answer.report);
  message.set_sha256(keys::sha256_hex(answer.report));
  message.set_refused(answer.refused.substr(0, kLongestReason));
  message.set_worker(answer.worker);
  return message.SerializeAsString();
}

Result<CellAnswer> parse_answer(std::string_view bytes, const std::string& build, const std::string& cell) {
  msg::SweepAnswer message;
  if (bytes.size() > kMostAnswer_B) return answer_refused("it has more than 512 KiB");
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return answer_refused("its bytes are no answer");
  if (message.build() != build) return answer_refused("it is of another build");
  if (message.cell() != cell) return answer_refused("it is of another cell than its subject names");
  if (message.report().empty() == message.refused().empty())
    return answer_refused("it is neither a report nor a refusal");
  if (message.worker().size() > kLongestName || message.refused().size() > kLongestReason)
    return answer_refused("a text in it is too long");
  if (message.sha256() != keys::sha256_hex(message.report())) return answer_refused("its report has another digest");
  return CellAnswer{.build = message.build(),
                    .cell = message.cell(),
                    .report = message.report(),
                    .refused = message.refused(),
                    .worker = message.worker()};
}

std::string encode(const Presence& presence) {
  msg::SweepPresence message;
  message.set_name(presence.name);
  message.set_build(presence.build);
  message.set_finished(presence.finished);
  return message.SerializeAsString();
}

Result<Presence> parse_presence(std::string_view bytes) {
  msg::SweepPresence message;
  if (bytes.size() > 4 * kLongestName || !message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return answer_refused("its bytes are no presence");
  if (message.name().empty() || message.name().size() > kLongestName || message.build().size() > kLongestName)
    return answer_refused("a text in it is empty or too long");
  return Presence{.name = message.name(), .build = message.build(), .finished = message.finished()};
}

}  // namespace telepalp::replay
