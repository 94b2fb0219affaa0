#include "base/worker.h"

#if defined(__linux__)
#include <pthread.h>
#endif

namespace glide {

void Worker::nameThread(const std::string& name) {
#if defined(__linux__)
  constexpr std::size_t kMaxName = 15;  // the kernel's limit without the terminating zero
  pthread_setname_np(pthread_self(), name.substr(0, kMaxName).c_str());
#else
  (void)name;
#endif
}

}  // namespace glide
