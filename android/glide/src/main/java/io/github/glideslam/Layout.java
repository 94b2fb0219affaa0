package io.github.glideslam;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Sizes and offsets, in bytes, of the C structs that cross JNI in direct buffers (glide_types.h on
 * 64-bit machines). {@link Native#layout} tells what the library has; a test compares.
 */
final class Layout {
  static final int POSE_SIZE = 56;
  static final int POSE_T = 32;

  static final int CONFIG_SIZE = 160;
  static final int CONFIG_BACKEND = 4;
  static final int CONFIG_MODE = 8;
  static final int CONFIG_EXECUTION = 12;
  static final int CONFIG_AXES = 16;
  static final int CONFIG_CAMERA = 32;
  static final int CAMERA_SIZE = 112;
  static final int CAMERA_WIDTH = 0;
  static final int CAMERA_HEIGHT = 4;
  static final int CAMERA_FX = 8;
  static final int CAMERA_DISTORTION = 40;
  static final int CAMERA_COUNT = 44;
  static final int CAMERA_COEFFICIENTS = 48;
  static final int CAMERA_MOST_COEFFICIENTS = 8;

  static final int IMAGE_SIZE = 136;
  static final int IMAGE_KIND = 4;
  static final int IMAGE_TIME = 8;
  static final int IMAGE_WIDTH = 16;
  static final int IMAGE_HEIGHT = 20;
  /** In Java the place of the first pixel in its buffer; JNI makes a pointer of it. */
  static final int IMAGE_PIXELS = 24;
  static final int IMAGE_ROW_STRIDE = 32;
  static final int IMAGE_TEXTURE = 40;
  static final int IMAGE_TRANSFORM = 44;
  static final int IMAGE_EXPOSURE = 120;
  static final int IMAGE_SKEW = 128;

  static final int FRAME_SIZE = 192;
  static final int FRAME_STATE = 4;
  static final int FRAME_REASON = 8;
  static final int FRAME_TRACKER = 12;
  static final int FRAME_TIME = 16;
  static final int FRAME_CAMERA = 24;
  static final int FRAME_CONFIDENCE = 80;
  static final int FRAME_KEYFRAME = 84;
  static final int FRAME_REVISION = 88;
  static final int FRAME_CORRECTED = 96;
  static final int FRAME_CORRECTION_DISTANCE = 100;
  static final int FRAME_CORRECTION_ROTATION = 104;
  static final int FRAME_CORRECTION_SCALE = 108;
  static final int FRAME_VISIBLE = 112;
  static final int FRAME_INLIERS = 116;
  static final int FRAME_UPDATE_MS = 120;
  static final int FRAME_RMS = 156;
  static final int FRAME_SWITCH_REASON = 160;
  static final int FRAME_START_MATCHES = 164;
  static final int FRAME_START_PARALLAX = 168;
  static final int FRAME_START_LANDMARKS = 172;
  static final int FRAME_GENERATION = 184;

  static final int LOCATION_SIZE = 72;
  static final int LOCATION_FLAGS = 4;
  static final int LOCATION_TIME = 8;
  static final int LOCATION_CAMERA = 16;

  static final int POINT_SIZE = 24;
  static final int POINT_ID = 16;

  static final int TRACKED_POINT_SIZE = 24;
  static final int TRACKED_POINT_U = 8;
  static final int TRACKED_POINT_V = 12;
  static final int TRACKED_POINT_RESIDUAL = 16;
  static final int TRACKED_POINT_INLIER = 20;

  static final int KEYFRAME_SIZE = 80;
  static final int KEYFRAME_TIME = 8;
  static final int KEYFRAME_CAMERA = 16;
  static final int KEYFRAME_RETIRED = 72;

  static final int LOOP_SIZE = 16;
  static final int LOOP_OLDER = 8;

  static final int HIT_SIZE = 64;
  static final int HIT_DISTANCE = 56;
  static final int HIT_POINTS = 60;

  static final int ANCHOR_SIZE = 72;
  static final int ANCHOR_TRACKING = 4;
  static final int ANCHOR_POSE = 8;
  static final int ANCHOR_REVISION = 64;

  static final int IMU_SIZE = 32;
  static final int IMU_ACCELERATION = 8;
  static final int IMU_ANGULAR_VELOCITY = 20;

  static final int BACKEND_SIZE = 328;
  static final int BACKEND_KIND = 4;
  static final int BACKEND_VENDOR = 8;
  static final int BACKEND_RENDERER = 72;
  static final int BACKEND_VERSION = 200;

  /** A zeroed struct that knows its size: for those that begin with struct_size. */
  static ByteBuffer struct(int size) {
    return array(1, size).putInt(0, size);
  }

  /** Zeroed structs in a row. */
  static ByteBuffer array(int count, int size) {
    return ByteBuffer.allocateDirect(Math.multiplyExact(count, size)).order(ByteOrder.nativeOrder());
  }

  /** The same in the order of {@link Native#layout}. */
  static int[] expected() {
    return new int[] {
      POSE_SIZE, POSE_T,
      CONFIG_SIZE, CONFIG_BACKEND, CONFIG_MODE, CONFIG_EXECUTION, CONFIG_AXES, CONFIG_CAMERA,
      CAMERA_SIZE, CAMERA_WIDTH, CAMERA_HEIGHT, CAMERA_FX, CAMERA_DISTORTION, CAMERA_COUNT, CAMERA_COEFFICIENTS,
      CAMERA_MOST_COEFFICIENTS,
      IMAGE_SIZE, IMAGE_KIND, IMAGE_TIME, IMAGE_WIDTH, IMAGE_HEIGHT, IMAGE_PIXELS,
      IMAGE_ROW_STRIDE, IMAGE_TEXTURE, IMAGE_TRANSFORM, IMAGE_EXPOSURE, IMAGE_SKEW,
      FRAME_SIZE, FRAME_STATE, FRAME_REASON, FRAME_TRACKER, FRAME_TIME, FRAME_CAMERA,
      FRAME_CONFIDENCE, FRAME_KEYFRAME, FRAME_REVISION, FRAME_CORRECTED, FRAME_CORRECTION_DISTANCE,
      FRAME_CORRECTION_ROTATION, FRAME_CORRECTION_SCALE, FRAME_VISIBLE, FRAME_INLIERS,
      FRAME_UPDATE_MS, FRAME_RMS, FRAME_SWITCH_REASON, FRAME_START_MATCHES, FRAME_START_PARALLAX,
      FRAME_START_LANDMARKS, FRAME_GENERATION,
      LOCATION_SIZE, LOCATION_FLAGS, LOCATION_TIME, LOCATION_CAMERA,
      POINT_SIZE, POINT_ID,
      TRACKED_POINT_SIZE, TRACKED_POINT_U, TRACKED_POINT_V, TRACKED_POINT_RESIDUAL,
      TRACKED_POINT_INLIER,
      KEYFRAME_SIZE, KEYFRAME_TIME, KEYFRAME_CAMERA, KEYFRAME_RETIRED,
      LOOP_SIZE, LOOP_OLDER,
      HIT_SIZE, HIT_DISTANCE, HIT_POINTS,
      ANCHOR_SIZE, ANCHOR_TRACKING, ANCHOR_POSE, ANCHOR_REVISION,
      IMU_SIZE, IMU_ACCELERATION, IMU_ANGULAR_VELOCITY,
      BACKEND_SIZE, BACKEND_KIND, BACKEND_VENDOR, BACKEND_RENDERER, BACKEND_VERSION,
    };
  }

  private Layout() {}
}
