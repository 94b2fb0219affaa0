#pragma once

#include <span>
#include <string_view>

namespace glide {

/// What we do differently on some drivers. docs/gpu-tuning.md has the table.
struct DriverQuirks {
  /// The device is the CPU: Backend::automatic takes the vectorised CPU code instead.
  bool is_software = false;
  /// Building a program, or running it for the first time, takes longer than all that the autotuner
  /// may spend: nothing is tried.
  bool has_slow_builds = false;
};

/// GL_VENDOR, GL_RENDERER and GL_VERSION, or parts of them.
struct DriverName {
  std::string_view vendor, renderer, version;
};

/// One row of the table.
struct DriverQuirk {
  std::string_view name;
  DriverName parts;  ///< of the driver's strings, in any case; an empty one fits every driver
  bool DriverQuirks::*effect;
  std::string_view reason;
};

/// Every driver that we know to need something else.
std::span<const DriverQuirk> knownDriverQuirks();

/// Whether each part is in the string of its driver.
bool fits(const DriverName& parts, const DriverName& driver);

/// The effects of all rows that fit.
DriverQuirks driverQuirks(const DriverName& driver);

}  // namespace glide
