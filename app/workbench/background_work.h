// SPDX-License-Identifier: MIT
// Work beside the window that follows what is shown: asked for by name, once each, and told of when it is
// done. In: requests with names. Out: results, and one flag for all such work that says that there is
// something to show.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <utility>

#include "app/workbench/latest_worker.h"

namespace inkbench {

/// Whether anything was finished beside the window since it last looked. Shared by all that works there.
class News {
 public:
  /// `wake` is called on the worker's thread.
  explicit News(std::function<void()> wake = {}) : wake_(std::move(wake)) {}

  /// From any thread, when the result is there to be taken.
  void tell() {
    is_new_ = true;
    if (wake_) wake_();
  }
  /// The window's look.
  bool take() { return is_new_.exchange(false); }

 private:
  std::function<void()> wake_;
  std::atomic<bool> is_new_ = false;
};

/// A worker and the name of what it was last asked for. `Name`: what tells requests apart.
template <class Request, class Result, class Name>
class BackgroundWork {
 public:
  using Work = typename LatestWorker<Request, Result>::Work;

  /// `work` as `LatestWorker` takes it. `news` must outlive it.
  BackgroundWork(Work work, WhenNewer when_newer, WorkPriority priority, News& news)
      : worker_(std::move(work), when_newer, priority, [&news] { news.tell(); }) {}

  /// Asks for it unless it was the last thing asked for; what still waits is replaced. `make` gives the
  /// request; what it throws leaves everything as it was.
  template <class Make>
  void ask(const Name& name, const Make& make) {
    if (asked_ == name) return;
    worker_.submit(make());
    asked_ = name;
  }
  /// The same where nothing is in work, for requests that are costly to make: asked for again in each frame,
  /// the newest one follows.
  template <class Make>
  void ask_when_free(const Name& name, const Make& make) {
    if (!is_busy()) ask(name, make);
  }

  /// Whether this is what was asked for last.
  bool has_asked(const Name& name) const { return asked_ == name; }
  /// The same may be asked for again.
  void forget() { asked_.reset(); }

  /// The newest result, once.
  std::optional<Result> take() { return worker_.poll(); }
  /// Whether anything waits or is in work.
  bool is_busy() const { return worker_.is_busy(); }

 private:
  std::optional<Name> asked_;
  LatestWorker<Request, Result> worker_;
};

}  // namespace inkbench
