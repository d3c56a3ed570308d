// SPDX-License-Identifier: MIT
#include "app/window/cause_desk.h"

#include <utility>

#include "app/window/picture_upload.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr float kCausesVeil = 0.8F;

/// So that the passes of another pipeline read and decimate nothing again.
void share_meshes(MeshStore& to, MeshStore& from, const Settings& settings) {
  for (size_t i = 0; i < settings.models.size(); ++i) {
    if (settings.models[i].visible) to.share(from, settings.models[i], level_of(settings, i));
  }
}

}  // namespace

void CauseDesk::forget() {
  if (own_ && own_->lines.is_busy()) return;  // the end of its work would be waited for
  if (own_) own_->pipeline.forget_results();  // nothing of it stays in the pool
  own_.reset();
  asked_.reset();
  found_.reset();
  error_.clear();
  overlay_.forget();
  is_behind_ = has_step_ = false;
}

std::shared_ptr<const ReferenceLines> CauseDesk::lines_of(const LineRequest& request) {
  if (std::optional<FoundLines> found = own_->lines.take()) own_->found_lines = std::move(found);
  const std::optional<FoundLines>& found = own_->found_lines;
  if (found && found->key == request.key) {
    if (!found->error.empty()) throw work_error("reference lines", found->error);
    return found->lines;
  }
  own_->lines.ask_when_free(request.key, [&] { return request; });
  return nullptr;
}

void CauseDesk::do_step(Pipeline& pipeline, const Frame& frame, const Key& key) {
  if (!own_) own_ = std::make_unique<Own>(pipeline.line_finder(), news_);
  share_meshes(own_->pipeline.meshes(), pipeline.meshes(), frame.settings());
  if (asked_ != key) {
    asked_ = key;
    own_->causes.reset();  // in case the new one cannot be made
    own_->causes.emplace(own_->pipeline, frame.settings(),
                         [this](const LineRequest& request) { return lines_of(request); });
  }
  if (own_->causes->step()) return;
  CauseMaps maps = own_->causes->causes();
  const CauseCounts counts = count_causes(maps);
  found_ = Found{std::move(maps), counts, frame.settings().judge.tolerance, key};
  own_->causes.reset();
  own_->pipeline.forget_results();
  is_behind_ = false;
}

void CauseDesk::refresh(Pipeline& pipeline, const Frame& frame, bool hurry) {
  const Key key = causes_key(frame);
  has_step_ = false;
  is_behind_ = !found_ || found_->key != key;
  const bool has_failed = !error_.empty() && asked_ == key;
  if (!is_behind_ || has_failed || hurry) return;
  error_.clear();
  try {
    do_step(pipeline, frame, key);
  } catch (const Error& error) {
    error_ = error.what();
    own_->causes.reset();
    asked_ = key;
  }
  has_step_ = is_behind_ && error_.empty() && !own_->lines.is_busy();
}

TileOverlay CauseDesk::overlay() {
  if (!found_) return {};
  const Key key = KeyBuilder().add("causes overlay").add(found_->key).key();
  return {&overlay_.get(key, [&] { return texture_of("causes overlay", cause_overlay(found_->maps)); }), key,
          kCausesVeil};
}

}  // namespace inkbench
