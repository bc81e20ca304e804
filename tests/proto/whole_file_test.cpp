// How every program writes a file.

#include "support/program/files/whole_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/child_process.h"

namespace telepalp::program {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

mode_t mode_of(const fs::path& path) {
  struct stat at {};
  return ::lstat(path.c_str(), &at) == 0 ? at.st_mode & 0777U : 0;
}

class WholeFile : public testing::Test {
 protected:
  WholeFile() : umask_(::umask(0022)) {}
  ~WholeFile() override { ::umask(umask_); }
  fs::path in(const std::string& name) const { return folder_.path() / name; }
  long files() const { return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()); }

  support::TemporaryFolder folder_;

 private:
  mode_t umask_;
};

TEST_F(WholeFile, OfAPatientIsForItsOwnerAndGroup) {
  ASSERT_TRUE(make_folder(in("a/b/"), Readers::Group));
  ASSERT_TRUE(write_whole_file(in("a/b/view.png"), "patient", Readers::Group));
  EXPECT_EQ(mode_of(in("a")), 0750U);
  EXPECT_EQ(mode_of(in("a/b")), 0750U);
  EXPECT_EQ(mode_of(in("a/b/view.png")), 0640U);
}

TEST_F(WholeFile, WithoutAPatientIsForAnyone) {
  ASSERT_TRUE(make_folder(in("figures"), Readers::Anyone));
  ASSERT_TRUE(write_whole_file(in("figures/a.svg"), "figure", Readers::Anyone));
  EXPECT_EQ(mode_of(in("figures")), 0755U);
  EXPECT_EQ(mode_of(in("figures/a.svg")), 0644U);
}

TEST_F(WholeFile, LeavesTheModeOfAFolderThatItDidNotMake) {
  fs::create_directory(in("mine"));
  fs::permissions(in("mine"), fs::perms{0777});
  ASSERT_TRUE(make_folder(in("mine"), Readers::Group));
  EXPECT_EQ(mode_of(in("mine")), 0777U);
}

TEST_F(WholeFile, ReplacesAnEarlierOneWhateverItsModeWas) {
  std::ofstream(in("report.html")) << "earlier";
  fs::permissions(in("report.html"), fs::perms{0666});
  ASSERT_TRUE(write_whole_file(in("report.html"), "new", Readers::Group));
  EXPECT_EQ(bytes_of(in("report.html")), "new");
  EXPECT_EQ(mode_of(in("report.html")), 0640U);
  EXPECT_EQ(files(), 1);
}

TEST_F(WholeFile, DoesNotWriteThroughAPlantedSymbolicLink) {
  std::ofstream(in("victim")) << "precious";
  fs::create_symlink(in("victim"), in("report.html"));
  fs::create_symlink(in("nowhere"), in("view.png"));
  ASSERT_TRUE(write_whole_file(in("report.html"), "report", Readers::Group));
  ASSERT_TRUE(write_whole_file(in("view.png"), "view", Readers::Group));
  EXPECT_EQ(bytes_of(in("victim")), "precious");
  EXPECT_FALSE(fs::exists(in("nowhere")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(in("report.html"))));
}

TEST_F(WholeFile, DoesNotPutItselfInThePlaceOfADeviceOrFolder) {
  fs::create_directory(in("folder"));
  fs::create_symlink("/dev/null", in("null"));
  for (const fs::path& place : {fs::path("/dev/full"), in("null"), in("folder"), in("folder/")}) {
    const Result<void> written = write_whole_file(place, "report", Readers::Group);
    ASSERT_FALSE(written.ok()) << place;
    EXPECT_NE(to_string(written.error()).find("fix: name another file"), std::string::npos);
  }
  EXPECT_TRUE(fs::is_symlink(in("null")));
}

TEST_F(WholeFile, LeavesNothingBehindWhenTheFolderIsMissing) {
  const Result<void> written = write_whole_file(in("missing/a.png"), "x", Readers::Group);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().where, in("missing/a.png").string());
  EXPECT_EQ(files(), 0);
}

/// A child process whose files may not grow beyond 4 kB: its writes fail as they would on a full disk.
TEST_F(WholeFile, OnAFullDiskIsAnErrorAndTheEarlierFileStays) {
  std::ofstream(in("report.html")) << "earlier";
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const Result<void> written = write_whole_file(in("report.html"), std::string(100'000, 'x'), Readers::Group);
    const bool says_so = !written && written.error().fix.find("free space") != std::string::npos;
    ::_exit(says_so ? 7 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(bytes_of(in("report.html")), "earlier");
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace telepalp::program
