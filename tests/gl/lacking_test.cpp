// SPDX-License-Identifier: MIT
// Buffers that hold nothing, and what they say that they lack.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/pipeline.h"
#include "tests/gl/scenes.h"

namespace inkbench {
namespace {

bool is_empty(const Image& image) {
  return std::all_of(image.samples.begin(), image.samples.end(), [](float sample) { return sample == 0.0F; });
}

TEST(LackingFor, is_told_by_those_buffers_that_hold_nothing) {
  Pipeline pipeline;
  for (size_t method = 0; method < ChoiceNames<EdgeMethod>::names.size(); ++method) {
    Settings settings = analytic_scene();
    settings.edges.method = static_cast<EdgeMethod>(method);
    const Frame frame = pipeline.at(settings);
    for (const BufferName buffer : all_buffers()) {
      EXPECT_EQ(is_empty(frame.raw(buffer)), !lacking_for(buffer, settings).empty())
          << name_of(buffer) << " by " << ChoiceNames<EdgeMethod>::names.at(method);
    }
  }
}

TEST(LackingFor, names_what_is_to_be_set) {
  EXPECT_EQ(lacking_for(BufferName::pair_gaps, Settings()), "edges.method = dihedral");
  EXPECT_EQ(lacking_for(BufferName::final, Settings()), "");
}

}  // namespace
}  // namespace inkbench
