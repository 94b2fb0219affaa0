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

}  // namespace
}  // namespace glide::replay
