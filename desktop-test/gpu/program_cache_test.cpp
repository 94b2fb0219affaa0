#include "gpu/program_cache.h"

#include "support/temporary_folder.h"

#include "gpu/compute_program.h"
#include "gpu/gl_test.h"

#include "base/file_io.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

namespace glide::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShader = "luma_to_float.comp";
const ShaderDefines kDefines{{"GROUP_ROWS", 2}};

class ProgramCacheTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    if (caps().program_binary_formats.empty()) {
      GTEST_SKIP() << caps().renderer << " has no program binary format";
    }
    text_ = assembleShader(embeddedShaders(), kShader, kDefines).value();
  }

  DeviceCache files() const { return {folder_.path().string(), caps()}; }
  ProgramCache cache() const { return {files(), caps()}; }
  std::vector<std::byte> stored() const { return files().load("program", text_).value(); }
  void build() const {
    const Result<ComputeProgram> made = ComputeProgram::create(kShader, kDefines, cache());
    ASSERT_TRUE(made.ok()) << made.error().message;
  }

  const TemporaryFolder folder_;
  std::string text_;
};

/// Runs the program on four pixels.
ImageF convertedPixels(const GlProgram& program) {
  const std::array<std::uint8_t, 4> grey{1, 20, 255, 0};
  const GlTexture bytes = GlTexture::allocate(GL_R8UI, 4, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 1, GL_RED_INTEGER, GL_UNSIGNED_BYTE, grey.data());
  const GlTexture floats = GlTexture::allocate(GL_R32F, 4, 1);
  glBindTexture(GL_TEXTURE_2D, bytes.get());
  glBindImageTexture(0, floats.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  glUseProgram(program.get());
  glDispatchCompute(1, 1, 1);
  return readTexture(floats);
}

TEST_F(ProgramCacheTest, GivesBackAProgramThatDoesTheSame) {
  EXPECT_FALSE(cache().load(text_).has_value());
  build();
  const std::optional<GlProgram> kept = cache().load(text_);
  ASSERT_TRUE(kept.has_value());
  const ImageF pixels = convertedPixels(*kept);
  EXPECT_EQ(pixels.at(1, 0), 20.0F);
  EXPECT_EQ(pixels.at(2, 0), 255.0F);
}

TEST_F(ProgramCacheTest, TellsDefinesApart) {
  build();
  const ShaderDefines others{{"GROUP_ROWS", 1}};
  const std::string other = assembleShader(embeddedShaders(), kShader, others).value();
  EXPECT_FALSE(cache().load(other).has_value());
}

TEST_F(ProgramCacheTest, BuildsAnewWhatTheDriverRefusesWithoutAnError) {
  build();
  const std::vector<std::byte> whole = stored();
  // The file is sound, what the driver once wrote into it is not.
  std::vector<std::byte> damaged = whole;
  for (std::size_t i = sizeof(GLenum); i < damaged.size(); ++i) damaged[i] = std::byte{0x5a};
  files().store("program", text_, damaged);
  EXPECT_FALSE(cache().load(text_).has_value());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  build();
  EXPECT_NE(stored(), damaged);
  EXPECT_TRUE(cache().load(text_).has_value());
  forgetDriverMessages();  // a refusal may be reported there
}

TEST_F(ProgramCacheTest, DoesNotShowTheDriverAFormatThatItDoesNotKnow) {
  build();
  std::vector<std::byte> foreign = stored();
  foreign[0] ^= std::byte{0xff};
  files().store("program", text_, foreign);
  EXPECT_FALSE(cache().load(text_).has_value());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  files().store("program", text_, std::span<const std::byte>(foreign).first(2));
  EXPECT_FALSE(cache().load(text_).has_value());
}

TEST_F(ProgramCacheTest, ReadsEachProgramOnceAndWritesItOnce) {
  build();
  const std::string path = files().path("program", text_);
  const auto written = fs::last_write_time(path);
  build();
  EXPECT_EQ(fs::last_write_time(path), written);
}

TEST_F(ProgramCacheTest, LeavesTheErrorsOfTheAppAlone) {
  glEnable(0);  // GL_INVALID_ENUM, as an app may leave it
  build();
  build();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  forgetDriverMessages();
}

TEST_F(ProgramCacheTest, KeepsNothingWhereTheDriverHasNoFormat) {
  GlCaps without = caps();
  without.program_binary_formats.clear();
  const ProgramCache none(files(), without);
  EXPECT_FALSE(none.isKept());
  ASSERT_TRUE(ComputeProgram::create(kShader, kDefines, none).ok());
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

}  // namespace
}  // namespace glide::test
