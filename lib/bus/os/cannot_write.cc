#include "lib/bus/os/cannot_write.h"

#include <cerrno>

#include "lib/bus/os/file_descriptor.h"

namespace shoal {

namespace {

std::string Remedy(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space, or choose another folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder that you may write to";
    case ENOENT:
    case ENOTDIR:
      return "make its folder first";
    case EISDIR:
      return "it is a folder: name a file in it";
    case EMFILE:
    case ENFILE:
      return "too many files are open: raise `ulimit -n`";
    default:
      return "check the disk, or choose another folder";
  }
}

}  // namespace

Error CannotWrite(const std::string& path, int error_number) {
  return Error{"cannot write " + path + ": " + ErrnoText(error_number) + " (" +
               Remedy(error_number) + ")"};
}

}  // namespace shoal
