// SPDX-License-Identifier: MIT
// A real window under a test: the program in a folder of its own, real mouse and keyboard events from
// xdotool, and what the window says of itself in its state file.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/unit/support.h"

namespace inkbench {

using Json = nlohmann::json;

class AppTest : public testing::Test {
 protected:
  AppTest();
  ~AppTest() override;

  /// Opens the window at 1100 x 720 with a small scene of plain shapes and waits until it rests; the page of
  /// keys is closed unless it is what the test is about.
  void open(bool close_keys_page = true);
  /// The same with other arguments than the scene's.
  void open_with(const std::vector<std::string>& arguments, bool close_keys_page = true);
  /// As `open`, with a copy of the project's shaders and data in the folder "root".
  void open_with_own_shaders();
  bool has_ended();
  /// Waits for the program's end; its exit status, or -1 for another end.
  int wait_for_end();
  /// By the keyboard; expects status 0.
  void quit();
  /// Without a chance to tidy up.
  void kill_program();
  void send_signal(int signal);
  /// What is typed and clicked meanwhile comes all at once, as in one very slow frame.
  void while_it_stands_still(const std::function<void()>& act);

  /// What the window says now.
  Json state() const;
  /// Waits until `holds` is true of the state, which is returned. Throws after 20 s, or when the
  /// program has ended.
  Json wait_for(const std::string& what, const std::function<bool(const Json&)>& holds);
  /// Waits until nothing has changed for a moment and no reference lines are being found.
  Json settled();

  std::string parameter(const Json& state, const std::string& key) const {
    return state.at("parameters").at(key).get<std::string>();
  }
  /// "" without one.
  std::string first_problem(const Json& state) const {
    return state.at("problems").empty() ? "" : state.at("problems")[0].get<std::string>();
  }
  long runs(const Json& state, const std::string& pass) const {
    return state.at("passes").at(pass).at("runs").get<long>();
  }

  struct Place {
    int x = 0, y = 0;
  };
  /// A point of a widget, as shares of its width and height, once it is there and rests.
  Place place(const std::string& widget, double across = 0.5, double down = 0.5);

  /// Runs xdotool with these words.
  void xdotool(const std::vector<std::string>& words);
  /// The same, and waits until the window has taken it all in.
  void input(std::vector<std::string> words);
  void move_to(const Place& place);
  void click(const std::string& widget, int button = 1);
  /// Ctrl and click on a number, then its new text.
  void type_over(const std::string& widget, const std::string& text);
  void wait_for_text_field();
  void drag(const Place& from, const Place& to, int button = 1);
  /// Chooses the edge detector in the panel of parameters.
  void choose_method(const std::string& method);
  /// The first half of a drag: the button stays down.
  void press_and_move(const Place& from, const Place& to);
  void release() { input({"mouseup", "1"}); }
  void keys(const std::string& keys) { input({"key", keys}); }
  void type(const std::string& text) {
    xdotool({"type", "--delay", "15", text});
    input({});
  }

  /// Memory of the program that is in use.
  long resident_kb() const;
  /// Types a path into the dialog for opening.
  void open_by_dialog(const std::filesystem::path& path);

  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) { folder_.write(name, text); }
  std::string small_scene() const;

  std::map<std::string, std::string> environment_;  ///< Of the program, on top of the tests' own.

 private:
  TemporaryFolder folder_;
  pid_t process_ = -1;   ///< -1 without one.
  int end_status_ = -1;  ///< Of the last one.
  long marks_ = 0;       ///< How often `input` was called.
};

}  // namespace inkbench
