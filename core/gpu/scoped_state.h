#pragma once

#include "glide/config.h"

namespace glide {

/// Saves one group of the app's GL state, makes it neutral, and leaves it on destruction as the
/// policy says. A template because the groups (GlComputeState, GlDrawState) differ in their fields
/// only. A State has
///   static State current();          what the context has
///   static State initial();          what a new context has
///   void apply() const;              gives it to the context
///   static void neutralize();        what our kernels expect and do not set themselves
template <class State>
class ScopedState {
 public:
  explicit ScopedState(GlStatePolicy policy)
      : policy_(policy),
        left_(policy == GlStatePolicy::preserve ? State::current() : State::initial()) {
    State::neutralize();
  }
  ~ScopedState() {
    if (policy_ != GlStatePolicy::none) left_.apply();
  }
  ScopedState(const ScopedState&) = delete;
  ScopedState& operator=(const ScopedState&) = delete;

 private:
  GlStatePolicy policy_;
  State left_;  ///< what the app finds afterwards
};

}  // namespace glide
