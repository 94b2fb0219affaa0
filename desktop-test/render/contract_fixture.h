#pragma once

#include "gpu/app_fixture.h"

#include "glide/render_target.h"

#include <cstdint>
#include <optional>

namespace glide::test {

/// Renderers inside of an app's contexts: each test begins with a render target bound, too.
class ContractTest : public AppTest {
 protected:
  static constexpr int kWidth = 64, kHeight = 48;
  static constexpr Viewport kViewport{0, 0, kWidth, kHeight};
  static constexpr std::uint32_t kStateSeed = 41;
  static constexpr Color kBlack{0.0F, 0.0F, 0.0F, 1.0F};

  void SetUp() override;
  void TearDown() override;

  /// What is drawn into; in a new context, after begin().
  RenderTarget& target() { return *target_; }
  void prepareCall() override;

 private:
  std::optional<RenderTarget> target_;
};

}  // namespace glide::test
