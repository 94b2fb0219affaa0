#include "base/file_io.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace glide {
namespace {

namespace fs = std::filesystem;

// Enough for programs that save into the same folder at once, or were killed while they did.
constexpr int kMaxAttempts = 100;
// Read at a time, bytes.
constexpr std::size_t kChunk = std::size_t{1} << 20;

Error failure(const char* what, const fs::path& path, int error_number) {
  return {ErrorCode::io,
          std::string(what) + " " + path.string() + ": " +
              std::generic_category().message(error_number)};
}

/// A file descriptor, closed at the end.
class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&&) = delete;
  ~File() { close(); }

  bool isOpen() const { return descriptor_ >= 0; }
  int get() const { return descriptor_; }
  /// False when the system reports a late error of writing.
  bool close() {
    const int descriptor = std::exchange(descriptor_, -1);
    return descriptor < 0 || ::close(descriptor) == 0;
  }

 private:
  int descriptor_ = -1;
};

/// A new file beside `path` that nobody else writes.
struct TemporaryFile {
  fs::path path;
  File file;
};

TemporaryFile createBeside(const fs::path& path) {
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    fs::path name = path;
    name += "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
    constexpr mode_t kAccess = 0666;  // less the umask, as for any file
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kAccess);
    if (descriptor >= 0 || errno != EEXIST) return {std::move(name), File(descriptor)};
  }
  return {path, File(-1)};
}

bool writeAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

/// The new name lasts only once the folder is on disk; where a file system cannot do that, the file
/// is whole all the same.
void syncFolder(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const File file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.isOpen()) ::fsync(file.get());
}

}  // namespace

Status writeFileAtomically(const fs::path& path,
                           std::span<const std::byte> bytes,
                           FileDurability durability) {
  TemporaryFile temporary = createBeside(path);
  if (!temporary.file.isOpen()) return failure("cannot create", path, errno);
  const bool is_synced = durability == FileDurability::synced;
  const bool is_written =
      writeAll(temporary.file.get(), bytes) && (!is_synced || ::fsync(temporary.file.get()) == 0) &&
      temporary.file.close() && ::rename(temporary.path.c_str(), path.c_str()) == 0;
  if (!is_written) {
    const int error_number = errno;
    ::unlink(temporary.path.c_str());
    return failure("cannot write", path, error_number);
  }
  if (is_synced) syncFolder(path);
  return Unit{};
}

Result<std::vector<std::byte>> readFile(const fs::path& path) {
  const File file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file.isOpen()) return failure("cannot open", path, errno);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return failure("cannot read", path, errno);
  if (!S_ISREG(status.st_mode)) {
    return Error{ErrorCode::io, "cannot read " + path.string() + ": not a regular file"};
  }
  std::vector<std::byte> bytes;
  bytes.reserve(static_cast<std::size_t>(status.st_size));
  for (;;) {  // until the end: the size may have changed
    const std::size_t have = bytes.size();
    bytes.resize(have + kChunk);
    const ssize_t count = ::read(file.get(), bytes.data() + have, kChunk);
    const int error_number = errno;
    bytes.resize(have + static_cast<std::size_t>(count > 0 ? count : 0));
    if (count == 0) return bytes;
    if (count < 0 && error_number != EINTR) return failure("cannot read", path, error_number);
  }
}

}  // namespace glide
