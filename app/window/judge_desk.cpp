// SPDX-License-Identifier: MIT
#include "app/window/judge_desk.h"

#include <utility>

#include "app/window/picture_upload.h"

namespace inkbench {
namespace {

constexpr float kReferenceVeil = 0.55F, kMatchesVeil = 0.8F;

JudgedView view_of(const Frame& frame, std::shared_ptr<const ReferenceLines> lines) {
  return {std::make_shared<Image>(frame.raw(BufferName::lines)), std::move(lines)};
}

}  // namespace

void JudgeDesk::refresh_measures(const Frame& frame, const FoundLines& lines, const KeyedView& full) {
  const Key edges = frame.key(BufferName::lines);
  const JudgeParams& params = frame.settings().judge;
  const Key key = KeyBuilder().add(edges).add(lines.key).add(full.key).add(judge_text(params)).key();
  judge_.ask_when_free(key, [&] {
    return JudgeRequest{
        .id = ++last_id_, .view = view_of(frame, lines.lines), .full = full.view, .judge = params};
  });
  behind_ = !judge_.has_asked(key) || !now_ || now_->id != last_id_;
}

void JudgeDesk::refresh_pinned(const Pictures& pictures) {
  const KeyedView& pinned = pictures.pinned_view();
  if (pinned.view.edges == nullptr) {
    pinned_.reset();
    pinned_judge_.forget();
    return;
  }
  if (!pinned_judge_.has_asked(pinned.key)) pinned_.reset();
  pinned_judge_.ask(pinned.key, [&] {
    return JudgeRequest{.view = pinned.view, .judge = pictures.pinned_settings()->judge};
  });
}

void JudgeDesk::take_results() {
  if (std::optional<Judgement> result = judge_.take()) now_ = std::move(result);
  if (std::optional<Judgement> result = pinned_judge_.take()) pinned_ = std::move(result);
}

void JudgeDesk::refresh(Pictures& pictures, const Frame& frame, Wanted wanted, bool hurry) {
  take_results();
  if (!wanted.measures) full_mesh_.forget();
  wanted.causes ? causes.refresh(pictures.pipeline(), frame, hurry) : causes.forget();
  if (!wanted.lines && !wanted.measures) return;
  ReferenceDesk& reference = pictures.reference();
  reference.refresh(frame);
  if (!wanted.measures) return;
  const KeyedView full = full_mesh_.refresh(pictures.pipeline(), frame, hurry);
  if (reference.is_behind()) {
    behind_ = true;
  } else {
    refresh_measures(frame, *reference.now(), full);
    behind_ |= full_mesh_.is_behind();
  }
  refresh_pinned(pictures);
}

bool JudgeDesk::reload_changed_shaders() {
  bool changed = causes.reload_changed_shaders();
  changed |= full_mesh_.reload_changed_shaders();
  return changed;
}

std::string JudgeDesk::shader_problem() {
  const std::string problem = causes.shader_problem();
  return problem.empty() ? full_mesh_.shader_problem() : problem;
}

TileOverlay JudgeDesk::overlay(Overlay kind, ReferenceDesk& reference) {
  if (kind == Overlay::reference && reference.now() != nullptr)
    return {&reference.overlay(), reference.now()->key, kReferenceVeil};
  if (kind == Overlay::causes) return causes.overlay();
  if (kind == Overlay::matches && now_ && now_->error.empty()) {
    const Key key = KeyBuilder().add("matches").add(std::to_string(now_->id)).key();
    return {&matches_.get(key, [&] { return texture_of("matches overlay", match_overlay(now_->maps)); }), key,
            kMatchesVeil};
  }
  return {};
}

}  // namespace inkbench
