#include "capi/conversion.h"
#include "capi/handles.h"
#include "capi/sized_struct.h"

#include "glide/glide.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace glide {

SessionTable& sessionTable() {
  static SessionTable& table = *new SessionTable(0);
  return table;
}

namespace {

/// Ends the sessions that are open when the process exits or the library is unloaded: their threads
/// must not outlive what they use. The driver may be gone already: GL objects are forgotten.
struct SessionsEnd {
  SessionsEnd() = default;
  SessionsEnd(const SessionsEnd&) = delete;
  SessionsEnd& operator=(const SessionsEnd&) = delete;
  ~SessionsEnd() {
    guarded([] {
      for (const std::shared_ptr<AppSession>& session : sessionTable().removeIdle())
        session->abandonGl();
      return kDone;
    });
  }
};

glide_status nullArgument(const char* name) {
  return refuseArgument(std::string(name) + " is null, or its struct_size is not set");
}

template <std::size_t n>
void copyText(const std::string& text, char (&target)[n]) {
  const std::size_t length = std::min(text.size(), n - 1);
  std::copy_n(text.begin(), length, target);
  target[length] = '\0';
}

glide_status createSession(const glide_config* given, glide_session** out) {
  if (out == nullptr) return refuseArgument("session, where the handle goes, is null");
  *out = nullptr;
  const std::optional<glide_config> config = readSized(given);
  if (!config) return nullArgument("config");
  Result<std::shared_ptr<AppSession>> session = AppSession::create(*config);
  if (!session) return refuse(session.error());
  static const SessionsEnd sessions_end;  // after all that the session has loaded: ends before it
  *out = sessionTable().add(*std::move(session));
  return kDone;
}

glide_backend_info toC(const BackendInfo& backend) {
  glide_backend_info info{};
  info.backend = backend.backend == Backend::gles ? GLIDE_BACKEND_GLES : GLIDE_BACKEND_CPU;
  copyText(backend.vendor, info.vendor);
  copyText(backend.renderer, info.renderer);
  copyText(backend.version, info.version);
  return info;
}

}  // namespace
}  // namespace glide

using namespace glide;  // NOLINT(google-build-using-namespace): the file is the C side of it

extern "C" {

uint32_t glide_abi_version(void) { return (GLIDE_ABI_MAJOR << 16U) | GLIDE_ABI_MINOR; }

#define GLIDE_TEXT_OF(number) #number
#define GLIDE_TEXT(number) GLIDE_TEXT_OF(number)

const char* glide_version_string(void) {
  return GLIDE_TEXT(GLIDE_VERSION_MAJOR) "." GLIDE_TEXT(GLIDE_VERSION_MINOR) "." GLIDE_TEXT(
      GLIDE_VERSION_PATCH);
}

glide_status glide_session_create(const glide_config* config, glide_session** session) {
  return guarded([&] { return createSession(config, session); });
}

void glide_session_destroy(glide_session* session) {
  guarded([&] {
    sessionTable().remove(session);
    return kDone;
  });
}

glide_status glide_session_pause(glide_session* session) {
  return withSession(session, [](AppSession& app) {
    app.pause();
    return kDone;
  });
}

glide_status glide_session_resume(glide_session* session) {
  return withSession(session, [](AppSession& app) {
    app.resume();
    return kDone;
  });
}

glide_status glide_session_reset(glide_session* session) {
  return withSession(session, [](AppSession& app) {
    app.reset();
    return kDone;
  });
}

glide_status glide_session_wait_for_mapping(glide_session* session) {
  return withSession(session, [](AppSession& app) {
    app.waitForMapping();
    return kDone;
  });
}

glide_status glide_session_update(glide_session* session,
                                  const glide_image* image,
                                  glide_frame* frame) {
  return withSession(session, [&](AppSession& app) {
    const std::optional<glide_image> known = readSized(image);
    if (!known) return nullArgument("image");
    if (!isWritable(frame)) return nullArgument("frame");
    return app.update(*known, frame);
  });
}

glide_status glide_session_release_gl(glide_session* session) {
  return withSession(session, [](AppSession& app) { return app.releaseGl(); });
}

glide_status glide_session_abandon_gl(glide_session* session) {
  return withSession(session, [](AppSession& app) {
    app.abandonGl();
    return kDone;
  });
}

glide_status glide_session_backend(glide_session* session, glide_backend_info* info) {
  return withSession(session, [&](AppSession& app) {
    if (!isWritable(info)) return nullArgument("info");
    writeSized(toC(app.backend()), info);
    return kDone;
  });
}

glide_status glide_session_push_imu(glide_session* session,
                                    const glide_imu_sample* samples,
                                    size_t count) {
  return withSession(session, [&](AppSession& app) {
    if (samples == nullptr && count > 0) return refuseArgument("samples is null");
    return app.pushImu(samples, count);
  });
}

glide_status glide_session_locate(glide_session* session, int64_t t_ns, glide_location* location) {
  return withSession(session, [&](AppSession& app) {
    if (!isWritable(location)) return nullArgument("location");
    writeSized(app.locate(t_ns), location);
    return kDone;
  });
}

}  // extern "C"
