// SPDX-License-Identifier: MIT
// Keys that are meant for a text field which is not there yet: it opens a frame or two after the click or the
// key that asked for it, and on a slow renderer whole words are typed meanwhile. They wait for it, so that
// none is lost or acts as a shortcut.
#pragma once

namespace inkbench {

/// A text field that opens now will take the keyboard.
void expect_typing();

/// The same at the field's own place: ImGui's next item gets the keyboard.
void take_keyboard();

/// Whether a field is still on its way.
bool typing_is_expected();

/// Whether keys must wait in this frame; once a frame, before ImGui::NewFrame. They wait until a text field
/// has the keyboard, some frames at most: one that never comes swallows nothing.
bool keys_must_wait();

}  // namespace inkbench
