#pragma once

#include "support/app_context.h"

#include "gpu/gl_test.h"

#include <cstdint>
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

/// The library inside of an app's contexts (docs/gl-contract.md). Each test begins with a new
/// context current, app(), and fails when the driver complains about a call in it.
class AppTest : public GlTest {
 protected:
  void SetUp() override;
  void TearDown() override;

  AppContext& app() { return *app_; }
  /// The app's context is destroyed, with all that is in it.
  void destroyApp() { app_.reset(); }
  /// Another context than app(), current afterwards.
  AppContext makeContext(ContextSharing sharing);

  /// No call changes state or objects of an app that has set all state at random.
  void expectNoTrace(const std::vector<PublicCall>& calls, std::uint32_t seed);
  /// What a call needs of the app, once its state is random.
  virtual void prepareCall() {}
  /// An error that the app has not fetched is there after each call, and no other.
  void expectErrorsUntouched(const std::vector<PublicCall>& calls);

 private:
  std::optional<ScopedCurrentContext> main_;
  std::optional<AppContext> app_;
};

}  // namespace glide::test
