// SPDX-License-Identifier: MIT
// SVG files as PDF, by the program rsvg-convert (Debian's librsvg2-bin). In: an SVG file's text. Out: a PDF
// file's bytes.
#pragma once

#include <string>

namespace inkbench {

/// Vectors stay vectors; a px is 1/96 inch. The same text gives the same bytes: the file says that it was
/// made in 1970. Errors (work): the program is not there, with its package; what it says.
std::string pdf_of(const std::string& svg);

}  // namespace inkbench
