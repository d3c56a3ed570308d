// SPDX-License-Identifier: MIT
#include "app/workbench/live_reference.h"

#include <algorithm>
#include <utility>

#include "pipeline/lines/drawing.h"

namespace inkbench {
namespace {

Picture clear_where_white(const Picture& picture) {
  Picture clear(picture.width_px, picture.height_px, 4);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) {
      const bool line = std::min({picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)}) < 255;
      for (int c = 0; c < 3; ++c) clear.at(x, y, c) = picture.at(x, y, c);
      clear.at(x, y, 3) = line ? 255 : 0;
    }
  }
  return clear;
}

FoundLines find_or_say_why(LineFinder& finder, const LineRequest& request, const StopAsked& stop) {
  try {
    return with_pictures(request.key, std::make_shared<ReferenceLines>(finder.find(request, stop)));
  } catch (const Stopped&) {
    throw;
  } catch (const std::bad_alloc&) {
    return {.key = request.key, .error = "out of memory; choose a smaller mesh"};
  } catch (const std::exception& error) {
    return {.key = request.key, .error = error.what()};
  }
}

}  // namespace

FoundLines with_pictures(const Key& key, std::shared_ptr<const ReferenceLines> lines) {
  FoundLines found{.key = key, .lines = std::move(lines)};
  found.picture = draw_reference(*found.lines);
  found.overlay = clear_where_white(found.picture);
  return found;
}

LiveReference::LiveReference(std::shared_ptr<LineFinder> finder, News& news)
    : BackgroundWork(
          [finder = std::move(finder)](const LineRequest& request, const StopAsked& stop) {
            return find_or_say_why(*finder, request, stop);
          },
          WhenNewer::finish, WorkPriority::below, news) {}

}  // namespace inkbench
