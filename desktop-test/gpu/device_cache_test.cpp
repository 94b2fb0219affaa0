#include "gpu/device_cache.h"

#include "support/temporary_folder.h"

#include "gpu/gl_caps.h"

#include "base/file_io.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace glide::test {
namespace {

namespace fs = std::filesystem;

GlCaps someDevice() {
  GlCaps caps;
  caps.vendor = "ARM";
  caps.renderer = "Mali-G52";
  caps.version = "OpenGL ES 3.2 v1.r26p0";
  return caps;
}

class DeviceCacheTest : public testing::Test {
 protected:
  DeviceCache cacheOf(const GlCaps& caps) const { return {folder_.path() / "made" / "here", caps}; }

  const TemporaryFolder folder_;
  const DeviceCache cache_ = cacheOf(someDevice());
  const std::vector<std::byte> value_ = std::vector<std::byte>(10, std::byte{7});
};

TEST_F(DeviceCacheTest, GivesBackWhatItKept) {
  EXPECT_EQ(cache_.load("program", "key"), std::nullopt);
  cache_.store("program", "key", value_);
  EXPECT_EQ(cache_.load("program", "key"), value_);
  EXPECT_EQ(cacheOf(someDevice()).load("program", "key"), value_);  // another start of the app
  cache_.store("program", "key", {});
  EXPECT_EQ(cache_.load("program", "key"), std::vector<std::byte>());
}

TEST_F(DeviceCacheTest, KeepsKeysAndKindsApart) {
  cache_.store("program", "key", value_);
  EXPECT_EQ(cache_.load("program", "another key"), std::nullopt);
  EXPECT_EQ(cache_.load("tuning", "key"), std::nullopt);
}

TEST_F(DeviceCacheTest, KeepsDevicesAndDriversApart) {
  cache_.store("program", "key", value_);
  GlCaps updated = someDevice();
  updated.version = "OpenGL ES 3.2 v1.r38p1";
  EXPECT_EQ(cacheOf(updated).load("program", "key"), std::nullopt);
  GlCaps other = someDevice();
  other.renderer = "Mali-G57";
  EXPECT_EQ(cacheOf(other).load("program", "key"), std::nullopt);
}

TEST_F(DeviceCacheTest, DoesNotBelieveAFileOfAnotherKeyUnderItsName) {
  cache_.store("program", "key", value_);
  fs::copy_file(cache_.path("program", "key"), cache_.path("program", "clash"));
  EXPECT_EQ(cache_.load("program", "clash"), std::nullopt);
}

TEST_F(DeviceCacheTest, TakesADamagedFileForNoneAndReplacesIt) {
  cache_.store("program", "key", value_);
  const std::string path = cache_.path("program", "key");
  const std::vector<std::byte> whole = readFile(path).value();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::vector<std::byte> changed = whole;
    changed[i] ^= std::byte{1};
    ASSERT_TRUE(writeFileAtomically(path, changed, FileDurability::cached).ok());
    EXPECT_EQ(cache_.load("program", "key"), std::nullopt) << "byte " << i;
    const std::span<const std::byte> cut(whole.data(), i);
    ASSERT_TRUE(writeFileAtomically(path, cut, FileDurability::cached).ok());
    EXPECT_EQ(cache_.load("program", "key"), std::nullopt) << "cut after " << i;
  }
  cache_.store("program", "key", value_);
  EXPECT_EQ(cache_.load("program", "key"), value_);
}

TEST_F(DeviceCacheTest, LeavesOneFileForAValue) {
  for (int i = 0; i < 3; ++i) cache_.store("program", "key", value_);
  const fs::path folder = fs::path(cache_.path("program", "key")).parent_path();
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(DeviceCacheTest, KeepsNothingWithoutAFolder) {
  const DeviceCache none("", someDevice());
  EXPECT_FALSE(none.isKept());
  none.store("program", "key", value_);
  EXPECT_EQ(none.load("program", "key"), std::nullopt);
}

TEST_F(DeviceCacheTest, DoesWithoutAFolderThatCannotBeMade) {
  std::ofstream(folder_.path() / "file") << "not a folder";
  const DeviceCache blocked((folder_.path() / "file" / "inside").string(), someDevice());
  blocked.store("program", "key", value_);
  EXPECT_EQ(blocked.load("program", "key"), std::nullopt);
}

}  // namespace
}  // namespace glide::test
