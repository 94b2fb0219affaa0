#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace glide {

/// Why a call could not do what it was asked. "Lost" is never an error: it is a TrackingState.
enum class ErrorCode {
  invalid_argument,  ///< A config field or an input is out of its range; the message names it.
  unsupported,       ///< The device or the build lacks what was asked for (for instance no ES 3.1).
  out_of_order,      ///< A timestamp does not increase.
  missing_context,   ///< No OpenGL ES 3.1 context is current on this thread.
  io,                ///< A file could not be read or written; the message names it.
  invalid_data,      ///< The bytes are no sound map; the message says what is wrong with them.
  unknown_version,   ///< A map of another version of the format.
  gl,                ///< A GL call failed; the message names it.
  no_map,            ///< There is no map yet that this could be done with.
  internal,          ///< A dependency failed unexpectedly (for instance out of memory).
};

/// An error with a message for people: it names the thing that is wrong.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
};

/// A value or an Error. Test with ok() (or bool) before reading either; no exception is thrown.
template <class T>
class Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  const T& value() const& {
    assert(ok());
    return *std::get_if<0>(&state_);
  }
  T&& value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&state_));
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const {
    assert(!ok());
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

/// The value type of a Result that carries no value.
struct Unit {};
using Status = Result<Unit>;

}  // namespace glide
