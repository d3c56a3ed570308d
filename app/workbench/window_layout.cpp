// SPDX-License-Identifier: MIT
#include "app/workbench/window_layout.h"

namespace inkbench {

const Description& WindowLayout::description() {
  static const Description kDescription{
      "layout",
      "The window",
      {
          field<&WindowLayout::width_px>(
              {.name = "width_px", .help = "Width of the window.", .unit = "px", .limits = {320, 32768}}),
          field<&WindowLayout::height_px>(
              {.name = "height_px", .help = "Height of the window.", .unit = "px", .limits = {240, 32768}}),
          field<&WindowLayout::maximised>({.name = "maximised", .help = "The window fills the screen."}),
          field<&WindowLayout::left>({.name = "left",
                                      .help = "Width of the parameters, as a share of the window's.",
                                      .limits = {0.05, 0.6}}),
          field<&WindowLayout::right>({.name = "right",
                                       .help = "Width of the inspector, as a share of the window's.",
                                       .limits = {0.05, 0.6}}),
          field<&WindowLayout::bottom>({.name = "bottom",
                                        .help = "Height of timings and log, as a share of the window's.",
                                        .limits = {0.05, 0.8}}),
          field<&WindowLayout::show_parameters>({.name = "show_parameters", .help = "Parameters are open."}),
          field<&WindowLayout::show_inspector>({.name = "show_inspector", .help = "The inspector is open."}),
          field<&WindowLayout::show_timings>({.name = "show_timings", .help = "Timings are open."}),
          field<&WindowLayout::show_log>({.name = "show_log", .help = "The log is open."}),
          field<&WindowLayout::show_welcome>(
              {.name = "show_welcome", .help = "Show the page of keys and mouse at the start."}),
          field<&WindowLayout::left_tab>({.name = "left_tab", .help = "What the panel on the left shows."}),
          field<&WindowLayout::side_page>(
              {.name = "side_page", .help = "What the panel beside the pictures shows."}),
          field<&WindowLayout::overlay>({.name = "overlay", .help = "Lines laid over all pictures."}),
          field<&WindowLayout::theme>({.name = "theme", .help = "Dark or light."}),
          field<&WindowLayout::ui_scale>({.name = "ui_scale",
                                          .help = "Size of text and controls; 0 follows the monitor.",
                                          .limits = {0, 4}}),
          field<&WindowLayout::open_groups>(
              {.name = "open_groups", .help = "Groups of parameters that are open."}),
          field<&WindowLayout::hidden_buffers>(
              {.name = "hidden_buffers", .help = "Buffers that are left out of the contact sheet."}),
      }};
  return kDescription;
}

}  // namespace inkbench
