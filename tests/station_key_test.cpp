// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The station's key is private: looked at whenever it is opened, and in nothing that a crash
// writes.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "db/hex.h"
#include "db/signature.h"
#include "db/station.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();

class StationKey : public testing::Test {
 protected:
    void SetUp() override {
        use(folder.file("station.key"));
        ::unsetenv("CREDENTIALS_DIRECTORY");
        own_ = db::Station().public_key();
    }
    void use(const std::string& path) {
        path_ = path;
        ::setenv("PLACODE_STATION_KEY", path.c_str(), 1);
    }
    void set_mode(mode_t mode) const { ASSERT_EQ(::chmod(path_.c_str(), mode), 0); }
    [[nodiscard]] static StoreError refusal() {
        return failure_of([] { (void)db::Station().sign("x"); });
    }

    TemporaryFolder folder;
    std::string path_, own_;
};

TEST_F(StationKey, IsMadeForItsOwnerAlone) {
    struct stat status {};
    ASSERT_EQ(::stat(path_.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0600u);
    EXPECT_EQ(own_.size(), 64u);
    EXPECT_EQ(db::Station().public_key(), own_) << "the same one the next time";
    EXPECT_TRUE(db::signature_is_right("x", db::Station().sign("x"), own_));
}

TEST_F(StationKey, ThatOthersCanReadOrWriteIsRefusedWithTheWayOut) {
    for (const mode_t mode : {0644, 0640, 0660, 0604, 0602, 0666}) {
        set_mode(mode);
        const StoreError error = refusal();
        EXPECT_EQ(error.kind(), StoreError::Kind::kRefused) << mode;
        EXPECT_THAT(error.what(), HasSubstr(path_ + " is open to others (mode 6"));
        EXPECT_THAT(error.what(), HasSubstr("`chmod 600` it"));
    }
    set_mode(0644);
    db::Station again;
    for (int i = 0; i < 2; ++i)
        EXPECT_THAT(failure_of([&] { (void)again.public_key(); }).what(), HasSubstr("(mode 644)"))
            << "not once only: what was refused never signs";
    // Nothing is written into a store without its signature either.
    EXPECT_THAT(failure_of([&] {
                    const auto store = db::open_store("sqlite:" + folder.file("a.db"));
                    store->audit().write("test", "a", "b", "c");
                }).what(),
                HasSubstr("`chmod 600` it"));
    for (const mode_t mode : {0600, 0400}) {
        set_mode(mode);
        EXPECT_EQ(db::Station().public_key(), own_);
    }
}

TEST_F(StationKey, OfAnotherAccountIsRefused) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root gives files away";
    ASSERT_EQ(::chown(path_.c_str(), 12345, 12345), 0);
    const StoreError error = refusal();
    EXPECT_EQ(error.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(error.what(), HasSubstr("belongs to another account (number 12345)"));
    EXPECT_THAT(error.what(), HasSubstr("set PLACODE_STATION_KEY to a file of your own"));
}

TEST_F(StationKey, OfASystemdCredentialMayBeTheGroupsByItsAccessList) {
    set_mode(0440);
    EXPECT_EQ(refusal().kind(), StoreError::Kind::kRefused);
    ::setenv("CREDENTIALS_DIRECTORY", folder.path().c_str(), 1);
    EXPECT_EQ(db::Station().public_key(), own_);
    set_mode(0444);
    EXPECT_EQ(refusal().kind(), StoreError::Kind::kRefused);
    ::unsetenv("CREDENTIALS_DIRECTORY");
}

TEST_F(StationKey, ThatIsNoFileIsDamaged) {
    use(folder.path().string());
    EXPECT_EQ(refusal().kind(), StoreError::Kind::kDamaged);
}

/// The memory that a core file would hold: every mapping that can be read and is not left out. The
/// bytes looked for are given masked, so that this test does not find itself.
class CoreFile {
 public:
    static constexpr unsigned char kMask = 0xa5;
    using Masked = std::vector<unsigned char>;

    [[nodiscard]] static int places_with(const Masked& masked) {
        std::ifstream maps("/proc/self/smaps");
        std::string line;
        uintptr_t begin = 0, end = 0;
        bool readable = false;
        int found = 0;
        while (std::getline(maps, line)) {
            if (line.starts_with("VmFlags:")) {
                const bool left_out = line.find(" dd") != std::string::npos;
                if (readable && !left_out) found += in_range(begin, end, masked);
                continue;
            }
            std::istringstream words(line);
            std::string range, rights;
            if (!(words >> range >> rights) || range.find('-') == std::string::npos) continue;
            begin = std::stoul(range.substr(0, range.find('-')), nullptr, 16);
            end = std::stoul(range.substr(range.find('-') + 1), nullptr, 16);
            readable = rights[0] == 'r';
        }
        return found;
    }

 private:
    static int in_range(uintptr_t begin, uintptr_t end, const Masked& masked) {
        static std::array<unsigned char, size_t{1} << 16> window{};
        const int memory = ::open("/proc/self/mem", O_RDONLY | O_CLOEXEC);
        int found = 0;
        const size_t step = window.size() - masked.size();
        for (uintptr_t at = begin; at < end; at += step) {
            const size_t most = std::min<size_t>(window.size(), end - at);
            const ssize_t got = ::pread(memory, window.data(), most, static_cast<off_t>(at));
            if (got < static_cast<ssize_t>(masked.size())) continue;
            const unsigned char* const first = window.data();
            const unsigned char* const last = first + got;
            const auto* place = std::search(
                first, last, masked.begin(), masked.end(),
                [](unsigned char byte, unsigned char hidden) { return (byte ^ kMask) == hidden; });
            found += place != last ? 1 : 0;
            window.fill(0);  // Or it would be found here.
        }
        ::close(memory);
        return found;
    }
};

/// 24 digits of the secret half, masked as they come off the disk.
CoreFile::Masked masked_part(const std::string& path) {
    std::array<unsigned char, 256> bytes{};
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const ssize_t got = ::read(file, bytes.data(), bytes.size());
    ::close(file);
    EXPECT_GT(got, 64 + 1 + 24);
    CoreFile::Masked masked;
    for (size_t i = 0; i < 24; ++i)
        masked.push_back(static_cast<unsigned char>(bytes[65 + i] ^ CoreFile::kMask));
    sodium_memzero(bytes.data(), bytes.size());
    return masked;
}

/// The same as the bytes that the digits mean.
CoreFile::Masked bytes_meant(const CoreFile::Masked& digits) {
    CoreFile::Masked masked;
    for (size_t i = 0; i + 1 < digits.size(); i += 2) {
        unsigned value = 0;
        for (const size_t each : {i, i + 1}) {
            const auto digit = static_cast<unsigned>(digits[each] ^ CoreFile::kMask);
            value = 16 * value + (digit >= 'a' ? digit - 'a' + 10 : digit - '0');
        }
        masked.push_back(static_cast<unsigned char>(value ^ CoreFile::kMask));
    }
    return masked;
}

TEST_F(StationKey, IsInNoCoreFile) {
    use(folder.file("another.key"));
    db::Station station;
    EXPECT_EQ(station.public_key().size(), 64u);
    const auto digits = masked_part(path_), meant = bytes_meant(digits);
    EXPECT_FALSE(station.sign("a recording").empty());
    EXPECT_EQ(CoreFile::places_with(digits), 0) << "just made, read and used, still open";
    EXPECT_EQ(CoreFile::places_with(meant), 0);
    db::Station reading;
    EXPECT_FALSE(reading.sign("a recording").empty());
    EXPECT_EQ(CoreFile::places_with(digits), 0);
    EXPECT_EQ(CoreFile::places_with(meant), 0);
    // And what lies about is found.
    std::string lying_about = read_text(path_);
    EXPECT_GT(CoreFile::places_with(digits), 0);
    db::wipe(lying_about);
}

}  // namespace THIS_TEST
