#include "server/meet/caller/arrival.h"

#include <boost/asio/buffer.hpp>
#include <span>
#include <utility>

#include "server/meet/words/meet_frames.h"

namespace telepalp::meet {

using boost::asio::ip::tcp;
using boost::system::error_code;

void Arrival::start(Known known) {
  known_ = std::move(known);
  read();
}

void Arrival::close() {
  error_code ignored;
  known_ = nullptr;
  socket_.close(ignored);
}

/// Reads at most to the end of an answer's token, because the bytes behind it belong to the caller.
void Arrival::read() {
  const std::size_t answer = kAnswer.size() + kTokenBytes;
  const bool may_be_answer = kAnswer.starts_with(std::string_view(bytes_).substr(0, kAnswer.size()));
  const std::size_t room = may_be_answer ? answer - bytes_.size() : kMostHelloBytes - bytes_.size();
  const std::size_t before = bytes_.size();
  bytes_.resize(before + room);
  socket_.async_read_some(boost::asio::buffer(bytes_.data() + before, room),
                          [self = shared_from_this(), before](const error_code& failed, std::size_t count) {
                            self->bytes_.resize(before + count);
                            if (failed || !self->known_) return;
                            self->look();
                          });
}

void Arrival::look() {
  if (bytes_.starts_with(kAnswer)) {
    if (bytes_.size() < kAnswer.size() + kTokenBytes) return read();
    return std::exchange(known_, nullptr)(AnswerToCall{bytes_.substr(kAnswer.size())}, std::move(socket_), {});
  }
  if (!bytes_.empty() && bytes_.front() == '\0' && bytes_.size() < 8) return read();
  if (is_for_relay(bytes_)) return std::exchange(known_, nullptr)(WantsRelay{}, std::move(socket_), std::move(bytes_));
  HelloRead found = read_client_hello(std::as_bytes(std::span(bytes_)));
  const bool may_be_answer = kAnswer.starts_with(bytes_);
  if (found.state == HelloRead::State::Incomplete || may_be_answer) return read();
  if (found.state == HelloRead::State::NotTls) return close();
  std::exchange(known_, nullptr)(std::move(found.hello), std::move(socket_), std::move(bytes_));
}

}  // namespace telepalp::meet
