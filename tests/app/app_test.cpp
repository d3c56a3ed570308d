// SPDX-License-Identifier: MIT
#include "tests/app/app_test.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "pipeline/base/files.h"
#include "tests/app/display.h"
#include "tests/cli/command.h"
#include "tests/places.h"

namespace inkbench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kPatience = 20.0;
constexpr auto kPause = std::chrono::milliseconds(20);
constexpr auto kRest = std::chrono::milliseconds(150);

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const Display& display() {
  static const Display value;
  return value;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

AppTest::AppTest() {
  environment_ = {{"DISPLAY", display().name()},
                  {"XDG_CONFIG_HOME", file("config").string()},
                  {"XDG_DATA_HOME", file("data").string()},
                  {"INKBENCH_CACHE", ""},
                  {"LIBGL_ALWAYS_SOFTWARE", "1"}};
}

AppTest::~AppTest() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (HasFailure()) ADD_FAILURE() << "the program said: " << text_of(file("output.txt"));
}

std::string AppTest::small_scene() const {
  return R"(
[image]
width = 96
height = 96
[camera]
eye = [0, 2, 6]
[[model]]
name = "ball"
shape = "sphere"
size = 2
position = [-0.8, 0, 0]
[[model]]
name = "block"
shape = "box"
size = 1.4
position = [1.2, 0, 0]
rotation = [0, 30, 0]
[[light]]
name = "key"
direction = [0.5, 0.7, 0.6]
)";
}

void AppTest::open(bool close_keys_page) {
  write("scene.toml", small_scene());
  open_with({"--scene", file("scene.toml").string()}, close_keys_page);
}

void AppTest::open_with(const std::vector<std::string>& arguments, bool close_keys_page) {
  std::filesystem::remove(file("state.json"));
  std::vector<std::string> command{inkbench_program(), "app",          "--size",
                                   "1100x720",         "--state-file", file("state.json").string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  marks_ = 0;
  process_ = start_program(command, environment_, folder_.path().string(), file("output.txt").string());
  settled();
  if (!close_keys_page || state().at("layout").at("show_welcome") != "true") return;
  keys("Escape");
  wait_for("the page of keys to close",
           [](const Json& now) { return now.at("layout").at("show_welcome") == "false"; });
}

void AppTest::open_with_own_shaders() {
  namespace fs = std::filesystem;
  fs::create_directories(file("root"));
  fs::copy(project_file("shaders"), file("root/shaders"), fs::copy_options::recursive);
  fs::copy(project_file("data"), file("root/data"), fs::copy_options::recursive);
  environment_["INKBENCH_ROOT"] = file("root").string();
  open();
}

void AppTest::choose_method(const std::string& method) {
  click("choice:edges.method");
  click("choice:edges.method=" + method);
  wait_for("the method",
           [&](const Json& now) { return parameter(now, "edges.method") == "\"" + method + "\""; });
}

long AppTest::resident_kb() const {
  std::istringstream status(text_of("/proc/" + std::to_string(process_) + "/status"));
  const std::string name = "VmRSS:";
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name)) return std::stol(line.substr(name.size()));
  }
  throw std::runtime_error("the program is gone");
}

bool AppTest::has_ended() {
  int status = 0;
  if (process_ > 0 && waitpid(process_, &status, WNOHANG) == process_) {
    process_ = -1;
    end_status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  return process_ < 0;
}

int AppTest::wait_for_end() {
  const auto start = Clock::now();
  while (seconds_since(start) < kPatience) {
    if (has_ended()) return end_status_;
    std::this_thread::sleep_for(kPause);
  }
  ADD_FAILURE() << "the program did not end";
  return -1;
}

void AppTest::quit() {
  xdotool({"key", "ctrl+q"});
  EXPECT_EQ(wait_for_end(), 0);
}

void AppTest::kill_program() {
  kill(process_, SIGKILL);
  EXPECT_EQ(wait_for_end(), -1);
}

void AppTest::send_signal(int signal) {
  kill(process_, signal);
}

void AppTest::while_it_stands_still(const std::function<void()>& act) {
  kill(process_, SIGSTOP);
  try {
    act();
  } catch (...) {
    kill(process_, SIGCONT);
    throw;
  }
  kill(process_, SIGCONT);
}

Json AppTest::state() const {
  const std::string text = text_of(file("state.json"));
  return text.empty() ? Json() : Json::parse(text);
}

Json AppTest::wait_for(const std::string& what, const std::function<bool(const Json&)>& holds) {
  const auto start = Clock::now();
  while (seconds_since(start) < kPatience) {
    Json now = state();
    if (!now.is_null() && holds(now)) return now;
    if (has_ended())
      throw std::runtime_error("the program ended with " + std::to_string(end_status_) + ", before " + what);
    std::this_thread::sleep_for(kPause);
  }
  throw std::runtime_error("waited in vain for " + what + "; the state is " + state().dump(1));
}

Json AppTest::settled() {
  const auto start = Clock::now();
  auto changed = start;
  std::string last;
  while (seconds_since(start) < kPatience) {
    std::string now = text_of(file("state.json"));
    if (now != last) changed = Clock::now();
    last = std::move(now);
    if (!last.empty() && Clock::now() - changed > kRest) {
      Json state = Json::parse(last);
      if (!state.at("finds_lines").get<bool>()) return state;
    }
    std::this_thread::sleep_for(kPause);
  }
  throw std::runtime_error("the window does not come to rest");
}

AppTest::Place AppTest::place(const std::string& widget, double across, double down) {
  Json last;
  auto moved = Clock::now();
  // It may still be on its way.
  wait_for("the widget '" + widget + "' to rest", [&](const Json& now) {
    const Json rect = now["ui"].contains(widget) ? now["ui"][widget] : Json();
    if (rect != last) moved = Clock::now();
    last = rect;
    return !last.is_null() && Clock::now() - moved > kRest;
  });
  const auto rect = last.get<std::vector<double>>();
  return {static_cast<int>(rect[0] + across * (rect[2] - rect[0])),
          static_cast<int>(rect[1] + down * (rect[3] - rect[1]))};
}

void AppTest::xdotool(const std::vector<std::string>& words) {
  std::vector<std::string> command{"/usr/bin/xdotool"};
  command.insert(command.end(), words.begin(), words.end());
  CommandOptions options;
  options.environment["DISPLAY"] = display().name();
  const CommandResult result = run_command(command, options);
  if (result.status != 0) throw std::runtime_error("xdotool (Debian's package xdotool): " + result.err);
}

void AppTest::input(std::vector<std::string> words) {
  words.insert(words.end(), {"key", "Pause"});
  xdotool(words);
  ++marks_;
  wait_for("the mouse and keyboard", [&](const Json& now) { return now["marks"] == marks_; });
}

void AppTest::move_to(const Place& place) {
  input({"mousemove", std::to_string(place.x), std::to_string(place.y)});
}

void AppTest::click(const std::string& widget, int button) {
  const Place at = place(widget);
  input({"mousemove", std::to_string(at.x), std::to_string(at.y), "click", std::to_string(button)});
}

void AppTest::type_over(const std::string& widget, const std::string& text) {
  input({"keydown", "ctrl"});
  click(widget);
  wait_for_text_field();
  input({"keyup", "ctrl"});
  type(text);
  keys("Return");
}

void AppTest::wait_for_text_field() {
  wait_for("a text field", [](const Json& now) { return now["text_field"].get<bool>(); });
}

void AppTest::press_and_move(const Place& from, const Place& to) {
  const auto text = [](int number) { return std::to_string(number); };
  input({"mousemove", text(from.x), text(from.y)});
  input({"mousedown", "1"});
  input({"mousemove", text((from.x + to.x) / 2), text((from.y + to.y) / 2)});
  input({"mousemove", text(to.x), text(to.y)});
}

void AppTest::drag(const Place& from, const Place& to, int button) {
  const auto text = [](int number) { return std::to_string(number); };
  const int steps = 6;
  std::vector<std::string> words{"mousemove", text(from.x), text(from.y), "mousedown", text(button)};
  for (int i = 1; i <= steps; ++i) {
    words.insert(words.end(), {"mousemove", text(from.x + (to.x - from.x) * i / steps),
                               text(from.y + (to.y - from.y) * i / steps), "sleep", "0.02"});
  }
  words.insert(words.end(), {"mouseup", text(button)});
  input(words);
}

void AppTest::open_by_dialog(const std::filesystem::path& path) {
  keys("ctrl+o");
  wait_for("the dialog", [](const Json& now) { return now["ui"].contains("chooser:ok"); });
  settled();
  type(path.string());
  keys("Return");
  wait_for("the dialog to close", [](const Json& now) { return !now["ui"].contains("chooser:ok"); });
}

}  // namespace inkbench
