// SPDX-License-Identifier: MIT
#include "pipeline/vectors/pdf_file.h"

#include <algorithm>
#include <string_view>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/base/run_program.h"
#include "pipeline/base/scratch_folder.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

constexpr std::chrono::minutes kLimit{5};

/// Over the date of now, in as many bytes, so that what the file says of its bytes' places stays true.
void forget_date(std::string& pdf) {
  constexpr std::string_view kEntry = "/CreationDate (", kDate = "D:19700101000000Z";
  const size_t entry = pdf.rfind(kEntry);
  if (entry == std::string::npos) return;
  const size_t first = entry + kEntry.size(), end = pdf.find(')', first);
  if (end == std::string::npos || end - first < kDate.size()) return;
  std::fill(pdf.begin() + static_cast<std::ptrdiff_t>(first), pdf.begin() + static_cast<std::ptrdiff_t>(end),
            ' ');
  pdf.replace(first, kDate.size(), kDate);
}

}  // namespace

std::string pdf_of(const std::string& svg) {
  const ScratchFolder folder(memory_place());
  const fs::path from = folder.path() / "drawing.svg", to = folder.path() / "drawing.pdf";
  write_file_atomically(from, svg, Sync::later);
  const ProgramEnd end =
      run_program({"rsvg-convert", "--format", "pdf", "--output", to.string(), from.string()}, kLimit,
                  "install the package librsvg2-bin, which makes PDF files");
  if (end.status != 0)
    throw work_error("rsvg-convert", "failed with status " + std::to_string(end.status),
                     printable(trim(end.output)));
  std::string pdf = read_file(to);
  forget_date(pdf);
  return pdf;
}

}  // namespace inkbench
