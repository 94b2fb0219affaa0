// Snapshots of the map, and map files by path or as bytes.
#include "arguments.h"
#include "jni_guard.h"
#include "natives.h"

#include "glide/glide.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

namespace glide_jni {
namespace {

using AcquireCall = glide_status (*)(glide_session*, glide_map**);

/// acquireMap and acquireFrameMap.
template <AcquireCall call>
jlong JNICALL acquire(JNIEnv* env, jclass /*type*/, jlong session) {
  glide_map* map = nullptr;
  guarded(env, [&] { return call(handleOf<glide_session>(session), &map); });
  return numberOf(map);
}

void JNICALL releaseMap(JNIEnv* /*env*/, jclass /*type*/, jlong map) {
  glide_map_release(handleOf<glide_map>(map));
}

using NumberCall = glide_status (*)(const glide_map*, std::uint64_t*);

/// mapRevision and mapGeneration.
template <NumberCall call>
jlong JNICALL mapNumber(JNIEnv* env, jclass /*type*/, jlong map) {
  std::uint64_t number = 0;
  guarded(env, [&] { return call(handleOf<glide_map>(map), &number); });
  return static_cast<jlong>(number);
}

jint JNICALL mapPoints(JNIEnv* env, jclass /*type*/, jlong map, jobject points) {
  return counted<glide_point>(
      env, points, [&](std::size_t capacity, glide_point* out, std::size_t* count) {
        return glide_map_points(handleOf<glide_map>(map), capacity, out, count);
      });
}

jint JNICALL mapKeyframes(JNIEnv* env, jclass /*type*/, jlong map, jobject keyframes) {
  return counted<glide_keyframe>(
      env, keyframes, [&](std::size_t capacity, glide_keyframe* out, std::size_t* count) {
        return glide_map_keyframes(handleOf<glide_map>(map), capacity, out, count);
      });
}

jint JNICALL mapLoops(JNIEnv* env, jclass /*type*/, jlong map, jobject loops) {
  return counted<glide_loop>(
      env, loops, [&](std::size_t capacity, glide_loop* out, std::size_t* count) {
        return glide_map_loops(handleOf<glide_map>(map), capacity, out, count);
      });
}

void JNICALL mapCorrectedCamera(JNIEnv* env, jclass /*type*/, jlong map, jobject camera) {
  withStruct<glide_intrinsics>(env, camera, [&](glide_intrinsics* answer) {
    return glide_map_corrected_camera(handleOf<glide_map>(map), answer);
  });
}

using FileCall = glide_status (*)(glide_session*, const char*);

/// saveMap and loadMap of a zero-ended UTF-8 path.
template <FileCall call>
void JNICALL withPath(JNIEnv* env, jclass /*type*/, jlong session, jbyteArray given) {
  guarded(env, [&]() -> glide_status {
    if (given == nullptr) return refuse(env, "path is null");
    const jsize size = env->GetArrayLength(given);
    std::vector<char> path(static_cast<std::size_t>(size) + 1, '\0');
    env->GetByteArrayRegion(given, 0, size, reinterpret_cast<jbyte*>(path.data()));
    return call(handleOf<glide_session>(session), path.data());
  });
}

/// glide_io's write into a std::vector; less than asked for when memory ends.
std::size_t append(void* user, const void* data, std::size_t size) {
  auto* target = static_cast<std::vector<jbyte>*>(user);
  const auto* bytes = static_cast<const jbyte*>(data);
  try {
    target->insert(target->end(), bytes, bytes + size);
  } catch (const std::bad_alloc&) {
    return 0;
  }
  return size;
}

jbyteArray JNICALL saveMapBytes(JNIEnv* env, jclass /*type*/, jlong session) {
  jbyteArray result = nullptr;
  guarded(env, [&]() -> glide_status {
    std::vector<jbyte> bytes;
    glide_io io;
    GLIDE_INIT(io);
    io.write = append;
    io.user = &bytes;
    const glide_status status = glide_map_save_io(handleOf<glide_session>(session), &io);
    if (status < 0) return status;
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<jsize>::max()))
      return raise(env, GLIDE_ERROR_RESOURCE_EXHAUSTED, "the map is more than a Java array holds");
    result = env->NewByteArray(static_cast<jsize>(bytes.size()));
    if (result == nullptr) return GLIDE_ERROR_FATAL;  // an OutOfMemoryError is pending
    env->SetByteArrayRegion(result, 0, static_cast<jsize>(bytes.size()), bytes.data());
    return status;
  });
  return result;
}

/// A Java array that is read piece by piece, on the thread of the call.
struct ArrayReader {
  JNIEnv* env;
  jbyteArray array;
  jsize size;
  jsize next;
};

/// glide_io's read from an ArrayReader.
std::size_t readArray(void* user, void* data, std::size_t size) {
  auto* reader = static_cast<ArrayReader*>(user);
  const jsize left = reader->size - reader->next;
  const auto piece = static_cast<jsize>(std::min(size, static_cast<std::size_t>(left)));
  reader->env->GetByteArrayRegion(reader->array, reader->next, piece, static_cast<jbyte*>(data));
  reader->next += piece;
  return static_cast<std::size_t>(piece);
}

void JNICALL loadMapBytes(JNIEnv* env, jclass /*type*/, jlong session, jbyteArray map) {
  guarded(env, [&]() -> glide_status {
    if (map == nullptr) return refuse(env, "map is null");
    ArrayReader reader{env, map, env->GetArrayLength(map), 0};
    glide_io io;
    GLIDE_INIT(io);
    io.read = readArray;
    io.user = &reader;
    return glide_map_load_io(handleOf<glide_session>(session), &io);
  });
}

}  // namespace

std::vector<JNINativeMethod> mapNatives() {
  return {
      native("acquireMap", "(J)J", acquire<glide_map_acquire>),
      native("acquireFrameMap", "(J)J", acquire<glide_map_acquire_frame>),
      native("releaseMap", "(J)V", releaseMap),
      native("mapRevision", "(J)J", mapNumber<glide_map_revision>),
      native("mapGeneration", "(J)J", mapNumber<glide_map_generation>),
      native("mapPoints", "(JLjava/nio/ByteBuffer;)I", mapPoints),
      native("mapKeyframes", "(JLjava/nio/ByteBuffer;)I", mapKeyframes),
      native("mapLoops", "(JLjava/nio/ByteBuffer;)I", mapLoops),
      native("mapCorrectedCamera", "(JLjava/nio/ByteBuffer;)V", mapCorrectedCamera),
      native("saveMap", "(J[B)V", withPath<glide_map_save>),
      native("loadMap", "(J[B)V", withPath<glide_map_load>),
      native("saveMapBytes", "(J)[B", saveMapBytes),
      native("loadMapBytes", "(J[B)V", loadMapBytes),
  };
}

}  // namespace glide_jni
