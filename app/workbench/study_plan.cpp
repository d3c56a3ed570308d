// SPDX-License-Identifier: MIT
#include "app/workbench/study_plan.h"

#include <fmt/format.h>

#include "pipeline/base/text.h"

namespace inkbench {

double pixel_count(const StudySpec& spec) {
  const ImageParams& image = spec.base.image;
  const size_t pictures = cell_count(spec) * picture_count(spec);
  return static_cast<double>(image.width) * image.height * static_cast<double>(pictures);
}

double most_bytes(const StudySpec& spec) {
  constexpr double kBytesPerPixel = 3;
  return kBytesPerPixel * pixel_count(spec);
}

std::string shape_text(const StudySpec& spec) {
  const size_t count = cell_count(spec);
  std::vector<std::string> sides;
  for (const Axis& axis : spec.axes) sides.push_back(std::to_string(axis.values.size()));
  const ImageParams& image = spec.base.image;
  if (!spec.axes.empty() && !spec.variants.empty()) sides.push_back(std::to_string(spec.variants.size()));
  const std::string views = spec.views.size() > 1 ? fmt::format(" in {} {}", spec.views.size(),
                                                                spec.camera_path ? "frames" : "views")
                                                  : "";
  return fmt::format("{} cell{}{}{} of {} x {} px", with_commas(static_cast<long long>(count)),
                     count == 1 ? "" : "s", sides.size() > 1 ? " (" + join(sides, " x ") + ")" : "", views,
                     image.width, image.height);
}

std::string plan_text(const StudySpec& spec) {
  return shape_text(spec) + ", at most " + readable_bytes(most_bytes(spec));
}

}  // namespace inkbench
