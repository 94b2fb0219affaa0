#include "replay/render/frame_sink.h"

#include "replay/outputs/render_path.h"
#include "replay/render/picture_folder.h"
#include "replay/render/video_file.h"

namespace glide::replay {

Result<std::unique_ptr<FrameSink>> openFrameSink(const std::filesystem::path& path,
                                                 const PictureSize& size) {
  return isVideoName(path) ? VideoFile::open(path, size) : PictureFolder::open(path);
}

}  // namespace glide::replay
