// SPDX-License-Identifier: MIT
#include "app/window/reference_desk.h"

#include <utility>

#include "app/window/picture_upload.h"
#include "pipeline/base/error.h"
#include "pipeline/passes/lines/reference.h"

namespace inkbench {

void ReferenceDesk::refresh(const Frame& frame) {
  const Key key = frame.key(BufferName::reference);
  if (std::optional<FoundLines> found = finder_.take()) {
    if (found->error.empty()) {
      now_ = std::move(found);
    } else if (found->key == key) {
      behind_ = false;
      throw work_error("reference lines", found->error);
    }
  }
  behind_ = !now_ || now_->key != key;
  // Making a request reads pictures back.
  if (behind_) finder_.ask_when_free(key, [&] { return frame.line_request(); });
}

void ReferenceDesk::finish(const Frame& frame) {
  const Key key = frame.key(BufferName::reference);
  if (now_ && now_->key == key) return;
  now_ = with_pictures(key, frame.value<ReferencePass>());
}

const Texture& ReferenceDesk::picture() {
  return picture_.get(now_->key, [&] { return texture_of("reference picture", now_->picture); });
}

const Texture& ReferenceDesk::overlay() {
  return overlay_.get(now_->key, [&] { return texture_of("reference overlay", now_->overlay); });
}

}  // namespace inkbench
