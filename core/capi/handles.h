#pragma once

#include "capi/app_session.h"
#include "capi/handle_table.h"
#include "capi/status.h"

namespace glide {

using SessionTable = HandleTable<AppSession, glide_session>;
using MapTable = HandleTable<const AppSession::AppMap, glide_map>;

/// The handles of this process. The one mutable state that belongs to nobody: a C handle must be
/// recognised as stale without following it. Never destroyed: threads may call while the process
/// exits.
SessionTable& sessionTable();
MapTable& mapTable();

/// Runs function(AppSession&) on the session of a handle, or says that there is none.
template <class Function>
glide_status withSession(const glide_session* handle, Function&& function) noexcept {
  return guarded([&]() -> glide_status {
    const SessionTable::Use session = sessionTable().find(handle);
    if (!session) return refuse(GLIDE_ERROR_SESSION_CLOSED, "the session is null or was destroyed");
    return function(*session);
  });
}

}  // namespace glide
