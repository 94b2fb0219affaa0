/* The layout of the C ABI on 64-bit machines, pinned: a change here is another ABI. Compiled by abi_test.sh. */
#include "glide/glide.h"

#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), #type)
#define AT(type, field, bytes) _Static_assert(offsetof(type, field) == (bytes), #type "." #field)

SIZE(glide_pose, 56);
SIZE(glide_intrinsics, 112);
AT(glide_intrinsics, fx, 8);
AT(glide_intrinsics, coefficients, 48);
SIZE(glide_config, 160);
AT(glide_config, settings, 24);
AT(glide_config, camera, 32);
AT(glide_config, log_user, 152);
SIZE(glide_image, 136);
AT(glide_image, t_ns, 8);
AT(glide_image, pixels, 24);
AT(glide_image, texture, 40);
AT(glide_image, hardware_buffer, 112);
AT(glide_image, rolling_shutter_skew_ns, 128);
SIZE(glide_loop, 16);
SIZE(glide_frame, 192);
AT(glide_frame, map_generation, 184);
AT(glide_frame, mapping_ms, 148);
AT(glide_frame, start_landmarks, 172);
AT(glide_frame, t_ns, 16);
AT(glide_frame, camera, 24);
AT(glide_frame, map_revision, 88);
AT(glide_frame, pose_ms, 144);
SIZE(glide_location, 72);
AT(glide_location, camera, 16);
SIZE(glide_point, 24);
AT(glide_point, id, 16);
SIZE(glide_tracked_point, 24);
AT(glide_tracked_point, inlier, 20);
SIZE(glide_keyframe, 80);
AT(glide_keyframe, camera, 16);
SIZE(glide_hit, 64);
AT(glide_hit, distance, 56);
SIZE(glide_anchor, 72);
AT(glide_anchor, revision, 64);
SIZE(glide_imu_sample, 32);
AT(glide_imu_sample, angular_velocity, 20);
SIZE(glide_backend_info, 328);
SIZE(glide_io, 32);
AT(glide_io, user, 24);

int main(void) { return 0; }
