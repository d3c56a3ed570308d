// SPDX-License-Identifier: MIT
#include "pipeline/passes/ink/drawn_ink.h"

#include "pipeline/flow/describe_choice.h"
#include "pipeline/passes/edges/combine.h"
#include "pipeline/passes/ink/both_inks.h"
#include "pipeline/passes/ink/narrow_coverage.h"
#include "pipeline/passes/ink/published_look.h"
#include "pipeline/passes/strokes/stroke_ink.h"

namespace inkbench {
namespace {

bool draws_as_published(const Settings& settings) {
  switch (settings.edges.method) {
    case EdgeMethod::decaudin:
      return !settings.decaudin.thin;
    case EdgeMethod::saito_takahashi:
      return !settings.saito_takahashi.thin;
    case EdgeMethod::mitchell:
      return !settings.mitchell.thin;
    default:
      return false;
  }
}

}  // namespace

bool places_lines(const Settings& settings) {
  return !is_papers_ink(settings) && !draws_as_published(settings);
}

size_t FilterInk::chosen(const Settings& settings) {
  if (is_papers_ink(settings)) return 0;
  return draws_as_published(settings) ? 1 : 2;
}

const PassKind& FilterInk::kind() {
  static const PassKind kKind = describe_choice<FilterInk, CombinePass, PublishedLookPass, LineCoverage>(
      "filter_ink", EdgesParams::description().group, {});
  return kKind;
}

const PassKind& DrawnInk::kind() {
  static const PassKind kKind = describe_choice<DrawnInk, FilterInk, StrokeInkPass, BothInksPass>(
      "drawn_ink", InkParams::description().group, {});
  return kKind;
}

}  // namespace inkbench
