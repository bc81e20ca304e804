// Encrypted sessions: they read like others, from any place; and each altered or missing byte is noticed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "proto/keys/seal/site_key.h"
#include "proto/keys/secret/private_key.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/sealed/sealed_header.h"
#include "proto/wire/mcap/sealed/sealed_source.h"
#include "proto/wire/mcap/sealed/sealed_stream.h"
#include "proto/wire/mcap/sealed/sealed_text.h"
#include "proto/wire/mcap/sealed/sealer.h"
#include "proto/wire/mcap/writing/output_file.h"
#include "tests/support/child_process.h"

namespace telepalp::wire::mcap {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void put(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

std::string noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

class SealedSession : public ::testing::Test {
 protected:
  void SetUp() override { use(make_key("ward3")); }
  void TearDown() override { ::unsetenv("TELEPALP_SITE_KEYS"); }

  /// Writes NAME.key and NAME.pub as telepalp-keys site-key does; returns the private part's file.
  [[nodiscard]] fs::path make_key(const std::string& name, const std::string& passphrase = "") const {
    const Result<keys::OwnKey> own = keys::make_private_key(passphrase);
    const std::string shown = *keys::public_text(*own->key);
    put(in(name + ".key"), shown + own->text);
    put(in(name + ".pub"), shown);
    fs::permissions(in(name + ".key"), fs::perms::owner_read | fs::perms::owner_write);
    return in(name + ".key");
  }
  static void use(const std::string& files) { ::setenv("TELEPALP_SITE_KEYS", files.c_str(), 1); }
  [[nodiscard]] fs::path in(const std::string& name) const { return folder_.path() / name; }
  /// Writes `content` in pieces of `piece` bytes.
  [[nodiscard]] fs::path write(const std::string& content, std::size_t piece, Protection protection) const {
    fs::remove(in("a.mcap"));
    Result<OutputFile> file = OutputFile::create(in("a.mcap"), protection);
    EXPECT_TRUE(file) << to_string(file.error());
    for (std::size_t at = 0; at < content.size(); at += piece)
      EXPECT_TRUE(file->append(std::string_view(content).substr(at, piece)));
    EXPECT_TRUE(file->publish());
    return in("a.mcap");
  }
  [[nodiscard]] static std::string read(const fs::path& file) {
    const auto source = open_session(file);
    if (!source) return to_string(source.error());
    std::string all;
    if (!(*source)->read(0, static_cast<std::size_t>((*source)->size()), all)) return "unreadable";
    return all;
  }

  support::TemporaryFolder folder_;
};

TEST_F(SealedSession, ReadsAsItWasWrittenInPiecesOfAnySize) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kSealedBlockBytes - 1, kSealedBlockBytes,
                                 kSealedBlockBytes + 1, 3 * kSealedBlockBytes, 5 * kSealedBlockBytes + 77})
    for (const std::size_t piece : {std::size_t{999}, kSealedBlockBytes, 2 * kSealedBlockBytes + 5}) {
      const std::string content = noise(size, 1);
      const fs::path file = write(content, piece, Protection::OfSite);
      EXPECT_EQ(read(file) == content, true) << size << " B in pieces of " << piece;
      if (size > 32) {
        EXPECT_EQ(bytes_of(file).find(content.substr(0, 32)), std::string::npos) << "stored readable";
      }
    }
}

TEST_F(SealedSession, ReadsFromAnyPlace) {
  const std::string content = noise(4 * kSealedBlockBytes + 1234, 2);
  const auto source = open_session(write(content, 70'001, Protection::OfSite));
  ASSERT_TRUE(source);
  ASSERT_EQ((*source)->size(), content.size());
  std::mt19937 random(3);
  std::string part;
  for (int i = 0; i < 500; ++i) {
    const std::size_t at = random() % content.size();
    const std::size_t length = random() % (content.size() - at);
    ASSERT_TRUE((*source)->read(at, length, part));
    ASSERT_EQ(part == content.substr(at, length), true) << at << " + " << length;
  }
}

TEST_F(SealedSession, AnAlteredByteMakesItsBlockUnreadableAndNoOther) {
  const std::string content = noise(3 * kSealedBlockBytes + 100, 4);
  const std::string sealed = bytes_of(write(content, 1 << 20, Protection::OfSite));
  constexpr std::size_t kStride = kSealedBlockBytes + keys::kSealBytes;
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    std::string altered = sealed;
    const std::size_t at = kSealedHeaderBytes + random() % (3 * kStride);
    altered[at] = static_cast<char>(altered[at] ^ (1 << random() % 8));
    const auto source = decrypted(in_memory(altered, "altered"));
    ASSERT_TRUE(source);
    std::string part;
    for (std::size_t block = 0; block < 3; ++block)
      EXPECT_EQ((*source)->read(block * kSealedBlockBytes, 100, part), block != (at - kSealedHeaderBytes) / kStride)
          << at;
  }
}

TEST_F(SealedSession, BlocksThatChangedTheirPlaceOrTheirFileAreUnreadable) {
  const std::string content = noise(2 * kSealedBlockBytes, 6);
  const std::string one = bytes_of(write(content, 1 << 20, Protection::OfSite));
  const std::string other = bytes_of(write(content, 1 << 20, Protection::OfSite));
  constexpr std::size_t kStride = kSealedBlockBytes + keys::kSealBytes;
  std::string swapped = one.substr(0, kSealedHeaderBytes) + one.substr(kSealedHeaderBytes + kStride) +
                        one.substr(kSealedHeaderBytes, kStride);
  std::string mixed = one.substr(0, kSealedHeaderBytes) + other.substr(kSealedHeaderBytes);
  for (const std::string& wrong : {swapped, mixed}) {
    const auto source = decrypted(in_memory(wrong, "wrong"));
    std::string part;
    if (source) {
      EXPECT_FALSE((*source)->read(0, 10, part));
    }
  }
}

TEST_F(SealedSession, AFileThatIsCutOffEndsWithItsLastWholeBlock) {
  const std::string content = noise(2 * kSealedBlockBytes + 5000, 7);
  const std::string sealed = bytes_of(write(content, 1 << 20, Protection::OfSite));
  for (const std::size_t missing : {1U, 27U, 28U, 4000U, 5027U}) {
    const auto source = decrypted(in_memory(sealed.substr(0, sealed.size() - missing), "cut off"));
    ASSERT_TRUE(source);
    EXPECT_EQ((*source)->size(), 2 * kSealedBlockBytes) << missing;
  }
}

TEST_F(SealedSession, EachDamageOfTheHeaderIsSaid) {
  const std::string sealed = bytes_of(write("content", 100, Protection::OfSite));
  for (std::size_t at = 0; at < kSealedHeaderBytes; ++at) {
    std::string altered = sealed;
    altered[at] = static_cast<char>(altered[at] ^ 1);
    const auto source = decrypted(in_memory(altered, "altered"));
    if (at < kSealedMagic.size()) continue;  // then it is no encrypted session, and no session at all
    ASSERT_FALSE(source) << at;
    EXPECT_NE(source.error().what.find("its header is damaged"), std::string::npos) << source.error().what;
  }
  EXPECT_FALSE(decrypted(in_memory(sealed.substr(0, 300), "short")));
}

TEST_F(SealedSession, ItsErrorNamesTheKeyThatIsMissing) {
  const fs::path file = write("content", 100, Protection::OfSite);
  const std::string id = keys::in_hexadecimal_digits(keys::SiteKey::load(in("ward3.pub"))->id());
  ::unsetenv("TELEPALP_SITE_KEYS");
  EXPECT_NE(read(file).find(id), std::string::npos) << read(file);
  use(make_key("ward4"));
  EXPECT_NE(read(file).find(id), std::string::npos) << read(file);
  use(in("ward3.pub"));
  EXPECT_NE(read(file).find("decrypts nothing"), std::string::npos) << read(file);
  use(in("ward4.key").string() + ":" + in("ward3.key").string());
  EXPECT_EQ(read(file), "content");
  use(in("none.key"));
  EXPECT_NE(read(file).find("cannot be read"), std::string::npos) << read(file);
}

TEST_F(SealedSession, ThePublicPartEncryptsAndAProtectedPrivatePartDecrypts) {
  ::setenv("TELEPALP_PASSPHRASE", "the passphrase of ward 5", 1);
  const fs::path key = make_key("ward5", "the passphrase of ward 5");
  use(in("ward5.pub"));
  const fs::path file = write("content", 100, Protection::OfSite);
  use(key);
  EXPECT_EQ(read(file), "content");
  ::unsetenv("TELEPALP_PASSPHRASE");
}

TEST_F(SealedSession, OthersMayNotReadThePrivatePart) {
  fs::permissions(in("ward3.key"), fs::perms::others_read, fs::perm_options::add);
  use("");
  use(in("ward3.key"));
  EXPECT_FALSE(OutputFile::create(in("b.mcap"), Protection::OfSite));
}

TEST_F(SealedSession, AnotherSiteKeyNeedsANewHeaderOnly) {
  const std::string content = noise(kSealedBlockBytes + 9, 8);
  const std::string before = bytes_of(write(content, 1 << 20, Protection::OfSite));
  const SealedHeader header = **header_in(before.substr(0, kSealedHeaderBytes), "a");
  const Result<keys::FileKey> key = file_key_of(header, "a");
  ASSERT_TRUE(key);
  const fs::path next = make_key("next");
  const Result<SealedHeader> changed = with_key_of(header, *keys::SiteKey::load(next), *key);
  ASSERT_TRUE(changed);
  put(in("b.mcap"), in_bytes(*changed) + before.substr(kSealedHeaderBytes));
  EXPECT_NE(read(in("b.mcap")).find("which is not given"), std::string::npos) << "the old key decrypts it no more";
  use(next);
  EXPECT_EQ(read(in("b.mcap")) == content, true);
}

TEST_F(SealedSession, WithoutAKeyOrWhenItIsGivenAwayItIsNotEncrypted) {
  EXPECT_EQ(bytes_of(write("content", 100, Protection::None)), "content");
  ::unsetenv("TELEPALP_SITE_KEYS");
  EXPECT_EQ(bytes_of(write("content", 100, Protection::OfSite)), "content");
}

TEST_F(SealedSession, ATextBesideItIsEncryptedForTheSameKeyByWhoeverHasThePublicPart) {
  const fs::path session = write("content", 100, Protection::OfSite);
  use(make_key("next").string() + ":" + in("ward3.pub").string());
  const Result<std::string> beside = text_beside(session, "a note");
  ASSERT_TRUE(beside) << to_string(beside.error());
  EXPECT_EQ(beside->find("a note"), std::string::npos);
  EXPECT_NE(text_of(*beside, "n").error().what.find("decrypts nothing"), std::string::npos);
  use(in("ward3.key"));
  EXPECT_EQ(*text_of(*beside, "n"), "a note") << "whoever reads the session reads the note";
  EXPECT_EQ(*text_of("a note", "n"), "a note") << "an older version wrote it";
  use(in("next.key"));
  EXPECT_NE(text_beside(session, "a note").error().what.find("which is not given"), std::string::npos);
}

TEST_F(SealedSession, ATextBesideAPlainSessionIsPlainAndBesideANewOneIsEncrypted) {
  EXPECT_EQ(*text_beside(write("content", 100, Protection::None), "a note"), "a note");
  EXPECT_EQ(text_beside(in("new.mcap"), "a note")->find("a note"), std::string::npos);
  ::unsetenv("TELEPALP_SITE_KEYS");
  EXPECT_EQ(*text_beside(in("new.mcap"), "a note"), "a note");
}

TEST_F(SealedSession, EachAlteredOrMissingByteOfATextIsNoticed) {
  const std::string note = "tender here, second rib";
  const std::string sealed = *sealed_text(*keys::SiteKey::load(in("ward3.key")), note);
  ASSERT_EQ(sealed.size(), note.size() + kSealedTextExtra_B);
  for (std::size_t at = kSealedMagic.size(); at < sealed.size(); ++at) {
    std::string altered = sealed;
    altered[at] = static_cast<char>(altered[at] ^ 1);
    EXPECT_FALSE(text_of(altered, "n")) << at;
    EXPECT_FALSE(text_of(sealed.substr(0, at), "n")) << at;
  }
  EXPECT_FALSE(text_of(sealed + "x", "n"));
}

TEST_F(SealedSession, ABlockOfTheSessionIsNoTextBesideIt) {
  const std::string session = bytes_of(write("content", 100, Protection::OfSite));
  EXPECT_FALSE(text_of(session, "n"));
  const auto source = decrypted(in_memory(*sealed_text(*keys::SiteKey::load(in("ward3.key")), "a note"), "n"));
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->size(), 0U) << "nor is a text a session";
}

TEST_F(SealedSession, AStreamIsEncryptedAndReadsUpToItsLastFlush) {
  const std::string content = noise(3 * kSealedBlockBytes + 500, 11);
  const fs::path file = in("run.journal");
  {
    const auto out = create_stream(file);
    ASSERT_TRUE(out) << to_string(out.error());
    **out << content << std::flush;
    EXPECT_EQ(bytes_of(file).find(content.substr(0, 32)), std::string::npos);
    **out << "lost";
    ASSERT_TRUE((*out)->good());
    EXPECT_EQ(read(file) == content, true) << "what was flushed is there after a crash";
  }
  const auto back = open_stream(file);
  ASSERT_TRUE(back);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(**back), {}).substr(0, content.size()) == content, true);
  EXPECT_EQ(fs::status(file).permissions() & fs::perms::others_all, fs::perms::none);
  use(make_key("ward4"));
  EXPECT_FALSE(open_stream(file));
}

TEST_F(SealedSession, AStreamWithoutAKeyIsPlainAndADamagedOneEndsBeforeTheDamage) {
  const std::string content = noise(3 * kSealedBlockBytes, 12);
  const auto write_stream = [&](const fs::path& file) { (**create_stream(file) << content).flush(); };
  write_stream(in("sealed.journal"));
  std::string damaged = bytes_of(in("sealed.journal"));
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  put(in("damaged.journal"), damaged);
  const auto part = open_stream(in("damaged.journal"));
  ASSERT_TRUE(part);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(**part), {}) == content.substr(0, kSealedBlockBytes), true);
  ::unsetenv("TELEPALP_SITE_KEYS");
  write_stream(in("plain.journal"));
  EXPECT_EQ(bytes_of(in("plain.journal")) == content, true);
  EXPECT_FALSE(create_stream(in("none/plain.journal")));
}

/// A sink that is full after some bytes.
class FullSink final : public ByteSink {
 public:
  explicit FullSink(std::size_t room) : room_(room) {}
  [[nodiscard]] Result<void> write(std::uint64_t offset, std::string_view bytes) override {
    const std::size_t fits = room_ > offset ? room_ - static_cast<std::size_t>(offset) : 0;
    bytes_.resize(static_cast<std::size_t>(offset));
    bytes_ += bytes.substr(0, fits);
    if (fits >= bytes.size()) return {};
    return Error{.what = "full", .where = "test", .fix = "make room"};
  }
  void cut(std::uint64_t size) noexcept override { bytes_.resize(static_cast<std::size_t>(size)); }
  [[nodiscard]] Result<void> publish() override { return {}; }
  void discard() noexcept override {}
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::size_t room_;
  std::string bytes_;
};

TEST_F(SealedSession, AFullDiskLeavesWhatWasWrittenBefore) {
  FullSink sink(300'000);
  Sealer sealer = **sealer_of_site();
  ASSERT_TRUE(sealer.begin(sink));
  const std::string first = noise(100'000, 9);
  ASSERT_TRUE(sealer.append(sink, first));
  ASSERT_FALSE(sealer.append(sink, noise(400'000, 10)));
  const auto source = decrypted(in_memory(sink.bytes(), "full"));
  ASSERT_TRUE(source);
  std::string all;
  ASSERT_TRUE((*source)->read(0, static_cast<std::size_t>((*source)->size()), all));
  EXPECT_EQ(all == first, true);
  ASSERT_TRUE(sealer.append(sink, "more")) << "it goes on when there is room again";
}

}  // namespace
}  // namespace telepalp::wire::mcap
