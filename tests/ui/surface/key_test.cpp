// SPDX-License-Identifier: MIT
#include "ui/surface/key.h"

#include <gtest/gtest.h>

#include "ui/surface/input.h"

namespace svoscope::ui {
namespace {

TEST(Key, ParsesNamesCharactersAndModifiers) {
  EXPECT_EQ(parseKey("space")->key, Key::space);
  EXPECT_EQ(parseKey("right")->key, Key::right);
  EXPECT_EQ(parseKey("p")->key, keyOf('P'));
  EXPECT_EQ(parseKey("p")->character, 'p');
  EXPECT_TRUE(parseKey("shift+p")->shift);
  EXPECT_EQ(parseKey("shift+p")->character, 'P');
  const KeyChord save = *parseKey("ctrl+s");
  EXPECT_TRUE(save.ctrl);
  EXPECT_EQ(save.character, 0) << "shortcuts type nothing";
  EXPECT_EQ(index(parseKey("f12")->key), index(Key::f12));
}

TEST(Key, ShiftedCharactersPressTheKeyBelow) {
  const KeyChord help = *parseKey("?");
  EXPECT_EQ(help.key, Key::slash);
  EXPECT_TRUE(help.shift);
  EXPECT_EQ(help.character, '?');
  EXPECT_EQ(parseKey("+")->key, Key::equal);
}

TEST(Key, UnknownNamesAreNoKey) {
  for (const char* text : {"", "hyper", "f13", "f0", "ctrl+", "ctrl+nonsense"})
    EXPECT_FALSE(parseKey(text)) << text;
}

TEST(InputState, AShortClickBetweenTwoFramesIsNotLost) {
  ImGuiContext* context = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  InputState input;
  input.setButton(0, true);
  input.setButton(0, false);
  input.apply(io);
  EXPECT_TRUE(io.MouseDown[0]);
  input.apply(io);
  EXPECT_FALSE(io.MouseDown[0]);
  ImGui::DestroyContext(context);
}

}  // namespace
}  // namespace svoscope::ui
