#include "render/contract_fixture.h"

#include <utility>

namespace glide::test {

void ContractTest::SetUp() {
  AppTest::SetUp();
  if (IsSkipped() || HasFatalFailure()) return;
  Result<RenderTarget> target = RenderTarget::create(kWidth, kHeight);
  ASSERT_TRUE(target.ok()) << target.error().message;
  target_.emplace(std::move(*target));
  ASSERT_TRUE(target_->begin(kBlack).ok());
}

void ContractTest::TearDown() {
  target_.reset();
  AppTest::TearDown();
}

void ContractTest::prepareCall() { ASSERT_TRUE(target().begin(kBlack).ok()); }

}  // namespace glide::test
