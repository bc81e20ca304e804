#include "clients/record/live/recording_plan.h"

#include "clients/record/live/attached_files.h"
#include "support/program/people/account.h"
#include "support/program/version.h"

namespace telepalp::record {
namespace {

/// The key's owner, or the account on this machine.
std::string recorded_by(const RecordingOptions& options) {
  return options.key ? keys::describe(options.key->identity) : program::account();
}

}  // namespace

Result<SessionFiles::Plan> plan_of(const RecordingOptions& options) {
  SessionFiles::Plan plan{.name = options.file,
                          .session = {.program = "telepalp-record",
                                      .version = program::version(),
                                      .commit = program::commit(),
                                      .source = program::to_text(options.server),
                                      .scene = {},
                                      .recorded_by = recorded_by(options),
                                      .consent = options.consent,
                                      .voice_consent = options.voice_consent},
                          .attachments = {},
                          .splitting = options.splitting};
  std::vector<std::filesystem::path> attached = options.attachments;
  if (!options.scene.empty()) attached.insert(attached.begin(), options.scene);
  for (const std::filesystem::path& file : attached) {
    Result<wire::mcap::Attachment> attachment = attach(file);
    if (!attachment) return attachment.error();
    plan.attachments.push_back(std::move(*attachment));
  }
  if (!options.scene.empty()) plan.session.scene = plan.attachments.front().data;
  return plan;
}

}  // namespace telepalp::record
