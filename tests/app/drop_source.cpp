// SPDX-License-Identifier: MIT
#include "tests/app/drop_source.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace inkbench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kDropPatience = std::chrono::seconds(20);
constexpr long kVersion = 5;

class DropSource {
 public:
  DropSource(const std::string& display, std::string list)
      : display_(XOpenDisplay(display.c_str())), list_(std::move(list)) {
    if (display_ == nullptr) throw std::runtime_error("no display " + display);
    root_ = DefaultRootWindow(display_);
    source_ = XCreateSimpleWindow(display_, root_, 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
  }
  DropSource(const DropSource&) = delete;
  DropSource& operator=(const DropSource&) = delete;
  ~DropSource() { XCloseDisplay(display_); }

  void drop() {
    target_ = find_target();
    const auto uris = static_cast<long>(atom("text/uri-list"));
    send("XdndEnter", {kVersion << 24, uris, 0, 0});
    send("XdndPosition", {0, middle_of_target(), CurrentTime, static_cast<long>(atom("XdndActionCopy"))});
    if ((wait_for("XdndStatus") & 1) == 0) throw std::runtime_error("the window refuses the drop");
    send("XdndDrop", {0, CurrentTime, 0, 0});
    // GLFW answers with the list's length instead of a flag.
    if (wait_for("XdndFinished") == 0) throw std::runtime_error("the window did not take the drop");
  }

 private:
  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  bool takes_drops(Window window) const {
    Atom type = None;
    int format = 0;
    unsigned long count = 0;
    unsigned long rest = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(display_, window, atom("XdndAware"), 0, 1, False, XA_ATOM, &type, &format, &count,
                       &rest, &data);
    if (data != nullptr) XFree(data);
    return count > 0;
  }

  Window find_target() const {
    Window ignored = None;
    Window* children = nullptr;
    unsigned int count = 0;
    XQueryTree(display_, root_, &ignored, &ignored, &children, &count);
    Window found = None;
    for (unsigned int i = 0; i < count && found == None; ++i) {
      if (takes_drops(children[i])) found = children[i];
    }
    if (children != nullptr) XFree(children);
    if (found == None) throw std::runtime_error("no window takes drops");
    return found;
  }

  long middle_of_target() const {
    XWindowAttributes place{};
    XGetWindowAttributes(display_, target_, &place);
    return static_cast<long>(place.x + place.width / 2) << 16 | (place.y + place.height / 2);
  }

  /// The first number of every message is the source.
  void send(const char* message, const std::array<long, 4>& numbers) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(source_);
    for (size_t i = 0; i < numbers.size(); ++i) event.xclient.data.l[i + 1] = numbers[i];
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  /// What the window answers; meanwhile gives it the list when it asks.
  long wait_for(const char* message) {
    const auto end = Clock::now() + kDropPatience;
    while (Clock::now() < end) {
      while (XPending(display_) > 0) {
        XEvent event{};
        XNextEvent(display_, &event);
        if (event.type == SelectionRequest) give_list(event.xselectionrequest);
        if (event.type == ClientMessage && event.xclient.message_type == atom(message))
          return event.xclient.data.l[1];
      }
      pollfd wait{ConnectionNumber(display_), POLLIN, 0};
      poll(&wait, 1, 50);
    }
    throw std::runtime_error(std::string("the window does not answer with ") + message);
  }

  void give_list(const XSelectionRequestEvent& request) const {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(list_.data()), static_cast<int>(list_.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &event);
    XFlush(display_);
  }

  ::Display* display_;
  std::string list_;
  Window root_ = None, source_ = None, target_ = None;
};

}  // namespace

std::string uri_list(const std::vector<std::filesystem::path>& files) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string list;
  for (const std::filesystem::path& file : files) {
    list += "file://";
    for (const char c : file.string()) {
      std::array<char, 4> code{};
      std::snprintf(code.data(), code.size(), "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
      list += kPlain.find(c) != std::string_view::npos ? std::string(1, c) : code.data();
    }
    list += "\r\n";
  }
  return list;
}

void drop(const std::string& display, const std::string& uri_list) {
  DropSource(display, uri_list).drop();
}

}  // namespace inkbench
