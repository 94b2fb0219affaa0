// The sums of one point at a pose. Needs records, pixels, sums, level_image and level.
#include "frame_patch.glsl"

float mean;  // m0 of the patch
int pixel;   // index of e of the next pixel
vec4 intensity;
float sy;

void visitFramePixel(float i) {
  int stride = constants.limits.x;
  i -= mean;
  intensity += i * vec4(1.0, i, pixels[pixel], pixels[pixel + stride]);
  sy += i * pixels[pixel + 2 * stride];
  pixel += 3 * stride;
}

// Samples the frame around the point and writes S1 S2 Sc Sx Sy and whether it is visible.
void sumPoint(int point, vec4 q_cam_ref, vec3 t_cam_ref) {
  int at = recordIndex(level, point);
  vec4 p_ref = records[at].p_ref;
  bool visible = false;
  intensity = vec4(0.0);
  sy = 0.0;
  if (p_ref.w > 0.5) {
    Projected projected = projectPoint(rotate(q_cam_ref, p_ref.xyz) + t_cam_ref, levelScale(level));
    vec2 size = vec2(textureSize(level_image, 0));
    visible = projected.ok &&
              isInside(projected.uv, float(kHalfPatch), size, float(kHalfPatch + 1));
    if (visible) {
      mean = records[at].moments.x;
      pixel = pixelIndex(level, point, 0, 0);
      walkFramePatch(projected.uv);
    }
  }
  sums[point].intensity = intensity;
  sums[point].rest.xy = vec2(sy, visible ? 1.0 : 0.0);
}
