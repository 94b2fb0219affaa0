#include "base/work_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>
#include <vector>

namespace glide {
namespace {

TEST(WorkQueue, HandsItemsOutInOrder) {
  WorkQueue<int> queue(3);
  for (int i : {1, 2, 3}) ASSERT_TRUE(queue.tryPush(i));
  EXPECT_EQ(queue.size(), 3U);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.size(), 0U);
}

TEST(WorkQueue, LeavesTheItemUntouchedWhenFull) {
  WorkQueue<std::unique_ptr<int>> queue(1);
  auto first = std::make_unique<int>(1);
  auto second = std::make_unique<int>(2);
  EXPECT_TRUE(queue.tryPush(first));
  EXPECT_EQ(first, nullptr);
  EXPECT_FALSE(queue.tryPush(second));
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(*second, 2);
}

TEST(WorkQueue, TakesItemsAgainOnceOneIsPopped) {
  WorkQueue<int> queue(1);
  int item = 1;
  ASSERT_TRUE(queue.tryPush(item));
  queue.pop();
  EXPECT_TRUE(queue.tryPush(item));
}

TEST(WorkQueue, AClosedQueueRefusesAndDropsWhatWaits) {
  WorkQueue<int> queue(4);
  int item = 1;
  ASSERT_TRUE(queue.tryPush(item));
  queue.close();
  EXPECT_EQ(queue.size(), 0U);
  EXPECT_FALSE(queue.tryPush(item));
  EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(WorkQueue, CloseWakesAWaitingConsumer) {
  WorkQueue<int> queue(1);
  std::optional<int> popped = 7;
  std::thread consumer([&] { popped = queue.pop(); });
  queue.close();
  consumer.join();
  EXPECT_EQ(popped, std::nullopt);
}

TEST(WorkQueue, CloseWakesWhoWaitsForIdle) {
  WorkQueue<int> queue(1);
  int item = 1;
  ASSERT_TRUE(queue.tryPush(item));
  std::thread waiter([&] { queue.waitIdle(); });
  queue.close();
  waiter.join();
}

TEST(WorkQueue, PushWaitsForRoom) {
  WorkQueue<int> queue(1);
  int first = 1, second = 2;
  ASSERT_TRUE(queue.push(first));
  std::thread producer([&] { EXPECT_TRUE(queue.push(second)); });
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_EQ(queue.pop(), 2);
  producer.join();
}

TEST(WorkQueue, CloseWakesWhoWaitsForRoom) {
  WorkQueue<int> queue(1);
  int first = 1, second = 2;
  ASSERT_TRUE(queue.push(first));
  std::thread producer([&] { EXPECT_FALSE(queue.push(second)); });
  queue.close();
  producer.join();
  EXPECT_EQ(second, 2);
}

TEST(WorkQueue, IsIdleWhenNothingWasPushed) {
  WorkQueue<int> queue(1);
  queue.waitIdle();
  EXPECT_EQ(queue.size(), 0U);
}

TEST(WorkQueue, WaitIdleWaitsForTheItemBeingWorkedOn) {
  WorkQueue<int> queue(8);
  int sum = 0;  // written by the consumer before done(), read after waitIdle()
  std::thread consumer([&] {
    while (const std::optional<int> item = queue.pop()) {
      sum += *item;
      queue.done();
    }
  });
  for (int i = 1; i <= 5; ++i) ASSERT_TRUE(queue.tryPush(i));
  queue.waitIdle();
  EXPECT_EQ(sum, 15);
  queue.close();
  consumer.join();
}

TEST(WorkQueue, WaitIdleDoesNotWaitForWhatIsPushedMeanwhile) {
  WorkQueue<int> queue(8);
  std::atomic<bool> is_over{false};
  std::thread consumer([&] {
    while (std::optional<int> item = queue.pop()) {
      if (!is_over) queue.pushAnyway(*item);  // before done(): there is always one
      queue.done();
    }
  });
  int item = 1;
  ASSERT_TRUE(queue.tryPush(item));
  queue.waitIdle();
  is_over = true;
  queue.close();
  consumer.join();
}

TEST(WorkQueue, LosesNothingBetweenSeveralProducersAndAConsumer) {
  constexpr int kProducers = 3;
  constexpr int kItems = 500;
  WorkQueue<int> queue(4);
  std::vector<int> received;
  std::thread consumer([&] {
    while (received.size() < kProducers * kItems) {
      received.push_back(*queue.pop());
      queue.done();
    }
  });
  std::vector<std::thread> producers;
  for (int p = 0; p < kProducers; ++p) {
    producers.emplace_back([&] {
      for (int i = 0; i < kItems;) {
        int item = i;
        if (queue.tryPush(item)) {
          ++i;
        } else {
          std::this_thread::yield();
        }
      }
    });
  }
  for (std::thread& producer : producers) producer.join();
  consumer.join();
  const int sum = std::accumulate(received.begin(), received.end(), 0);
  EXPECT_EQ(sum, kProducers * kItems * (kItems - 1) / 2);
}

}  // namespace
}  // namespace glide
