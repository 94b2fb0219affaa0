// Replaces operator new of this test program by one that counts.
#include "unit/photometric/align_fixture.h"

#include "photometric/cpu_aligner.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocation_count{0};

void* countedAllocation(std::size_t size, std::size_t alignment) {
  ++allocation_count;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  void* block = std::aligned_alloc(alignment, rounded > 0 ? rounded : alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

}  // namespace

void* operator new(std::size_t size) { return countedAllocation(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return countedAllocation(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }

namespace glide {
namespace {

TEST(CpuAligner, AllocatesNothingPerFrameAfterWarmUp) {
  const test::AlignScenario scenario = test::smallScenario();
  const ImageU8 frame = scenario.frameImage();
  const std::vector<AlignPoint> points = scenario.alignPoints();
  const std::unique_ptr<CpuAligner> aligner = scenario.alignerWithReference();
  aligner->loadFrame(frame.view());
  EXPECT_TRUE(aligner->align(scenario.perturbedGuess()).valid);

  const long before = allocation_count;
  aligner->loadFrame(frame.view());
  const AlignResult tracked = aligner->align(scenario.perturbedGuess());
  aligner->promoteReference(points);
  const AlignResult promoted = aligner->align(SE3d{});
  EXPECT_EQ(allocation_count - before, 0);
  EXPECT_TRUE(tracked.valid && promoted.valid);
}

TEST(CpuAligner, AllocatesItsWorkArraysWhenItIsMade) {
  const test::AlignScenario scenario = test::smallScenario();
  const long before = allocation_count;
  const auto aligner = CpuAligner::create(scenario.config, scenario.camera);
  EXPECT_GT(allocation_count - before, 0);  // so the counter above counts
}

}  // namespace
}  // namespace glide
