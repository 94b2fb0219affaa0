#ifndef GLIDE_GLIDE_H
#define GLIDE_GLIDE_H

/* GLidE-SLAM's C ABI (C99): what C, JNI, Unity, Rust and Python bind to. docs/c-api.md explains it.
 *
 * Scale is arbitrary (monocular) until glide_session_set_metric_scale. World: the first keyframe's
 * camera, turned upright by glide_session_set_gravity, in the axes of glide_config.axes.
 *
 * Threads. Every function may be called from any thread. Those that look wait for no
 * update and no mapping, at most for each other's copy of a map; update, release_gl, abandon_gl,
 * pause, resume, reset and map_load take turns (docs/c-api.md: a table).
 * With the GLES backend update, release_gl and destroy need the app's GL context current, and the
 * thread of the first update owns the GL objects until glide_session_release_gl or _abandon_gl:
 * update elsewhere is GLIDE_ERROR_WRONG_THREAD. update never waits for mapping, but does it itself
 * with GLIDE_EXECUTION_INLINE.
 *
 * Handles that are null or were destroyed give GLIDE_ERROR_SESSION_CLOSED, null results
 * GLIDE_ERROR_INVALID_ARGUMENT. No C++ exception leaves the library.
 *
 * Counted results (two-call idiom): `*count` receives how many there are; at most `capacity` are
 * written. Call with capacity 0 and a null array to ask. GLIDE_TRUNCATED when there are more. */

#include "glide/glide_types.h"

#if defined(_WIN32)
#define GLIDE_C_API
#else
#define GLIDE_C_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* (major << 16) | minor of the ABI that the library has; glide_version_string: of the library. */
GLIDE_C_API uint32_t glide_abi_version(void);
GLIDE_C_API const char* glide_version_string(void);
/* Static text for a status, never null. */
GLIDE_C_API const char* glide_status_string(glide_status status);
/* Why the last call on this thread that failed did so; "" when none has. Valid until the next call
 * on this thread. */
GLIDE_C_API const char* glide_last_error(void);

/* Life. create needs no GL context: GL objects are made by the first update. */
GLIDE_C_API glide_status glide_session_create(const glide_config* config, glide_session** session);
/* Null and stale handles are fine. Waits for the calls that other threads are in, and frees on this
 * one. Without a current context call abandon_gl or release_gl first. */
GLIDE_C_API void glide_session_destroy(glide_session* session);
GLIDE_C_API glide_status glide_session_pause(glide_session* session);
GLIDE_C_API glide_status glide_session_resume(glide_session* session);
/* Drops the map: anchors stay but are no longer tracked, scale and gravity are arbitrary again. */
GLIDE_C_API glide_status glide_session_reset(glide_session* session);

/* Tracks one frame. SESSION_PAUSED while paused; TIMESTAMP_ORDER when t_ns does not increase. Being
 * lost is GLIDE_OK: see frame->state. */
GLIDE_C_API glide_status glide_session_update(glide_session* session,
                                              const glide_image* image,
                                              glide_frame* frame);
/* Frees all GL objects while the context is current / forgets them when it is gone. The next update
 * makes them anew, on any thread, in whatever context is current then; the map stays. */
GLIDE_C_API glide_status glide_session_release_gl(glide_session* session);
GLIDE_C_API glide_status glide_session_abandon_gl(glide_session* session);
GLIDE_C_API glide_status glide_session_backend(glide_session* session, glide_backend_info* info);

/* Keeps samples of the last seconds for later versions; poses do not use them yet. */
GLIDE_C_API glide_status glide_session_push_imu(glide_session* session,
                                                const glide_imu_sample* samples,
                                                size_t count);
/* Where the camera was, or will be up to 100 ms ahead. Never fails for a time: see location->flags.
 */
GLIDE_C_API glide_status glide_session_locate(glide_session* session,
                                              int64_t t_ns,
                                              glide_location* location);

/* Blocks until every keyframe so far is mapped and the loops that this closed are worked in: for
 * files, where the next frame can wait. Not for what other threads hand over meanwhile, which may
 * put off the adjustment of the whole map after a loop. The next update shows what was mapped. */
GLIDE_C_API glide_status glide_session_wait_for_mapping(glide_session* session);

/* World. Metres per present scene unit, relative to what is shown now: a distance that shows as 2
 * and is 1 m: 0.5. NOT_TRACKING unless the last frame was tracked. Poses, points and anchors change
 * at once. */
GLIDE_C_API glide_status glide_session_set_metric_scale(glide_session* session,
                                                        float metres_per_unit);
/* Direction of gravity (down) in the camera's axes at the last frame: the world's y axis (GL) then
 * points up. NOT_TRACKING unless the last frame was tracked. */
GLIDE_C_API glide_status glide_session_set_gravity(glide_session* session, const float down[3]);

/* Display: its rotation against the camera's image (0, 90, 180, 270 degrees) and size in px. */
GLIDE_C_API glide_status glide_session_set_display(glide_session* session,
                                                   int32_t rotation_deg,
                                                   int32_t width,
                                                   int32_t height);
/* Column-major float[16] for OpenGL, whatever the axes of poses. view: world (GL axes) -> display-
 * oriented camera of the last frame; projection fills the display (centre crop of the image). */
GLIDE_C_API glide_status glide_session_view_matrix(glide_session* session, float matrix[16]);
GLIDE_C_API glide_status glide_session_projection_matrix(glide_session* session,
                                                         float near_plane,
                                                         float far_plane,
                                                         float matrix[16]);

/* Landmarks in the last frame's view. */
GLIDE_C_API glide_status glide_session_point_cloud(glide_session* session,
                                                   size_t capacity,
                                                   glide_point* points,
                                                   size_t* count);
/* The landmarks that the last frame was tracked by, at the pixels where it sees them. Empty unless
 * it was tracked with the setting "tracked_points=on" (or "=indirect", by the indirect tracker),
 * and for the frame that starts a map. */
GLIDE_C_API glide_status glide_session_tracked_points(glide_session* session,
                                                      size_t capacity,
                                                      glide_tracked_point* points,
                                                      size_t* count);
/* What the ray through a pixel of the last camera image meets: landmarks near it, and the plane
 * through those; nearest first. Empty (OK) when there is nothing. */
GLIDE_C_API glide_status glide_session_hit_test(
    glide_session* session, const float uv[2], size_t capacity, glide_hit* hits, size_t* count);

/* Anchors keep their place in the scene when the map is corrected, which update tells: between two
 * updates points, hits and anchors are of the map that the last frame was tracked in, and so must
 * be the pose that one is made at. NOT_TRACKING without a map. */
GLIDE_C_API glide_status glide_anchor_create(glide_session* session,
                                             const glide_pose* pose,
                                             uint64_t* anchor);
GLIDE_C_API glide_status glide_anchor_get(glide_session* session,
                                          uint64_t anchor,
                                          glide_anchor* state);
GLIDE_C_API glide_status glide_anchor_destroy(glide_session* session, uint64_t anchor);

/* The complete map at one revision; readable from any thread until released, also after the
 * session. Empty from reset on until there is a new one. */
GLIDE_C_API glide_status glide_map_acquire(glide_session* session, glide_map** map);
/* The same as the last frame was tracked in: what its pose, points, hits and anchors are of, while
 * the newest may be corrected already. Since ABI 1.2. */
GLIDE_C_API glide_status glide_map_acquire_frame(glide_session* session, glide_map** map);
GLIDE_C_API void glide_map_release(glide_map* map);
GLIDE_C_API glide_status glide_map_revision(const glide_map* map, uint64_t* revision);
/* As glide_frame.map_generation: poses of different generations are of different worlds. Since ABI
 * 1.2. */
GLIDE_C_API glide_status glide_map_generation(const glide_map* map, uint64_t* generation);
GLIDE_C_API glide_status glide_map_points(const glide_map* map,
                                          size_t capacity,
                                          glide_point* points,
                                          size_t* count);
GLIDE_C_API glide_status glide_map_keyframes(const glide_map* map,
                                             size_t capacity,
                                             glide_keyframe* keyframes,
                                             size_t* count);

GLIDE_C_API glide_status glide_map_loops(const glide_map* map,
                                         size_t capacity,
                                         glide_loop* loops,
                                         size_t* count);
/* The camera as the map has corrected it; NOT_YET_AVAILABLE while it is as given. Poses are of this
 * camera: draw with it. */
GLIDE_C_API glide_status glide_map_corrected_camera(const glide_map* map, glide_intrinsics* camera);

/* Map files (docs/map-format.md), by path (UTF-8) or by callbacks. Saving does not hold up update.
 * Loading takes the place of the present map, or changes nothing: DATA_INVALID_FORMAT,
 * DATA_UNSUPPORTED_VERSION, IO, INVALID_ARGUMENT (another camera). */
GLIDE_C_API glide_status glide_map_save(glide_session* session, const char* path);
GLIDE_C_API glide_status glide_map_load(glide_session* session, const char* path);
GLIDE_C_API glide_status glide_map_save_io(glide_session* session, const glide_io* io);
GLIDE_C_API glide_status glide_map_load_io(glide_session* session, const glide_io* io);

#ifdef __cplusplus
}
#endif

#endif
