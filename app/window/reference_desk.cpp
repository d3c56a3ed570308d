#include "app/window/reference_desk.h"

#include <utility>

#include "app/window/picture_upload.h"
#include "app/window/window.h"
#include "pipeline/base/error.h"

namespace inkbench {

ReferenceDesk::ReferenceDesk(BufferSource& source)
    : source_(source), finder_(source.finder(), [this] {
        news_ = true;
        wake_window();
      }) {}

void ReferenceDesk::refresh(const Settings& settings) {
  const Key key = source_.reference_key(settings);
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
  finder_.submit(source_.line_request(settings));
}

void ReferenceDesk::finish(const Settings& settings) {
  const Key key = source_.reference_key(settings);
  if (now_ && now_->key == key) return;
  now_ = with_pictures(key, std::make_shared<ReferenceLines>(source_.reference(settings)));
}

const Texture& ReferenceDesk::picture() {
  return picture_.get(now_->key, [&] { return texture_of("reference picture", now_->picture); });
}

const Texture& ReferenceDesk::overlay() {
  return overlay_.get(now_->key, [&] { return texture_of("reference overlay", now_->overlay); });
}

}  // namespace inkbench
