/**
 * What needs Android's types: hardware buffers as frames, and glide-camera2, a camera set up for
 * tracking. The API itself is {@link io.github.glideslam}.
 */
package io.github.glideslam.android;
