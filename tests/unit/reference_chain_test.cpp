// SPDX-License-Identifier: MIT
// Links joined to chains.
#include "pipeline/lines/chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace inkbench {
namespace {

const std::vector<glm::dvec3> kCross{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};

TEST(ReferenceChain, two_links_go_on_whatever_the_turn) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0.1, 0.01, 0}};
  const std::vector<Link> links{{0, 1}, {2, 1}};
  EXPECT_EQ(chain_links(points, links, 10.0), (std::vector<Chain>{{0, 1, 2}}));
}

TEST(ReferenceChain, ring_is_closed) {
  const std::vector<Link> links{{1, 3}, {3, 2}, {4, 1}, {2, 4}};
  const std::vector<Chain> chains = chain_links(kCross, links, 60.0);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].size(), 5U);
  EXPECT_EQ(chains[0].front(), chains[0].back());
}

TEST(ReferenceChain, crossing_lines_go_straight_on) {
  const std::vector<Link> links{{0, 1}, {0, 3}, {0, 2}, {0, 4}};
  EXPECT_EQ(chain_links(kCross, links, 60.0), (std::vector<Chain>{{1, 0, 2}, {3, 0, 4}}));
}

TEST(ReferenceChain, straightest_pair_goes_on_first) {
  const std::vector<Link> links{{0, 1}, {0, 3}, {0, 2}, {0, 4}};
  EXPECT_EQ(chain_links(kCross, links, 180.0), (std::vector<Chain>{{1, 0, 2}, {3, 0, 4}}));
}

TEST(ReferenceChain, corner_where_three_meet_ends_all) {
  const std::vector<glm::dvec3> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Link> links{{0, 1}, {0, 2}, {0, 3}};
  EXPECT_EQ(chain_links(corner, links, 60.0).size(), 3U);
  EXPECT_EQ(chain_links(corner, links, 180.0).size(), 2U);
}

TEST(ReferenceChain, any_turn_closes_what_meets_in_even_numbers) {
  // Two rings that share point 0.
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0.2, 0}, {1, -0.2, 0}, {0.2, 1, 0}, {-0.2, 1, 0}};
  const std::vector<Link> links{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
  size_t steps = 0;
  for (const Chain& chain : chain_links(points, links, 180.0)) {
    EXPECT_EQ(chain.front(), chain.back());
    steps += chain.size() - 1;
  }
  EXPECT_EQ(steps, 6U);
}

TEST(ReferenceChain, each_link_is_in_exactly_one_chain) {
  // A grid's edges: many meetings of four.
  std::vector<glm::dvec3> points;
  std::vector<Link> links;
  for (uint32_t y = 0; y < 9; ++y) {
    for (uint32_t x = 0; x < 9; ++x) {
      points.emplace_back(x, y, 0);
      if (x > 0) links.push_back({y * 9 + x - 1, y * 9 + x});
      if (y > 0) links.push_back({y * 9 + x, y * 9 - 9 + x});
    }
  }
  std::map<Link, int> used;
  const std::vector<Chain> chains = chain_links(points, links, 60.0);
  for (const Chain& chain : chains) {
    for (size_t i = 1; i < chain.size(); ++i) {
      const auto [a, b] = std::minmax(chain[i - 1], chain[i]);
      ++used[Link{a, b}];
    }
  }
  EXPECT_EQ(used.size(), links.size());
  for (const auto& [link, count] : used) EXPECT_EQ(count, 1);
  EXPECT_EQ(chains.size(), 15U);  // 14 lines inside, the rim as one
}

TEST(ReferenceChain, crowded_point_ends_all) {
  std::vector<glm::dvec3> points{{0, 0, 0}};
  std::vector<Link> links;
  for (uint32_t i = 1; i <= 2000; ++i) {
    points.emplace_back(std::cos(i), std::sin(i), 0.0);
    links.push_back({0, i});
  }
  EXPECT_EQ(chain_links(points, links, 180.0).size(), 2000U);
}

TEST(ReferenceChain, nothing_gives_nothing) {
  EXPECT_TRUE(chain_links({}, {}, 60.0).empty());
}

}  // namespace
}  // namespace inkbench
