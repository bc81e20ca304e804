#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "proto/keys/web_certificate.h"

namespace telepalp::access {

/// The two files of the certificate that browsers see (--web-cert, --web-key).
class WebCertificateFile {
 public:
  WebCertificateFile(std::filesystem::path certificate, std::filesystem::path key)
      : certificate_(std::move(certificate)), key_(std::move(key)) {}

  /// Error: as for keys::load_web_certificate().
  [[nodiscard]] Result<keys::WebCertificate> read(const keys::AskPassphrase& ask) {
    read_ = times();
    Result<keys::WebCertificate> loaded =
        keys::load_web_certificate(certificate_, key_, std::chrono::system_clock::now(), ask);
    if (loaded) hosts_ = loaded->hosts;
    return loaded;
  }
  /// A file was written since the last read().
  [[nodiscard]] bool has_changed() const { return times() != read_; }
  /// The hosts of the last certificate that was read.
  [[nodiscard]] const std::vector<std::string>& hosts() const noexcept { return hosts_; }

 private:
  using Times = std::pair<std::filesystem::file_time_type, std::filesystem::file_time_type>;
  [[nodiscard]] Times times() const {
    std::error_code gone;
    return {std::filesystem::last_write_time(certificate_, gone), std::filesystem::last_write_time(key_, gone)};
  }

  std::filesystem::path certificate_, key_;
  std::vector<std::string> hosts_;
  Times read_{};
};

}  // namespace telepalp::access
