// SPDX-License-Identifier: MIT
#include "app/window/pass_timer.h"

namespace inkbench {
namespace {

constexpr double kNewestShare = 0.2;

}  // namespace

PassTimer::~PassTimer() {
  for (const Span& span : waiting_) {
    glDeleteQueries(1, &span.begin);
    glDeleteQueries(1, &span.end);
  }
  for (const GLuint query : idle_) glDeleteQueries(1, &query);
}

GLuint PassTimer::take_query() {
  GLuint query = 0;
  if (idle_.empty()) {
    glCreateQueries(GL_TIMESTAMP, 1, &query);
    return query;
  }
  query = idle_.back();
  idle_.pop_back();
  return query;
}

void PassTimer::note_run(const std::string& name) {
  if (last_run_change_ != change_) {
    for (auto& [other, record] : records_) {
      record.time.ran = false;
      record.time.runs_in_change = 0;
    }
    last_run_change_ = change_;
  }
  PassTime& time = records_[name].time;
  time.ran = true;
  ++time.runs_in_change;
}

void PassTimer::begin_pass(std::string_view name) {
  note_run(std::string(name));
  waiting_.push_back({std::string(name), take_query(), take_query(), frame_});
  glQueryCounter(waiting_.back().begin, GL_TIMESTAMP);
}

void PassTimer::end_pass() {
  glQueryCounter(waiting_.back().end, GL_TIMESTAMP);
}

void PassTimer::finish(const Span& span) {
  GLuint64 begin = 0;
  GLuint64 end = 0;
  glGetQueryObjectui64v(span.begin, GL_QUERY_RESULT, &begin);
  glGetQueryObjectui64v(span.end, GL_QUERY_RESULT, &end);
  idle_.push_back(span.begin);
  idle_.push_back(span.end);
  Record& record = records_[span.name];
  const double ms = end > begin ? static_cast<double>(end - begin) * 1e-6 : 0.0;
  if (record.frame == span.frame && record.measured) {
    record.time.last_ms += ms;
    record.time.mean_ms += kNewestShare * ms;
    return;
  }
  record.time.last_ms = ms;
  record.time.mean_ms = record.measured ? (1.0 - kNewestShare) * record.time.mean_ms + kNewestShare * ms : ms;
  record.frame = span.frame;
  record.measured = true;
}

void PassTimer::begin_frame(long change) {
  ++frame_;
  change_ = change;
  while (!waiting_.empty()) {
    GLint arrived = GL_FALSE;
    glGetQueryObjectiv(waiting_.front().end, GL_QUERY_RESULT_AVAILABLE, &arrived);
    if (arrived == GL_FALSE) return;
    finish(waiting_.front());
    waiting_.pop_front();
  }
}

PassTime PassTimer::time_of(const std::string& name) const {
  const auto found = records_.find(name);
  return found == records_.end() ? PassTime{} : found->second.time;
}

double PassTimer::mean_ms() const {
  double sum = 0.0;
  for (const auto& [name, record] : records_) sum += record.time.mean_ms;
  return sum;
}

}  // namespace inkbench
