// SPDX-License-Identifier: MIT
// A colour as a swatch that opens a picker. In: the colour. Out: changes of the document, of which one drag
// is one step.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <string>

#include "app/window/ui_map.h"
#include "app/workbench/document.h"

namespace inkbench {

/// The swatch alone; returns whether it was pressed, to open the picker.
bool colour_swatch(const glm::vec3& colour, float width);

/// In the ID scope of the swatch. `opens`: from this frame on. `change` takes the new colour to the document.
/// `mark` is the picker's name in the map. Shift makes its drags finer.
void colour_picker(Document& document, UiMap& ui_map, const std::string& mark, glm::vec3 colour, bool opens,
                   const std::function<void(const glm::vec3&)>& change);

}  // namespace inkbench
