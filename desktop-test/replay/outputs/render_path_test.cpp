#include "replay/outputs/render_path.h"

#include "replay/readers/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

TEST(RenderPath, IsAVideoOrAFolder) {
  for (const char* name : {"out/x.mp4", "X.MKV", "x.avi"}) {
    EXPECT_TRUE(isVideoName(name));
    EXPECT_FALSE(problemOfRenderPath(name)) << name;
  }
  for (const char* name : {"frames", "out/frames/", "v1.2/frames"}) {
    EXPECT_FALSE(isVideoName(name));
    EXPECT_FALSE(problemOfRenderPath(name)) << name;
  }
}

TEST(RenderPath, SaysWhichExtensionItDoesNotKnow) {
  const auto problem = problemOfRenderPath("out/x.gif");
  ASSERT_TRUE(problem);
  EXPECT_THAT(*problem, testing::HasSubstr("out/x.gif: unknown extension .gif"));
}

TEST(RenderPath, MayBeAFolderWithADotThatIsThere) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "frames.of.today";
  EXPECT_TRUE(problemOfRenderPath(path));
  std::filesystem::create_directories(path);
  EXPECT_FALSE(problemOfRenderPath(path));
}

TEST(RenderPath, LeavesTheSourceAlone) {
  const ScratchFolder scratch;
  const std::filesystem::path images = scratch.path() / "images";
  std::filesystem::create_directories(images);
  std::filesystem::create_directory_symlink(images, scratch.path() / "link");
  for (const auto& target :
       {images, images / "", images / "sub" / "new", scratch.path() / "link", scratch.path()}) {
    EXPECT_TRUE(dangerToSource(target, images)) << target;
  }
  for (const char* target : {"images2", "frames", "images/../pictures", "images/walk.mp4"}) {
    EXPECT_FALSE(dangerToSource(scratch.path() / target, images)) << target;
  }
}

TEST(RenderPath, LeavesAVideoAlone) {
  const ScratchFolder scratch;
  const std::filesystem::path walk = scratch.path() / "walk.mp4";
  EXPECT_TRUE(dangerToSource(walk, walk));
  EXPECT_TRUE(dangerToSource(scratch.path() / "x" / ".." / "walk.mp4", walk));
  EXPECT_TRUE(dangerToSource(walk, scratch.path() / "walk.partial.mp4"));  // where it would grow
  EXPECT_FALSE(dangerToSource(scratch.path() / "walk_map.mp4", walk));
  EXPECT_FALSE(dangerToSource(scratch.path() / "walk" / "walk.mp4", walk));
}

}  // namespace
}  // namespace glide::replay
