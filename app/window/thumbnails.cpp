// SPDX-License-Identifier: MIT
#include "app/window/thumbnails.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/base/error.h"
#include "pipeline/base/priority.h"
#include "pipeline/image/image_file.h"
#include "studies/report/scaling.h"

namespace inkbench {
namespace {

constexpr double kMemoryBytes = 96e6;
constexpr size_t kMostAnswers = 64;  // read ahead of a window that does not draw

/// The largest size of the picture's shape that fits.
Picture fitted(const Picture& picture, int width_px, int height_px) {
  const double scale = std::min({static_cast<double>(width_px) / picture.width_px,
                                 static_cast<double>(height_px) / picture.height_px, 1.0});
  return scaled(picture, std::max(1, static_cast<int>(std::lround(picture.width_px * scale))),
                std::max(1, static_cast<int>(std::lround(picture.height_px * scale))));
}

Image with_alpha_channel(const Picture& picture) {
  Image image(picture.width_px, picture.height_px, 4, 1.0F);
  for (size_t i = 0; i < picture.samples.size(); ++i)
    image.samples[i / 3 * 4 + i % 3] = static_cast<float>(picture.samples[i]) / 255.0F;
  return image;
}

}  // namespace

Thumbnails::Thumbnails() : thread_([this] { serve(); }) {}

Thumbnails::~Thumbnails() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Thumbnails::serve() {
  step_back_for_drawing();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return closing_ || (!wishes_.empty() && answers_.size() < kMostAnswers); });
    if (closing_) return;
    Answer answer{wishes_.front(), {}, ""};
    wishes_.erase(wishes_.begin());
    reading_ = answer.wish;
    lock.unlock();
    try {
      answer.picture = fitted(read_picture(answer.wish.file, 3), answer.wish.width_px, answer.wish.height_px);
    } catch (const std::exception& error) {
      answer.problem = error.what();
    }
    lock.lock();
    answers_.push_back(std::move(answer));
    reading_.reset();
  }
}

void Thumbnails::take(Answer& answer) {
  if (answer.wish.revision != revision_) return;
  Entry& entry = entries_[{answer.wish.file, answer.wish.slot}];
  entry.width_px = answer.wish.width_px;
  entry.height_px = answer.wish.height_px;
  entry.problem = answer.problem;
  entry.frame = frame_;
  entry.texture = {};
  if (!answer.problem.empty()) return;
  const Picture& picture = answer.picture;
  entry.texture = Texture("thumbnail", TextureFormat::rgba8, picture.width_px, picture.height_px);
  entry.texture.upload(with_alpha_channel(picture));
}

/// Those that were wanted longest ago go first; what the last frame showed stays.
void Thumbnails::drop_unused() {
  double bytes = 0;
  std::vector<std::pair<long, Place>> by_age;
  for (const auto& [place, entry] : entries_) {
    bytes += 4.0 * entry.texture.width_px() * entry.texture.height_px();
    if (entry.frame < frame_ - 1) by_age.emplace_back(entry.frame, place);
  }
  std::sort(by_age.begin(), by_age.end());
  for (const auto& [age, place] : by_age) {
    if (bytes <= kMemoryBytes) return;
    const Texture& texture = entries_.at(place).texture;
    bytes -= 4.0 * texture.width_px() * texture.height_px();
    entries_.erase(place);
  }
}

void Thumbnails::begin_frame() {
  ++frame_;
  std::vector<Answer> answers;
  {
    const std::lock_guard lock(mutex_);
    answers.swap(answers_);
  }
  changed_.notify_all();
  for (Answer& answer : answers) take(answer);
  if (!answers.empty()) drop_unused();
}

const Texture* Thumbnails::get(const std::filesystem::path& file, int width_px, int height_px, int slot) {
  const std::string name = file.string();
  const auto found = entries_.find({name, slot});
  const bool is_right =
      found != entries_.end() && found->second.width_px == width_px && found->second.height_px == height_px;
  if (!is_right) wanted_.push_back({name, width_px, height_px, slot, revision_});
  if (found == entries_.end()) return nullptr;
  found->second.frame = frame_;
  return found->second.texture.width_px() > 0 ? &found->second.texture : nullptr;
}

std::string Thumbnails::problem(const std::filesystem::path& file) const {
  const auto found = entries_.find({file.string(), 0});
  return found == entries_.end() ? "" : found->second.problem;
}

void Thumbnails::end_frame() {
  waiting_ = !wanted_.empty();
  {
    const std::lock_guard lock(mutex_);
    // What is being read, or waits for the next frame, need not be read again.
    std::erase_if(wanted_, [&](const Wish& wish) {
      return reading_ == wish || std::any_of(answers_.begin(), answers_.end(),
                                             [&](const Answer& answer) { return answer.wish == wish; });
    });
    wishes_.swap(wanted_);
  }
  wanted_.clear();
  changed_.notify_all();
}

void Thumbnails::forget() {
  ++revision_;
  entries_.clear();
}

}  // namespace inkbench
