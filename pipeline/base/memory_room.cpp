// SPDX-License-Identifier: MIT
#include "pipeline/base/memory_room.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

#include "pipeline/base/error.h"
#include "pipeline/base/text.h"

namespace inkbench {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kNoLimit = std::numeric_limits<uintmax_t>::max();

uintmax_t less(uintmax_t limit, uintmax_t used) {
  return limit == kNoLimit ? kNoLimit : limit - std::min(used, limit);
}

/// What a file of /proc or /sys holds, of which the system tells no size; "" where there is none.
std::string system_text(const fs::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::optional<uintmax_t> number_in_file(const fs::path& path) {
  const std::string text = system_text(path);
  uintmax_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

/// "MemAvailable:   1234 kB" of /proc/meminfo, in bytes.
uintmax_t meminfo_bytes(const std::string& meminfo, const std::string& name) {
  const size_t at = meminfo.find(name + ":");
  if (at == std::string::npos) return 0;
  std::istringstream rest(meminfo.substr(at + name.size() + 1));
  uintmax_t kilobytes = 0;
  rest >> kilobytes;
  return kilobytes << 10;
}

uintmax_t system_room() {
  const std::string meminfo = system_text("/proc/meminfo");
  const uintmax_t available = meminfo_bytes(meminfo, "MemAvailable");
  return available == 0 ? kNoLimit : available + meminfo_bytes(meminfo, "SwapFree");
}

/// Of one control group's folder: its limit less what it uses, file pages that can be dropped not counted.
uintmax_t group_room(const fs::path& group, const char* limit_file, const char* usage_file) {
  const std::optional<uintmax_t> limit = number_in_file(group / limit_file);  // "max" is no number
  const std::optional<uintmax_t> usage = number_in_file(group / usage_file);
  if (!limit || !usage) return kNoLimit;
  std::istringstream statistics(system_text(group / "memory.stat"));
  uintmax_t droppable = 0;
  std::string name;
  for (uintmax_t value = 0; statistics >> name >> value;) {
    if (name == "inactive_file" || name == "total_inactive_file") droppable = std::max(droppable, value);
  }
  return less(*limit, less(*usage, droppable));
}

/// Of this process's control group and all above it, whichever version the system has.
uintmax_t control_group_room() {
  std::istringstream lines(system_text("/proc/self/cgroup"));
  uintmax_t room = kNoLimit;
  for (std::string line; std::getline(lines, line);) {  // "0::/user.slice" or "4:memory:/docker/ID"
    const std::vector<std::string> parts = split(line, ':');
    if (parts.size() != 3) continue;
    const bool is_second = parts[1].empty();
    const fs::path root = is_second ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    if (!is_second && parts[1] != "memory") continue;
    for (fs::path group = parts[2];; group = group.parent_path()) {
      const fs::path folder = root / group.relative_path();
      room = std::min(room, is_second ? group_room(folder, "memory.max", "memory.current")
                                      : group_room(folder, "memory.limit_in_bytes", "memory.usage_in_bytes"));
      if (!group.has_relative_path()) break;
    }
  }
  return room;
}

uintmax_t address_space_room() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
  const std::optional<uintmax_t> pages = number_in_file("/proc/self/statm");
  return less(limit.rlim_cur, pages.value_or(0) * static_cast<uintmax_t>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

uintmax_t memory_room() {
  return std::min({system_room(), control_group_room(), address_space_room()});
}

void check_memory(double bytes, const std::string& where, const std::string& what,
                  const std::string& instead) {
  const auto room = static_cast<double>(memory_room());
  if (bytes <= room) return;
  throw work_error(where,
                   what + " needs about " + readable_bytes(bytes) + " of memory, and " +
                       readable_bytes(room) + " can be had",
                   instead);
}

}  // namespace inkbench
