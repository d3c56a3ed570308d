// SPDX-License-Identifier: MIT
#include "app/workbench/ladder_maker.h"

namespace inkbench {
namespace {

MadeLadder make_ladder(const LadderRequest& request, const StopAsked& stop) {
  try {
    MeshLadder ladder(request.model, request.level.subdivide);
    if (stop && stop()) throw Stopped();
    ladder.prepare(request.level, stop);
    return {request.name, std::move(ladder)};
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception&) {
    return {request.name, std::nullopt};  // drawing it says why
  }
}

}  // namespace

LadderMaker::LadderMaker(News& news)
    : BackgroundWork(make_ladder, WhenNewer::give_up, WorkPriority::as_window, news) {}

}  // namespace inkbench
