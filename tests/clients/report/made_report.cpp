#include "tests/clients/report/made_report.h"

#include <gtest/gtest.h>

#include "clients/report/figures/report_html.h"
#include "clients/report/summary/report_json.h"
#include "proto/wire/mcap/writer.h"

namespace telepalp::report {

Session session_of(const MadeSession& made) {
  Session session;
  session.name = "made.mcap";
  for (const wire::Message& message : made_messages(made)) add(session, message);
  return session;
}

std::filesystem::path written(const MadeSession& made, const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
  std::filesystem::remove(file);
  auto writer = wire::McapWriter::open(
      file, {.program = "report_test", .version = {}, .commit = {}, .source = "made", .scene = {}});
  EXPECT_TRUE(writer.ok());
  for (const wire::Message& message : made_messages(made)) EXPECT_TRUE(writer->write(message).ok());
  EXPECT_TRUE(writer->close().ok());
  return file;
}

std::string json_of(const Session& session) {
  const Summary summary = summarise(session);
  return report_json(session, summary, judge(summary, kPaths.front(), &session));
}

std::string html_of(const Session& session) {
  const Summary summary = summarise(session);
  return report_html(session, summary, judge(summary, kPaths.front(), &session), "");
}

}  // namespace telepalp::report
