#pragma once

#include <string>
#include <thread>
#include <utility>

namespace glide {

/// A named thread that runs one loop until its queue is closed, and is joined on destruction.
/// Whoever owns it closes the queue first.
class Worker {
 public:
  template <class Loop>
  Worker(const std::string& name, Loop loop)
      : thread_([name, body = std::move(loop)]() mutable {
          nameThread(name);
          body();
        }) {}
  ~Worker() {
    if (thread_.joinable()) thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

 private:
  static void nameThread(const std::string& name);

  std::thread thread_;
};

}  // namespace glide
