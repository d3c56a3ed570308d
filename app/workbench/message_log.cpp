// SPDX-License-Identifier: MIT
#include "app/workbench/message_log.h"

#include <array>
#include <ctime>

namespace inkbench {
namespace {

constexpr size_t kMaxMessages = 2000;

std::string clock_text() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%H:%M:%S", &local);
  return text.data();
}

}  // namespace

void MessageLog::add(Severity severity, const std::string& text) {
  put(severity, text);
  if (told_) told_();
}

void MessageLog::put(Severity severity, const std::string& text) {
  const std::lock_guard lock(mutex_);
  ++revision_;
  if (!messages_.empty() && messages_.back().severity == severity && messages_.back().text == text) {
    messages_.back().time = clock_text();
    ++messages_.back().repeats;
    return;
  }
  messages_.push_back({severity, clock_text(), text, 1});
  if (messages_.size() > kMaxMessages) messages_.pop_front();
}

std::vector<Message> MessageLog::messages() const {
  const std::lock_guard lock(mutex_);
  return {messages_.begin(), messages_.end()};
}

void MessageLog::clear() {
  {
    const std::lock_guard lock(mutex_);
    messages_.clear();
    ++revision_;
  }
  if (told_) told_();
}

long MessageLog::revision() const {
  const std::lock_guard lock(mutex_);
  return revision_;
}

}  // namespace inkbench
