/* track_folder WIDTH HEIGHT FX FY CX CY IMAGE.pgm...: prints where the camera was (docs/c-api.md). */
#include <glide/glide.h>
#include <stdio.h>
#include <stdlib.h>

/* Reads a binary 8-bit PGM of the given size; 0 when it is none. */
static int read_pgm(const char* path, unsigned char* pixels, int width, int height) {
  int w = 0, h = 0, ok = 0;
  FILE* file = fopen(path, "rb");
  if (file == NULL) return 0;
  if (fscanf(file, "P5 %d %d 255", &w, &h) == 2 && w == width && h == height && fgetc(file) != EOF)
    ok = fread(pixels, 1, (size_t)(w * h), file) == (size_t)(w * h);
  fclose(file);
  return ok;
}

int main(int count, char** arguments) {
  glide_config config;
  glide_image image;
  glide_frame frame;
  glide_session* session = NULL;
  unsigned char* pixels = NULL;
  int i, tracked = 0;
  if (count < 8) return fprintf(stderr, "usage: WIDTH HEIGHT FX FY CX CY IMAGE...\n"), 1;

  GLIDE_INIT(config);
  config.backend = GLIDE_BACKEND_CPU;
  config.execution = GLIDE_EXECUTION_INLINE; /* files can wait for the map; a camera cannot */
  config.camera.width = atoi(arguments[1]);
  config.camera.height = atoi(arguments[2]);
  config.camera.fx = atof(arguments[3]);
  config.camera.fy = atof(arguments[4]);
  config.camera.cx = atof(arguments[5]);
  config.camera.cy = atof(arguments[6]);
  if (glide_session_create(&config, &session) != GLIDE_OK)
    return fprintf(stderr, "%s\n", glide_last_error()), 1;

  pixels = malloc((size_t)(config.camera.width * config.camera.height));
  GLIDE_INIT(image);
  image.kind = GLIDE_IMAGE_LUMA8;
  image.width = config.camera.width;
  image.height = config.camera.height;
  image.pixels = pixels;
  image.row_stride = image.width;
  GLIDE_INIT(frame);
  for (i = 7; i < count; ++i) {
    if (!read_pgm(arguments[i], pixels, image.width, image.height)) {
      fprintf(stderr, "%s: not a PGM of the camera's size\n", arguments[i]);
      continue;
    }
    image.t_ns += 33333333; /* 30 images a second */
    if (glide_session_update(session, &image, &frame) != GLIDE_OK) {
      fprintf(stderr, "%s: %s\n", arguments[i], glide_last_error());
    } else if (frame.state == GLIDE_STATE_TRACKING) {
      printf("%s %.4f %.4f %.4f\n", arguments[i], frame.camera.p[0], frame.camera.p[1], frame.camera.p[2]);
      ++tracked;
    }
  }
  glide_session_destroy(session);
  free(pixels);
  return fprintf(stderr, "%d of %d images tracked\n", tracked, count - 7), tracked > 0 ? 0 : 4;
}
