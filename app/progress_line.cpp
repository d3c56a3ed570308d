// SPDX-License-Identifier: MIT
#include "app/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "app/terminal.h"
#include "app/workbench/duration_text.h"

namespace inkbench {
namespace {

constexpr double kQuietSeconds = 10.0;
constexpr double kTerminalSeconds = 0.1;

void print_json(const ProgressNote& note) {
  print_out("{}\n", note.json);
  flush_out();
}

}  // namespace

std::string progress_text(const StudyProgress& progress) {
  std::string text = fmt::format("{} / {} cells", progress.done, progress.total);
  if (progress.failed > 0) text += fmt::format(", {} failed", progress.failed);
  const size_t tried = progress.drawn + progress.measured + progress.failed;
  if (tried == 0 || progress.seconds <= 0) return text;
  const double rate = static_cast<double>(tried) / progress.seconds;
  text += fmt::format(", {:.1f} a second", rate);
  const size_t left = progress.total - progress.done - progress.failed;
  if (left > 0) text += ", " + duration_text(static_cast<double>(left) / rate) + " left";
  return text;
}

std::string progress_json(const StudyProgress& progress) {
  return fmt::format(R"({{"done":{},"total":{},"drawn":{},"measured":{},"failed":{},"seconds":{:.3f}}})",
                     progress.done, progress.total, progress.drawn, progress.measured, progress.failed,
                     progress.seconds);
}

ProgressNote note_of(const StudyProgress& progress) {
  return {progress.seconds, progress_text(progress), progress_json(progress)};
}

ProgressLine::ProgressLine(ProgressFormat format)
    : format_(format),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_seconds_(terminal_ || format == ProgressFormat::json ? 0.0 : kQuietSeconds) {}

void ProgressLine::begin(const ProgressNote& note) {
  if (format_ == ProgressFormat::json) print_json(note);
}

void ProgressLine::show(const ProgressNote& note) {
  if (note.seconds < next_seconds_) return;
  if (format_ == ProgressFormat::json) {
    next_seconds_ = note.seconds + kTerminalSeconds;
    return print_json(note);
  }
  next_seconds_ = note.seconds + (terminal_ ? kTerminalSeconds : kQuietSeconds);
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r\033[K" : "", note.text, terminal_ ? "" : "\n");
  std::fflush(stderr);
  open_ = terminal_;
}

void ProgressLine::finish(const ProgressNote& note) {
  if (format_ == ProgressFormat::json) return print_json(note);
  fmt::print(stderr, "{}{}\n", open_ ? "\r\033[K" : "", note.text);
  open_ = false;
}

}  // namespace inkbench
