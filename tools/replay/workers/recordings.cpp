#include "tools/replay/workers/recordings.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <utility>
#include <vector>

#include "proto/keys/digest/file_digest.h"
#include "support/program/files/whole_file.h"
#include "tools/replay/source/tape.h"
#include "tools/replay/workers/sweep_subjects.h"

namespace telepalp::replay {
namespace {

namespace fs = std::filesystem;

constexpr auto kUnfinishedKept = std::chrono::hours(24);

struct KindName {
  Recording::Kind kind;
  std::string_view scheme;
};
constexpr KindName kKinds[] = {
    {Recording::Kind::Mcap, "session"}, {Recording::Kind::Oni, "oni"}, {Recording::Kind::Pcd, "pcd"}};

std::string_view ending_of(Recording::Kind kind) noexcept {
  return kind == Recording::Kind::Mcap ? ".mcap" : kind == Recording::Kind::Oni ? ".oni" : ".pcd";
}

std::string chunk_subject(const Recording& recording, const std::string& number) {
  return "telepalp-sweep.source." + recording.sha256 + "." + std::to_string(recording.chunk_B) + "." + number;
}

Error cannot_be_sent(const std::string& source) {
  return {
      .what =
          "this source cannot be sent to workers: it must be a session, an .oni or a .pcd file of at most 16 GiB, or "
          "a synthetic patient without a file of its own",
      .where = source,
      .fix = "record the source as a session (telepalp-record), or leave out --workers"};
}

bool is_cached_name(const std::string& name) {
  return name.size() > 64 && is_digest(std::string_view(name).substr(0, 64), 64);
}

/// Reads the chunk of this number into `chunk`.
bool read_chunk(std::ifstream& in, const Recording& recording, std::uint64_t number, std::string& chunk) {
  chunk.resize(recording.size_of_chunk(number));
  in.seekg(static_cast<std::streamoff>(number * recording.chunk_B));
  in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
  return in.good();
}

}  // namespace

Result<std::optional<LocalRecording>> local_recording(const std::string& source, std::uint64_t most_chunk_B) {
  if (is_plain_synthetic(source)) return std::optional<LocalRecording>();
  const std::string spec = with_kind(source);
  const std::size_t colon = spec.find(':');
  const auto* const kind = std::ranges::find_if(
      kKinds, [&](const KindName& one) { return one.scheme == std::string_view(spec).substr(0, colon); });
  if (colon == spec.npos || kind == std::end(kKinds)) return cannot_be_sent(source);
  LocalRecording local{.file = spec.substr(colon + 1), .content = {}};
  local.content.kind = kind->kind;
  std::error_code failed;
  local.content.size_B = fs::file_size(local.file, failed);
  if (failed || !fs::is_regular_file(local.file, failed))
    return Error{.what = "is not a file that can be read", .where = local.file.string(), .fix = "check its name"};
  if (local.content.size_B == 0 || local.content.size_B > kMostRecording_B) return cannot_be_sent(source);
  Result<std::string> digest = keys::sha256_hex_of_file(local.file);
  if (!digest) return digest.error();
  local.content.sha256 = *std::move(digest);
  local.content.chunk_B =
      static_cast<std::uint32_t>(std::clamp<std::uint64_t>(most_chunk_B, kLeastChunk_B, kMostChunk_B));
  return std::optional(std::move(local));
}

Result<void> forget_recording(nats::Streams& streams, const Recording& recording) {
  return streams.erase(kSweeps, chunk_subject(recording, "*"));
}

Result<void> store_recording(nats::Streams& streams, const LocalRecording& recording, const std::atomic<bool>& stop,
                             const std::function<void(std::uint64_t bytes)>& progress) {
  const Recording& content = recording.content;
  const auto stored = streams.subjects(kSweeps, chunk_subject(content, "*"));
  if (!stored) return stored.error();
  const std::set<std::string> there(stored->begin(), stored->end());
  std::ifstream in(recording.file, std::ios::binary);
  std::string chunk;
  for (std::uint64_t i = 0; i < content.chunks() && !stop; ++i) {
    progress(i * content.chunk_B);
    const std::string subject = chunk_subject(content, std::to_string(i));
    if (there.contains(subject)) continue;
    if (!read_chunk(in, content, i, chunk))
      return Error{.what = "cannot be read to its end",
                   .where = recording.file.string(),
                   .fix = "do not change the recording while a sweep reads it"};
    if (const Result<void> done = streams.store(subject, chunk); !done) return done;
  }
  return {};
}

Result<void> RecordingCache::make_room(std::uint64_t bytes) const {
  struct Cached {
    fs::path file;
    fs::file_time_type used;
    std::uint64_t size_B;
  };
  const auto no_room = [&](const std::string& what, const std::string& fix) {
    return Error{.what = what, .where = folder_.string(), .fix = fix};
  };
  if (bytes > most_B_)
    return no_room("the recording has " + std::to_string(bytes >> 20U) + " MiB, more than the cache may hold",
                   "start the worker with a larger --cache-GB");
  std::vector<Cached> all;
  std::uint64_t sum_B = bytes;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder_, failed)) {
    if (!entry.is_regular_file(failed) || !is_cached_name(entry.path().filename().string())) continue;
    const Cached one{entry.path(), entry.last_write_time(failed), entry.file_size(failed)};
    const bool left_over =
        entry.path().extension() == ".part" && one.used < fs::file_time_type::clock::now() - kUnfinishedKept;
    if (left_over) fs::remove(one.file, failed);
    if (left_over || entry.path().extension() == ".part") continue;
    sum_B += one.size_B;
    all.push_back(one);
  }
  std::ranges::sort(all, {}, &Cached::used);
  for (const Cached& one : all) {
    if (sum_B <= most_B_) break;
    if (fs::remove(one.file, failed)) sum_B -= one.size_B;
  }
  if (sum_B <= most_B_) return {};
  return no_room("old recordings in the cache cannot be removed", "let this user write to the folder");
}

Result<void> RecordingCache::write_chunks(nats::Streams& streams, const Recording& recording, const fs::path& file,
                                          const std::atomic<bool>& stop) const {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  std::error_code failed;
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, failed);  // it may show a patient
  for (std::uint64_t i = 0; i < recording.chunks(); ++i) {
    if (stop) return Error{.what = "stopped before its end", .where = "the recording", .fix = "start the worker again"};
    const std::string subject = chunk_subject(recording, std::to_string(i));
    const Result<std::optional<std::string>> chunk = streams.newest(kSweeps, subject);
    if (!chunk) return chunk.error();
    if (!*chunk || (*chunk)->size() != recording.size_of_chunk(i))
      return Error{.what = *chunk ? "a chunk of the recording has another size than the order states"
                                  : "the cluster does not hold all chunks of the recording",
                   .where = subject,
                   .fix = "give the sweep's command again: it sends what is missing"};
    out.write((*chunk)->data(), static_cast<std::streamsize>((*chunk)->size()));
    if (!out)
      return Error{.what = "the recording cannot be written", .where = file.string(), .fix = "make room on the disk"};
  }
  out.close();
  if (!out)
    return Error{.what = "the recording cannot be written", .where = file.string(), .fix = "make room on the disk"};
  return {};
}

Result<fs::path> RecordingCache::fetch(nats::Streams& streams, const Recording& recording,
                                       const std::atomic<bool>& stop) {
  if (const Result<void> made = program::make_folder(folder_, program::Readers::Group); !made) return made.error();
  const fs::path file = folder_ / (recording.sha256 + std::string(ending_of(recording.kind)));
  std::error_code failed;
  const auto is_right = [&](const fs::path& one) {
    const Result<std::string> digest = keys::sha256_hex_of_file(one);
    return digest && *digest == recording.sha256;
  };
  if (fs::is_regular_file(file, failed) && fs::file_size(file, failed) == recording.size_B &&
      (checked_ == recording.sha256 || is_right(file))) {
    fs::last_write_time(file, fs::file_time_type::clock::now(), failed);
    checked_ = recording.sha256;
    return file;
  }
  if (const Result<void> room = make_room(recording.size_B); !room) return room.error();
  const fs::path part = folder_ / (recording.sha256 + "." + std::to_string(::getpid()) + ".part");
  const Result<void> written = write_chunks(streams, recording, part, stop);
  const bool right = written && is_right(part);
  std::error_code not_renamed;
  if (right) fs::rename(part, file, not_renamed);
  if (!right || not_renamed) fs::remove(part, failed);
  if (!written) return written.error();
  if (not_renamed)
    return Error{.what = "the recording cannot be kept: " + not_renamed.message(),
                 .where = file.string(),
                 .fix = "remove this file, or give another --cache"};
  if (!right)
    return Error{.what = "the recording has another digest than the order states",
                 .where = chunk_subject(recording, "*"),
                 .fix = "give the sweep's command again: it sends the whole recording again"};
  checked_ = recording.sha256;
  return file;
}

}  // namespace telepalp::replay
