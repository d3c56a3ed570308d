// SPDX-License-Identifier: MIT
#include "app/terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "pipeline/base/system_reason.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

/// Of the first write to standard output that failed; 0 where none did.
int& output_errno() {
  static int number = 0;
  return number;
}

void note_failure(bool good) {
  if (!good && output_errno() == 0) output_errno() = errno == 0 ? EIO : errno;
}

}  // namespace

void write_out(std::string_view text) {
  const std::string shown = printable(text, true);
  errno = 0;
  note_failure(std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size());
}

void write_error(std::string_view text) {
  const std::string shown = printable(text, true);
  std::fwrite(shown.data(), 1, shown.size(), stderr);
}

void flush_out() {
  errno = 0;
  note_failure(std::fflush(stdout) == 0);
}

int fail(std::string_view message, int status) {
  print_error("inkbench: error: {}\n", message);
  return status;
}

int finish_output(int status) {
  flush_out();
  note_failure(std::ferror(stdout) == 0);  // what others printed
  if (output_errno() == 0) return status;
  if (output_errno() == EPIPE) return status == 0 ? 1 : status;  // a reader that has seen enough, like `head`
  return fail("standard output: cannot be written; " + system_reason(output_errno()), 1);
}

void open_closed_descriptors() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDWR);  // takes the lowest
  }
}

}  // namespace inkbench
