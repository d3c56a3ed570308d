// SPDX-License-Identifier: MIT
#include "app/window/keeping.h"

#include <utility>

#include "app/workbench/param_changes.h"
#include "app/workbench/scene_base.h"
#include "app/workbench/session_merge.h"
#include "app/workbench/user_folder.h"
#include "pipeline/base/error.h"

namespace inkbench {
namespace {

constexpr double kAutosaveSeconds = 3.0;

std::filesystem::path folder_or_none(std::vector<std::string>& notes) {
  try {
    return user_folder();
  } catch (const Error& error) {
    notes.emplace_back(error.what());
    return {};
  }
}

}  // namespace

Keeping::Keeping() : folder_(folder_or_none(notes_)), presets_(folder_ / "presets") {
  if (!folder_.empty()) store_ = std::make_unique<SessionStore>(folder_);
}

Session Keeping::start() {
  Session session = store_ != nullptr ? store_->load() : first_session();
  kept_ = session;
  if (store_ != nullptr) {
    notes_.insert(notes_.end(), store_->notes().begin(), store_->notes().end());
    drop_known_work(session);
  }
  saved_layout_ = session.layout;
  return session;
}

/// Work that differs from what comes back anyway only in the window's layout is not worth a question: the
/// newest layout, recent files and bookmarks are kept.
void Keeping::drop_known_work(Session& session) {
  std::error_code error;
  auto layout_time = std::filesystem::last_write_time(folder_ / "session.toml", error);
  for (size_t i = store_->unsaved().size(); i-- > 0;) {
    const UnsavedWork& work = store_->unsaved()[i];
    if (!same_settings(work.session.settings, session.settings)) continue;
    if (!same_marks(work.session.marks, session.marks)) continue;
    merge_lists({}, work.session, kept_);
    if (work.time > layout_time) {
      session.layout = work.session.layout;
      layout_time = work.time;
    }
    store_->forget_unsaved(i);
  }
}

std::span<const UnsavedWork> Keeping::unsaved() const {
  return store_ != nullptr ? std::span(store_->unsaved()) : std::span<const UnsavedWork>();
}

Session Keeping::session_of(const Document& document, const WindowLayout& layout) const {
  Session session = kept_;
  session.settings = with_absolute_paths(document.settings());
  session.scene = document.scene();
  session.marks = document.marks();
  session.layout = layout;
  return session;
}

void Keeping::save_now(const Document& document, const WindowLayout& layout) {
  if (store_ == nullptr) return;
  try {
    store_->autosave(session_of(document, layout));
  } catch (const Error& error) {
    notes_.emplace_back(error.what());
  }
}

void Keeping::autosave(const Document& document, const WindowLayout& layout, double now_seconds) {
  const long revision = document.revision() + own_revision_;
  if (now_seconds < next_save_ || document.is_editing()) return;
  if (revision == saved_revision_ && layout == saved_layout_) return;
  save_now(document, layout);
  saved_revision_ = revision;
  saved_layout_ = layout;
  next_save_ = now_seconds + kAutosaveSeconds;
}

void Keeping::close(const Document& document, const WindowLayout& layout) {
  if (store_ == nullptr) return;
  try {
    store_->close(session_of(document, layout));
  } catch (const Error& error) {
    notes_.emplace_back(error.what());
  }
}

void Keeping::restore(Document& document, WindowLayout& layout) {
  if (unsaved().empty()) return;
  const Session session = unsaved().front().session;
  if (!document.take_over(session.settings, session.scene, session.marks, "restore unsaved work")) return;
  layout = session.layout;
  merge_lists({}, session, kept_);
  ++own_revision_;
  save_now(document, layout);  // before the old autosave goes
  discard();
}

void Keeping::discard() {
  if (unsaved().empty()) return;
  store_->forget_unsaved(0);
}

std::vector<std::string> Keeping::take_notes() {
  return std::exchange(notes_, {});
}

void Keeping::add_recent(const std::filesystem::path& file) {
  inkbench::add_recent(kept_, file);
  ++own_revision_;
}

void Keeping::set_bookmarks(std::vector<CameraBookmark> bookmarks) {
  bookmarks.resize(std::min(bookmarks.size(), kMaxBookmarks));
  kept_.bookmarks = std::move(bookmarks);
  ++own_revision_;
}

}  // namespace inkbench
