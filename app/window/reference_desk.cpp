#include "app/window/reference_desk.h"

#include <utility>

#include "app/window/picture_upload.h"
#include "app/window/window.h"
#include "pipeline/base/error.h"
#include "pipeline/passes/lines/reference.h"

namespace inkbench {

ReferenceDesk::ReferenceDesk(Pipeline& pipeline)
    : finder_(pipeline.line_finder(), [this] {
        news_ = true;
        wake_window();
      }) {}

void ReferenceDesk::refresh(const Frame& frame) {
  const Key key = frame.key(BufferName::reference);
  if (std::optional<FoundLines> found = finder_.poll()) {
    if (found->error.empty()) {
      now_ = std::move(found);
    } else if (found->key == key) {
      behind_ = false;
      throw work_error("reference lines", found->error);
    }
  }
  behind_ = !now_ || now_->key != key;
  // The newest settings are asked for when it is done: making a request reads pictures back.
  if (!behind_ || key == asked_ || finder_.is_busy()) return;
  asked_ = key;
  finder_.submit(frame.line_request());
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
