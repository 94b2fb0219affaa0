#include "base/worker.h"

#include "base/work_queue.h"

#include <gtest/gtest.h>

#if defined(__linux__)
#include <array>
#include <pthread.h>
#endif
#include <optional>
#include <string>
#include <thread>

namespace glide {
namespace {

TEST(Worker, RunsItsLoopAndIsJoinedOnDestruction) {
  WorkQueue<int> queue(4);
  int sum = 0;
  {
    const Worker worker("adder", [&] {
      while (const std::optional<int> item = queue.pop()) {
        sum += *item;
        queue.done();
      }
    });
    for (int i : {1, 2, 3}) EXPECT_TRUE(queue.tryPush(i));
    queue.waitIdle();
    queue.close();
  }
  EXPECT_EQ(sum, 6);
}

#if defined(__linux__)
TEST(Worker, NamesItsThreadWithinTheKernelsLimit) {
  std::string name;
  {
    const Worker worker("a name that is too long", [&] {
      std::array<char, 32> buffer{};
      pthread_getname_np(pthread_self(), buffer.data(), buffer.size());
      name = buffer.data();
    });
  }
  EXPECT_EQ(name, "a name that is ");
}
#endif

}  // namespace
}  // namespace glide
