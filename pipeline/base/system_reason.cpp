// SPDX-License-Identifier: MIT
#include "pipeline/base/system_reason.h"

#include <cerrno>
#include <cstring>

namespace inkbench {

std::string system_reason(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "the disk is full; free some space or choose another folder";
    case EFBIG:
      return "the file would exceed the allowed file size; raise the limit or choose a smaller image";
    case EACCES:
    case EPERM:
      return "permission denied; choose a folder you may write to";
    case EROFS:
      return "the file system is read-only; choose another folder";
    default:
      return std::strerror(error_number);
  }
}

}  // namespace inkbench
