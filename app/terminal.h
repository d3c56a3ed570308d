// SPDX-License-Identifier: MIT
// The one way to standard output and standard error. In: text, with names from files in it. Out: the same
// without what would act on a terminal, and, at the end, whether all of it got out.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace inkbench {

/// To standard output, `printable` but for line breaks and tabs. Never fails: `finish_output` tells.
void write_out(std::string_view text);

/// The same to standard error; whether all of it got out is not asked.
void write_error(std::string_view text);

template <class... Arguments>
void print_out(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  write_out(fmt::format(format, std::forward<Arguments>(arguments)...));
}

template <class... Arguments>
void print_error(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  write_error(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Hands on what was printed so far.
void flush_out();

/// "inkbench: error: MESSAGE" to standard error; returns `status`.
int fail(std::string_view message, int status);

/// Hands on all that was printed. Returns `status`, or 1, with a message, where standard output did not take
/// it all; without one where its reader went away.
int finish_output(int status);

/// Opens those of the three standard descriptors that are closed on /dev/null, so that no file or pipe of
/// ours takes their numbers. First thing in main.
void open_closed_descriptors();

}  // namespace inkbench
