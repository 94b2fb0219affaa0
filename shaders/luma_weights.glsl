// Grey level 0..255 of a sampled colour, rounded as OpenCV's cvtColor does for 8 bits: BT.601 in 15-bit fixed point.
// Every sum stays below 2^24, so that floats are exact, in ESSL 1.00 too. `weights` add up to 32768: (9798, 19235, 3735)
// for red, green, blue, or (32768, 0, 0) for textures whose red is the luma.
float greyOf(vec3 colour, vec3 weights) {
  vec3 levels = floor(clamp(colour, 0.0, 1.0) * 255.0 + 0.5);
  return floor((dot(levels, weights) + 16384.0) / 32768.0);
}
