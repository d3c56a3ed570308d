// SPDX-License-Identifier: MIT
// What each detector costs from the G-buffer to its ink, pass by pass, beside the paper's gradient, range and
// combine:
//
//   detector_benchmark [SIDE_PX=1024] [SCENE=data/scenes/paper.toml] [KEY=VALUE...]
//
// The methods take turns, and each pass counts with its fastest of ten runs, since machines are shared. Then
// what a change of each method's first number costs, with the passes that it runs.
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "pipeline/base/error.h"
#include "pipeline/base/files.h"
#include "pipeline/gl/context.h"
#include "pipeline/pipeline.h"
#include "pipeline/settings/settings_file.h"

namespace {

using namespace inkbench;
using Clock = std::chrono::steady_clock;

constexpr int kRounds = 10;

/// Shared by all methods, or not about lines.
const std::set<std::string> kNotOfDetectors{"meshes", "gbuffer", "quantise", "shade", "ink"};

/// The fastest run of each pass, in ms.
class FastestRuns final : public PassObserver {
 public:
  void begin_pass(std::string_view name) override {
    glFinish();
    name_ = name;
    start_ = Clock::now();
  }
  void end_pass() override {
    glFinish();
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    const auto found = ms_.try_emplace(name_, ms).first;
    found->second = std::min(found->second, ms);
  }
  void clear() { ms_.clear(); }
  const std::map<std::string, double>& ms() const { return ms_; }
  double sum() const {
    double total = 0;
    for (const auto& [name, ms] : ms_) total += kNotOfDetectors.contains(name) ? 0.0 : ms;
    return total;
  }

 private:
  std::string name_;
  Clock::time_point start_;
  std::map<std::string, double> ms_;
};

/// The first number of the method's own group.
std::string first_number(const std::string& method) {
  return method == "paper"             ? "combine.k_depth"
         : method == "decaudin"        ? "decaudin.k_depth"
         : method == "saito_takahashi" ? "saito_takahashi.profile"
         : method == "mitchell"        ? "mitchell.angle"
         : method == "laplacian"       ? "laplacian.bend"
                                       : "dihedral.angle";
}

void change(Settings& settings, const std::string& key, int round) {
  const Param param = find_param(settings, key, "benchmark");
  param.set(std::get<float>(param.value()) * (round % 2 == 0 ? 1.02F : 1.0F / 1.02F), "benchmark");
}

void print(const std::string& method, const FastestRuns& runs, double papers) {
  std::string passes;
  int count = 0;
  for (const auto& [name, ms] : runs.ms()) {
    if (kNotOfDetectors.contains(name)) continue;
    ++count;
    passes += fmt::format(" {} {:.1f}", name, ms);
  }
  fmt::print("{:<16} {:6.1f} ms {:5.2f} x the paper's {:2} passes:{}\n", method, runs.sum(),
             runs.sum() / papers, count, passes);
}

void time_methods(Pipeline& pipeline, const Settings& start, bool of_change) {
  std::map<std::string, FastestRuns> runs;
  for (int round = 0; round < kRounds; ++round) {
    for (const std::string_view name : ChoiceNames<EdgeMethod>::names) {
      const std::string method(name);
      Settings settings = start;
      set_param_text(settings, "edges.method", method, "benchmark");
      pipeline.observe(nullptr);
      pipeline.forget_results();
      if (of_change) {
        pipeline.at(settings).draw(BufferName::final);
        change(settings, first_number(method), round);
      }
      pipeline.observe(&runs[method]);
      pipeline.at(settings).draw(BufferName::final);
    }
  }
  pipeline.observe(nullptr);
  const double papers = runs.at("paper").sum();
  for (const std::string_view name : ChoiceNames<EdgeMethod>::names)
    print(std::string(name), runs.at(std::string(name)), papers);
}

}  // namespace

int main(int argc, char** argv) try {
  const HeadlessContext context;
  Pipeline pipeline;
  Settings settings = load_settings(argc > 2 ? argv[2] : project_file("data/scenes/paper.toml"));
  settings.image.width = settings.image.height = argc > 1 ? std::atoi(argv[1]) : 1024;
  for (int i = 3; i < argc; ++i) apply_assignment(settings, argv[i]);
  fmt::print("{}, {} x {} px\n\nfrom the G-buffer to the ink\n", renderer_info().renderer,
             settings.image.width, settings.image.height);
  time_methods(pipeline, settings, false);
  fmt::print("\nafter a change of the method's first number\n");
  time_methods(pipeline, settings, true);
  return 0;
} catch (const Error& error) {
  fmt::print(stderr, "detector_benchmark: {}\n", error.what());
  return 1;
}
