// SPDX-License-Identifier: MIT
// Texts of panels: facts in columns, headings, notes, and words that fit the room they have.
#pragma once

#include <imgui/imgui.h>

#include <string>
#include <vector>

namespace svoscope::ui {

/// printf into a std::string.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));
/// "1 message", "2 messages".
std::string counted(int count, const char* noun);

/// With line breaks at blanks so that it fits `width`; unlike ImGui's own, never inside of a
/// number.
std::string wrapped(const std::string& text, float width);
/// Ends in "…" if it is wider than `width`; never cut inside of a character.
std::string elided(const std::string& text, float width);
/// Wrapped, and lines that are still too wide elided: what is cut is seen to be.
std::string fitted(const std::string& text, float width);
/// The text elided to the rest of the line; the whole is in the tooltip then.
void elidedText(const std::string& text, ImU32 color);
/// Widths made to fit `room`: the widest ones give way first, all of them to the same width.
std::vector<float> sharedWidths(std::vector<float> widths, float room);

/// Name on the left in dim ink, value in a column; for lists of facts.
void valueRow(const char* name, const std::string& value, ImU32 color = 0);
/// A value that the frame has none of: a dash, and why in the tooltip.
void missingRow(const char* name, const char* why);
/// A thin heading with a rule.
void heading(const char* text);
/// Text in dim ink, wrapped.
void note(const std::string& text);
/// A centred message for a panel that has nothing to show yet.
void emptyState(const char* title, const std::string& what_to_do);

}  // namespace svoscope::ui
