// SPDX-License-Identifier: MIT
#include "ui/render/fonts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace svoscope::ui {
namespace {

struct FontKind {
  const char* environment;
  std::vector<const char*> file_names;
  float size;  // px at scale 1
  const ImWchar* glyphs;
};

constexpr const char* kFolders[] = {
    "/usr/share/fonts/truetype/dejavu",    // Debian: fonts-dejavu-core
    "/usr/share/fonts/dejavu-sans-fonts",  // Fedora
    "/usr/share/fonts/dejavu",
    "/usr/share/fonts/TTF",  // Arch
    "/usr/local/share/fonts",
};

// Latin-1, Greek, dashes and quotes, super- and subscripts, arrows, operators, shapes, check marks.
constexpr ImWchar kTextGlyphs[] = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x2033, 0x2070, 0x209C,
                                   0x2190, 0x21FF, 0x2200, 0x22FF, 0x2300, 0x2311, 0x25A0, 0x25FF,
                                   0x2605, 0x2606, 0x26A0, 0x26A0, 0x2713, 0x2717, 0};
constexpr ImWchar kPlainGlyphs[] = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x2033,
                                    0x2190, 0x2194, 0x2200, 0x22C5, 0};

std::optional<std::string> findFont(const FontKind& kind) {
  std::error_code ignored;
  if (const char* chosen = std::getenv(kind.environment); chosen && *chosen) {
    if (std::filesystem::is_regular_file(chosen, ignored)) return std::string(chosen);
  }
  for (const char* name : kind.file_names) {
    for (const char* folder : kFolders) {
      const std::filesystem::path file = std::filesystem::path(folder) / name;
      if (std::filesystem::is_regular_file(file, ignored)) return file.string();
    }
  }
  return std::nullopt;
}

bool addFont(const FontKind& kind, float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const float size = std::max(6.0f, std::round(kind.size * scale));
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  const std::optional<std::string> file = findFont(kind);
  if (file && atlas.AddFontFromFileTTF(file->c_str(), size, &config, kind.glyphs)) return true;
  ImFontConfig fallback;
  fallback.SizePixels = size;
  atlas.AddFontDefault(&fallback);
  return false;
}

ImFont* font(int place) {
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  return atlas.Fonts.Size > place ? atlas.Fonts[place] : ImGui::GetFont();
}

}  // namespace

std::vector<std::string> buildFonts(float scale) {
  const FontKind kinds[] = {
      {"SVOSCOPE_FONT", {"DejaVuSans.ttf"}, 15, kTextGlyphs},
      {"SVOSCOPE_FONT_MONO", {"DejaVuSansMono.ttf"}, 14, kPlainGlyphs},
      {"SVOSCOPE_FONT_BOLD", {"DejaVuSans-Bold.ttf", "DejaVuSans.ttf"}, 15, kPlainGlyphs},
  };
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.TexGlyphPadding = 1;
  std::vector<std::string> warnings;
  for (const FontKind& kind : kinds) {
    if (addFont(kind, scale)) continue;
    warnings.push_back(std::string(kind.file_names.front()) +
                       " not found: Greek letters and arrows will show as '?' (install "
                       "fonts-dejavu-core, or set " +
                       kind.environment + " to a TTF file)");
  }
  atlas.Build();
  return warnings;
}

ImFont* textFont() { return font(0); }
ImFont* monoFont() { return font(1); }
ImFont* titleFont() { return font(2); }

}  // namespace svoscope::ui
