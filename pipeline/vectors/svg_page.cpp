// SPDX-License-Identifier: MIT
#include "pipeline/vectors/svg_page.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "pipeline/vectors/svg_parts.h"

namespace inkbench {
namespace {

std::string about_text(const ImageText& about) {
  if (about.empty()) return "";
  std::string text = "<metadata>\n";
  for (const auto& [name, value] : about)
    text += fmt::format("<ink:text name=\"{}\">{}</ink:text>\n", xml_text(name), xml_text(value));
  return text + "</metadata>\n";
}

/// `size`: of width and height attributes and the view box.
std::string whole_file(const std::string& size, const ImageText& about, const std::string& note,
                       const std::string& drawn) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" xmlns:ink=\"urn:inkbench\" " +
         size + ">\n" + (note.empty() ? "" : "<desc>" + xml_text(note) + "</desc>\n") + about_text(about) +
         drawn + "</svg>\n";
}

std::string layer(const std::string& id, const std::string& attributes, const std::string& content) {
  if (content.empty()) return "";
  return fmt::format("<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\"{1}>\n{2}</g>\n", id,
                     attributes, content);
}

std::string object_name(const std::vector<std::string>& names, int id) {
  const size_t place = static_cast<size_t>(id) - 1;
  return place < names.size() ? names[place] : std::to_string(id);
}

/// What `xml_text` made of a text.
std::string from_xml(std::string text) {
  constexpr std::array<std::pair<std::string_view, char>, 4> kEntities{
      {{"&quot;", '"'}, {"&gt;", '>'}, {"&lt;", '<'}, {"&amp;", '&'}}};
  for (const auto& [entity, character] : kEntities) {
    for (size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
      text.replace(at, entity.size(), 1, character);
  }
  return text;
}

using ByObject = std::map<int, std::string>;  // elements

std::string class_layer(const std::string& id, const std::string& attributes, const ByObject& objects,
                        const std::vector<std::string>& names) {
  std::string content;
  for (const auto& [object_id, elements] : objects) {
    if (object_id == 0) {
      content += elements;
    } else {
      content +=
          fmt::format("<g id=\"{}-{}\">\n{}</g>\n", id, id_part(object_name(names, object_id)), elements);
    }
  }
  return layer(id, attributes, content);
}

}  // namespace

std::string svg_file(const VectorPage& page, const std::string& note, const std::string& drawn) {
  return whole_file(
      fmt::format("width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\"", page.width_px, page.height_px),
      page.about, note, drawn);
}

std::string svg_file_mm(const VectorPage& page, double width_mm, double height_mm, const std::string& note,
                        const std::string& drawn) {
  const std::string width = svg_number(width_mm, 3), height = svg_number(height_mm, 3);
  return whole_file(fmt::format("width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\"", width, height),
                    page.about, note, drawn);
}

std::string svg_entry(std::string_view svg, std::string_view name) {
  const std::string opening = fmt::format("<ink:text name=\"{}\">", xml_text(name));
  const size_t begin = svg.find(opening);
  if (begin == std::string_view::npos) return "";
  const size_t first = begin + opening.size(), end = svg.find("</ink:text>", first);
  return end == std::string_view::npos ? "" : from_xml(std::string(svg.substr(first, end - first)));
}

std::string class_groups(const std::vector<ClassItem>& items, const ClassAttributes& attributes,
                         const std::vector<std::string>& object_names) {
  std::array<ByObject, kCurveClasses> visible, hidden;
  for (const ClassItem& item : items) {
    auto& classes = item.is_hidden ? hidden : visible;
    classes[static_cast<size_t>(item.curve_class)][item.object_id] += item.element;
  }
  std::string hidden_classes, visible_classes;
  for (size_t i = kCurveClasses; i-- > 0;) {
    const std::string name(kCurveClassNames[i]);
    hidden_classes += class_layer("hidden-" + name, attributes.hidden[i], hidden[i], object_names);
    visible_classes += class_layer(name, attributes.visible[i], visible[i], object_names);
  }
  return layer("hidden", attributes.hidden_group, hidden_classes) + visible_classes;
}

}  // namespace inkbench
