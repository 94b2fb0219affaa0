#include "gpu/driver_quirks.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace glide {
namespace {

constexpr std::string_view kOnTheCpu =
    "rasterises on the CPU, where the library's own vectorised code is faster";
constexpr std::string_view kBuildsLate =
    "makes machine code when a kernel first runs: 2 to 3 s for those of a frame";

constexpr std::array kQuirks{
    // lavapipe under zink and ANGLE has this name, too.
    DriverQuirk{
        "llvmpipe is software", {"", "llvmpipe", ""}, &DriverQuirks::is_software, kOnTheCpu},
    DriverQuirk{
        "lavapipe is software", {"", "lavapipe", ""}, &DriverQuirks::is_software, kOnTheCpu},
    DriverQuirk{
        "softpipe is software", {"", "softpipe", ""}, &DriverQuirks::is_software, kOnTheCpu},
    DriverQuirk{"swrast is software", {"", "swrast", ""}, &DriverQuirks::is_software, kOnTheCpu},
    DriverQuirk{"Mesa's oldest rasteriser is software",
                {"", "software rasterizer", ""},
                &DriverQuirks::is_software,
                kOnTheCpu},
    DriverQuirk{
        "SwiftShader is software", {"", "swiftshader", ""}, &DriverQuirks::is_software, kOnTheCpu},
    DriverQuirk{
        "llvmpipe builds late", {"", "llvmpipe", ""}, &DriverQuirks::has_slow_builds, kBuildsLate},
    DriverQuirk{"SwiftShader builds late",
                {"", "swiftshader", ""},
                &DriverQuirks::has_slow_builds,
                kBuildsLate},
    DriverQuirk{"softpipe interprets",
                {"", "softpipe", ""},
                &DriverQuirks::has_slow_builds,
                "interprets kernels: one frame takes as long as all that may be tried"},
};

bool contains(std::string_view text, std::string_view part) {
  const auto same = [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end() ||
         part.empty();
}

}  // namespace

std::span<const DriverQuirk> knownDriverQuirks() { return kQuirks; }

bool fits(const DriverName& parts, const DriverName& driver) {
  return contains(driver.vendor, parts.vendor) && contains(driver.renderer, parts.renderer) &&
         contains(driver.version, parts.version);
}

DriverQuirks driverQuirks(const DriverName& driver) {
  DriverQuirks quirks;
  for (const DriverQuirk& quirk : kQuirks) {
    if (fits(quirk.parts, driver)) quirks.*quirk.effect = true;
  }
  return quirks;
}

}  // namespace glide
