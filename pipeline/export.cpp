// SPDX-License-Identifier: MIT
#include "pipeline/export.h"

#include <fmt/format.h>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/lines/class_pixels.h"
#include "pipeline/settings/settings_file.h"
#include "pipeline/vector_export.h"
#include "pipeline/vectors/pdf_file.h"
#include "pipeline/vectors/svg_page.h"

namespace inkbench {
namespace {

constexpr const char* kVersionEntry = "inkbench:version";
constexpr const char* kSettingsEntry = "inkbench:settings";
constexpr const char* kFilesEntry = "inkbench:files";

/// The entry of an image or of a vector file; "" where there is none.
std::string read_entry(const fs::path& path, const std::string& name) {
  if (path.extension() == ".svg") return svg_entry(read_file(path, kMostImageBytes), name);
  return read_image_text(path, name);
}

}  // namespace

ImageText export_text(const Settings& settings, BufferName buffer, const std::vector<UsedFile>& files) {
  ImageText text{{"Software", "inkbench " INKBENCH_VERSION},
                 {kVersionEntry, INKBENCH_VERSION},
                 {std::string(kBufferEntry), std::string(name_of(buffer))},
                 {kSettingsEntry, settings_text(settings)}};
  if (buffer.info().as_lines == ReadAsLines::classes)
    text.emplace(std::string(kClassesEntry), class_bit_names());
  if (!files.empty()) text.emplace(kFilesEntry, used_files_text(files));
  return text;
}

bool has_origin(const std::filesystem::path& image) {
  return !read_entry(image, kSettingsEntry).empty();
}

ImageOrigin read_origin(const std::filesystem::path& image) {
  const std::string settings = read_entry(image, kSettingsEntry);
  if (settings.empty()) {
    throw input_error(image.string(), "carries no parameters in its metadata",
                      "give an image that `inkbench render` or a study's cells/ folder holds");
  }
  ImageOrigin origin;
  origin.settings = parse_settings(settings, image.string() + " (metadata)", "/");
  origin.buffer =
      parse_buffers({read_entry(image, std::string(kBufferEntry))}, image.string() + " (metadata)").front();
  origin.version = read_entry(image, kVersionEntry);
  origin.files = used_files_from(read_entry(image, kFilesEntry));
  return origin;
}

std::vector<std::string> notes_on_changed_files(const fs::path& image, const ImageOrigin& origin,
                                                const Settings& now) {
  std::vector<std::string> notes;
  for (const UsedFile& file : changed_files(origin.files, origin.settings, now)) {
    notes.push_back(
        fmt::format("{} ({}) is another file now than when {} was made: the picture is not the same",
                    file.path, file.key, image.string()));
  }
  return notes;
}

void write_buffer(const Frame& frame, BufferName buffer, const fs::path& path) {
  const std::string format = path.extension().string();
  if (format == ".svg" && is_of_lines(buffer)) {
    write_file_atomically(path, vector_text(frame, buffer));
  } else if (format == ".pdf" && is_of_lines(buffer)) {
    write_file_atomically(path, pdf_of(vector_text(frame, buffer)));
  } else if (format == ".exr") {
    write_exr(path, frame.raw(buffer), export_text(frame.settings(), buffer, frame.used_files()));
  } else if (format == ".png") {
    write_png(path, frame.picture(buffer), export_text(frame.settings(), buffer, frame.used_files()));
  } else {
    throw input_error(path.string(), "is no name for an image of " + std::string(name_of(buffer)),
                      "end it in .png or .exr, or .svg or .pdf for reference, curves and strokes");
  }
}

}  // namespace inkbench
