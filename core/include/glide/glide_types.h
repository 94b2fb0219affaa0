#ifndef GLIDE_GLIDE_TYPES_H
#define GLIDE_GLIDE_TYPES_H

/* Plain-C types of glide.h. Structs that may grow begin with struct_size: set it to sizeof the
 * struct (GLIDE_INIT does), zero the rest; a library that is older or newer than the app's header
 * reads and writes only what both know. */

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Version of this ABI. Another major number is another ABI; a higher minor number only adds. */
#define GLIDE_ABI_MAJOR 1
#define GLIDE_ABI_MINOR 2

/* Zeroes a size-tagged struct and tells its size: glide_config config; GLIDE_INIT(config); */
#define GLIDE_INIT(object) \
  (memset(&(object), 0, sizeof(object)), (void)((object).struct_size = (uint32_t)sizeof(object)))

/* 0: done. Negative: not done, nothing has changed (after FATAL the frame counts as seen),
 * glide_last_error() says why. Positive: done, with something to know. Numbers that ARCore has mean
 * here what they mean there. */
typedef int32_t glide_status;
enum {
  GLIDE_OK = 0,
  GLIDE_TRUNCATED = 1, /* *count is larger than the capacity that was given */

  GLIDE_ERROR_INVALID_ARGUMENT = -1,
  GLIDE_ERROR_FATAL = -2, /* a dependency failed, for instance out of memory */
  GLIDE_ERROR_SESSION_PAUSED = -3,
  GLIDE_ERROR_NOT_TRACKING = -5,
  GLIDE_ERROR_MISSING_GL_CONTEXT = -7,
  GLIDE_ERROR_UNSUPPORTED_CONFIGURATION = -8,
  GLIDE_ERROR_RESOURCE_EXHAUSTED = -11,
  GLIDE_ERROR_NOT_YET_AVAILABLE = -12,
  GLIDE_ERROR_DATA_INVALID_FORMAT = -18,
  GLIDE_ERROR_DATA_UNSUPPORTED_VERSION = -19,
  GLIDE_ERROR_SESSION_CLOSED = -100, /* null, destroyed or never a handle of this kind */
  GLIDE_ERROR_WRONG_THREAD = -101,   /* another thread owns the session's GL objects */
  GLIDE_ERROR_TIMESTAMP_ORDER = -102,
  GLIDE_ERROR_IO = -103, /* a file or a callback failed */
  GLIDE_ERROR_GL = -104
};

/* Handles. Never dereferenced by the app; a stale one is recognised, not followed. */
typedef struct glide_session glide_session;
typedef struct glide_map glide_map; /* a map at one revision, immutable */

/* Axes of poses and points that the app sees. */
enum {
  GLIDE_AXES_GL = 0, /* x right, y up, camera looks along -z (OpenGL, ARCore, OpenXR) */
  GLIDE_AXES_CV = 1  /* x right, y down, camera looks along +z (OpenCV) */
};
enum { GLIDE_BACKEND_AUTO = 0, GLIDE_BACKEND_GLES = 1, GLIDE_BACKEND_CPU = 2 };
enum { GLIDE_MODE_SLAM = 0, GLIDE_MODE_LOCALIZATION_ONLY = 1 };
enum { GLIDE_EXECUTION_THREADED = 0, GLIDE_EXECUTION_INLINE = 1 };
enum {
  GLIDE_DISTORTION_NONE = 0,
  GLIDE_DISTORTION_RADTAN = 1,
  GLIDE_DISTORTION_KANNALA_BRANDT4 = 2
};
enum { GLIDE_LOG_DEBUG = 0, GLIDE_LOG_INFO = 1, GLIDE_LOG_WARNING = 2, GLIDE_LOG_ERROR = 3 };

/* Called on the thread of the call that it tells about, which waits for it: it must not call update
 * or what waits for update. */
typedef void (*glide_log_fn)(void* user, int32_t level, const char* message);

/* Object in world: rotation first, then translation. */
typedef struct glide_pose {
  double q[4]; /* x y z w, unit */
  double p[3]; /* scene units; metres once a metric scale is set */
} glide_pose;

/* Calibration at the resolution of the frames, OpenCV's conventions: (0,0) is the centre of the
 * first pixel. Coefficients: none; k1 k2 p1 p2 [k3]; k1 k2 k3 k4. */
typedef struct glide_intrinsics {
  int32_t width, height; /* px */
  double fx, fy, cx, cy; /* px */
  int32_t distortion;    /* GLIDE_DISTORTION_* */
  int32_t coefficient_count;
  double coefficients[8];
} glide_intrinsics;

typedef struct glide_config {
  uint32_t struct_size;
  int32_t backend;   /* GLIDE_BACKEND_* */
  int32_t mode;      /* GLIDE_MODE_* */
  int32_t execution; /* GLIDE_EXECUTION_* */
  int32_t axes;      /* GLIDE_AXES_* */
  uint32_t setting_count;
  const char* const* settings; /* "direct.patch_size=11": every field of glide/config.h */
  glide_intrinsics camera;
  glide_log_fn log; /* may be null */
  void* log_user;
} glide_config;

enum {
  GLIDE_IMAGE_LUMA8 = 0,
  GLIDE_IMAGE_TEXTURE_2D = 1,
  GLIDE_IMAGE_TEXTURE_EXTERNAL = 2,
  GLIDE_IMAGE_HARDWARE_BUFFER = 3 /* Android */
};

/* One camera frame. What does not belong to its kind is ignored. */
typedef struct glide_image {
  uint32_t struct_size;
  int32_t kind;                    /* GLIDE_IMAGE_* */
  int64_t t_ns;                    /* nanoseconds in the camera's clock, strictly increasing */
  int32_t width, height;           /* px; the config's */
  const uint8_t* pixels;           /* LUMA8: read only during the call */
  int64_t row_stride;              /* LUMA8: bytes, at least width */
  uint32_t texture;                /* TEXTURE_*: GL name */
  float transform[16];             /* TEXTURE_*, HARDWARE_BUFFER: column-major, as of
                                      SurfaceTexture.getTransformMatrix; all zero: (s, 1 - t), for an image
                                      whose first row is the uppermost (docs/inputs.md) */
  void* hardware_buffer;           /* HARDWARE_BUFFER: AHardwareBuffer* */
  int64_t exposure_ns;             /* 0: unknown. Not used yet. */
  int64_t rolling_shutter_skew_ns; /* 0: global shutter or unknown. Not used yet. */
} glide_image;

enum {
  GLIDE_STATE_INITIALIZING = 0, /* no map yet: see glide_frame.reason */
  GLIDE_STATE_TRACKING = 1,
  GLIDE_STATE_LOST = 2,
  GLIDE_STATE_PAUSED = 3
};
enum { GLIDE_TRACKER_NONE = 0, GLIDE_TRACKER_DIRECT = 1, GLIDE_TRACKER_INDIRECT = 2 };

/* Why there is no pose, and what a user can do about it. */
enum {
  GLIDE_REASON_NONE = 0,
  GLIDE_REASON_INSUFFICIENT_FEATURES = 1, /* dark, blurred or blank */
  GLIDE_REASON_EXCESSIVE_MOTION = 2,
  GLIDE_REASON_INSUFFICIENT_PARALLAX = 3, /* move sideways */
  GLIDE_REASON_AMBIGUOUS = 4,             /* keep moving */
  GLIDE_REASON_RELOCALIZING = 5           /* return to where the camera has been */
};

/* Why the direct tracker did not make the pose of a frame. */
enum {
  GLIDE_SWITCH_NONE = 0, /* it did */
  GLIDE_SWITCH_NO_REFERENCE = 1,
  GLIDE_SWITCH_SOLVE_FAILED = 2,
  GLIDE_SWITCH_TOO_FEW_VISIBLE = 3,
  GLIDE_SWITCH_PHOTOMETRIC_ERROR = 4,
  GLIDE_SWITCH_BASELINE = 5,
  GLIDE_SWITCH_ROTATION = 6,
  GLIDE_SWITCH_MAX_DIRECT_FRAMES = 7,
  GLIDE_SWITCH_DISABLED = 8
};

/* The answer to one frame. */
typedef struct glide_frame {
  uint32_t struct_size;
  int32_t state;   /* GLIDE_STATE_* */
  int32_t reason;  /* GLIDE_REASON_* */
  int32_t tracker; /* GLIDE_TRACKER_* */
  int64_t t_ns;
  glide_pose camera; /* camera in world; the last known one unless tracking */
  float confidence;  /* 0..1; 0 unless tracking */
  int32_t keyframe;  /* 1: became a keyframe */
  uint64_t map_revision;
  int32_t world_corrected;   /* 1: the world has moved under the camera; anchors followed */
  float correction_distance; /* of the camera, scene units */
  float correction_rotation; /* rad */
  float correction_scale;
  int32_t visible, inliers; /* landmarks */
  float update_ms, pyramid_ms, precompute_ms, align_ms, features_ms, match_ms, pose_ms;
  float mapping_ms;         /* of GLIDE_EXECUTION_INLINE, not part of update_ms */
  float readback_ms;        /* bringing a texture's pixels to the CPU */
  float rms;                /* direct: patch error, grey levels; indirect: reprojection error, px */
  int32_t switch_reason;    /* GLIDE_SWITCH_* */
  int32_t start_matches;    /* with the first view, while initializing */
  float start_parallax_deg; /* median parallax of these */
  int32_t start_landmarks;  /* that the best start would have */
  int32_t reserved;
  uint64_t map_generation; /* grows when a new map, with a world of its own, is begun: after reset,
                              load or a start that failed; scale and gravity are arbitrary again */
} glide_frame;

enum { GLIDE_LOCATION_VALID = 1, GLIDE_LOCATION_TRACKED = 2 };
typedef struct glide_location {
  uint32_t struct_size;
  uint32_t flags; /* GLIDE_LOCATION_* */
  int64_t t_ns;
  glide_pose camera;
} glide_location;

/* A landmark. */
typedef struct glide_point {
  float x, y, z;    /* world */
  float confidence; /* 0..1, by the keyframes that see it */
  uint64_t id;
} glide_point;

/* A landmark as the last frame saw it. */
typedef struct glide_tracked_point {
  uint64_t landmark; /* glide_point.id */
  float u, v;        /* px in the image */
  float residual;    /* direct frames: RMS difference of the patch, grey levels; indirect: px */
  int32_t inlier;    /* 1: it agrees with the pose */
} glide_tracked_point;

typedef struct glide_keyframe {
  uint64_t id;
  int64_t t_ns;
  glide_pose camera; /* camera in world */
  int32_t retired;   /* 1: culled; its pose stays defined */
  int32_t reserved;
} glide_keyframe;

/* A place that was recognised: two keyframes see the same landmarks. */
typedef struct glide_loop {
  uint64_t newer, older; /* ids of keyframes */
} glide_loop;

typedef struct glide_hit {
  glide_pose pose; /* at the hit; y axis (GL) or -y axis (CV) along the surface's normal */
  float distance;  /* from the camera, scene units */
  int32_t points; /* landmarks that the surface rests on; 1: a single point, normal to the camera */
} glide_hit;

typedef struct glide_anchor {
  uint32_t struct_size;
  int32_t tracking;  /* 1: the map that it belongs to is still there */
  glide_pose pose;   /* now: follows corrections of the map */
  uint64_t revision; /* grows when the pose has changed */
} glide_anchor;

typedef struct glide_imu_sample {
  int64_t t_ns;
  float acceleration[3];     /* m/s2, device axes */
  float angular_velocity[3]; /* rad/s */
} glide_imu_sample;

typedef struct glide_backend_info {
  uint32_t struct_size;
  int32_t backend;                              /* GLIDE_BACKEND_GLES or _CPU */
  char vendor[64], renderer[128], version[128]; /* of the GL; empty on the CPU */
} glide_backend_info;

/* Both return the bytes moved; fewer than size is an error, in read also the end of the data. */
typedef struct glide_io {
  uint32_t struct_size;
  size_t (*read)(void* user, void* data, size_t size);
  size_t (*write)(void* user, const void* data, size_t size);
  void* user;
} glide_io;

#endif
