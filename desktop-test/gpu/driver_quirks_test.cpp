#include "gpu/driver_quirks.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace glide::test {
namespace {

DriverQuirks quirksOf(std::string_view renderer) { return driverQuirks({"", renderer, ""}); }

TEST(DriverQuirks, KnowRasterisersThatRunOnTheCpu) {
  EXPECT_TRUE(quirksOf("llvmpipe (LLVM 15.0.6, 256 bits)").is_software);
  EXPECT_TRUE(quirksOf("softpipe").is_software);
  EXPECT_TRUE(
      quirksOf("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device), SwiftShader)").is_software);
  EXPECT_TRUE(quirksOf("zink (llvmpipe (LLVM 15.0.6, 256 bits))").is_software);
  EXPECT_FALSE(quirksOf("Mali-G52").is_software);
  EXPECT_FALSE(quirksOf("Adreno (TM) 630").is_software);
}

TEST(DriverQuirks, KnowWhereTryingTakesTooLong) {
  EXPECT_TRUE(quirksOf("llvmpipe (LLVM 15.0.6, 256 bits)").has_slow_builds);
  EXPECT_TRUE(
      quirksOf("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device), SwiftShader)").has_slow_builds);
  EXPECT_FALSE(quirksOf("Mali-G52").has_slow_builds);
}

TEST(DriverQuirks, FitByPartsOfAllThreeStringsInAnyCase) {
  const DriverName driver{"ARM", "Mali-T860", "OpenGL ES 3.2 v1.r14p0"};
  EXPECT_TRUE(fits({"", "", ""}, driver));
  EXPECT_TRUE(fits({"arm", "mali-t", "R14P0"}, driver));
  EXPECT_FALSE(fits({"Qualcomm", "mali-t", ""}, driver));
  EXPECT_FALSE(fits({"ARM", "mali-g", ""}, driver));
  EXPECT_FALSE(fits({"ARM", "mali-t", "r26"}, driver));
  EXPECT_FALSE(fits({"", "mali-t860 and more", ""}, driver));
}

TEST(DriverQuirks, AreNamedAndExplained) {
  std::set<std::string_view> names;
  for (const DriverQuirk& quirk : knownDriverQuirks()) {
    EXPECT_TRUE(names.insert(quirk.name).second) << quirk.name;
    EXPECT_FALSE(quirk.reason.empty()) << quirk.name;
    EXPECT_FALSE(quirk.parts.vendor.empty() && quirk.parts.renderer.empty() &&
                 quirk.parts.version.empty())
        << quirk.name << " would fit every driver";
  }
}

}  // namespace
}  // namespace glide::test
