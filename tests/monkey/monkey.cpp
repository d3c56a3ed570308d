// SPDX-License-Identifier: MIT
#include "tests/monkey/monkey.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace inkbench {
namespace {

constexpr std::array kKeys{"Escape", "Return",    "Tab",
                           "Delete", "BackSpace", "space",
                           "Left",   "Right",     "Up",
                           "Down",   "Home",      "End",
                           "1",      "2",         "3",
                           "9",      "0",         "f",
                           "z",      "c",         "p",
                           "l",      "j",         "w",
                           "o",      "v",         "r",
                           "s",      "shift+s",   "F1",
                           "F3",     "F11",       "F12",
                           "ctrl+z", "ctrl+y",    "ctrl+z",
                           "ctrl+y", "ctrl+f",    "ctrl+shift+z",
                           "ctrl+o", "ctrl+s",    "ctrl+a",
                           "ctrl+c", "ctrl+v",    "shift+Left"};
constexpr std::array kModifiers{"ctrl", "shift", "alt"};
constexpr std::array kTexts{"0.01", " -1",     "1e9", "nan", "k",         "ball",
                            "512",  "[0 1 0]", "##",  "0",   "nosuch.obj"};
/// They lead out of the folders that the test made, out of the program, or to meshes of gigabytes. What opens
/// while events come in is not known here, so that Quit is hit at times.
constexpr std::array<std::string_view, 5> kForbidden{"place:All files", "chooser:up", "path", "menu:Quit",
                                                     "bar:mesh.subdivide"};

bool is_forbidden(const std::string& widget) {
  return std::find(kForbidden.begin(), kForbidden.end(), widget) != kForbidden.end();
}

}  // namespace

int Monkey::number(int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random_);
}

bool Monkey::chance(double share) {
  return std::bernoulli_distribution(share)(random_);
}

template <class Items>
const auto& Monkey::one_of(const Items& items) {
  return *std::next(std::begin(items), number(0, static_cast<int>(std::size(items)) - 1));
}

Monkey::Place Monkey::any_place() {
  const Place place{number(0, width_ - 1), number(0, height_ - 1)};
  const bool allowed = std::none_of(forbidden_.begin(), forbidden_.end(), [&](const Rect& rect) {
    return place.x >= rect[0] && place.y >= rect[1] && place.x <= rect[2] && place.y <= rect[3];
  });
  return allowed ? place : any_place();
}

Monkey::Place Monkey::place_in_widget() {
  if (widgets_.empty()) return any_place();
  const Rect& rect = one_of(widgets_);
  return {number(static_cast<int>(rect[0]), static_cast<int>(rect[2])),
          number(static_cast<int>(rect[1]), static_cast<int>(rect[3]))};
}

void Monkey::send(const std::string& command) {
  script_ += command + "\n";
  ++sent_;
}

void Monkey::move(const Place& place) {
  send("mousemove " + std::to_string(place.x) + " " + std::to_string(place.y));
}

void Monkey::press_button() {
  const std::string button = chance(0.75) ? "1" : chance(0.7) ? "3" : "2";
  const std::string repeat = chance(0.15) ? "--repeat 2 --delay 20 " : "";
  send("click " + repeat + button);
}

void Monkey::turn_wheel() {
  send("click --delay 5 --repeat " + std::to_string(number(1, 5)) + (chance(0.5) ? " 4" : " 5"));
}

void Monkey::drag() {
  const std::string button = chance(0.8) ? "1" : "2";
  send("mousedown " + button);
  for (int i = number(1, 5); i > 0; --i) {
    move(chance(0.7) ? any_place() : place_in_widget());
    script_ += "sleep 0.01\n";
  }
  send("mouseup " + button);
}

void Monkey::press_key() {
  send(std::string("key ") + one_of(kKeys));
}

void Monkey::type_text() {
  send(std::string("type \"") + one_of(kTexts) + "\"");
  if (chance(0.5)) send("key Return");
}

void Monkey::resize() {
  send("search --name ^inkbench$ windowsize " + std::to_string(number(480, 1100)) + " " +
       std::to_string(number(320, 720)));
}

void Monkey::act() {
  // A file chooser's own list may lead anywhere: only what is known is pressed there.
  if (in_chooser_ || chance(0.8)) {
    move(place_in_widget());
  } else {
    move(any_place());
  }
  const std::string held = chance(0.15) ? one_of(kModifiers) : "";
  if (!held.empty()) send("keydown " + held);
  const int kind = number(0, 99);
  if (kind < 45) {
    press_button();
  } else if (kind < 65) {
    drag();
  } else if (kind < 75) {
    turn_wheel();
  } else if (kind < 92) {
    press_key();
  } else if (kind < 98) {
    type_text();
  } else {
    resize();
  }
  if (!held.empty()) send("keyup " + held);
}

std::string Monkey::events(const nlohmann::json& state, int count) {
  widgets_.clear();
  forbidden_.clear();
  width_ = height_ = 1;
  in_chooser_ = state.at("ui").contains("chooser:ok");
  for (const auto& [name, rect] : state.at("ui").items()) {
    width_ = std::max(width_, static_cast<int>(rect[2].get<double>()));
    height_ = std::max(height_, static_cast<int>(rect[3].get<double>()));
    (is_forbidden(name) ? forbidden_ : widgets_).push_back(rect.get<Rect>());
  }
  script_.clear();
  sent_ = 0;
  if (in_chooser_ && chance(0.6)) send("key Escape");
  while (sent_ < count) act();
  return script_;
}

}  // namespace inkbench
