#include "base/published.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace glide {
namespace {

TEST(Published, GivesTheInitialValueAndThenTheNewest) {
  Published<int> published(std::make_shared<const int>(1));
  EXPECT_EQ(*published.load(), 1);
  published.store(std::make_shared<const int>(2));
  published.store(std::make_shared<const int>(3));
  EXPECT_EQ(*published.load(), 3);
}

TEST(Published, MayHoldNothing) {
  Published<int> published(nullptr);
  EXPECT_EQ(published.load(), nullptr);
}

TEST(Published, AReaderKeepsItsValueAliveAndUnchanged) {
  Published<int> published(std::make_shared<const int>(1));
  const std::shared_ptr<const int> held = published.load();
  published.store(std::make_shared<const int>(2));
  EXPECT_EQ(*held, 1);
}

TEST(Published, DropsTheOldValueWhenNobodyHoldsIt) {
  auto first = std::make_shared<const int>(1);
  const std::weak_ptr<const int> watch = first;
  Published<int> published(std::move(first));
  published.store(std::make_shared<const int>(2));
  EXPECT_TRUE(watch.expired());
}

TEST(Published, TheOldValueMayReadItsSuccessorWhileItDies) {
  struct Node {
    Published<Node>* owner = nullptr;
    std::atomic<bool>* read = nullptr;
    ~Node() {
      if (owner) *read = owner->load() != nullptr;  // deadlocks if it dies under the lock
    }
  };
  std::atomic<bool> read = false;
  Published<Node> published(nullptr);
  published.store(std::make_shared<const Node>(Node{&published, &read}));
  published.store(std::make_shared<const Node>());
  EXPECT_TRUE(read);
}

TEST(Published, ReadersSeeWholeValuesInOrderWhileAWriterStores) {
  struct Pair {
    int a = 0, b = 0;
  };
  constexpr int kStores = 2000;
  Published<Pair> published(std::make_shared<const Pair>());
  std::atomic<int> torn = 0;
  std::vector<std::thread> readers;
  for (int i = 0; i < 2; ++i) {
    readers.emplace_back([&] {
      for (int last = 0; last < kStores;) {
        const std::shared_ptr<const Pair> value = published.load();
        if (value->a != value->b || value->a < last) ++torn;
        last = value->a;
      }
    });
  }
  for (int i = 1; i <= kStores; ++i) published.store(std::make_shared<const Pair>(Pair{i, i}));
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(torn, 0);
}

}  // namespace
}  // namespace glide
