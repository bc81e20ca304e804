#include "haptic_station/station/threads/journal_thread.h"

#include <boost/asio/post.hpp>
#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>
#include <utility>

#include "haptic_station/core/journal/journal_words.h"
#include "proto/wire/mcap/sealed/sealed_stream.h"

namespace telepalp::station {
namespace {

constexpr std::chrono::milliseconds kPeriod{20};
constexpr std::size_t kMostWaitingBytes = 256U << 20U;
constexpr int kTicksInBlock = 400;

Error not_written(const std::filesystem::path& file, const std::string& why) {
  return {.what = "the journal cannot be written: " + why,
          .where = file.string(),
          .fix = "give --journal a file in a folder of this user, on a disk with 5 MB of space for each second"};
}

}  // namespace

Result<std::unique_ptr<JournalThread>> JournalThread::open(const std::filesystem::path& file,
                                                           const msg::JournalHeader& header) {
  Result<std::unique_ptr<std::ostream>> out = wire::mcap::create_stream(file);
  if (!out) return out.error().where == file.string() ? not_written(file, out.error().what) : out.error();
  return std::unique_ptr<JournalThread>(new JournalThread(file, *std::move(out), header));
}

JournalThread::JournalThread(const std::filesystem::path& file, std::unique_ptr<std::ostream> out,
                             const msg::JournalHeader& header)
    : file_(file), out_(std::move(out)), writer_(*out_, header), thread_([this] {
        every_20_ms();
        io_.run();
      }) {}

JournalThread::~JournalThread() { (void)close(); }

void JournalThread::every_20_ms() {
  drain();
  out_->flush();
  timer_.expires_after(kPeriod);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error && !closing_) every_20_ms();
  });
}

void JournalThread::drain() {
  core::JournalTick tick;
  for (bool more = true; more;) {
    msg::JournalBlock block;
    msg::JournalTicks& ticks = *block.mutable_ticks();
    while (ticks.ticks_size() < kTicksInBlock && (more = ticks_->try_pop(tick))) *ticks.add_ticks() = message_of(tick);
    if (ticks.ticks().empty()) return;
    end_.set_ticks(end_.ticks() + static_cast<std::uint64_t>(ticks.ticks_size()));
    writer_.add(block);
  }
}

void JournalThread::add(msg::JournalSurfaceRun run) {
  msg::JournalBlock block;
  *block.mutable_surface_run() = std::move(run);
  add(std::move(block));
}

void JournalThread::add(msg::JournalCollisionRun run) {
  msg::JournalBlock block;
  *block.mutable_collision_run() = std::move(run);
  add(std::move(block));
}

void JournalThread::add(msg::JournalBlock block) {
  const std::size_t bytes = block.ByteSizeLong();
  if (waiting_bytes_.fetch_add(bytes) + bytes > kMostWaitingBytes) {
    waiting_bytes_ -= bytes;
    ++runs_lost_;
    return;
  }
  boost::asio::post(io_, [this, bytes, block = std::move(block)] {
    writer_.add(block);
    end_.set_runs(end_.runs() + 1);
    waiting_bytes_ -= bytes;
  });
}

Result<void> JournalThread::close() {
  if (!thread_.joinable()) return {};
  boost::asio::post(io_, [this] {  // behind all runs that were posted
    closing_ = true;
    timer_.cancel();
  });
  thread_.join();
  drain();
  msg::JournalBlock block;
  end_.set_ticks_lost(ticks_lost_);
  end_.set_runs_lost(runs_lost_);
  *block.mutable_end() = end_;
  writer_.add(block);
  errno = 0;
  out_->flush();
  if (!*out_) return not_written(file_, std::generic_category().message(errno == 0 ? EIO : errno));
  return {};
}

}  // namespace telepalp::station
