// SPDX-License-Identifier: MIT
#include "tests/cli/cli_test.h"
#include "tests/places.h"

#include <unistd.h>

#include <fstream>
#include <sstream>

namespace inkbench {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string summary(const CommandResult& result) {
  std::ostringstream text;
  text << "status " << result.status << ", signal " << result.signal
       << (result.timed_out ? ", timed out" : "") << "\nstdout: " << result.out.substr(0, 2000)
       << "\nstderr: " << result.err.substr(0, 4000);
  return text.str();
}

testing::AssertionResult is_error(const CommandResult& result, int status,
                                  const std::vector<std::string>& words) {
  if (result.status != status)
    return testing::AssertionFailure() << "status " << status << " expected\n" << summary(result);
  std::string error;
  for (const std::string& line : lines_of(result.err)) {
    if (line.starts_with("inkbench: note: ")) continue;
    if (!line.starts_with("inkbench: error: "))
      return testing::AssertionFailure() << "an odd line\n" << summary(result);
    if (!error.empty()) return testing::AssertionFailure() << "more than one error line\n" << summary(result);
    error = line;
  }
  if (error.empty()) return testing::AssertionFailure() << "no error line\n" << summary(result);
  for (const std::string& word : words) {
    if (error.find(word) == std::string::npos)
      return testing::AssertionFailure() << "'" << word << "' is missing\n" << summary(result);
  }
  return testing::AssertionSuccess();
}

}  // namespace

CliTest::CliTest() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::path(testing::TempDir()) / (std::string("inkbench_") + test.test_suite_name() + "_" +
                                            test.name() + "_" + std::to_string(getpid()));
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  folder_ = fs::canonical(folder_);
}

CliTest::~CliTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

CommandResult CliTest::inkbench(const std::vector<std::string>& arguments, CommandOptions options) const {
  std::vector<std::string> command{inkbench_program()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  if (options.working_folder.empty()) options.working_folder = folder_;
  return run_command(command, options);
}

fs::path CliTest::write(const std::string& name, const std::string& content) const {
  const fs::path path = file(name);
  fs::create_directories(path.parent_path());
  std::ofstream stream(path, std::ios::binary);
  stream << content;
  stream.close();
  EXPECT_TRUE(stream) << path;
  return path;
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  EXPECT_TRUE(stream) << path << " cannot be read";
  std::ostringstream content;
  content << stream.rdbuf();
  return std::move(content).str();
}

FolderContent folder_content(const fs::path& folder) {
  FolderContent content;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      content[fs::relative(entry.path(), folder).string()] = content_of(entry.path());
  }
  return content;
}

std::vector<std::string> unfinished_files(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.find(".part") != std::string::npos) names.push_back(name);
  }
  return names;
}

testing::AssertionResult succeeds(const CommandResult& result) {
  if (result.status == 0 && result.err.find("error:") == std::string::npos)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << summary(result);
}

testing::AssertionResult is_input_error(const CommandResult& result, const std::vector<std::string>& words) {
  return is_error(result, 2, words);
}

testing::AssertionResult is_work_error(const CommandResult& result, const std::vector<std::string>& words) {
  return is_error(result, 1, words);
}

std::string small_scene() {
  return R"(title = "A small scene"
[image]
width = 64
height = 48
[camera]
eye = [0, 1, 8]
target = [0, 1, 0]
fov = 40
far = 20
[[model]]
name = "box"
shape = "box"
size = 1.4
position = [-1.5, 0, 0]
rotation = [20, 30, 0]
[[model]]
name = "ball"
shape = "sphere"
segments = 24
size = 1.2
position = [1.8, 2.4, 0]
material = { colour = "#cc4020" }
[[model]]
name = "ground"
shape = "plane"
size = 12
position = [0, -1.5, 0]
[[light]]
name = "key"
direction = [1, 1, 1]
)";
}

}  // namespace inkbench
