#pragma once

#include "support/app_context.h"
#include "support/gl_app.h"

#include "gpu/gl_test.h"

#include "glide/render_target.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glide::test {

/// A call of the public API, and what it is called in messages.
struct PublicCall {
  std::string name;
  std::function<void()> run;
};

/// Renderers inside of an app's contexts (docs/gl-contract.md). Each test begins in a new context
/// with a render target bound, and fails when the driver complains about a call in it.
class ContractTest : public GlTest {
 protected:
  static constexpr int kWidth = 64, kHeight = 48;
  static constexpr Viewport kViewport{0, 0, kWidth, kHeight};
  static constexpr Color kBlack{0.0F, 0.0F, 0.0F, 1.0F};

  void SetUp() override;
  void TearDown() override;

  AppContext& app() { return *app_; }
  /// What is drawn into; in a new context, after begin().
  RenderTarget& target() { return *target_; }
  /// Another context than app(), current afterwards.
  AppContext makeContext(ContextSharing sharing);
  void destroyApp() { app_.reset(); }

  /// Runs each call in a random state of the app, and compares all of it with what is afterwards.
  void expectNoTrace(const std::vector<PublicCall>& calls);
  /// Runs each call while an error is pending.
  void expectErrorsUntouched(const std::vector<PublicCall>& calls);

 private:
  std::optional<ScopedCurrentContext> main_;
  std::optional<AppContext> app_;
  std::optional<RenderTarget> target_;
};

}  // namespace glide::test
