// SPDX-License-Identifier: MIT
// GPU time of each pass, from timestamps around its commands. In: a pipeline's passes. Out: milliseconds,
// which arrive a frame or two later, and whether each pass ran when something last ran.
#pragma once

#include <epoxy/gl.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "pipeline/flow/pass_observer.h"

namespace inkbench {

struct PassTime {
  double last_ms = 0.0;  ///< All runs within one frame together.
  double mean_ms = 0.0;  ///< Over the last runs, the newest counting most.
  bool ran = false;      ///< Since the last change after which any pass ran.
  int runs_in_change = 0;
};

class PassTimer : public PassObserver {
 public:
  PassTimer() = default;
  PassTimer(const PassTimer&) = delete;
  PassTimer& operator=(const PassTimer&) = delete;
  ~PassTimer() override;

  void begin_pass(std::string_view name) override;
  void end_pass() override;

  /// Before a frame's first pass: takes in the times that have arrived.
  /// `change` is another number once what is drawn has changed.
  void begin_frame(long change);
  /// Whether times are still on their way.
  bool is_waiting() const { return !waiting_.empty(); }
  /// Of a pass that never ran: all zero.
  PassTime time_of(const std::string& name) const;
  /// Of all passes together.
  double mean_ms() const;

 private:
  struct Span {
    std::string name;
    GLuint begin = 0, end = 0;
    long frame = 0;
  };
  struct Record {
    PassTime time;
    long frame = 0;  ///< Of `last_ms`.
    bool measured = false;
  };
  GLuint take_query();
  void note_run(const std::string& name);
  void finish(const Span& span);

  long frame_ = 0;
  long change_ = 0;
  long last_run_change_ = -1;
  std::deque<Span> waiting_;
  std::vector<GLuint> idle_;
  std::map<std::string, Record> records_;
};

}  // namespace inkbench
