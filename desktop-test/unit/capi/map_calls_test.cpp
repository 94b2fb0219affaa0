#include "unit/capi/c_walk_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <vector>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr int kFrames = 30;

/// Bytes behind the callbacks of a glide_io.
struct Memory {
  std::vector<unsigned char> bytes;
  std::size_t at = 0;
  std::size_t room = SIZE_MAX;

  glide_io io() {
    glide_io io = sized<glide_io>();
    io.user = this;
    io.read = [](void* user, void* data, std::size_t size) {
      auto* memory = static_cast<Memory*>(user);
      const std::size_t got = std::min(size, memory->bytes.size() - memory->at);
      std::memcpy(data, memory->bytes.data() + memory->at, got);
      memory->at += got;
      return got;
    };
    io.write = [](void* user, const void* data, std::size_t size) {
      auto* memory = static_cast<Memory*>(user);
      const std::size_t taken = std::min(size, memory->room);
      const auto* from = static_cast<const unsigned char*>(data);
      memory->bytes.insert(memory->bytes.end(), from, from + taken);
      return taken;
    };
    return io;
  }
};

class CMap : public ::testing::Test {
 protected:
  CMap() { walk_.walk(kFrames); }
  CWalk walk_{GLIDE_AXES_GL};
};

TEST_F(CMap, OutlivesItsSession) {
  glide_map* map = nullptr;
  {
    CWalk other(GLIDE_AXES_GL);
    other.walk(kFrames);
    ASSERT_EQ(glide_map_acquire(other.session(), &map), GLIDE_OK);
  }
  std::size_t points = 0;
  std::size_t keyframes = 0;
  EXPECT_EQ(glide_map_points(map, 0, nullptr, &points), GLIDE_TRUNCATED);
  EXPECT_EQ(glide_map_keyframes(map, 0, nullptr, &keyframes), GLIDE_TRUNCATED);
  EXPECT_GT(points, 40U);
  ASSERT_GE(keyframes, 2U);
  std::vector<glide_keyframe> all(keyframes);
  ASSERT_EQ(glide_map_keyframes(map, keyframes, all.data(), &keyframes), GLIDE_OK);
  EXPECT_LT(all[0].t_ns, all[1].t_ns);
  std::size_t loops = 9;
  EXPECT_EQ(glide_map_loops(map, 0, nullptr, &loops), GLIDE_OK);
  EXPECT_EQ(loops, 0U);
  glide_intrinsics camera{};
  EXPECT_EQ(glide_map_corrected_camera(map, &camera), GLIDE_ERROR_NOT_YET_AVAILABLE);
  std::uint64_t revision = 0;
  EXPECT_EQ(glide_map_revision(map, &revision), GLIDE_OK);
  EXPECT_GT(revision, 0U);
  glide_map_release(map);
  EXPECT_EQ(glide_map_revision(map, &revision), GLIDE_ERROR_SESSION_CLOSED);
}

TEST_F(CMap, GoesThroughCallbacksIntoANewSession) {
  Memory memory;
  glide_io io = memory.io();
  ASSERT_EQ(glide_map_save_io(walk_.session(), &io), GLIDE_OK) << glide_last_error();
  CWalk other(GLIDE_AXES_GL);
  ASSERT_EQ(glide_map_load_io(other.session(), &io), GLIDE_OK) << glide_last_error();
  EXPECT_EQ(other.feed(0.15).state, GLIDE_STATE_TRACKING);
}

TEST_F(CMap, TellsBrokenBytesFromOtherVersionsAndUnreadableFiles) {
  Memory memory;
  glide_io io = memory.io();
  ASSERT_EQ(glide_map_save_io(walk_.session(), &io), GLIDE_OK);
  memory.bytes[memory.bytes.size() / 2] ^= 0x40U;
  EXPECT_EQ(glide_map_load_io(walk_.session(), &io), GLIDE_ERROR_DATA_INVALID_FORMAT);
  memory.at = 0;
  memory.bytes[8] = 77;  // the version follows eight bytes of magic
  EXPECT_EQ(glide_map_load_io(walk_.session(), &io), GLIDE_ERROR_DATA_UNSUPPORTED_VERSION);
  EXPECT_EQ(glide_map_load(walk_.session(), "/nonexistent/file.map"), GLIDE_ERROR_IO);
  EXPECT_THAT(glide_last_error(), HasSubstr("/nonexistent/file.map"));
  EXPECT_EQ(walk_.feed(0.29).state, GLIDE_STATE_TRACKING);  // nothing was lost
}

TEST_F(CMap, SaysWhenItCouldNotBeWritten) {
  Memory memory;
  memory.room = 10;
  glide_io io = memory.io();
  EXPECT_EQ(glide_map_save_io(walk_.session(), &io), GLIDE_ERROR_IO);
  EXPECT_THAT(glide_last_error(), HasSubstr("took 10 of"));
  EXPECT_EQ(glide_map_save(walk_.session(), "/nonexistent/file.map"), GLIDE_ERROR_IO);
}

TEST_F(CMap, OverwritesNoFileWithoutAMap) {
  const auto path = std::filesystem::path(testing::TempDir()) / "glide_c_no_map_test.map";
  ASSERT_EQ(glide_map_save(walk_.session(), path.c_str()), GLIDE_OK);
  const auto size = std::filesystem::file_size(path);
  ASSERT_EQ(glide_session_reset(walk_.session()), GLIDE_OK);
  EXPECT_EQ(glide_map_save(walk_.session(), path.c_str()), GLIDE_ERROR_NOT_TRACKING);
  EXPECT_THAT(glide_last_error(), HasSubstr("no map to save"));
  EXPECT_EQ(std::filesystem::file_size(path), size);
}

TEST_F(CMap, SavesAndLoadsFiles) {
  const auto path = std::filesystem::path(testing::TempDir()) / "glide_c_map_test.map";
  ASSERT_EQ(glide_map_save(walk_.session(), path.c_str()), GLIDE_OK);
  EXPECT_EQ(glide_map_load(walk_.session(), path.c_str()), GLIDE_OK);
  std::filesystem::remove(path);
  EXPECT_EQ(walk_.feed(0.2).state, GLIDE_STATE_TRACKING);
}

}  // namespace
}  // namespace glide::test
