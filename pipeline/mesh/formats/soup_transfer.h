// SPDX-License-Identifier: MIT
// A polygon soup as flat bytes, to cross the pipe from a reading child process.
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/mesh/formats/isolated_call.h"
#include "pipeline/mesh/polygon_soup.h"

namespace inkbench {

void send_soup(const PolygonSoup& soup, const ByteSink& sink);

/// The soup back, consistent in its sizes. Errors (work): bytes that no `send_soup` wrote.
PolygonSoup receive_soup(std::span<const uint8_t> bytes);

}  // namespace inkbench
