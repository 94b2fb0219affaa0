#include "base/file_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <unistd.h>

namespace glide {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<std::byte> someBytes(std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>(i * 37);
  return bytes;
}

/// A folder of its own for each test.
class FileIo : public testing::Test {
 protected:
  FileIo()
      : folder_(fs::temp_directory_path() /
                (std::string("glide_") + std::to_string(::getpid()) + "_" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~FileIo() override { fs::remove_all(folder_); }

  std::size_t filesInFolder() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const fs::path folder_;
};

TEST_F(FileIo, ReadsBackWhatWasWritten) {
  const fs::path path = folder_ / "a.bin";
  for (const auto durability : {FileDurability::synced, FileDurability::cached}) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{3'000'000}}) {
      ASSERT_TRUE(writeFileAtomically(path, someBytes(size), durability).ok());
      const auto read = readFile(path);
      ASSERT_TRUE(read.ok());
      EXPECT_EQ(read.value(), someBytes(size));
    }
  }
  EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(FileIo, SurvivesLeftoversOfAnotherSave) {
  const fs::path path = folder_ / "a.bin";
  std::ofstream(path.string() + "." + std::to_string(::getpid()) + "-0.tmp") << "left over";
  ASSERT_TRUE(writeFileAtomically(path, someBytes(10), FileDurability::synced).ok());
  EXPECT_EQ(readFile(path)->size(), 10U);
  EXPECT_EQ(filesInFolder(), 2U);  // what is not ours stays
}

TEST_F(FileIo, LeavesNothingHalfWritten) {
  const fs::path taken = folder_ / "folder";
  fs::create_directories(taken / "inside");  // a rename onto it fails
  const Status status = writeFileAtomically(taken, someBytes(10), FileDurability::synced);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::io);
  EXPECT_THAT(status.error().message, HasSubstr(taken.string()));
  EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(FileIo, NamesTheFileThatCannotBeWritten) {
  const fs::path path = folder_ / "missing" / "a.bin";
  const Status status = writeFileAtomically(path, someBytes(10), FileDurability::synced);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::io);
  EXPECT_THAT(status.error().message, HasSubstr(path.string()));
}

TEST_F(FileIo, NamesTheFileThatCannotBeRead) {
  const auto missing = readFile(folder_ / "missing");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::io);
  EXPECT_THAT(missing.error().message, HasSubstr((folder_ / "missing").string()));
  const auto folder = readFile(folder_);
  ASSERT_FALSE(folder.ok());
  EXPECT_THAT(folder.error().message, HasSubstr("not a regular file"));
  EXPECT_FALSE(readFile("/dev/zero").ok());  // has no end
}

}  // namespace
}  // namespace glide
