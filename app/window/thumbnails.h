// SPDX-License-Identifier: MIT
// Pictures from files at the size at which they are shown: read and scaled on a thread of their own, in the
// order in which they are wanted, and kept on the GPU as far as a fixed amount of memory goes. In: paths and
// sizes, each frame anew. Out: textures, once they are there.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "pipeline/gl/texture.h"

namespace inkbench {

class Thumbnails {
 public:
  Thumbnails();
  Thumbnails(const Thumbnails&) = delete;
  Thumbnails& operator=(const Thumbnails&) = delete;
  ~Thumbnails();

  /// Before the first `get` of a frame: takes in what was read.
  void begin_frame();
  /// The picture fitted into the size; one of another size or nullptr while that is being read. A file that
  /// is shown at two sizes at once needs a slot for each.
  const Texture* get(const std::filesystem::path& file, int width_px, int height_px, int slot = 0);
  /// Why the file cannot be shown; "" where it can or is not read yet.
  std::string problem(const std::filesystem::path& file) const;
  /// After the last `get`: what was asked for is read next, and nothing else.
  void end_frame();
  bool is_waiting() const { return waiting_; }
  /// The files may be others now.
  void forget();

 private:
  struct Wish {
    std::string file;
    int width_px = 0, height_px = 0, slot = 0;
    long revision = 0;
    bool operator==(const Wish&) const = default;
  };
  struct Answer {
    Wish wish;
    Picture picture;
    std::string problem;
  };
  struct Entry {
    Texture texture;
    int width_px = 0, height_px = 0;  ///< That were wished for.
    std::string problem;
    long frame = 0;  ///< In which it was last wanted.
  };
  void serve();
  void take(Answer& answer);
  void drop_unused();

  using Place = std::pair<std::string, int>;  ///< File and slot.
  std::map<Place, Entry> entries_;
  std::vector<Wish> wanted_;
  long frame_ = 0, revision_ = 0;
  bool waiting_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Wish> wishes_;
  std::optional<Wish> reading_;
  std::vector<Answer> answers_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace inkbench
