#include "server/oidc/web/fetch.h"

#include <curl/curl.h>
#include <pthread.h>

#include <csignal>
#include <memory>

namespace telepalp::oidc {
namespace {

constexpr long kLongest_ms = 5000;
constexpr long kLongestConnecting_ms = 3000;

struct EndOfHandle {
  void operator()(CURL* handle) const noexcept { curl_easy_cleanup(handle); }
  void operator()(curl_slist* list) const noexcept { curl_slist_free_all(list); }
};
using Handle = std::unique_ptr<CURL, EndOfHandle>;

/// OpenSSL writes to a connection that the provider has closed: the write then fails, and no signal ends the server.
void block_broken_pipe() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

std::size_t take(const char* bytes, std::size_t, std::size_t count, void* body) {
  auto& text = *static_cast<std::string*>(body);
  if (text.size() + count > kMostReplyBytes) return 0;  // ends the transfer with an error
  text.append(bytes, count);
  return count;
}

int is_stopped(void* stopped, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
  return static_cast<const std::atomic<bool>*>(stopped)->load() ? 1 : 0;
}

void set_limits(CURL* handle, const std::atomic<bool>& stopped) {
  curl_easy_setopt(handle, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(handle, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(handle, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(handle, CURLOPT_TIMEOUT_MS, kLongest_ms);
  curl_easy_setopt(handle, CURLOPT_CONNECTTIMEOUT_MS, kLongestConnecting_ms);
  curl_easy_setopt(handle, CURLOPT_NOPROGRESS, 0L);
  curl_easy_setopt(handle, CURLOPT_XFERINFOFUNCTION, is_stopped);
  curl_easy_setopt(handle, CURLOPT_XFERINFODATA, const_cast<std::atomic<bool>*>(&stopped));  // it is only read
}

void set_request(CURL* handle, const WebRequest& request) {
  curl_easy_setopt(handle, CURLOPT_URL, request.address.c_str());
  if (!request.form.empty()) {
    curl_easy_setopt(handle, CURLOPT_POSTFIELDSIZE, static_cast<long>(request.form.size()));
    curl_easy_setopt(handle, CURLOPT_POSTFIELDS, request.form.c_str());
  }
  if (!request.user.empty()) {
    curl_easy_setopt(handle, CURLOPT_HTTPAUTH, CURLAUTH_BASIC);
    curl_easy_setopt(handle, CURLOPT_USERNAME, request.user.c_str());
    curl_easy_setopt(handle, CURLOPT_PASSWORD, request.password.c_str());
  }
  if (!request.bearer.empty()) {
    curl_easy_setopt(handle, CURLOPT_HTTPAUTH, CURLAUTH_BEARER);
    curl_easy_setopt(handle, CURLOPT_XOAUTH2_BEARER, request.bearer.c_str());
  }
}

}  // namespace

Result<WebReply> fetch(const WebRequest& request, const std::filesystem::path& authority_file,
                       const std::atomic<bool>& stopped) {
  static const CURLcode kReady = curl_global_init(CURL_GLOBAL_DEFAULT);
  block_broken_pipe();
  const Handle handle(kReady == CURLE_OK ? curl_easy_init() : nullptr);
  const std::unique_ptr<curl_slist, EndOfHandle> headers(curl_slist_append(nullptr, "Accept: application/json"));
  if (!handle || !headers)
    return Error{.what = "libcurl cannot start", .where = request.address, .fix = "free memory on this computer"};
  WebReply reply;
  set_limits(handle.get(), stopped);
  set_request(handle.get(), request);
  curl_easy_setopt(handle.get(), CURLOPT_HTTPHEADER, headers.get());
  if (!authority_file.empty()) curl_easy_setopt(handle.get(), CURLOPT_CAINFO, authority_file.c_str());
  curl_easy_setopt(handle.get(), CURLOPT_WRITEFUNCTION, take);
  curl_easy_setopt(handle.get(), CURLOPT_WRITEDATA, &reply.body);
  if (const CURLcode failed = curl_easy_perform(handle.get()); failed != CURLE_OK)
    return Error{.what = failed == CURLE_WRITE_ERROR ? "the reply is larger than 64 KiB" : curl_easy_strerror(failed),
                 .where = request.address,
                 .fix = "check that this server reaches the provider, and that its certificate is trusted"};
  curl_easy_getinfo(handle.get(), CURLINFO_RESPONSE_CODE, &reply.status);
  return reply;
}

}  // namespace telepalp::oidc
