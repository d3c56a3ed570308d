// SPDX-License-Identifier: MIT
// Random mouse and keyboard events from a seed: most of them on widgets, some anywhere. In: the window's
// state. Out: a script for xdotool, one event a line.
#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace inkbench {

class Monkey {
 public:
  explicit Monkey(uint64_t seed) : random_(seed) {}

  /// `count` events or a few more, for a window whose state is `state`. Buttons and modifiers that are
  /// pressed are released in the end.
  std::string events(const nlohmann::json& state, int count);

 private:
  struct Place {
    int x = 0, y = 0;
  };
  int number(int low, int high);
  bool chance(double share);
  template <class Items>
  const auto& one_of(const Items& items);
  Place any_place();
  Place place_in_widget();
  void send(const std::string& command);
  void move(const Place& place);
  void act();
  void press_button();
  void turn_wheel();
  void drag();
  void press_key();
  void type_text();
  void resize();

  std::mt19937_64 random_;
  using Rect = std::vector<double>;  ///< Left, top, right, bottom in px.
  std::vector<Rect> widgets_, forbidden_;
  int width_ = 0, height_ = 0;
  bool in_chooser_ = false;
  std::string script_;
  int sent_ = 0;
};

}  // namespace inkbench
