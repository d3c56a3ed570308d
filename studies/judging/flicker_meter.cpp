// SPDX-License-Identifier: MIT
#include "studies/judging/flicker_meter.h"

#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/passes/gbuffer/gbuffer.h"
#include "pipeline/passes/gbuffer/motion.h"
#include "pipeline/passes/lines/reference.h"

namespace inkbench {
namespace {

/// The frame as one whose past is `other`: its motion is to there, whichever of them is the later.
Frame looking_at(Pipeline& pipeline, const Frame& frame, const Frame& other) {
  return pipeline.at(frame.settings(), other);
}

}  // namespace

Key FlickerMeter::seen_key(const Frame& frame) const {
  KeyBuilder key;
  key.add(frame.key_of<GBufferPass>());
  if (needs_.frames) key.add(frame.key(BufferName::lines));
  if (needs_.reference_frames)
    key.add(frame.key(BufferName::reference)).add(judge_text(frame.settings().judge));
  return key.key();
}

FlickerMeter::Seen FlickerMeter::seen(const Frame& frame) const {
  Seen seen{.key = seen_key(frame), .camera = frame.settings().camera};
  if (needs_.frames) seen.drawn = counted_lines(line_map_from(frame.raw(BufferName::lines)));
  if (needs_.reference_frames)
    seen.wanted = counted_lines(tier_map(*frame.value<ReferencePass>(), frame.settings().judge, 1));
  seen.depth = frame.value<GBufferPass>()->normal_and_depth.read(3, 1);
  return seen;
}

FlickerTally FlickerMeter::tally(const Frame& before, const Frame& now) {
  if (before.settings().image.width != now.settings().image.width ||
      before.settings().image.height != now.settings().image.height)
    throw input_error("path", "two frames of it have different sizes",
                      "let nothing change image.width and image.height");
  if (!last_ || last_->key != seen_key(before)) last_ = seen(before);
  Seen here = seen(now);
  const MotionMap ahead = looking_at(pipeline_, before, now).value<MotionPass>()->read(0, 4);
  const MotionMap back = looking_at(pipeline_, now, before).value<MotionPass>()->read(0, 4);
  const LineCarrier carrier({last_->depth, last_->camera}, ahead, {here.depth, here.camera}, back,
                            now.settings().judge.tolerance);
  FlickerTally tally;
  if (needs_.frames) tally.drawn = carrier.counts(last_->drawn, here.drawn);
  if (needs_.reference_frames) tally.wanted = carrier.counts(last_->wanted, here.wanted);
  last_ = std::move(here);
  return tally;
}

Key FlickerMeter::key(const Frame& before, const Frame& now) {
  return KeyBuilder()
      .add(seen_key(before))
      .add(seen_key(now))
      .add(looking_at(pipeline_, before, now).key_of<MotionPass>())
      .add(looking_at(pipeline_, now, before).key_of<MotionPass>())
      .add(judge_text(now.settings().judge))
      .key();
}

}  // namespace inkbench
