// Where sessions are kept: copies between the disk and a cluster, encrypted or not, and new keys for encrypted ones.
#include <chrono>
#include <cstdio>
#include <optional>
#include <string_view>

#include "clients/record/file_commands.h"
#include "clients/record/store/cluster_terms.h"
#include "clients/record/store/reseal.h"
#include "clients/record/store/whole_copy.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/words/counted.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/session_store/session_place.h"

namespace telepalp::record {
namespace {

program::Usage copy_usage() {
  return {.program = "telepalp-record copy",
          .purpose = "copies a session as it is, between the disk and a cluster (nats://HOST/SITE/SESSION.mcap)",
          .positional = "SESSION",
          .options = {{"out", "SESSION", "the new session; encrypted if TELEPALP_SITE_KEYS names a key"},
                      {"keep-days", "N", "in a cluster: kept so long, but not longer than the session's consent says"},
                      {"plain", "", "do not encrypt the copy"}},
          .example = "telepalp-record copy nats://10.0.0.5/ward3/a.mcap --out a.mcap"};
}

program::Usage reseal_usage() {
  return {.program = "telepalp-record reseal",
          .purpose = "lets the first key of TELEPALP_SITE_KEYS decrypt sessions, instead of the old one",
          .positional = "FILE...",
          .options = {},
          .example = "telepalp-record reseal session.mcap"};
}

program::Usage forget_usage() {
  return {.program = "telepalp-record forget",
          .purpose = "removes a session from a cluster before its time, such as when the consent is withdrawn",
          .positional = "SESSION",
          .options = {{"delete", "", "remove it; without it nothing changes"}},
          .example = "telepalp-record forget nats://127.0.0.1/ward3/session.mcap --delete"};
}

int fail_asked_wrongly(std::string what, const program::Usage& usage) {
  return program::fail(asked_wrongly(std::move(what), usage), program::kAskedWrongly);
}

/// --keep-days; nullopt: it is not given.
Result<std::optional<std::chrono::days>> keep_days(const program::Arguments& arguments) {
  if (!arguments.has("keep-days")) return std::optional<std::chrono::days>();
  const Result<std::int64_t> days = arguments.whole("keep-days", 1, 36500);
  if (!days) return days.error();
  return std::optional(std::chrono::days(*days));
}

std::string_view in_words(CopiedNotes notes) {
  switch (notes) {
    case CopiedNotes::Copied:
      return ", and the notes on it";
    case CopiedNotes::LeftOut:
      return "; a cluster keeps no notes, so those beside the session are not copied";
    case CopiedNotes::None:
      break;
  }
  return "";
}

int run_copy(const program::Arguments& arguments) {
  if (arguments.positional().size() != 1 || !arguments.has("out"))
    return fail_asked_wrongly("copy needs one session, and a new one named by --out", copy_usage());
  WholeCopyOptions options;
  if (arguments.has("plain")) options.protection = wire::mcap::Protection::None;
  const auto keep = keep_days(arguments);
  if (!keep) return program::fail(keep.error(), program::kAskedWrongly);
  options.keep = *keep;
  const std::string out = arguments.text("out");
  const Result<WholeCopy> copy = copy_whole(arguments.positional().front(), out, options);
  if (!copy) return program::fail(copy.error());
  program::log(kProgram, out + ": " + counted(copy->bytes, "byte", "bytes") + ", all of the session" +
                             std::string(in_words(copy->notes)));
  return program::kDone;
}

int run_reseal(const program::Arguments& arguments) {
  if (arguments.positional().empty()) return fail_asked_wrongly("no session is named", reseal_usage());
  int result = program::kDone;
  for (const std::string& file : arguments.positional()) {
    const Result<Resealed> done = reseal(file);
    if (!done)
      result = program::fail(done.error());
    else
      std::printf("%s: %s\n", program::escaped(file).c_str(),
                  *done == Resealed::Changed ? "the new key decrypts it" : "the new key decrypted it already");
  }
  return result;
}

int run_forget(const program::Arguments& arguments) {
  if (arguments.positional().size() != 1) return fail_asked_wrongly("one session is needed", forget_usage());
  const std::string& name = arguments.positional().front();
  if (!session_store::is_in_cluster(name))
    return program::fail({.what = "is not the name of a session in a cluster",
                          .where = name,
                          .fix = "give nats://HOST/SITE/SESSION.mcap; delete a file with rm"},
                         program::kAskedWrongly);
  if (!arguments.has("delete")) {
    const auto found = wire::mcap::open_session(name);
    if (!found) return program::fail(found.error());
    std::printf("%s: would be removed (%.1f MB). Add --delete to remove it\n", program::escaped(name).c_str(),
                static_cast<double>((*found)->size()) / 1e6);
    return program::kDone;
  }
  if (const Result<void> removed = session_store::remove_session(name); !removed) return program::fail(removed.error());
  std::printf("%s: removed\n", program::escaped(name).c_str());
  return program::kDone;
}

}  // namespace

int copy_command(int argc, const char* const* argv) { return program::run_program(copy_usage(), argc, argv, run_copy); }

int reseal_command(int argc, const char* const* argv) {
  return program::run_program(reseal_usage(), argc, argv, run_reseal);
}

int forget_command(int argc, const char* const* argv) {
  return program::run_program(forget_usage(), argc, argv, run_forget);
}

Result<void> settle_cluster_terms(const program::Arguments& arguments) {
  if (!session_store::is_in_cluster(arguments.text("out"))) return {};
  const auto keep = keep_days(arguments);
  if (!keep) return keep.error();
  if (arguments.has("keep-last"))
    return Error{.what = "a cluster keeps whole sessions",
                 .where = "--keep-last",
                 .fix = "give --keep-days, or record to a file"};
  const auto terms = cluster_terms(arguments.text("consent"), *keep, std::chrono::system_clock::now());
  if (!terms) return terms.error();
  session_store::use_cluster_sessions(*terms);
  return {};
}

}  // namespace telepalp::record
