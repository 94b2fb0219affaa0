#include "replay/app/job.h"

#include "base/stopwatch.h"

#include <fmt/format.h>

namespace glide::replay {
namespace {

constexpr double kBytesPerMb = 1024.0 * 1024.0;

}  // namespace

std::optional<Failure> loadMap(Job& job) {
  if (!job.options.map_in) return std::nullopt;
  Stopwatch watch;
  const Status status = job.session->loadMap(*job.options.map_in);
  if (!status) return Failure{kUnreadableInput, status.error().message};
  const double load_ms = watch.lapMs();
  const std::shared_ptr<const MapView> map = job.session->map();
  job.log.note(fmt::format("map: {}, {} keyframes, {} landmarks, loaded in {:.1f} ms",
                           job.options.map_in->string(),
                           map->keyframes.size(),
                           map->landmarks.size(),
                           load_ms));
  return std::nullopt;
}

std::optional<Failure> saveMap(Job& job) {
  if (job.run.map->keyframes.empty()) {
    if (job.options.map_out) job.log.say("there is no map to save");
    return std::nullopt;
  }
  if (job.run.map->generation != job.session->map()->generation) {
    if (job.options.map_out) job.log.say("the map was given up when it was lost: none is saved");
    return std::nullopt;
  }
  const Result<std::vector<std::byte>> bytes = job.session->saveMap();
  if (bytes) job.run.map_file_bytes = bytes.value().size();
  if (!job.options.map_out) return std::nullopt;
  const Status status = job.session->saveMap(*job.options.map_out);
  if (!status) return Failure{kUnreadableInput, status.error().message};
  job.log.note(fmt::format("map: saved to {}, {:.2f} MB",
                           job.options.map_out->string(),
                           static_cast<double>(job.run.map_file_bytes) / kBytesPerMb));
  return std::nullopt;
}

}  // namespace glide::replay
