#include "app/window/judge_desk.h"

#include <utility>

#include "app/window/picture_upload.h"
#include "app/window/window.h"

namespace inkbench {
namespace {

constexpr float kReferenceVeil = 0.55F, kMatchesVeil = 0.8F;

JudgedView view_of(const Frame& frame, std::shared_ptr<const ReferenceLines> lines) {
  return {std::make_shared<Image>(frame.raw(BufferName::combined_edges)), std::move(lines)};
}

}  // namespace

JudgeDesk::JudgeDesk()
    : judge_([this] {
        news_ = true;
        wake_window();
      }),
      pinned_judge_([this] {
        news_ = true;
        wake_window();
      }) {}

void JudgeDesk::refresh_measures(const Frame& frame, const FoundLines& lines, const FullView& full) {
  const Key edges = frame.key(BufferName::combined_edges);
  const Key key = KeyBuilder().add(edges).add(lines.key).add(full.key).key();
  if (key == asked_) {
    behind_ = !now_ || now_->id != last_id_;
    return;
  }
  behind_ = true;
  if (judge_.is_busy()) return;  // the newest settings are asked for when it is done
  judge_.submit({.id = ++last_id_, .view = view_of(frame, lines.lines), .full = full.view});
  asked_ = key;
}

void JudgeDesk::refresh_pinned(const JudgedView& view) {
  if (view.edges == nullptr) pinned_.reset();
  if (view.edges == pinned_edges_) return;
  pinned_edges_ = view.edges;
  pinned_.reset();
  if (view.edges != nullptr) pinned_judge_.submit({.view = view});
}

void JudgeDesk::take_results() {
  if (std::optional<Judgement> result = judge_.poll()) now_ = std::move(result);
  if (std::optional<Judgement> result = pinned_judge_.poll()) pinned_ = std::move(result);
}

void JudgeDesk::refresh(Pictures& pictures, const Frame& frame, Wanted wanted, bool hurry) {
  take_results();
  if (!wanted.measures) full_mesh_.forget();
  if (!wanted.lines && !wanted.measures) return;
  ReferenceDesk& reference = pictures.reference();
  reference.refresh(frame);
  if (!wanted.measures) return;
  const FullView full = full_mesh_.refresh(pictures.pipeline(), frame, hurry);
  if (reference.is_behind()) {
    behind_ = true;
  } else {
    refresh_measures(frame, *reference.now(), full);
    behind_ |= full_mesh_.is_behind();
  }
  refresh_pinned(pictures.pinned_view());
}

bool JudgeDesk::take_news() {
  const bool lines = full_mesh_.take_news();
  return news_.exchange(false) || lines;
}

TileOverlay JudgeDesk::overlay(Overlay kind, ReferenceDesk& reference) {
  if (kind == Overlay::reference && reference.now() != nullptr)
    return {&reference.overlay(), reference.now()->key, kReferenceVeil};
  if (kind == Overlay::matches && now_ && now_->error.empty()) {
    const Key key = KeyBuilder().add("matches").add(std::to_string(now_->id)).key();
    return {&matches_.get(key, [&] { return texture_of("matches overlay", match_overlay(now_->maps)); }), key,
            kMatchesVeil};
  }
  return {};
}

}  // namespace inkbench
