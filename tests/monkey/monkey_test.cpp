// SPDX-License-Identifier: MIT
// Random events: no crash, no OpenGL error, no memory that grows. INKBENCH_MONKEY_EVENTS and
// INKBENCH_MONKEY_SEED choose how many (./check --all: ten thousand) and which; a failure names the seed and
// shows the last events.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

#include "pipeline/base/files.h"
#include "tests/app/app_test.h"
#include "tests/monkey/monkey.h"

namespace inkbench {
namespace {

constexpr int kChunk = 60;
/// What the last state may take more than every one of the first half: a large mesh with its levels, its
/// lines and the full mesh's own passes. In ten thousand events, a leak of 32 kB an event is more. Sanitizers
/// double what is allocated.
#ifdef __SANITIZE_ADDRESS__
constexpr long kSpareKb = 320 << 10;
#else
constexpr long kSpareKb = 160 << 10;
#endif
constexpr int kLargestSide = 400;  // px; larger pictures would test the renderer's patience

long from_environment(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atol(text);
}

class MonkeyTest : public AppTest {
 protected:
  ~MonkeyTest() override {
    if (HasFailure()) std::cout << "the last events:\n" << last_events_;
  }

  void start() {
    for (const char* folder : {"root", "home", "bin"}) fs::create_directories(file(folder));
    for (const char* folder : {"shaders", "data", "studies"})
      fs::copy(project_file(folder), file("root") / folder, fs::copy_options::recursive);
    // What would be opened by other programs is not.
    write("bin/xdg-open", "#!/bin/sh\nexit 0\n");
    fs::permissions(file("bin/xdg-open"), fs::perms::owner_all);
    environment_["PATH"] = file("bin").string() + ":" + std::getenv("PATH");
    environment_["INKBENCH_ROOT"] = file("root").string();
    environment_["HOME"] = file("home").string();
    environment_["XDG_DATA_HOME"] = file("home/data").string();
    environment_["XDG_CACHE_HOME"] = file("home/cache").string();
    open();
  }

  /// A monkey that hits Quit gets its window again.
  void play(const std::string& script) {
    write("events.txt", script);
    last_events_ = script;
    try {
      xdotool({file("events.txt").string()});
      input({});
    } catch (const std::exception&) {
      if (wait_for_end() != 0) throw;
      ++quits_;
      xdotool({"keyup", "ctrl", "keyup", "shift", "keyup", "alt", "mouseup", "1", "mouseup", "2"});
      open();
    }
  }

  /// Undoes until the image is small again.
  void keep_small() {
    for (int i = 0; i < 40 && is_large(state()); ++i) {
      keys("Escape");
      input({"key", "--repeat", "30", "--delay", "5", "ctrl+z"});
    }
    ASSERT_FALSE(is_large(state())) << "undo does not bring back the small image";
  }

  static bool is_large(const Json& state) {
    const auto side = [&](const char* key) {
      return std::stoi(state.at("parameters").at(key).get<std::string>());
    };
    return std::max(side("image.width"), side("image.height")) > kLargestSide;
  }

  static std::string gl_error(const Json& state) {
    for (const Json& line : state.at("log")) {
      if (line.get<std::string>().find("OpenGL") != std::string::npos) return line;
    }
    return "";
  }

  int quits() const { return quits_; }

 private:
  std::string last_events_;
  int quits_ = 0;
};

TEST_F(MonkeyTest, random_events_neither_crash_nor_grow) {
  const long count = from_environment("INKBENCH_MONKEY_EVENTS", 1500);
  const long seed = from_environment("INKBENCH_MONKEY_SEED", 1);
  SCOPED_TRACE("INKBENCH_MONKEY_SEED=" + std::to_string(seed));
  Monkey monkey(static_cast<uint64_t>(seed));
  start();
  long largest_kb = 0;  // in the first half
  std::set<std::string> seen;
  for (long done = 0; done < count; done += kChunk) {
    play(monkey.events(state(), kChunk));
    keep_small();
    const Json now = state();
    ASSERT_EQ(gl_error(now), "");
    for (const auto& widget : now["ui"].items()) seen.insert(widget.key());
    if (done <= count / 2) largest_kb = std::max(largest_kb, resident_kb());
  }
  EXPECT_GT(seen.size(), static_cast<size_t>(std::min(count / 10, 200L))) << "it does not get around";
  std::cout << seen.size() << " widgets, " << state()["frames"] << " frames, " << largest_kb / 1024
            << " MB half-way, " << resident_kb() / 1024 << " MB in the end, " << quits() << " times quit\n";
  EXPECT_LT(resident_kb(), largest_kb + kSpareKb) << "kB, in the first half at most " << largest_kb;
  keys("Escape");
  quit();
}

}  // namespace
}  // namespace inkbench
