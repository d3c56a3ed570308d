// SPDX-License-Identifier: MIT
// Finds the reference lines beside the window: the newest request wins, and the window never waits. In: what
// the lines are found from, as plain data. Out: the lines and pictures of them.
#pragma once

#include <memory>
#include <string>

#include "app/workbench/background_work.h"
#include "pipeline/image/image.h"
#include "pipeline/lines/line_finder.h"

namespace inkbench {

struct FoundLines {
  Key key;            ///< The request's.
  std::string error;  ///< Why there is nothing else; "" as a rule.
  std::shared_ptr<const ReferenceLines> lines;
  Picture picture;  ///< H x W x 3, as `draw_reference`.
  Picture overlay;  ///< H x W x 4: the same, clear where there is no line.
};

FoundLines with_pictures(const Key& key, std::shared_ptr<const ReferenceLines> lines);

/// Lines in work are finished when a newer request comes: while the camera moves they follow it.
class LiveReference : public BackgroundWork<LineRequest, FoundLines, Key> {
 public:
  LiveReference(std::shared_ptr<LineFinder> finder, News& news);
};

}  // namespace inkbench
